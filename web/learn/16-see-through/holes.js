// What is left of bars and glass if every face closes its rows.

import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/opaque-holes.js';
import { divider } from '../figures/kit.js';

export default {
  scene: 'yard-5.json',
  view: '8.8,5.4,0.5,40,0',
  options: { fov: 60 },
  size: [480, 300],
  world: byHandWorld,
  state: { split: 0.5 },
  controls: [],
  rows: [
    [
      divider({
        left: { title: 'The engine' },
        right: { title: 'Every face is opaque', draw: drawWith(draw) },
      }),
    ],
  ],
  numbers: {},
};
