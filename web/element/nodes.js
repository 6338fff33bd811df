// Makes elements without markup in strings, which pages may forbid (Trusted Types).
//
//     node('button', {type: 'button', class: 'cover'}, icon('play'))

const kSvg = 'http://www.w3.org/2000/svg';

// Drawn on 16 x 16 pixels.
const kIcons = {
  play: 'M3 1h2v1h2v1h2v1h2v1h1v1h1v1h1v2h-1v1h-1v1h-1v1H9v1H7v1H5v1H3z',
  pause: 'M3 2h4v12H3zM9 2h4v12H9z',
  reset: 'M5 2h7v1h1v1h1v8h-1v1h-1v1H4v-1H3v-1H2V9h2v2h1v1h6v-1h1V5h-1V4H8v2H7v1H6V6H5V5H4V4H3V2h1V1h1V0h1v2z',
  overlay: 'M1 2h4v1h1v1h4V3h1V2h4v11h-1v1h-3v-1h-1v-1H6v1H5v1H1zM3 4v8h1V4zM7 6v4h2V6zM12 4v8h1V4z',
  save: 'M7 1h2v6h3v1h-1v1h-1v1H9v1H7v-1H6V9H5V8H4V7h3zM2 11h2v2h8v-2h2v4H2z',
  share: 'M7 11V5H4V4h1V3h1V2h1V1h2v1h1v1h1v1h1v1H9v6zM2 9h2v4h8V9h2v6H2z',
  fullscreen: 'M1 1h5v2H3v3H1zM10 1h5v5h-2V3h-3zM1 10h2v3h3v2H1zM13 10h2v5h-5v-2h3z',
  leave: 'M2 3h1V2h2v1h1v1h1v1h2V4h1V3h1V2h2v1h1v2h-1v1h-1v1h-1v2h1v1h1v1h1v2h-1v1h-2v-1h-1v-1H9v-1H7v1H6v1H5v1H3v-1H2v-2h1v-1h1V9h1V7H4V6H3V5H2z',
  use: 'M3 15V5h1V3h2V2h4v1h2v2h1v10h-2V6h-1V4H6v2H5v9zM7 9h2v2H7z',
  fly: 'M1 4h3v1h2v1h1v1h2V6h1V5h2V4h3v2h-2v1h-2v1h-1v1h-1v2H7V9H6V8H5V7H3V6H1z',
  crouch: 'M7 2h2v5h3v1h-1v1h-1v1H9v1H7v-1H6V9H5V8H4V7h3zM3 12h10v2H3z',
  jump: 'M7 2h2v1h1v1h1v1h1v1H9v5H7V6H4V5h1V4h1V3h1zM3 12h10v2H3z',
};

export function node(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

export function icon(name) {
  const svg = document.createElementNS(kSvg, 'svg');
  const path = document.createElementNS(kSvg, 'path');
  for (const [key, value] of Object.entries({ viewBox: '0 0 16 16', 'aria-hidden': 'true', class: 'icon' })) svg.setAttribute(key, value);
  path.setAttribute('d', kIcons[name]);
  svg.append(path);
  return svg;
}
