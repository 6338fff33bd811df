import { kEye, kOptions } from './pixel.js';

const kView = { scene: 'yard.json', view: kEye, options: kOptions };
const kRow = 280;

export default {
  // How much of what stands behind the glass comes through.
  'through-the-glass': {
    ...kView,
    state: { column: 250, row: 170 },
    answer: (now) => (100 * (255 - now.pick.alpha)) / 255,
    tolerance: 0.6,
    unit: '%',
    digits: 1,
  },
  'glass-alpha': {
    ...kView,
    state: { column: 250, row: 170 },
    answer: (now) => now.pick.alpha,
  },
  // The depth at which the mirrored ray meets the beams.
  'beams-in-the-floor': {
    ...kView,
    state: { column: 250, row: kRow },
    answer: (now) => now.pick.reflection.depth,
    tolerance: 0.02,
    unit: 'units',
    digits: 2,
  },
  'floor-slope': {
    ...kView,
    state: { column: 250, row: kRow },
    answer: (now) => (now.slice.horizonRow - (kRow + 0.5)) / now.slice.projectionDistance,
    digits: 4,
  },
  // Where a tile behind the portal lies for somebody in the hall.
  'beyond-the-portal': {
    ...kView,
    state: { column: 250, row: 200 },
    answer(now) {
      const { from, to } = now.slice.portals[0];
      return now.pick.point[0] - to.tile[0] + from.tile[0];
    },
    tolerance: 0.02,
    digits: 2,
  },
  'point-beyond': {
    ...kView,
    state: { column: 250, row: 200 },
    answer: (now) => now.pick.point[0],
    digits: 2,
  },
};
