// The levels of a map as rows of signs, also those that are filled or repeated instead of written.
// Takes a map as the scene says it; gives its size, and each level's rows. Changes nothing.
//
//     sizeOfMap(map)          // {width, depth}: 0, 0 if nothing tells
//     levelsOf(map)           // [{entry, isWritten, rows}] from the ground up
//     entriesOf(map)          // how many entries `levels` has; a repetition is one
//
// `entry` is the place in `levels`. The rows of a level that is written stand there as they are;
// all others are worked out. What a scene says wrongly counts as nothing: the engine tells it.

import { signsOf } from '../engine/signs.js';

export const kMostLevels = 32; // of a map, as the engine has it
export const kEmpty = '.';
const kMostCells = 1 << 22; // of a level that is worked out
const kKept = ' '; // in rows over a fill: what the fill put there

const isRows = (entry) => Array.isArray(entry) && entry.every((row) => typeof row === 'string');

export const entriesOf = (map) => (Array.isArray(map.levels) ? map.levels.length : 0);

export function sizeOfMap(map) {
  const [width, depth] = Array.isArray(map.size) ? map.size : [];
  const isSaid = [width, depth].every((side) => Number.isInteger(side) && side > 0);
  if (isSaid && width * depth <= kMostCells) return { width, depth };
  const layers = [...flatLevels(map).map(({ level }) => level?.rows ?? level)];
  layers.push(map.floor?.tiles, map.ceiling?.tiles, map.objectRows?.rows);
  const rows = layers.find((layer) => isRows(layer) && layer.length > 0) ?? [];
  return { width: rows.length === 0 ? 0 : signsOf(rows[0]).length, depth: rows.length };
}

const known = new WeakMap(); // rows of a map change in place, entries never

export function levelsOf(map) {
  if (!known.has(map)) known.set(map, readLevels(map));
  return known.get(map);
}

function readLevels(map) {
  const { width, depth } = sizeOfMap(map);
  return flatLevels(map).map(({ entry, level, isRepeated }) =>
    isRows(level)
      ? { entry, isWritten: !isRepeated, rows: level }
      : { entry, isWritten: false, rows: filled(level ?? {}, width, depth) },
  );
}

// Each level with the entry that says it.
function flatLevels({ levels = [] }) {
  const flat = [];
  if (!Array.isArray(levels)) return flat;
  levels.forEach((said, entry) => {
    const isRepeated = Number.isInteger(said?.repeat) && Array.isArray(said.levels);
    const times = isRepeated ? Math.min(said.repeat, kMostLevels) : 1;
    for (let time = 0; time < times && flat.length < kMostLevels; ++time)
      for (const level of isRepeated ? said.levels : [said])
        flat.push({ entry, level, isRepeated });
  });
  return flat.slice(0, kMostLevels);
}

function filled({ fill, rows = [] }, width, depth) {
  const everywhere = typeof fill === 'string' ? fill : kEmpty;
  const cells = Array.from({ length: depth }, () => new Array(width).fill(everywhere));
  for (const rectangle of Array.isArray(fill) ? fill : []) {
    const { character, x = 0, y = 0, width: wide = 0, depth: deep = 0 } = rectangle ?? {};
    if (typeof character !== 'string') continue;
    for (let row = Math.max(0, y); row < Math.min(depth, y + deep); ++row)
      cells[row].fill(character, Math.max(0, x), Math.max(0, x + wide));
  }
  if (isRows(rows))
    rows.slice(0, depth).forEach((row, y) => {
      signsOf(row)
        .slice(0, width)
        .forEach((sign, x) => sign !== kKept && (cells[y][x] = sign));
    });
  return cells.map((row) => row.join(''));
}
