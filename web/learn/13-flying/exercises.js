import { kOpening } from './block.js';

const kEdges = { ...kOpening, state: { column: 240 } };
const rowsOf = (slice, what) =>
  slice.runs
    .filter((run) => run.what === what)
    .reduce((sum, { first, last }) => sum + last + 1 - first, 0);

export default {
  roof: { ...kEdges, answer: ({ slice }) => rowsOf(slice, 'roof'), tolerance: 1 },
  nearRow: { ...kEdges, answer: ({ slice }) => slice.hits[0].topFrontRow, digits: 1 },
  farRow: { ...kEdges, answer: ({ slice }) => slice.hits[0].topBackRow, digits: 1 },
  from: { ...kEdges, answer: ({ slice }) => slice.hits[0].depth },
  to: { ...kEdges, answer: ({ slice }) => slice.hits[0].backDepth },
  pictureRows: { ...kEdges, answer: ({ slice }) => slice.size[1] },
  distance: { ...kEdges, answer: ({ slice }) => slice.projectionDistance, digits: 1 },
  least: {
    ...kEdges,
    answer({ slice: { hits, projectionDistance, size } }) {
      const [{ top, depth, backDepth }] = hits;
      return top + size[1] / 2 / projectionDistance / (1 / depth - 1 / backDepth);
    },
    tolerance: 0.02,
    digits: 2,
    unit: 'units',
  },
  order: {
    scene: 'yard-2.json',
    view: '9.3,7.4,2.2,222,-0.15',
    options: { fov: 66 },
    state: { column: 280 },
    answer: ({ slice }) => slice.runs.findIndex(({ what }) => what === 'roof'),
  },
};
