// A mirror beside a flipped picture.

import { divider } from '../figures/kit.js';

export default {
  scene: 'slab.json',
  view: '3,4,1.8,2,-0.5',
  options: { fov: 60 },
  size: [480, 300],
  state: { split: 0.5 },
  controls: [],
  rows: [
    [
      divider({
        left: { title: 'The mirrored eye' },
        right: { title: 'Rows flipped', oldWay: 'A flipped reflection' },
      }),
    ],
  ],
  numbers: {},
};
