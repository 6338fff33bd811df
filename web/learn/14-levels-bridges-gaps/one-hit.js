import { divider } from '../figures/kit.js';

export default {
  scene: 'yard-3.json',
  view: '8.2,4.4,0.45,186,0.22',
  options: { fov: 66, detail: 'off' },
  state: { split: 0.5 },
  rows: [
    [
      divider({
        left: { title: 'All hits' },
        right: { title: 'One hit a level', oldWay: 'One hit per level' },
      }),
    ],
  ],
  numbers: {},
  says: () => 'On the right only the first block of each level is drawn.',
};
