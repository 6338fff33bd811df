// Build, and the light follows.

import { mapView, picture } from '../figures/kit.js';

export default {
  scene: 'sunlit.json',
  view: '11.2,11.2,4.6,245,-0.42',
  options: { fov: 66, light: 'off' },
  size: [400, 300],
  state: { edits: [['court', 0, 9, 6, 'o']] },
  rows: [
    [
      picture({ handles: [], mark: 'none', share: 1 }),
      mapView({
        paint: true,
        level: 0,
        blocks: ['o', 'c', '-', '|', '.'],
        handles: [],
        lit: false,
        order: false,
        marks: false,
        fov: false,
        ray: false,
        share: 1,
      }),
    ],
  ],
  numbers: {},
  says: (now) => `Cells painted: ${now.state.edits.length}.`,
};
