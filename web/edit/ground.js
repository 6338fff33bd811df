// The ground that things stand on: the floor, or the top of a block.
// Takes a document and a point; gives a height.
//
//     groundAt(scene, 0, { x: 3.5, y: 4.5, z: 1 })      // of what stands there at that height

import { kMostLevels } from './cells.js';
import { kindsOf } from './kinds.js';

// Within a block it is the first free place above, else the first top below.
export function groundAt(scene, map, { x, y, z }) {
  const kinds = new Map(kindsOf(scene, map).map(({ sign, blueprint }) => [sign, blueprint]));
  const spanIn = (level) => {
    const blueprint = kinds.get(scene.sign(map, level, Math.floor(x), Math.floor(y)));
    const span = blueprint === undefined ? null : spanAt(blueprint, x % 1, y % 1);
    return span && span.map((height) => level + height);
  };
  let up = z;
  for (let level = Math.floor(z); level < kMostLevels; ++level) {
    const span = spanIn(level);
    if (span === null || span[0] > up || span[1] <= up) break;
    [, up] = span;
    if (up < level + 1) break;
  }
  if (up > z) return up;
  for (let level = Math.floor(z); level >= 0; --level) {
    const span = spanIn(level);
    if (span !== null && span[1] <= z) return span[1];
  }
  return 0;
}

const kAlong = {
  east: (u) => u,
  west: (u) => 1 - u,
  south: (_, v) => v,
  north: (_, v) => 1 - v,
};
const kIsIn = {
  'north-west': (u, v) => u + v <= 1,
  'north-east': (u, v) => u >= v,
  'south-east': (u, v) => u + v >= 1,
  'south-west': (u, v) => u <= v,
};

// From the underside to the top of a block at a place of its tile; null if it is not there.
function spanAt({ bottom = 0, top = 1, rise, plan, diagonal, water }, u, v) {
  const [west, north, east, south] = plan ?? [0, 0, 1, 1];
  if (water || u < west || u > east || v < north || v > south) return null;
  if (diagonal !== undefined && kIsIn[diagonal]?.(u, v) === false) return null;
  const at = (height) => {
    if (!Array.isArray(height)) return height;
    return height[0] + (height[1] - height[0]) * (kAlong[rise]?.(u, v) ?? 0.5);
  };
  return [at(bottom), at(top)];
}
