import { divider, slider } from '../figures/kit.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/mirrored-yard.js';

export default {
  scene: 'yard-1.json',
  view: '6.8,7.6,0.5,338',
  options: { fov: 66 },
  state: { split: 0.5 },
  world: byHandWorld,
  controls: [slider({ label: 'Turn', eye: 'heading', from: 0, to: 359, step: 1, unit: '°' })],
  rows: [
    [
      divider({
        left: { title: 'Right is right' },
        right: { title: 'Right is left', draw: drawWith(draw, { fov: 66 }) },
        mark: 'none',
      }),
    ],
  ],
};
