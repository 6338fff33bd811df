// Moves and turns what selected cells hold, blocks and things, or takes it away.
// Takes a document, cells (selection.js) and a transform; gives changes. Changes nothing itself.
//
//     carryChanges(scene, 0, cells, transform)     // the cells, and what stands in them
//     clearChanges(scene, 0, cells)                // with what stands in them
//
// What would come to lie outside the map is left out.

import { cellChanges, isInside, kEmpty, signReader } from './cells.js';
import { differences } from './differences.js';
import { extentOf } from './shapes.js';
import { draftOf, kindFor, kindOf } from './kinds.js';
import { cellOf, keyOf } from './selection.js';
import { pictureOf } from './files/shipped.js';
import { turnedKinds } from './turned-kinds.js';
import { isStill, kStill, turnedFace, turnedHeading, turnedPortal } from './turning.js';

const kStep = 1e9; // a move there and back leaves no trace

const tidy = (number) => Math.round(number * kStep) / kStep;

// The cell where a thing stands.
export function placeOfThing({ x, y, z = 0 }) {
  return { level: Math.floor(z), x: Math.floor(x), y: Math.floor(y), z };
}

// A thing on a block belongs to it, if the cell above is not the thing's own.
export function isWithin(scene, map, cells, { level, x, y, z }) {
  if (cells.has(keyOf({ level, x, y }))) return true;
  if (z !== level || level === 0 || !cells.has(keyOf({ level: level - 1, x, y }))) return false;
  const kind = kindOf(scene, map, scene.sign(map, level - 1, x, y));
  return kind !== null && extentOf(kind.blueprint).high === 1;
}

function carriedPlace(thing, { point }) {
  const [x, y, z] = point([thing.x, thing.y, thing.z ?? 0]).map(tidy);
  const next = { ...thing, x, y };
  if (thing.z !== undefined || z !== 0) next.z = z;
  return next;
}

export const carriedLamp = (lamp, transform) => carriedPlace(lamp, transform);

// `mapName`: of the object's map, where the points of its path lie that name none. A heading shows
// where the sprite has a picture for each side.
export function carriedObject(object, transform, mapName, sprites) {
  const next = carriedPlace(object, transform);
  const isTurned = !isStill(transform.turn);
  const turned = (heading) => turnedHeading(heading ?? 0, transform.turn);
  const { motion } = object;
  const hasSides =
    motion === undefined && pictureOf({ sprites }, 'sprites', object.sprite)?.views !== undefined;
  if (isTurned && (object.heading !== undefined || hasSides)) next.heading = turned(object.heading);
  if (motion === undefined) return tidied(next, object);
  next.motion = { ...motion };
  if (isTurned && motion.kind !== 'circle') next.motion.heading = turned(motion.heading);
  if (motion.path !== undefined)
    next.motion.path = motion.path.map((place) =>
      (place.map ?? mapName) === mapName ? carriedPoint(place, transform) : place,
    );
  next.motion = tidied(next.motion, motion);
  return tidied(next, object);
}

// A heading that is the usual one need not be said.
function tidied(next, before) {
  if (next.heading === 0 && before.heading === undefined) delete next.heading;
  return next;
}

// Heights of points are said only where they matter.
function carriedPoint(place, { point }) {
  const [x, y, z] = point([place.x, place.y, place.z ?? 0]).map(tidy);
  return place.z === undefined ? { ...place, x, y } : { ...place, x, y, z };
}

export function carriedStart(start, transform) {
  const next = carriedPlace(start, transform);
  if (!isStill(transform.turn)) next.heading = turnedHeading(start.heading ?? 0, transform.turn);
  return tidied(next, start);
}

export function carryChanges(scene, map, cells, transform) {
  const { changes, signs } = turnedSigns(scene, map, cells, transform.turn);
  const signAt = signReader(scene, map);
  const moved = [];
  const emptied = [];
  for (const key of cells) {
    const cell = cellOf(key);
    const sign = signAt(cell.level, cell.x, cell.y);
    if (sign === kEmpty || sign === ' ') continue;
    const { level, x, y } = transform.cell(cell);
    emptied.push({ layer: cell.level, x: cell.x, y: cell.y, sign: kEmpty });
    moved.push({ layer: level, x, y, sign: signs.get(sign) ?? sign });
  }
  return [
    ...changes,
    ...cellChanges(scene, map, [...emptied, ...moved]),
    ...thingChanges(scene, map, cells, transform),
  ];
}

// What each sign becomes: {changes, signs}.
function turnedSigns(scene, map, cells, turn) {
  const signs = new Map();
  if (isStill(turn)) return { changes: [], signs };
  const used = new Set();
  const signAt = signReader(scene, map);
  for (const key of cells) {
    const { level, x, y } = cellOf(key);
    used.add(signAt(level, x, y));
  }
  const kinds = [...used].map((sign) => kindOf(scene, map, sign)).filter(Boolean);
  const { blueprints, motions, names } = turnedKinds(
    scene.value,
    kinds.map(({ name }) => name),
    turn,
  );
  const draft = draftOf(scene);
  draft.take(Object.entries(motions).map(([name, value]) => ({ path: ['motions', name], value })));
  for (const { sign, name } of kinds) {
    if (names.get(name) === name) continue;
    const kind = kindFor(draft, map, names.get(name), blueprints[names.get(name)]);
    draft.take(kind.changes);
    signs.set(sign, kind.sign);
  }
  return { changes: draft.changes(), signs };
}

function thingChanges(scene, map, cells, transform) {
  const { maps, start } = scene.value;
  const here = maps[map];
  const isIn = (thing) => isWithin(scene, map, cells, placeOfThing(thing));
  const kept = (thing) =>
    isInside(scene, map, { x: Math.floor(thing.x), y: Math.floor(thing.y) }) && (thing.z ?? 0) >= 0
      ? thing
      : undefined;
  const objects = here.objects?.map((object) =>
    isIn(object)
      ? kept(carriedObject(object, transform, here.name, scene.value.sprites ?? {}))
      : object,
  );
  const lamps = here.baked?.lamps?.map((lamp) =>
    isIn(lamp) ? kept(carriedLamp(lamp, transform)) : lamp,
  );
  const portalsOf = (other) =>
    other.portals?.map((portal) => carriedPortal(scene, map, cells, transform, portal, other));
  const changes = maps.flatMap((other, index) => [
    ...(index === map ? differences(here.objects, objects, ['maps', map, 'objects']) : []),
    ...(index === map
      ? differences(here.baked?.lamps, lamps, ['maps', map, 'baked', 'lamps'])
      : []),
    ...differences(other.portals, portalsOf(other), ['maps', index, 'portals']),
  ]);
  const isStartHere = start !== undefined && (start.map ?? maps[0].name) === here.name;
  if (!isStartHere || !isIn(start)) return changes;
  const next = kept(carriedStart(start, transform)); // the start stays rather than be lost
  return next === undefined ? changes : [...changes, ...differences(start, next, ['start'])];
}

function carriedPortal(scene, map, cells, transform, portal, home) {
  const here = scene.value.maps[map];
  const { x, y, level = 0, to } = portal;
  const exit = { level: to.level ?? level, x: to.x, y: to.y };
  const isHere = home === here && cells.has(keyOf({ level, x, y }));
  const leadsHere = (to.map ?? home.name) === here.name && cells.has(keyOf(exit));
  if (!isHere && !leadsHere) return portal;
  const next = { ...portal, to: { ...to } };
  if (isHere) {
    const at = transform.cell({ level, x, y });
    if (!isInside(scene, map, at)) return undefined;
    Object.assign(next, { x: at.x, y: at.y });
    if (portal.level !== undefined || at.level !== 0) next.level = at.level;
    if (portal.face !== undefined) next.face = turnedFace(portal.face, transform.turn);
  }
  const there = leadsHere ? transform.cell(exit) : exit;
  if (leadsHere && !isInside(scene, map, there)) return undefined;
  Object.assign(next.to, { x: there.x, y: there.y });
  if (to.level !== undefined || there.level !== (next.level ?? 0)) next.to.level = there.level;
  const turn = turnedPortal(
    portal,
    isHere ? transform.turn : kStill,
    leadsHere ? transform.turn : kStill,
  );
  if (turn !== (portal.turn ?? 0)) next.turn = turn;
  return next;
}

export function clearChanges(scene, map, cells) {
  const here = scene.value.maps[map];
  const isIn = (thing) => isWithin(scene, map, cells, placeOfThing(thing));
  const without = (list, isGone) => list?.map((one) => (isGone(one) ? undefined : one));
  const emptied = [...cells].map(cellOf).map(({ level, x, y }) => ({
    layer: level,
    x,
    y,
    sign: kEmpty,
  }));
  const isPortalIn = ({ x, y, level = 0 }) => cells.has(keyOf({ level, x, y }));
  return [
    ...cellChanges(scene, map, emptied),
    ...differences(here.objects, without(here.objects, isIn), ['maps', map, 'objects']),
    ...differences(here.baked?.lamps, without(here.baked?.lamps, isIn), [
      'maps',
      map,
      'baked',
      'lamps',
    ]),
    ...differences(here.portals, without(here.portals, isPortalIn), ['maps', map, 'portals']),
  ];
}

// The block alone; things stay.
export function fillChanges(scene, map, cells, sign) {
  return cellChanges(
    scene,
    map,
    [...cells].map(cellOf).map(({ level, x, y }) => ({ layer: level, x, y, sign })),
  );
}
