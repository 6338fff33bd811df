// Water that a box of cells becomes: a pool with a rim of blocks, or a pond in the floor.
// Takes a document and a box; gives changes. Changes nothing itself.
//
//     poolChanges(scene, 0, { from, to }, '#')   // in a rim of that kind, to swim if it is high
//     pondChanges(scene, 0, { from, to })        // level with the ground, to wade
//     withoutPond(scene, 0, { from, to })

import { cellChanges, kEmpty } from './cells.js';
import { draftOf, kindFor, kindOf } from './kinds.js';
import { nameWithHeights, withHeight } from './shapes.js';
import { tileChanges } from './tiles.js';
import { cellsIn } from './tools/strokes.js';

const kRim = 0.5; // of a block: what players walk up
const kSurface = 0.4; // of the highest water, in its level
const kWater = { colour: '#2f7f78', sight: 7 };
const kKinds = {
  water: { top: kSurface, water: kWater, faces: { top: 'water-clear' } },
  'water below': { water: kWater, faces: {} },
};
const kPond = 'water-surface'; // shipped, as is the pool's

// The walls are of that kind, the highest ones half as high; water fills what they enclose.
export function poolChanges(scene, map, box, sign) {
  const kind = kindOf(scene, map, sign);
  if (kind === null) return [];
  const draft = draftOf(scene);
  const signFor = (name, blueprint) => {
    const found = kindFor(draft, map, name, blueprint);
    draft.take(found.changes);
    return found.sign;
  };
  const { from, to } = box;
  const rim = withHeight(kind.blueprint, 'top', kRim) ?? kind.blueprint;
  const cells = cellsIn(box).map(({ level, x, y }) => {
    const isWall = x === from.x || x === to.x || y === from.y || y === to.y;
    const isTop = level === to.level;
    const name = isTop ? 'water' : 'water below';
    const wall = isTop ? signFor(nameWithHeights(kind.name, rim), rim) : sign;
    return { layer: level, x, y, sign: isWall ? wall : signFor(name, kKinds[name]) };
  });
  return [...draft.changes(), ...cellChanges(scene, map, cells)];
}

// What stands there on the ground goes.
export function pondChanges(scene, map, box) {
  const { floor } = scene.value.maps[map];
  const texture = floor?.water ?? kPond;
  const tiles = tileChanges(scene, map, 'floor', tilesIn(box), texture);
  const isNew = floor?.water === undefined && tiles.length > 0;
  const water = isNew ? [{ path: ['maps', map, 'floor', 'water'], value: texture }] : [];
  return [...tiles, ...water, ...withoutBlocks(scene, map, box)];
}

export function withoutPond(scene, map, box) {
  return tileChanges(scene, map, 'floor', tilesIn(box), null);
}

const tilesIn = ({ from, to }) => cellsIn({ from: { ...from, level: 0 }, to: { ...to, level: 0 } });

function withoutBlocks(scene, map, box) {
  const cells = tilesIn(box).map(({ x, y }) => ({ layer: 0, x, y, sign: kEmpty }));
  return cellChanges(scene, map, cells);
}
