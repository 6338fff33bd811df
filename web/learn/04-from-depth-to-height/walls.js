import { divider, slider } from '../figures/kit.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/chapter-04.js';

export default {
  scene: 'yard-1.json',
  view: '3.4,6.9,0.5,330',
  options: { fov: 66 },
  world: byHandWorld,
  controls: [
    slider({ label: 'Turn', eye: 'heading', from: 0, to: 359, step: 1, unit: '°' }),
    slider({ label: 'Height of the eye', eye: 'z', from: 0.1, to: 0.9, step: 0.05, unit: 'units' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'The engine' },
        right: { title: 'Your raycaster', draw: drawWith(draw, { fov: 66 }) },
        mark: 'none',
      }),
    ],
  ],
};
