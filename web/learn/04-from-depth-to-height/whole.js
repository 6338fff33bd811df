import { divider, slider } from '../figures/kit.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { draw } from '../by-hand/chapter-04.js';
import { draw as drawWhole } from '../by-hand/whole-heights.js';

export default {
  scene: 'long-wall.json',
  view: '12.5,10.4,3,300',
  options: { fov: 66 },
  size: [160, 100],
  world: byHandWorld,
  state: { split: 0.45 },
  controls: [
    slider({ label: 'Turn', eye: 'heading', from: 270, to: 320, step: 1, unit: '°' }),
    slider({ label: 'Height of the eye', eye: 'z', from: 0.5, to: 3, step: 0.05, unit: 'units' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Rounded last', draw: drawWith(draw, { fov: 66 }) },
        right: { title: 'Rounded first', draw: drawWith(drawWhole, { fov: 66 }) },
        mark: 'none',
      }),
    ],
  ],
};
