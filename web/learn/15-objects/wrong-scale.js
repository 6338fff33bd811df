import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard-4.json',
  view: '9.4,4.5,1.4,192,-0.05',
  options: { fov: 66, detail: 'off' },
  state: { split: 0.335 },
  controls: [slider({ label: 'Eye', eye: 'z', from: 0.2, to: 3, step: 0.05, unit: 'units' })],
  rows: [
    [
      divider({
        left: { title: 'Scale of the walls' },
        right: { title: 'Scale of the picture', oldWay: 'Objects in a wrong scale' },
      }),
    ],
  ],
  numbers: {},
  says: () => 'On the right objects are scaled by the height of the picture.',
};
