import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard-3.json',
  view: '2.5,3.15,3,80,-0.8',
  options: { fov: 66, detail: 'off' },
  state: { split: 0.45 },
  controls: [slider({ label: 'Look', eye: 'look', from: -1.2, to: 0.2, step: 0.05 })],
  rows: [
    [
      divider({
        left: { title: 'All tiles' },
        right: { title: 'Own tile left out', oldWay: 'The own tile is missing' },
      }),
    ],
  ],
  numbers: {},
  says: () => 'On the right the walk begins behind the first border.',
};
