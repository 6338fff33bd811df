import { picture, scrub, sideView, slider, sliceStrip } from '../figures/kit.js';

export default {
  scene: 'yard-2.json',
  view: '9.3,7.4,2.2,222,-0.15',
  options: { fov: 66 },
  state: { column: 280, step: 5 },
  controls: [
    scrub({ of: 'runs', label: 'Filled so far' }),
    slider({ label: 'Eye', eye: 'z', from: 0.3, to: 3, step: 0.05, unit: 'units' }),
  ],
  rows: [
    [
      picture({ title: 'The picture, and one slice', handles: ['column'] }),
      sliceStrip({ title: 'Rows filled, in order', pick: false }),
    ],
    [sideView({ title: 'The slice from the side', handles: ['eye'] })],
  ],
  numbers: { runs: (now) => String(now.slice.runs.length) },
  says: (now) => {
    const filled = now.runs.reduce((sum, { first, last }) => sum + last + 1 - first, 0);
    const open = now.height - filled;
    if (open === 0) return `No row is open after ${now.slice.runs.length} fills: the walk ends.`;
    return `${filled} rows are filled, ${open} are open.`;
  },
};
