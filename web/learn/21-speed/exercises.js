import { setsOfColumn } from './cache.js';

const kPlace = { scene: 'corner.json', view: '5,5,0.5,45' };

export default {
  // Seven tenths of the time, three times as fast.
  'three-times': {
    ...kPlace,
    answer: () => 1 / (0.3 + 0.7 / 3),
    tolerance: 0.02,
    unit: 'times',
    digits: 2,
  },
  // The sets that a column of a wide picture falls into.
  sets: {
    ...kPlace,
    answer: () => setsOfColumn(1280, false),
    unit: 'sets',
    digits: 0,
  },
  // Rows filled for each tile walked, in a frame.
  'rows-each-tile': {
    scene: 'yard.json',
    view: '7.4,7.5,0.5,235,0.12',
    options: { fov: 66 },
    answer(now) {
      const { tilesWalked, rowsFilled } = now.source.traceFrame().totals;
      return rowsFilled / tilesWalked;
    },
    tolerance: 0.5,
    unit: 'rows',
    digits: 1,
  },
  'frame-tiles': {
    scene: 'yard.json',
    view: '7.4,7.5,0.5,235,0.12',
    options: { fov: 66 },
    answer: (now) => now.source.traceFrame().totals.tilesWalked,
  },
  'frame-rows': {
    scene: 'yard.json',
    view: '7.4,7.5,0.5,235,0.12',
    options: { fov: 66 },
    answer: (now) => now.source.traceFrame().totals.rowsFilled,
  },
};
