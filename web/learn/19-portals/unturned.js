// What a portal shows if the ray is turned and the eye's offset is not.

import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/offset-not-turned.js';
import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard.json',
  view: '6.9,6.2,0.5,78,0',
  options: { fov: 60 },
  size: [480, 300],
  world: byHandWorld,
  state: { split: 0.5 },
  controls: [
    slider({ label: 'Eye, west to east', eye: 'x', from: 6.2, to: 9.2, step: 0.1 }),
    slider({ label: 'Turn', eye: 'heading', from: 60, to: 120, step: 1, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'The engine' },
        right: { title: 'Offset not turned', draw: drawWith(draw) },
      }),
    ],
  ],
  numbers: {},
};
