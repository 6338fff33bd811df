// Day and night in the same yard.

import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard-2.json',
  view: '7.4,7.5,0.5,235,0.12',
  options: { fov: 66 },
  size: [480, 300],
  controls: [
    slider({
      label: 'Walk',
      eye: 'x',
      from: 3.5,
      to: 9.5,
      step: 0.05,
      says: (value) => `x = ${value.toFixed(2)}`,
    }),
    slider({ label: 'Turn', eye: 'heading', from: 0, to: 360, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Day' },
        right: { title: 'Night', options: { lightPreset: 'night', multiplier: '2.5' } },
      }),
    ],
  ],
  says: (now) => {
    const [hit] = now.slice.hits;
    return hit === undefined
      ? 'The middle column shows no block.'
      : `In the middle column the nearest block is at depth ${now.fixed(hit.depth)}.`;
  },
};
