import { blockName, picture, scrub, sideView, slider, sliceStrip } from '../figures/kit.js';

export default {
  scene: 'yard-4.json',
  view: '9.4,4.5,3.2,192,-0.45',
  options: { fov: 66 },
  state: { column: 160, step: 2 },
  controls: [
    scrub({ of: 'runs', label: 'Met so far' }),
    slider({ label: 'Slice', field: 'column' }),
  ],
  rows: [
    [
      picture({ title: 'The picture, and one slice', handles: ['column'] }),
      sliceStrip({ title: 'Rows, in the order of the walk', pick: false }),
    ],
    [sideView({ title: 'The slice from the side', handles: ['eye'] })],
  ],
  numbers: {},
  says: (now) => {
    const { runs } = now;
    if (runs.length === 0) return 'All rows are open.';
    const last = runs.at(-1);
    const what = blockName(now.slice, last);
    return `${runs.length} of ${now.slice.runs.length}: ${what}, rows ${last.first} to ${last.last}${last.layer ? ', where the sprite has texels' : ''}.`;
  },
};
