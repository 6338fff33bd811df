import { divider } from '../figures/kit.js';

export default {
  scene: 'yard-2.json',
  view: '7.4,7.5,0.5,235,0.12',
  options: { fov: 66, detail: 'off' },
  state: { split: 0.45 },
  rows: [
    [
      divider({
        left: { title: 'All hits' },
        right: { title: 'First hit of each level', oldWay: 'One hit per level' },
      }),
    ],
  ],
  numbers: {},
  says: () => 'On the right each level shows only the first block on the ray.',
};
