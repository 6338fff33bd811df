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
  link: 'M2 6h5v2H4v2h3v2H2zM9 6h5v6H9v-2h3V8H9zM6 8h4v2H6zM7 2h2v2H7z',
  removes: 'M2 3h2l4 4 4-4h2v2l-4 3 4 4v2h-2l-4-4-4 4H2v-2l4-4-4-3z',
  // Ways of tools
  solid: 'M3 3h10v10H3z',
  hollow: 'M2 2h12v12H2zM5 5v6h6V5z',
  pool: 'M1 3h3v8h8V3h3v11H1zM5 6h2v1h2V6h2v4H5z',
  pond: 'M1 5h3v2h3V5h3v2h3V5h2v3h-2v2h-3V8H7v2H4V8H1zM4 12h8v2H4z',
  walls: 'M2 2h3v12H2zM11 2h3v12h-3z',
  'what is pointed at': 'M7 1h2v4H7zM7 11h2v4H7zM1 7h4v2H1zM11 7h4v2h-4zM7 7h2v2H7z',
  floor: 'M1 11h14v3H1zM7 2h2v4h2L8 9 5 6h2z',
  ceiling: 'M1 2h14v3H1zM7 14h2v-4h2L8 7l-3 3h2z',
  portal: 'M4 1h8v2h2v12h-4V5H6v10H2V3h2zM7 8h2v2H7zM7 12h2v2H7z',
  gate: 'M2 2h12v12h-2V4H4v10H2zM5 6h1v8H5zM7.5 6h1v8h-1zM10 6h1v8h-1zM5 9h6v1H5z',
  way: 'M2 11h4v4H2zM5 8h2v3H5zM5 7h6v2H5zM9 4h2v4H9zM9 4h3V2l3 3-3 3V6H9z',
  message: 'M2 2h12v9H8l-4 3v-3H2zM4 4v1h8V4zM4 7v1h6V7z',
  goal: 'M3 1h7v2H5v10h5v2H3zM8 7h4V5l3 3-3 3V9H8z',
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
