// Why a pixel has its colour: texel, light, fog.

import { picture, why } from '../figures/kit.js';

export default {
  scene: 'long-wall.json',
  view: '6.5,4.5,0.5,345',
  options: { fov: 66 },
  size: [480, 300],
  state: { column: 268, row: 146 },
  rows: [[picture({ handles: ['column', 'row', 'turn'], mark: 'pixel', share: 1.2 }), why()]],
  numbers: {
    north: (now) => now.fixed(now.blueprints.get('#').faces.north.light),
  },
  says: (now) =>
    now.pick === null || now.pick.texel === null
      ? 'This pixel shows the sky: it has no depth, so no light and no fog.'
      : `Depth ${now.fixed(now.pick.depth)}: the light is ${now.pick.texel.light} of 256, the haze ${now.pick.texel.fog} of 255.`,
};
