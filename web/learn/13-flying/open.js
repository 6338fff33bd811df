import { blockName, picture, scrub, sideView, slider, sliceStrip } from '../figures/kit.js';

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
    const { runs } = now;
    const all = now.slice.runs.length;
    if (runs.length === 0) return 'All rows are open.';
    const last = runs.at(-1);
    const rows =
      last.first === last.last ? `row ${last.first}` : `rows ${last.first} to ${last.last}`;
    const name = blockName(now.slice, last);
    return runs.length === all
      ? `${all} fills, and no row is open.`
      : `Fill ${runs.length} of ${all}: ${name}, ${rows}.`;
  },
};
