import { fixed, numberTable, picture, sideView, slider } from '../figures/kit.js';
import { kOpening } from './block.js';

const blockOf = ({ slice }) => slice.hits[0] ?? null;

function edgesOf(now) {
  const hit = blockOf(now);
  if (hit === null) return [];
  return [
    { edge: 'top, near', z: hit.top, depth: hit.depth, row: hit.topFrontRow },
    { edge: 'top, far', z: hit.top, depth: hit.backDepth, row: hit.topBackRow },
    { edge: 'bottom, near', z: hit.bottom, depth: hit.depth, row: hit.bottomFrontRow },
    { edge: 'bottom, far', z: hit.bottom, depth: hit.backDepth, row: hit.bottomBackRow },
  ];
}

const showsOf = (now) => {
  const shown = now.slice.runs.filter(({ hit }) => hit === 0).map(({ what }) => what);
  return ['side', 'roof', 'underside'].filter((what) => shown.includes(what));
};

export default {
  ...kOpening,
  state: { column: 240 },
  // The eye looks at the block, so that it stays in the picture.
  check: ({ eye }) => ({ eye: { look: (0.75 - eye.z) / 3 } }),
  controls: [slider({ label: 'Eye', eye: 'z', from: 0.1, to: 2.4, step: 0.05, unit: 'units' })],
  rows: [
    [
      sideView({
        title: 'Four edges from the side',
        handles: ['eye'],
        edges: true,
        runs: true,
        depth: 4.4,
        height: 2.2,
        plane: false,
      }),
      picture({ title: 'What the eye sees', handles: ['column'] }),
    ],
    [
      numberTable({
        title: 'The four edges',
        caption: 'Rows grow downwards',
        columns: [
          { head: 'Edge', value: ({ edge }) => edge },
          { head: 'Height', value: ({ z }) => fixed(z), class: 'number' },
          { head: 'Depth', value: ({ depth }) => fixed(depth), class: 'number' },
          { head: 'Row', value: ({ row }) => fixed(row, 1), class: 'number' },
        ],
        items: edgesOf,
      }),
    ],
  ],
  numbers: {
    roof: (now) =>
      String(
        now.slice.runs
          .filter(({ what }) => what === 'roof')
          .reduce((sum, { first, last }) => sum + last + 1 - first, 0),
      ),
  },
  says: (now) => {
    const hit = blockOf(now);
    if (hit === null) return 'This slice passes no block.';
    const where =
      now.eye.z > hit.top
        ? 'The eye is above the top'
        : now.eye.z < hit.bottom
          ? 'The eye is below the bottom'
          : 'The eye is between bottom and top';
    const shows = showsOf(now);
    return `${where}: the block shows ${shows.length === 0 ? 'nothing' : `its ${shows.join(' and its ')}`}.`;
  },
};
