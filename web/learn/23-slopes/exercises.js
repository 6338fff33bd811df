import { kFov, planeOf } from './plane.js';

const kUp = {
  scene: 'ramps.json',
  view: '1.5,4.5,0.5,0',
  options: { fov: kFov },
  size: [480, 300],
};
const kSteepest = 0.75; // src/world/slope.h

export default {
  // How far straight ahead up the ramp moves the horizon.
  shifted: {
    ...kUp,
    answer: (now) => planeOf(now, (now.width - 1) / 2).shift,
    tolerance: 0.5,
    unit: 'rows',
    digits: 1,
  },
  distance: { ...kUp, answer: (now) => now.slice.projectionDistance, digits: 1 },
  // The row of the ramp's upper edge.
  'upper-edge': {
    ...kUp,
    answer: (now) => now.source.project(6, 4.5, 1).y,
    tolerance: 0.6,
    digits: 1,
  },
  // By how many rows the horizon moves at a heading of sixty degrees.
  turned: {
    ...kUp,
    view: '1.5,4.5,0.5,60',
    answer: (now) => planeOf(now, (now.width - 1) / 2).shift,
    tolerance: 0.5,
    unit: 'rows',
    digits: 1,
  },
  // How many tiles a ramp of so much height needs.
  tiles: {
    ...kUp,
    answer: () => Math.ceil(2 / kSteepest),
    unit: 'tiles',
    digits: 0,
  },
};
