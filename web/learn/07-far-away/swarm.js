// The long wall from its end, with levels of detail and without them.

import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'long-wall.json',
  view: '2.5,3.2,0.5,338',
  options: { fov: 66 },
  size: [160, 100],
  controls: [
    slider({ label: 'Walk along the wall', eye: 'x', from: 2.5, to: 8, step: 0.02, unit: 'units' }),
    slider({ label: 'Turn', eye: 'heading', from: 300, to: 360, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Levels of detail' },
        right: { title: 'Level 0 only', options: { detail: 'off' } },
      }),
    ],
  ],
  says: (now) => `You stand ${now.fixed(now.state.eye.x)} units from the wall’s western end.`,
};
