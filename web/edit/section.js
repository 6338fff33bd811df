// The section through a map along a row of tiles, from west to east, or along a column, from north
// to south: which blocks it cuts, with their true heights, and what stands near it.
// Takes a document; gives lists. Changes nothing, and knows no canvas.
//
//     const section = { axis: 'x', at: 12 };      // 'x': west to east at row 12; 'y': at column 12
//     blocksIn(scene, 0, section)    // [{ along, level, sign, name, blueprint, profile }]
//     behind(scene, 0, section)      // the same of the nearest blocks behind, where none is cut;
//                                    // both of some levels, too: behind(scene, 0, section, [2])
//     thingsIn(scene, 0, section)    // [{ path, kind, along, z, away }]: `away` from its middle
//     portalsIn(scene, 0, section)   // [{ along, level, side, exit }]: 'from', 'to', 'top', ...
//     cellIn(section, along, level)  // { level, x, y }
//     edgeAt(profile, u, height)     // { edge: 'top', index, distance } nearest to a place in it
//     withEdge(blueprint, edge, index, height)        // null if it would have no height left
//
// A profile is the shape of a block in the section, within its cell: from `from` to `to`, with the
// heights of its `bottom` and `top` at these two. `ends` has the two numbers of a slope that rises
// along the section: which of its heights lies at which end, else null. What the section misses,
// as a thin wall at the tile's edge, is not `isCut`.

import { sizeOf } from './cells.js';
import { signsOf } from '../engine/signs.js';
import { kindsOf } from './kinds.js';
import { withHeight } from './shapes.js';
import { thingsOf } from './things.js';

const kMostBehind = 12; // tiles
const kNearThings = 1.5; // tiles from the section's middle
const kRises = { x: { east: [0, 1], west: [1, 0] }, y: { south: [0, 1], north: [1, 0] } };
const kPlain = /^[ -~]*$/; // each character is a sign
const kSides = {
  x: { west: 'from', east: 'to', top: 'top', bottom: 'bottom' },
  y: { north: 'from', south: 'to', top: 'top', bottom: 'bottom' },
};

export const cellIn = ({ axis, at }, along, level) =>
  axis === 'x' ? { level, x: along, y: at } : { level, x: at, y: along };

export const pointOf = ({ axis, at }, along, z) =>
  axis === 'x' ? [along, at + 0.5, z] : [at + 0.5, along, z];

export function lengthOf(scene, map, { axis }) {
  const { width, depth } = sizeOf(scene, map);
  return axis === 'x' ? width : depth;
}

// How many sections there are, side by side.
export function countOf(scene, map, { axis }) {
  const { width, depth } = sizeOf(scene, map);
  return axis === 'x' ? depth : width;
}

export function profileOf(blueprint, axis) {
  const { bottom = 0, top = 1, rise, plan = [0, 0, 1, 1], diagonal } = blueprint;
  const [west, north, east, south] = plan;
  let [from, to] = axis === 'x' ? [west, east] : [north, south];
  const across = axis === 'x' ? [north, south] : [west, east];
  if (diagonal !== undefined) {
    const [, second] = axis === 'x' ? ['west', 'east'] : ['north', 'south'];
    [from, to] = diagonal.includes(second) ? [0.5, 1] : [0, 0.5];
  }
  const ends = kRises[axis][rise] ?? null;
  const heights = (value) => {
    if (!Array.isArray(value)) return [value, value];
    if (ends === null) return [mean(value), mean(value)];
    const [first, last] = ends.map((index) => value[index]);
    return [from, to].map((u) => first + (last - first) * u);
  };
  return {
    from,
    to,
    bottom: heights(bottom),
    top: heights(top),
    ends,
    isCut: across[0] <= 0.5 && across[1] >= 0.5,
  };
}

const mean = ([one, other]) => (one + other) / 2;

export function blocksIn(scene, map, section, levels = allOf(scene, map)) {
  return blocksOf(scene, map, section, [section.at], levels);
}

// To the north of a section from west to east, to the east of one from north to south.
export function behind(scene, map, section, levels = allOf(scene, map)) {
  const { axis, at } = section;
  const step = axis === 'x' ? -1 : 1;
  const count = countOf(scene, map, section);
  const rows = Array.from({ length: kMostBehind + 1 }, (_, far) => at + step * far);
  const inside = rows.filter((row) => row >= 0 && row < count);
  return blocksOf(scene, map, section, inside, levels).filter(({ row }) => row !== at);
}

const allOf = (scene, map) =>
  Array.from({ length: sizeOf(scene, map).levels }, (_, level) => level);

// The first block of each cell, in the order of the rows.
function blocksOf(scene, map, { axis }, rows, levels) {
  const kinds = new Map(kindsOf(scene, map).map((kind) => [kind.sign, kind]));
  const profiles = new Map();
  const found = [];
  for (const level of levels) {
    const lines = linesOf(scene.rows(map, level), axis, rows);
    const length = Math.max(0, ...lines.map((line) => line.length));
    for (let along = 0; along < length; ++along) {
      const index = lines.findIndex((line) => kinds.has(line[along]));
      if (index < 0) continue;
      const kind = kinds.get(lines[index][along]);
      if (!profiles.has(kind)) profiles.set(kind, profileOf(kind.blueprint, axis));
      found.push({ ...kind, along, level, row: rows[index], profile: profiles.get(kind) });
    }
  }
  return found;
}

function linesOf(texts, axis, rows) {
  if (axis === 'x') return rows.map((row) => signsOf(texts[row] ?? ''));
  // Most rows are plain, and need not be split for one sign.
  const all = texts.map((text) => (kPlain.test(text) ? text : signsOf(text)));
  return rows.map((column) => all.map((row) => row[column]));
}

export function thingsIn(scene, map, { axis, at }) {
  return thingsOf(scene, map)
    .map(({ path, kind, x, y, z }) => {
      const [along, across] = axis === 'x' ? [x, y] : [y, x];
      return { path, kind, along, z, away: across - at - 0.5 };
    })
    .filter(({ away }) => Math.abs(away) <= kNearThings);
}

// `exit` is {along, level} if it lies in the section, too. 'front' faces the viewer or away.
export function portalsIn(scene, map, section) {
  const { portals = [], name } = scene.value.maps[map];
  const placeOf = ({ x, y }) => (section.axis === 'x' ? [x, y] : [y, x]);
  return portals.flatMap((portal) => {
    const [along, across] = placeOf(portal);
    if (across !== section.at) return [];
    const { level = 0, face, to = {} } = portal;
    const [exitAlong, exitAcross] = placeOf(to);
    const isHere = (to.map ?? name) === name && exitAcross === section.at;
    return {
      along,
      level,
      side: face === undefined ? 'whole' : (kSides[section.axis][face] ?? 'front'),
      exit: isHere ? { along: exitAlong, level: to.level ?? level } : null,
    };
  });
}

// At u, of the tile, and a height within the cell.
export function edgeAt({ from, to, bottom, top, ends }, u, height) {
  const part = Math.min(1, Math.max(0, (u - from) / Math.max(1e-6, to - from)));
  const at = ([first, last]) => first + (last - first) * part;
  const far = { top: Math.abs(height - at(top)), bottom: Math.abs(height - at(bottom)) };
  const edge = far.top <= far.bottom ? 'top' : 'bottom';
  return { edge, index: ends === null ? null : ends[part < 0.5 ? 0 : 1], distance: far[edge] };
}

// `index` says which height of a slope; of level edges there is one.
export function withEdge(blueprint, edge, index, height) {
  const { bottom = 0, top = 1 } = blueprint;
  if (![bottom, top].some(Array.isArray)) return withHeight(blueprint, edge, height);
  const heights = { bottom, top };
  const isSlope = Array.isArray(heights[edge]);
  if (isSlope && index === null) return null; // it rises across the section
  const to = Math.round(Math.min(1, Math.max(0, height)) * 100) / 100;
  heights[edge] = isSlope ? heights[edge].with(index, to) : to;
  const both = (value) => [value].flat().concat(value).slice(0, 2);
  const [low, high] = [both(heights.bottom), both(heights.top)];
  const isFit =
    low.every((one, end) => one <= high[end]) && low.some((one, end) => one < high[end]);
  return isFit ? { ...blueprint, [edge]: heights[edge] } : null;
}
