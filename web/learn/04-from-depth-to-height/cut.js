import { divider, slider } from '../figures/kit.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/chapter-04.js';
import { draw as drawCut } from '../by-hand/cut-heights.js';

export default {
  scene: 'yard-1.json',
  view: '2.4,7.35,0.25,20',
  options: { fov: 66 },
  size: [240, 150],
  world: byHandWorld,
  state: { split: 0.78 },
  controls: [
    slider({ label: 'Height of the eye', eye: 'z', from: 0.1, to: 0.9, step: 0.05, unit: 'units' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'By edges', draw: drawWith(draw, { fov: 66 }) },
        right: { title: 'Cut heights', draw: drawWith(drawCut, { fov: 66 }) },
        mark: 'none',
      }),
    ],
  ],
};
