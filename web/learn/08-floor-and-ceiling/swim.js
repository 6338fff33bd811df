// Rows that count from their upper edges: the floor does not fit the walls.

import { draw } from '../by-hand/chapter-08.js';
import { draw as wrong } from '../by-hand/half-row.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { divider, slider } from '../figures/kit.js';

const kFov = 66;

export default {
  scene: 'long-wall.json',
  view: '20.5,7.5,0.5,270',
  options: { fov: kFov, light: 'off', fog: 'off' },
  size: [160, 100],
  world: byHandWorld,
  controls: [
    slider({
      label: 'Step forward',
      eye: 'y',
      from: 3,
      to: 7.5,
      step: 0.02,
      says: (value, now) => `${now.fixed(value - 1)} units from the wall`,
    }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Middle of the row', draw: drawWith(draw, { fov: kFov }) },
        right: { title: 'Its upper edge', draw: drawWith(wrong, { fov: kFov }) },
      }),
    ],
  ],
};
