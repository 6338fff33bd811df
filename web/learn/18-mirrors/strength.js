// The strength of a mirror: the floor's texel and the reflection, blended.

import { picture, slider, why } from '../figures/kit.js';

export default {
  scene: 'yard.json',
  view: '1.4,4.8,0.5,357,-0.06,hall',
  options: { fov: 60 },
  size: [480, 300],
  state: { column: 240, row: 196, mirrors: 1.5 },
  controls: [
    slider({ label: 'All mirrors, times', option: 'mirrors', from: 0, to: 2.8, step: 0.1 }),
  ],
  rows: [[picture({ handles: ['column', 'row'], mark: 'pixel' }), why()]],
  numbers: {},
};
