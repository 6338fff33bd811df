// Cells of a scene in the document's terms: sizes of maps, and the changes that put signs into
// cells, also where a level or a floor of tiles must first be made.
// Takes a document; gives changes. Changes nothing itself, and knows no tool.
//
//     sizeOf(scene, 0)                                        // {width, depth, levels}
//     cellChanges(scene, 0, [{ layer: 3, x: 1, y: 2, sign: '#' }])
//     isInside(scene, 0, { x: 1, y: 2 })
//     const signAt = signReader(scene, 0);    signAt(level, x, y)   // for many cells

import { signsOf } from '../engine/signs.js';

export const kMostLevels = 32; // of a map, as the engine has it
export const kEmpty = '.';

export function sizeOf(scene, map) {
  const { levels = [], floor, ceiling } = scene.value.maps[map];
  const rows = [...levels, floor?.tiles, ceiling?.tiles].find((layer) => layer?.length > 0) ?? [];
  return {
    width: rows.length === 0 ? 0 : signsOf(rows[0]).length,
    depth: rows.length,
    levels: levels.length,
  };
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
  return [...missingLayers(scene, map, layers), { map, cells: inside }];
}

function missingLayers(scene, map, layers) {
  const { width, depth, levels } = sizeOf(scene, map);
  const rows = Array.from({ length: depth }, () => kEmpty.repeat(width));
  const changes = [];
  const highest = Math.max(-1, ...[...layers].filter((layer) => typeof layer === 'number'));
  for (let level = 0; level <= highest; ++level) {
    const isNeeded = layers.has(level) && scene.rows(map, level).length === 0;
    if (level >= levels || isNeeded)
      changes.push({ path: ['maps', map, 'levels', level], value: isNeeded ? rows : [] });
  }
  for (const layer of ['floor', 'ceiling']) {
    if (!layers.has(layer) || scene.rows(map, layer).length > 0) continue;
    const present = scene.value.maps[map][layer];
    const isPlain = typeof present === 'string';
    const tiles = { texture: present, legend: {}, tiles: rows };
    changes.push(
      isPlain
        ? { path: ['maps', map, layer], value: tiles }
        : { path: ['maps', map, layer, 'tiles'], value: rows },
    );
  }
  return changes;
}
