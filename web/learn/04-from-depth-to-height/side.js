import { fixed, picture, sideView, slider } from '../figures/kit.js';

export default {
  scene: 'yard-1.json',
  view: '3.4,6.9,0.5,330',
  options: { fov: 66 },
  state: { column: 120 },
  controls: [
    slider({ label: 'Column', field: 'column' }),
    slider({ label: 'Height of the eye', eye: 'z', from: 0.1, to: 0.9, step: 0.05, unit: 'units' }),
  ],
  rows: [[picture({ handles: ['column'] }), sideView({ handles: ['eye'], depth: 6, height: 1.3 })]],
  says: (now) => {
    const hit = now.slice.hits[0];
    if (hit === undefined) return `Column ${now.column} meets no block.`;
    return `Column ${now.column}: depth ${fixed(hit.depth)}, rows ${fixed(hit.topFrontRow, 1)} to ${fixed(hit.bottomFrontRow, 1)}.`;
  },
};
