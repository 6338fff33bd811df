// The pictures of the tools, on 16 x 16 squares.
// Gives SVG elements.

const kIcons = {
  place: 'M3 5h10v8H3zM3 5l2-2h10l-2 2M13 5l2-2v8l-2 2M7 7h2v4H7zM6 8h4v2H6z',
  box: 'M2 2h12v2H2zM2 12h12v2H2zM2 4h2v8H2zM12 4h2v8h-2zM7 7h2v2H7z',
  fill: 'M6 2h2v2h2v2h2v2h2v2h-2v2h-2v2H6v-2H4v-2H2V8h2V6h2zM13 11h2v3h-2z',
  replace: 'M2 4h8V2l4 3-4 3V6H2zM14 12H6v2l-4-3 4-3v2h8z',
  paint: 'M3 2h10v5H3zM7 7h2v3H7zM6 10h4v4H6z',
  line: 'M2 11h3v3H2zM11 2h3v3h-3zM5 9h2v2H5zM7 7h2v2H7zM9 5h2v2H9z',
  select: 'M2 2h4v2H4v2H2zM10 2h4v4h-2V4h-2zM2 10h2v2h2v2H2zM12 10h2v4h-4v-2h2zM7 7h2v2H7z',
  stamp: 'M6 2h4v3H9v3h4v3H3V8h4V5H6zM2 12h12v2H2z',
  thing: 'M7 9h2v6H7zM5 1h6v2h2v4h-2v2H5V7H3V3h2z',
  shape: 'M7 2h2v2h2v2H9v4h2v2H9v2H7v-2H5v-2h2V6H5V4h2z',
};

export function iconOf(name) {
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  svg.setAttribute('viewBox', '0 0 16 16');
  svg.setAttribute('aria-hidden', 'true');
  svg.setAttribute('shape-rendering', 'crispEdges');
  const path = document.createElementNS('http://www.w3.org/2000/svg', 'path');
  path.setAttribute('d', kIcons[name] ?? '');
  path.setAttribute('fill', 'currentColor');
  path.setAttribute('fill-rule', 'evenodd');
  svg.append(path);
  return svg;
}
