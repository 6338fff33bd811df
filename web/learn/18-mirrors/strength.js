// The strength of a mirror: the floor's texel and the reflection, blended.

import { picture, slider, why } from '../figures/kit.js';

const strengthAt = ({ slice, row }) =>
  slice.mirrors.find(({ first, last }) => first <= row && row <= last)?.strength ?? 0;

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
  says: (now) => {
    const strength = strengthAt(now);
    if (strength === 0) return 'The marked pixel is no mirror.';
    return `The mirror's strength is ${strength} of 255: ${Math.round((100 * strength) / 255)} % of the colour is the reflection's.`;
  },
};
