// What hangs before a portal, if the view through the portal is drawn last.

import { divider } from '../figures/kit.js';

export default {
  scene: 'yard.json',
  view: '12.4,3.3,0.5,5,0',
  options: { fov: 60 },
  size: [480, 300],
  state: { split: 0.5, edits: [['yard', 0, 14, 3, '-']] },
  controls: [],
  rows: [
    [
      divider({
        left: { title: 'The engine' },
        right: { title: 'Portal drawn last', oldWay: 'Portals drawn over' },
      }),
    ],
  ],
  numbers: {},
};
