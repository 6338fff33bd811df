import { divider, slider } from '../figures/kit.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/chapter-02.js';

export default {
  scene: 'yard-1.json',
  view: '2.2,6.9,0.5,330',
  options: { fov: 66 },
  world: byHandWorld,
  controls: [slider({ label: 'Turn', eye: 'heading', from: 0, to: 359, step: 1, unit: '°' })],
  rows: [
    [
      divider({
        left: { title: 'The engine' },
        right: { title: 'March, and grey', draw: drawWith(draw, { fov: 66 }) },
        mark: 'none',
      }),
    ],
  ],
};
