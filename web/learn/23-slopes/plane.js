// The gentle ramp of ramps.json, as the ray of a column meets it: the page's own numbers.

import { distanceOf, rayOf } from '../figures/kit.js';

export const kFov = 90;
export const kRise = 0.5; // of the ramp, per unit to the east
export const kFoot = 4; // x where it begins, at height 0
export const kHead = 6; // x where it ends

// The ramp's plane in this moment, for a column: `along` is the ray's part along the rise, `above`
// the height of the extended plane over the eye, `shift` the rows between the horizons.
export function planeOf(now, column = now.column) {
  const distance = distanceOf(kFov, now.width);
  const [along] = rayOf(now.eye, column, now.size, kFov);
  const horizon = now.height / 2 + now.eye.look * now.height;
  const shift = distance * kRise * along;
  const above = kRise * (now.eye.x - kFoot) - now.eye.z;
  const own = horizon - shift;
  return {
    along,
    distance,
    horizon,
    shift,
    above,
    own,
    rowAt: (depth) => own - (distance * above) / depth,
    depthAt: (row) => (distance * above) / (own - row),
    depthOf: (x) => (x - now.eye.x) / along,
  };
}
