// The handles of a map: points that are dragged, turned, removed or copied. Those of things, ends
// of portals, points of ways and areas; of what is edited also its heading, radius and corner.
// Takes a document; gives lists and changes. Changes nothing itself, and knows no view.
//
//     handlesOf(scene, 0, edited)                // [{path, kind, x, y, z}]
//     dragChanges(scene, path, target, stands)   // puts it where the pointer is; in the plan with
//                                                // the height over ground that it had:
//     standingOf(scene, 0, path)                 // {ground, above}
//     turnChanges(scene, path, notches)          // null: the wheel has no use there
//     removeChanges(scene, path)   copyOf(scene, path)
//     wordsOf(scene, 0, path, edited)            // what it is and does
//     formPathOf(path)                           // of the value whose form is shown

import { isInside } from './cells.js';
import { groundAt } from './ground.js';
import { framesOf, isPlaced, mapNumber, middleOf, startMap, withoutNames } from './links.js';
import { movedEnd, portalEnd } from './portal-ends.js';
import { pictureOf } from './files/shipped.js';
import { moveChanges, thingsOf, valueAt } from './things.js';

const kLampHeight = 0.8; // over the ground
const kArm = 1; // of a heading, units
const kHeadingStep = 5; // degrees
const kWheelTurn = 15; // degrees a notch
const kWheelLift = 0.1; // units a notch
const kMostRadius = 16; // of a lamp, as the schema has it
const kInner = new Set(['to', 'heading', 'radius', 'width']); // belong to what is around them

export const formPathOf = (path) => (path[0] === 'game' ? ['game'] : ownerOf(path));

// What a handle belongs to.
function ownerOf(path) {
  if (!kInner.has(path.at(-1))) return path;
  return path.at(-2) === 'motion' ? path.slice(0, -2) : path.slice(0, -1);
}

export function handlesOf(scene, map, edited) {
  const all = allOf(scene, map);
  return edited === null ? all : [...ofEdited(scene, map, edited), ...all];
}

const known = new WeakMap(); // a scene's value -> handles by map

function allOf(scene, map) {
  if (!known.has(scene.value)) known.set(scene.value, new Map());
  const maps = known.get(scene.value);
  if (!maps.has(map)) {
    const value = withoutNames(scene.value);
    const ends = [...portalEnds(value, map), ...wayPoints(value, map)];
    maps.set(map, [...thingsOf(scene, map), ...ends, ...areas(value, map)]);
  }
  return maps.get(map);
}

// How each kind is called, and what one does with it.
const kMoves = 'Drag moves it, Delete removes it.';
const kTurns = 'Drag moves it, the wheel turns it, Delete removes it.';
const kAbout = {
  object: ({ sprite, find }) => [find === undefined ? sprite : `Find: ${sprite}`, kTurns],
  lamp: () => ['Lamp', 'Drag moves it, the wheel raises and lowers it, Delete removes it.'],
  start: () => ['Start of the player', 'Drag moves it, the wheel turns it.'],
  place: (_, path) => [`Place "${path.at(-1)}"`, 'Drag moves it.'],
  portal: (_, path) => [path.at(-1) === 'to' ? 'Far end of a portal' : 'Portal', kMoves],
  way: () => ['Point of a way', kMoves],
  message: ({ text }) => [`Message: ${shortened(text)}`, kMoves],
  goal: () => ['Goal: the game ends here', kMoves],
  radius: () => ['Reach of the lamp', 'Drag changes it.'],
  heading: () => ['Where it faces', 'Drag turns it.'],
  corner: () => ['Corner of the tiles', 'Drag makes them more or fewer.'],
};
const kLongest = 40; // characters of a message

const shortened = (text) =>
  text.length > kLongest ? `${text.slice(0, kLongest).trimEnd()} …` : text;

export function wordsOf(scene, map, path, edited) {
  const handle = handlesOf(scene, map, edited).find((one) => String(one.path) === String(path));
  if (handle === undefined) return undefined;
  const kind = path.at(-1) === 'width' ? 'corner' : handle.kind;
  const [name, acts] = kAbout[kind](valueAt(scene.value, path) ?? {}, path);
  return `${name[0].toUpperCase()}${name.slice(1)}. ${acts}`;
}

function portalEnds(value, map) {
  return value.maps.flatMap(({ portals = [] }, from) =>
    portals.flatMap((portal, index) => {
      if (!isPlaced(portal) || !isPlaced(portal.to)) return [];
      const path = ['maps', from, 'portals', index];
      const to = portal.to.map === undefined ? from : mapNumber(value, portal.to.map);
      const frames = from === map || to === map ? framesOf(value, from, portal) : null;
      return [
        ...(from === map ? [{ path, kind: 'portal', ...middleOf(frames.from) }] : []),
        ...(to === map ? [{ path: [...path, 'to'], kind: 'portal', ...middleOf(frames.to) }] : []),
      ];
    }),
  );
}

function wayPoints(value, map) {
  return value.maps.flatMap(({ name, objects = [] }, from) =>
    objects.flatMap(({ motion, z: feet = 0 }, index) =>
      (motion?.path ?? [])
        .map((point, at) => ({
          path: ['maps', from, 'objects', index, 'motion', 'path', at],
          kind: 'way',
          x: point.x,
          y: point.y,
          z: point.z ?? feet,
          mapName: point.map ?? name,
        }))
        .filter(({ mapName }) => mapName === value.maps[map].name),
    ),
  );
}

function areasOf(value, map) {
  const all = (value.maps[map].messages ?? []).map((area, index) => ({
    path: ['maps', map, 'messages', index],
    kind: 'message',
    area,
  }));
  const at = value.game?.at;
  if (at !== undefined && (at.map ?? startMap(value)) === value.maps[map].name)
    all.push({ path: ['game', 'at'], kind: 'goal', area: at });
  return all;
}

function areas(value, map) {
  return areasOf(value, map).map(({ path, kind, area }) => {
    const { x, y, width = 1, depth = 1, bottom = 0 } = area;
    return { path, kind, x: x + width / 2, y: y + depth / 2, z: bottom + 0.1 };
  });
}

function ofEdited(scene, map, edited) {
  const area = areasOf(withoutNames(scene.value), map).find(
    ({ path }) => String(formPathOf(path)) === String(edited),
  );
  if (area !== undefined) {
    const { x, y, width = 1, depth = 1, bottom = 0 } = area.area;
    const corner = { x: x + width, y: y + depth, z: bottom + 0.1 };
    return [{ path: [...area.path, 'width'], kind: area.kind, ...corner }];
  }
  const thing = thingsOf(scene, map).find(({ path }) => String(path) === String(edited));
  if (thing === undefined) return [];
  const { x, y, z } = thing;
  if (thing.kind === 'lamp') {
    const { radius = 4 } = valueAt(scene.value, edited);
    return [{ path: [...edited, 'radius'], kind: 'radius', x: x + radius, y, z }];
  }
  const path = headingPath(scene.value, edited);
  if (path === null) return [];
  const angle = ((valueAt(scene.value, path) ?? 0) * Math.PI) / 180;
  const arm = { x: x + kArm * Math.cos(angle), y: y + kArm * Math.sin(angle), z };
  return [{ path, kind: 'heading', ...arm }];
}

// Where a thing keeps its heading; null if it has none.
export function headingPath(value, path) {
  if (path[0] === 'start') return ['start', 'heading'];
  const object = path[2] === 'objects' ? valueAt(value, path) : undefined;
  if (object === undefined) return null;
  if (object.motion !== undefined)
    return object.motion.kind === 'patrol' ? null : [...path, 'motion', 'heading'];
  const hasViews = pictureOf(value, 'sprites', object.sprite)?.views !== undefined;
  return hasViews || object.heading !== undefined ? [...path, 'heading'] : null;
}

const isArea = (path) => path[2] === 'messages' || (path[0] === 'game' && path[1] === 'at');
const set = (path, value) => ({ path, value });

// Only what differs from the document.
const differing = (scene, changes) =>
  changes.filter(({ path, value }) => valueAt(scene.value, path) !== value);

export function standingOf(scene, map, path) {
  const { x, y, z = 0 } = valueAt(scene.value, path) ?? {};
  if (!Number.isFinite(x) || !Number.isFinite(y)) return null;
  const ground = groundAt(scene, map, { x, y, z });
  return { ground, above: z - ground };
}

export function dragChanges(scene, path, target, stands = null) {
  const { map, point, view, lift } = target;
  if (lift !== undefined) return liftChanges(scene, path, lift);
  if (point === null) return [];
  const [x, y, z] = point;
  if (!isInside(scene, map, { x, y })) return [];
  const of = ownerOf(path);
  const thing = valueAt(scene.value, of);
  if (thing === undefined) return [];
  switch (path.at(-1)) {
    case 'heading': {
      const degrees = (Math.atan2(y - thing.y, x - thing.x) * 180) / Math.PI;
      return differing(scene, [set(path, headingOf(degrees))]);
    }
    case 'radius': {
      const far = Math.round(Math.hypot(x - thing.x, y - thing.y) * 10) / 10;
      return differing(scene, [set(path, Math.min(kMostRadius, Math.max(0.1, far)))]);
    }
    case 'width':
      return differing(scene, [
        set([...of, 'width'], Math.max(1, Math.ceil(x) - thing.x)),
        set([...of, 'depth'], Math.max(1, Math.ceil(y) - thing.y)),
      ]);
    default:
  }
  if (path[2] === 'portals') return movedEnd(scene, path, portalEnd(scene, target));
  if (isArea(path)) {
    if (map !== areaMap(scene.value, path)) return [];
    const { width = 1, depth = 1 } = thing;
    return differing(scene, [
      set([...path, 'x'], Math.max(0, Math.floor(x) - (width >> 1))),
      set([...path, 'y'], Math.max(0, Math.floor(y) - (depth >> 1))),
    ]);
  }
  const isPoint = path.includes('path');
  if (!isPoint && path[0] === 'maps' && path[1] !== map) return [];
  const height = path[2] === 'baked' ? z + kLampHeight : z;
  if (isPoint) return moveChanges(scene, path, { x, y });
  if (view !== 'plan' || stands === null) return moveChanges(scene, path, { x, y, z: height });
  const from = Math.max(stands.ground, z); // z: of the level that the plan shows
  return moveChanges(scene, path, {
    x,
    y,
    z: groundAt(scene, map, { x, y, z: from }) + stands.above,
  });
}

// Areas and portals stand on tiles, points of ways on the ground.
function liftChanges(scene, path, z) {
  const isThing = path[0] === 'start' || ['objects', 'lamps'].includes(path.at(-2));
  if (!isThing) return [];
  const height = Math.round(Math.max(0, z) * 20) / 20;
  return differing(scene, [set([...path, 'z'], height)]);
}

const areaMap = (value, path) =>
  path[0] === 'game' ? mapNumber(value, value.game.at.map ?? startMap(value)) : path[1];

function headingOf(degrees) {
  const whole = Math.round(degrees / kHeadingStep) * kHeadingStep;
  return ((whole % 360) + 360) % 360;
}

export function turnChanges(scene, path, notches) {
  const of = ownerOf(path);
  if (of[2] === 'baked') {
    const { z } = valueAt(scene.value, of);
    const next = Math.round((z + Math.sign(notches) * kWheelLift) * 100) / 100;
    return [set([...of, 'z'], Math.max(0, next))];
  }
  const heading = headingPath(scene.value, of);
  if (heading === null) return null;
  const degrees = (valueAt(scene.value, heading) ?? 0) + Math.sign(notches) * kWheelTurn;
  return [set(heading, headingOf(degrees))];
}

export function removeChanges(scene, path) {
  if (path[0] === 'start') return [];
  if (path.at(-1) === 'heading' || path.at(-1) === 'radius') return [];
  const of = ownerOf(path);
  if (of[0] === 'game') {
    const { needs } = scene.value.game;
    return [set(needs === undefined ? ['game'] : ['game', 'at'], undefined)];
  }
  const at = of.lastIndexOf('path');
  if (at === of.length - 2 && at > 0) {
    const points = valueAt(scene.value, of.slice(0, -1));
    if (points.length === 1) return [set(of.slice(0, at), undefined)]; // the motion
  }
  return [set(of, undefined)];
}

// The last point of a figure's way; none if it has no way.
export function lastPointOf(scene, object) {
  const points = valueAt(scene.value, object)?.motion?.path ?? [];
  return points.length === 0 ? null : [...object, 'motion', 'path', points.length - 1];
}

// A copy beside it: {path, changes}; null for what there is only once.
export function copyOf(scene, edited) {
  const path = ownerOf(edited);
  const isListed = ['objects', 'lamps', 'messages'].includes(path.at(-2));
  const original = isListed ? valueAt(scene.value, path) : undefined;
  if (original === undefined) return null;
  const { x, width } = original;
  const step = path[2] === 'messages' ? (width ?? 1) : 1;
  const isFree = isInside(scene, path[1], { x: x + step, y: original.y });
  const all = path.slice(0, -1);
  const copy = [...all, valueAt(scene.value, all).length];
  const moved = { ...original, x: isFree ? x + step : Math.max(0, x - step) };
  return { path: copy, changes: [set(copy, moved)] };
}
