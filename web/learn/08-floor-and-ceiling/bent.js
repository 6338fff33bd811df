// The floor with distances taken for depths.

import { draw } from '../by-hand/chapter-08.js';
import { draw as wrong } from '../by-hand/floor-by-distance.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { divider, slider } from '../figures/kit.js';

const kFov = 90;

export default {
  scene: 'long-wall.json',
  view: '20.5,5.5,0.5,270',
  options: { fov: kFov, light: 'off', fog: 'off' },
  size: [320, 200],
  world: byHandWorld,
  state: { split: 0.35 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: 180, to: 360, unit: '°' })],
  rows: [
    [
      divider({
        left: { title: 'Depth', draw: drawWith(draw, { fov: kFov }) },
        right: { title: 'Distance for depth', draw: drawWith(wrong, { fov: kFov }) },
      }),
    ],
  ],
};
