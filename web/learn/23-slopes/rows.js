// The rows of a ramp in one column: by the formula, and by the engine.

import { fixed, numberTable, picture, sideView, sliceStrip, slider } from '../figures/kit.js';
import { kFov, planeOf } from './plane.js';

const isRamp = ({ blueprint }) => ['low ramp', 'high ramp'].includes(blueprint);

// The ends of the ramp's two tiles in this slice.
const endsOf = (now) =>
  now.slice.hits.filter(isRamp).flatMap((hit) => [
    { tile: hit.tile, end: 'near', depth: hit.depth, row: hit.topFrontRow },
    { tile: hit.tile, end: 'far', depth: hit.backDepth, row: hit.topBackRow },
  ]);

const rampRows = (now) =>
  now.slice.runs.filter(({ what, hit }) => what === 'roof' && isRamp(now.slice.hits[hit]));

const aboveHorizon = (now) =>
  rampRows(now).reduce(
    (sum, { first, last }) =>
      sum + Math.max(0, Math.min(last + 1, Math.ceil(now.slice.horizonRow)) - first),
    0,
  );

export default {
  scene: 'ramps.json',
  view: '1.5,3.6,0.5,8',
  options: { fov: kFov },
  size: [480, 300],
  state: { column: 240, row: 140 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: -40, to: 40, step: 1, unit: '°' })],
  rows: [
    [
      picture({ handles: ['column'], share: 3 }),
      sliceStrip({ names: true, rows: true, share: 2, title: 'The rows of this slice' }),
    ],
    [
      sideView({ handles: ['eye'], depth: 6, height: 1.6, tall: 280, share: 3 }),
      numberTable({
        share: 2,
        caption: 'The ramp’s edges',
        columns: [
          { head: 'tile, end', value: ({ tile, end }) => `(${tile.join(', ')}) ${end}` },
          { head: 'depth', class: 'number', value: ({ depth }) => fixed(depth) },
          {
            head: 'formula',
            class: 'number',
            value: ({ depth }, index, now) => fixed(planeOf(now).rowAt(depth), 1),
          },
          { head: 'engine', class: 'number', value: ({ row }) => fixed(row, 1) },
        ],
        items: endsOf,
      }),
    ],
  ],
  numbers: {
    near: (now) => fixed(endsOf(now)[0]?.row, 1),
    far: (now) => fixed(endsOf(now).at(-1)?.row, 1),
    above: (now) => String(aboveHorizon(now)),
    runs: (now) => String(rampRows(now).length),
  },
  says(now) {
    const runs = rampRows(now);
    if (runs.length === 0) return 'This slice shows nothing of the ramp’s top.';
    return `The ramp fills the rows from ${Math.min(...runs.map(({ first }) => first))} to ${Math.max(...runs.map(({ last }) => last))}; ${aboveHorizon(now)} of them lie above the true horizon.`;
  },
};
