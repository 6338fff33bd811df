// The answers of this chapter's exercises.

import { edgeRows } from './projections.js';

const place = { scene: 'long-wall.json', view: '20.5,3.2,0.5,290' };

// The greatest error of the cosine cure, in rows.
function worst(now, fov) {
  let greatest = 0;
  for (let column = 0; column < now.width; ++column) {
    const rows = edgeRows(column, { eye: now.eye, fov, width: now.width, height: now.height });
    greatest = Math.max(greatest, Math.abs(rows.cosine - rows.exact));
  }
  return greatest;
}

export default {
  'too-short': {
    ...place,
    answer: () => 100 * (1 - Math.SQRT1_2),
    tolerance: 0.5,
    unit: 'percent',
    digits: 1,
  },
  stretched: { ...place, answer: () => 4 / Math.PI, tolerance: 0.01, digits: 3 },
  'one-row': {
    ...place,
    answer(now) {
      let [least, most] = [30, 120];
      for (let i = 0; i < 40; ++i) {
        const middle = (least + most) / 2;
        if (worst(now, middle) > 1) most = middle;
        else least = middle;
      }
      return most;
    },
    tolerance: 2,
    unit: 'degrees',
    digits: 0,
  },
};
