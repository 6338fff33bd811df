// Cells of a scene in the document's terms: sizes of maps, and the changes that put signs into
// cells, also where a level or a floor of tiles must first be made.
// Takes a document; gives changes. Changes nothing itself, and knows no tool.
//
//     sizeOf(scene, 0)                                        // {width, depth, levels}
//     cellChanges(scene, 0, [{ layer: 3, x: 1, y: 2, sign: '#' }])
//     isInside(scene, 0, { x: 1, y: 2 })
//     clipped(scene, 0, { from, to })                         // the part of a box within the map
//     outsideWords(scene, 0, cell)                            // why nothing can stand there
//     const signAt = signReader(scene, 0);    signAt(level, x, y)   // for many cells

import { signsOf } from '../engine/signs.js';
import { entriesOf, kEmpty, kMostLevels, levelsOf, sizeOfMap } from './levels.js';

export { kEmpty, kMostLevels };

export function sizeOf({ value: { maps } }, map) {
  return { ...sizeOfMap(maps[map]), levels: levelsOf(maps[map]).length };
}

// Reads many cells: what scene.sign() says, each row split once.
export function signReader(scene, map) {
  const layers = new Map();
  return (layer, x, y) => {
    if (!layers.has(layer)) layers.set(layer, { rows: scene.rows(map, layer), split: [] });
    const { rows, split } = layers.get(layer);
    if (rows[y] === undefined) return kEmpty;
    split[y] ??= signsOf(rows[y]);
    return split[y][x] ?? kEmpty;
  };
}

export function isInside(scene, map, { x, y, level = 0 }) {
  const { width, depth } = sizeOf(scene, map);
  return x >= 0 && y >= 0 && x < width && y < depth && level >= 0 && level < kMostLevels;
}

// The part of a box of cells {from, to} that lies within the map; null if none does.
export function clipped(scene, map, { from, to }) {
  const { width, depth } = sizeOf(scene, map);
  const least = (one) => ({
    level: Math.max(0, one.level),
    x: Math.max(0, one.x),
    y: Math.max(0, one.y),
  });
  const most = (one) => ({
    level: Math.min(kMostLevels - 1, one.level),
    x: Math.min(width - 1, one.x),
    y: Math.min(depth - 1, one.y),
  });
  const box = { from: least(from), to: most(to) };
  return ['level', 'x', 'y'].every((axis) => box.from[axis] <= box.to[axis]) ? box : null;
}

export const kEdgeWords = 'The map ends here. Map > Size in the panel makes it larger.';
const kTopWords = `A map ends above level ${kMostLevels - 1}.`;
const kGroundWords = 'Nothing lies below level 0: it stands on the ground.';

// Words that say why no block can stand in a cell; undefined if one can.
export function outsideWords(scene, map, cell) {
  if (cell === null || isInside(scene, map, cell)) return undefined;
  if (!isInside(scene, map, { ...cell, level: 0 })) return kEdgeWords;
  return cell.level < 0 ? kGroundWords : kTopWords;
}

// Cells outside the map are left out. Of several changes of a cell the last one counts.
export function cellChanges(scene, map, cells) {
  const { width, depth } = sizeOf(scene, map);
  const inside = cells.filter(({ layer, x, y }) => {
    const isLayer = typeof layer !== 'number' || (layer >= 0 && layer < kMostLevels);
    return isLayer && x >= 0 && y >= 0 && x < width && y < depth;
  });
  const signAt = signReader(scene, map);
  const layers = new Set();
  for (const { layer, x, y, sign } of inside)
    if (!layers.has(layer) && signAt(layer, x, y) !== sign) layers.add(layer);
  if (layers.size === 0) return [];
  const empty = Array.from({ length: depth }, () => kEmpty.repeat(width));
  return [
    ...missingLevels(scene, map, layers, empty),
    ...['floor', 'ceiling']
      .filter((layer) => layers.has(layer) && scene.rows(map, layer).length === 0)
      .map((layer) => tilesFor(scene, map, layer, empty)),
    { map, cells: inside },
  ];
}

// From the top down, so that no entry moves before its turn.
function missingLevels(scene, map, layers, empty) {
  const path = (entry) => ['maps', map, 'levels', entry];
  const levels = levelsOf(scene.value.maps[map]);
  const numbers = [...layers].filter((layer) => typeof layer === 'number');
  const changes = [];
  for (let level = levels.length; level <= Math.max(-1, ...numbers); ++level) {
    const entry = entriesOf(scene.value.maps[map]) + level - levels.length;
    changes.push({ path: path(entry), value: layers.has(level) ? empty : [] });
  }
  const lacks = (level) => layers.has(level) && levels[level].rows.length === 0;
  const entries = levels
    .filter(({ isWritten }, level) => layers.has(level) && (!isWritten || lacks(level)))
    .map(({ entry }) => entry);
  for (const entry of [...new Set(entries)].reverse()) {
    // A fill or a repetition is written out, all of it.
    const [first, ...others] = [...levels.entries()]
      .filter(([, level]) => level.entry === entry)
      .map(([level, { rows }]) => (lacks(level) ? empty : rows));
    changes.push({ path: path(entry), value: first });
    for (const [index, value] of others.entries())
      changes.push({ path: path(entry + 1 + index), value, insert: true });
  }
  return changes;
}

function tilesFor(scene, map, layer, rows) {
  const present = scene.value.maps[map][layer];
  return typeof present === 'string'
    ? { path: ['maps', map, layer], value: { texture: present, legend: {}, tiles: rows } }
    : { path: ['maps', map, layer, 'tiles'], value: rows };
}
