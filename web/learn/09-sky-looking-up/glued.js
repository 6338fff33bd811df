// A sky that does not follow the horizon.

import { draw } from '../by-hand/chapter-09.js';
import { draw as wrong } from '../by-hand/glued-sky.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { divider, slider } from '../figures/kit.js';

const kFov = 66;

export default {
  scene: 'yard-1.json',
  view: '1.6,6.7,0.5,345,0.3',
  options: { fov: kFov, light: 'off', fog: 'off' },
  size: [320, 200],
  world: byHandWorld,
  controls: [slider({ label: 'Look', eye: 'look', from: -0.5, to: 1, step: 0.02 })],
  rows: [
    [
      divider({
        left: { title: 'By the slope', draw: drawWith(draw, { fov: kFov }) },
        right: { title: 'By the row', draw: drawWith(wrong, { fov: kFov }) },
      }),
    ],
  ],
  says: (now) =>
    `Look is ${now.fixed(now.eye.look)}: the horizon is in row ${now.fixed(now.slice.horizonRow, 0)} of ${now.height}.`,
};
