// One view, two kinds of light.

import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'sunlit.json',
  view: '10.8,7.8,1.2,225,-0.1',
  options: { fov: 66 },
  size: [480, 300],
  state: { split: 0.4 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: 90, to: 320, step: 1, unit: '°' })],
  rows: [
    [
      divider({
        left: { title: 'Light by distance', options: { light: 'on', baked: 'off' } },
        right: { title: 'Sun, sky and a lamp', options: { light: 'off', baked: 'on' } },
      }),
    ],
  ],
  numbers: {},
};
