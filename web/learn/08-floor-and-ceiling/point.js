// One pixel of the floor: its tile and its texel.

import { fixed, mapView, picture, textureView } from '../figures/kit.js';

const isFlat = ({ pick }) => pick?.what === 'floor' || pick?.what === 'ceiling';
const fraction = (number) => number - Math.floor(number);
const flat = (write) => (now) => (isFlat(now) ? write(now.pick) : '–');

export default {
  scene: 'yard-1.json',
  view: '2.4,6.9,0.5,330',
  options: { fov: 66, detail: 'off' },
  size: [480, 300],
  state: { column: 236, row: 236 },
  rows: [
    [
      picture({ handles: ['column', 'row', 'turn'], mark: 'pixel', share: 1.5 }),
      mapView({
        title: 'The floor from above',
        window: [2, 3, 5, 5],
        handles: ['eye'],
        lit: false,
        order: false,
        marks: false,
        fov: false,
        over(now, at) {
          if (!isFlat(now)) return '';
          const [x, y] = now.pick.point;
          const [left, top] = at(Math.floor(x), Math.floor(y));
          return (
            now.box(left, top, at.unit, at.unit, 'class="fig-outline now"') +
            now.dot(...at(x, y), 5, 'class="fig-edge-dot"')
          );
        },
      }),
      textureView({ grid: true, title: 'The tile’s texture' }),
    ],
  ],
  numbers: {
    tile: flat(({ tile }) => `(${tile.join(', ')})`),
    u: flat(({ point }) => fixed(fraction(point[0]))),
    v: flat(({ point }) => fixed(fraction(point[1]))),
  },
  says(now) {
    if (!isFlat(now)) return 'This pixel shows no floor: move the column or the row.';
    const { point, tile, texture, texel, depth } = now.pick;
    return `At depth ${fixed(depth)} the ray is over x = ${fixed(point[0])}, y = ${fixed(point[1])}: tile (${tile.join(', ')}), ${texture}, texel ${texel.u}, ${texel.v}.`;
  },
};
