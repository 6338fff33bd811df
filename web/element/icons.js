// The icons of buttons.
//
//     node('button', {type: 'button'}, icon('reset'))

import { drawing, kPlay } from './nodes.js';

// Drawn on 16 x 16 pixels.
const kIcons = {
  play: kPlay,
  pause: 'M3 2h4v12H3zM9 2h4v12H9z',
  reset:
    'M6 1h1v1H6zM5 2h2v1H5zM4 3h8v1H4zM3 4h11v1H3zM4 5h8v1H4zM13 5h2v1H13zM5 6h2v1H5zM12 6h2v1H12zM6 7h1v1H6zM13 7h2v4H13zM1 8h2v3H1zM1 11h3v1H1z' +
    'M12 11h3v1H12zM2 12h3v1H2zM11 12h3v1H11zM3 13h10v1H3zM4 14h8v1H4z',
  overlay:
    'M1 1h14v2H1zM1 3h2v10H1zM13 3h2v10H13zM7 4h2v2H7zM6 6h4v2H6zM5 8h6v2H5zM4 10h3v1H4zM9 10h3v1H9zM4 11h2v1H4zM10 11h2v1H10zM1 13h14v2H1z',
  save: 'M7 1h2v5H7zM3 5h2v1H3zM11 5h2v1H11zM4 6h8v1H4zM5 7h6v1H5zM6 8h4v1H6zM7 9h2v1H7zM1 11h2v2H1zM13 11h2v2H13zM1 13h14v2H1z',
  share:
    'M7 1h2v1H7zM6 2h4v1H6zM5 3h6v1H5zM4 4h8v1H4zM3 5h2v1H3zM7 5h2v6H7zM11 5h2v1H11zM1 9h2v4H1zM13 9h2v4H13zM1 13h14v2H1z',
  sound: 'M1 6h3v4H1zM4 5h2v6H4zM6 4h1v8H6zM7 3h1v10H7zM10 6h1v4h-1zM12 4h1v8h-1zM14 2h1v12h-1z',
  silence:
    'M1 6h3v4H1zM4 5h2v6H4zM6 4h1v8H6zM7 3h1v10H7zM10 5h1v1h1v1h1V6h1V5h1v1h-1v1h-1v2h1v1h1v1h-1v-1h-1V9h-1v1h-1v1h-1v-1h1V9h1V7h-1V6h-1z',
  fullscreen: 'M1 1h5v2H3v3H1zM10 1h5v5h-2V3h-3zM1 10h2v3h3v2H1zM13 10h2v5h-5v-2h3z',
  leave:
    'M2 1h2v1H2zM12 1h2v1H12zM1 2h4v1H1zM11 2h4v1H11zM1 3h5v1H1zM10 3h5v1H10zM2 4h5v1H2zM9 4h5v1H9zM3 5h10v1H3zM4 6h8v1H4zM5 7h6v2H5zM4 9h8v1H4z' +
    'M3 10h10v1H3zM2 11h5v1H2zM9 11h5v1H9zM1 12h5v1H1zM10 12h5v1H10zM1 13h4v1H1zM11 13h4v1H11zM2 14h2v1H2zM12 14h2v1H12z',
  use: 'M3 15V5h1V3h2V2h4v1h2v2h1v10h-2V6h-1V4H6v2H5v9zM7 9h2v2H7z',
  fly: 'M1 4h3v1h2v1h1v1h2V6h1V5h2V4h3v2h-2v1h-2v1h-1v1h-1v2H7V9H6V8H5V7H3V6H1z',
  crouch: 'M7 2h2v5h3v1h-1v1h-1v1H9v1H7v-1H6V9H5V8H4V7h3zM3 12h10v2H3z',
  jump: 'M7 2h2v1h1v1h1v1h1v1H9v5H7V6H4V5h1V4h1V3h1zM3 12h10v2H3z',
};

export function icon(name) {
  return drawing(kIcons[name]);
}
