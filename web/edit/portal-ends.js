// The two ends of a portal: on a face of a block, or around a whole tile.
// Takes a document and targets; gives changes, or words where two ends do not fit.
//
//     portalEnd(scene, target)           // {map, x, y, level, face}, for a tile without face; null
//     portalBetween(scene, one, other)   // {path, value} of a new portal, or {words}
//     movedEnd(scene, path, end)         // changes; path: of a portal, or of its "to"

import { isInside } from './cells.js';
import { beside, blueprintAt, kSides, mapNumber, opposite, turned } from './links.js';
import { valueAt } from './things.js';

const isUpright = (face) => kSides.includes(face);

export function portalEnd(scene, { map, cell, before, face, point, view }) {
  const isBlock = cell !== null && blueprintAt(scene.value, map, cell) !== null;
  const at = isBlock ? cell : (before ?? cell);
  if (at === null || !isInside(scene, map, at)) return null;
  const end = { map, x: at.x, y: at.y, level: at.level };
  if (!isBlock) return end;
  return { ...end, face: view === 'plan' ? nearestSide(at, point) : face };
}

// Seen from above, the edge of the tile that is nearest counts.
function nearestSide({ x, y }, [px, py]) {
  const far = { north: py - y, south: y + 1 - py, west: px - x, east: x + 1 - px };
  return Object.keys(far).reduce((one, other) => (far[other] < far[one] ? other : one));
}

// The tile where one comes out of an end.
function exitOf(scene, { map, x, y, level, face }) {
  if (face === undefined) return { map, x, y, level };
  if (face === 'top') return { map, x, y, level: level + 1 };
  if (face === 'bottom') return { map, x, y, level: level - 1 };
  return { map, ...beside({ x, y, level }, face) };
}

function kindOfEnd({ face }) {
  if (face === undefined) return 'tile';
  return isUpright(face) ? 'side' : 'flat';
}

function quarter(from, to) {
  return ((kSides.indexOf(to) - kSides.indexOf(from) + 4) % 4) * 90;
}

export function portalBetween(scene, one, other) {
  const fault = misfit(scene, one, other);
  if (fault !== null) return { words: fault };
  const { maps } = scene.value;
  const to = exitOf(scene, other);
  const value = { x: one.x, y: one.y, level: one.level };
  if (one.face !== undefined) value.face = one.face;
  value.to = {
    ...(to.map === one.map ? {} : { map: maps[to.map].name }),
    x: to.x,
    y: to.y,
    level: to.level,
  };
  if (isUpright(one.face) && isUpright(other.face)) {
    const turn = quarter(opposite(one.face), other.face);
    if (turn !== 0) value.turn = turn;
  }
  if (kindOfEnd(one) === kindOfEnd(other)) value.twoWay = true;
  const path = ['maps', one.map, 'portals', (maps[one.map].portals ?? []).length];
  return { path, value };
}

// Words that say why two ends make no portal; null if they do.
function misfit(scene, one, other) {
  const { maps } = scene.value;
  if (JSON.stringify(one) === JSON.stringify(other))
    return 'Both ends are the same: click another face, or a tile of the floor.';
  if (kindOfEnd(one) === 'flat' && kindOfEnd(other) === 'flat' && one.face === other.face)
    return `Found two ${one.face}s: the other end of a top is the underside of a block.`;
  if (kindOfEnd(one) === 'flat' && kindOfEnd(other) === 'side')
    return 'Found a side and a top or underside: both ends must be upright, or both flat.';
  if (kindOfEnd(one) === 'side' && kindOfEnd(other) === 'flat')
    return 'Found a side and a top or underside: both ends must be upright, or both flat.';
  const to = exitOf(scene, other);
  if (!isInside(scene, to.map, to)) return 'The exit lies outside the map: choose another face.';
  if (blueprintAt(scene.value, to.map, to) !== null)
    return 'A block stands before that face: an exit must be free.';
  const isTaken = (maps[one.map].portals ?? []).some(
    ({ x, y, level = 0, face }) =>
      x === one.x && y === one.y && face === one.face && (!face || level === one.level),
  );
  return isTaken ? 'That face has a portal already: right click removes it.' : null;
}

// The far end of a portal as an end: the face behind its exit, where it has one.
function farEnd(scene, map, { level = 0, face, to, turn = 0, twoWay = false }) {
  const exit = {
    map: to.map === undefined ? map : mapNumber(scene.value, to.map),
    x: to.x,
    y: to.y,
    level: to.level ?? level,
  };
  if (face === undefined || (isUpright(face) && !twoWay)) return exit;
  const back = isUpright(face) ? turned(opposite(face), turn) : opposite(face);
  if (!isUpright(face))
    return { ...exit, level: exit.level + (back === 'bottom' ? 1 : -1), face: back };
  return { map: exit.map, ...beside(exit, opposite(back)), face: back };
}

export function movedEnd(scene, path, end) {
  if (end === null) return [];
  const isFar = path.at(-1) === 'to';
  const portal = isFar ? path.slice(0, -1) : path;
  const [, map] = portal;
  const present = valueAt(scene.value, portal);
  const { x, y, level = 0, face, comment } = present;
  const near = { map, x, y, level, ...(face === undefined ? {} : { face }) };
  const [one, other] = isFar ? [near, end] : [end, farEnd(scene, map, present)];
  if (one.map !== map) return []; // it belongs to its map
  if (JSON.stringify(one) === JSON.stringify(near) && !isFar) return [];
  const others = withoutPortal(scene, portal);
  const { value } = portalBetween(others, one, other);
  if (value === undefined) return [];
  const wanted = { ...(comment === undefined ? {} : { comment }), ...value };
  if (present.twoWay !== true) delete wanted.twoWay;
  return JSON.stringify(wanted) === JSON.stringify(present)
    ? []
    : [{ path: portal, value: wanted }];
}

// It is not in its own way.
function withoutPortal(scene, [, map, , index]) {
  const { value } = scene;
  const maps = value.maps.with(map, {
    ...value.maps[map],
    portals: value.maps[map].portals.toSpliced(index, 1),
  });
  return { value: { ...value, maps } };
}
