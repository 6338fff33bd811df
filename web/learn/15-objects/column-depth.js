import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard-4.json',
  view: '9.4,4.5,0.5,192,0.1',
  options: { fov: 66, detail: 'off' },
  state: { split: 0.335 },
  controls: [slider({ label: 'Eye', eye: 'z', from: 0.2, to: 2, step: 0.05, unit: 'units' })],
  rows: [
    [
      divider({
        left: { title: 'Rows that are open' },
        right: { title: 'One depth a column', oldWay: 'One depth per column' },
      }),
    ],
  ],
  numbers: {},
  says: () => 'On the right an object is seen only in columns whose first block is farther away.',
};
