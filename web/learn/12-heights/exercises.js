import { seenHits } from './behind.js';
import { kPillars, laneEdits, laneScene } from './lane.js';

const kBehind = {
  scene: 'yard-2.json',
  view: '9.4,4.5,0.35,192,0.08',
  options: { fov: 66 },
  state: { column: 240 },
};
const kOver = { ...kBehind, view: '9.4,4.5,0.65,192,0.08', state: { column: 200 } };

const kLane = {
  scene: laneScene,
  view: '0.5,1.5,0.5,0',
  options: { fov: 66 },
  state: { edits: laneEdits([3, 4, 9]), column: 240 },
};
const thirdOf = ({ slice }) => slice.hits.filter(({ tile }) => tile[0] === kPillars[2].x).at(-1);

export default {
  hidden: { ...kBehind, answer: ({ slice }) => slice.hits.length - seenHits(slice).size },
  nearDepth: { ...kOver, answer: ({ slice }) => slice.hits[0].depth, digits: 2 },
  nearTop: { ...kOver, answer: ({ slice }) => slice.hits[0].top },
  bedDepth: { ...kOver, answer: ({ slice }) => slice.hits[1].depth, digits: 2 },
  rise: {
    ...kOver,
    answer: ({ slice: { eye, hits } }) =>
      eye.z + ((hits[0].top - eye.z) * hits[1].depth) / hits[0].depth,
    tolerance: 0.01,
    digits: 2,
    unit: 'units',
  },
  top: { ...kLane, answer: (now) => thirdOf(now).topFrontRow, tolerance: 1, digits: 0 },
  pillarTop: { ...kLane, answer: (now) => thirdOf(now).top },
  pillarDepth: { ...kLane, answer: (now) => thirdOf(now).depth },
  horizon: { ...kLane, answer: ({ slice }) => slice.horizonRow },
  distance: { ...kLane, answer: ({ slice }) => slice.projectionDistance, digits: 1 },
};
