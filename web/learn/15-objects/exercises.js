import { kView, nearestDepth } from './order.js';

const kOptions = { fov: 66 };
const kSplit = {
  scene: 'yard-4.json',
  view: '9.4,4.5,3.2,192,-0.62',
  options: kOptions,
  state: { column: 160 },
};
const treeOf = ({ slice }) => slice.objects[0];

export default {
  depth: { ...kSplit, answer: (now) => treeOf(now).depth, digits: 3 },
  distance: { ...kSplit, answer: (now) => now.slice.projectionDistance, digits: 1 },
  rows: {
    ...kSplit,
    answer(now) {
      const { top, bottom, depth } = treeOf(now);
      return ((top - bottom) * now.slice.projectionDistance) / depth;
    },
    tolerance: 1.5,
    digits: 0,
  },
  first: {
    scene: 'yard-4.json',
    view: kView,
    options: kOptions,
    answer: nearestDepth,
    tolerance: 0.01,
    digits: 2,
  },
  width: { ...kSplit, answer: (now) => now.width },
  columns: {
    ...kSplit,
    answer: (now) => (2 * now.slice.projectionDistance) / now.width,
    tolerance: 0.02,
    digits: 2,
  },
};
