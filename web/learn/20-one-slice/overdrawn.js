// A portal behind stained glass, drawn last and therefore over it.

import { divider } from '../figures/kit.js';

export default {
  scene: 'yard.json',
  view: '9,2.1,0.5,14,0',
  options: { fov: 80 },
  state: { split: 0.36 },
  rows: [
    [
      divider({
        left: { title: 'Nearest shows' },
        right: { title: 'Last drawn shows', oldWay: 'Portals drawn over' },
      }),
    ],
  ],
  says: () =>
    'On the right there is a hole in the window: the hall behind the portal covers the glass.',
};
