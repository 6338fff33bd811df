// The sides of a ramp: triangles and trapezoids, column by column.

import { clamp, fixed, picture, polygon, sliceStrip, slider } from '../figures/kit.js';
import { kFov } from './plane.js';

// The southern side of a tile of the ramp, as corners of the world.
const kSides = [
  [
    [4, 6, 0],
    [5, 6, 0],
    [5, 6, 0.5],
  ],
  [
    [5, 6, 0],
    [6, 6, 0],
    [6, 6, 1],
    [5, 6, 0.5],
  ],
];

const outlines = (now) =>
  kSides
    .map((corners) => corners.map(([x, y, z]) => now.source.project(x, y, z)))
    .filter((corners) => corners.every((corner) => corner !== null && corner.depth > 0))
    .map((corners) =>
      polygon(
        corners.map(({ x, y }) => [x, y]),
        'fill="none" stroke="var(--lit)" stroke-width="2"',
      ),
    )
    .join('');

const sideRun = (now) =>
  now.slice.runs.find(
    ({ what, hit }) => what === 'side' && now.slice.hits[hit].blueprint.endsWith('ramp'),
  );

export default {
  scene: 'ramps.json',
  view: '3.6,7.9,0.5,300',
  options: { fov: kFov },
  size: [480, 300],
  state: { column: 250 },
  controls: [
    slider({
      label: 'Step aside',
      eye: 'x',
      from: 2,
      to: 7,
      step: 0.1,
      says: (x) => `x = ${fixed(x, 1)}`,
    }),
  ],
  check: ({ eye }) => ({ eye: { x: clamp(eye.x, 1.3, 8) } }),
  rows: [
    [
      picture({ handles: ['column', 'turn'], over: outlines, share: 3 }),
      sliceStrip({ names: true, share: 2, title: 'This slice' }),
    ],
  ],
  numbers: {},
  says(now) {
    const run = sideRun(now);
    if (run === undefined) return 'This slice shows no side of a ramp.';
    const hit = now.slice.hits[run.hit];
    return `In this column the side of the ${hit.blueprint} begins in row ${fixed(hit.topFrontRow, 1)} and ends in row ${fixed(hit.bottomFrontRow, 1)}.`;
  },
};
