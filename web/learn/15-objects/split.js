import { fixed, picture, scrub, sideView, slider, sliceStrip } from '../figures/kit.js';

export default {
  scene: 'yard-4.json',
  view: '9.4,4.5,3.2,192,-0.62',
  options: { fov: 66 },
  state: { column: 160, step: 3 },
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
    const filled = now.runs
      .filter(({ layer }) => !layer)
      .reduce((sum, { first, last }) => sum + last + 1 - first, 0);
    const [object] = now.slice.objects;
    if (object === undefined) return 'This slice meets no object.';
    return `The tree stands at depth ${fixed(object.depth)}. ${now.height - filled} rows are open behind it and above.`;
  },
};
