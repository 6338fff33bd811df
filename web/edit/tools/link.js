// Makes what refers to something: portals, gates and what opens them, ways, messages and the goal.
// Takes targets; gives changes, lines to show and what is to come next. Knows no view.

import { areaChanges, tilesOf } from '../areas.js';
import { clipped, isInside, kEdgeWords } from '../cells.js';
import { gateAt, moverAt, openedByFind, openedByGate, plainAt } from '../gates.js';
import { beside, blueprintAt, sideBox } from '../links.js';
import { boxLines, cellLines, kBrass, kCoral } from '../mark-lines.js';
import { portalBetween, portalEnd } from '../portal-ends.js';
import { pictureOf } from '../files/shipped.js';
import { valueAt } from '../things.js';
import { extentOf } from '../shapes.js';
import {
  cross,
  dragHandle,
  handleMarks,
  removeHandle,
  thingHint,
  turnHandle,
} from './handle-strokes.js';
import { boxOfCells } from './strokes.js';

const kWalk = 0.9; // of new patrols, units per second
const kNear = 0.3; // units from a segment of a way, to put a point into it
const kSamePlace = 0.25; // units between two clicks that end a way
const kHelp = {
  portal: 'Click a face or a tile, then the other end, also in another map.',
  gate: 'Click a block to make it a gate, then a thing that opens it or another gate.',
  way: 'Click a figure or a block, then where it goes; Done or a double click ends.',
  message: 'Drag over the tiles where the message comes.',
  goal: 'Drag over the tiles where the game ends.',
};
const kNext = {
  portal: 'Now click the other end. Another tool leaves it.',
  gate: 'Now click what opens it: a thing to find, or a gate. The floor: whoever walks up to it.',
  way: 'Click where it goes next. Done or a double click ends, right click removes a point.',
  mover: 'Now click how far it moves.',
};

export const link = {
  name: 'link',
  label: 'Links',
  key: 'Y',
  about: 'Portals, gates, ways, messages and the goal. O chooses which.',
  touch: 'Portals, gates, ways, messages and the goal.',
  canRemove: true,
  ways: ['portal', 'gate', 'way', 'message', 'goal'],
  waysAbout: kHelp,
  isFree: true,
  hasThings: true,
  hasCorners: (way) => isArea(way),

  help: ({ way, pending }) => kNext[pending?.kind] ?? kHelp[way] ?? '',

  hint: thingHint,

  point(target, context) {
    return [...handleMarks(target, context), ...preview(target, context)];
  },

  // Lines while it is dragged.
  show(stroke, context) {
    const [{ thing: found, mapName }] = stroke.targets;
    if (found !== null || !isArea(context.way)) return link.point(stroke.targets.at(-1), context);
    const box = areaOf(stroke, context);
    if (box === null) return [];
    const { from, to } = box;
    const { level } = from;
    return boxLines(
      mapName,
      { west: from.x, north: from.y, east: to.x + 1, south: to.y + 1, low: level, high: level + 1 },
      stroke.removes ? kCoral : kBrass,
    );
  },

  turn: turnHandle,

  drag: dragHandle,

  end(stroke, context) {
    const { targets, removes } = stroke;
    const [target] = targets;
    if (removes) return remove(stroke, context);
    if (isArea(context.way)) return area(stroke, context);
    const isDragged = targets.length > 1 && target.thing !== null;
    if (isDragged) return [];
    return { portal, gate, way }[context.way](target, context);
  },
};

const isArea = (way) => way === 'message' || way === 'goal';
const isObject = (path) => path !== null && path[2] === 'objects' && path.length === 4;

function remove(stroke, context) {
  const { scene, pending } = context;
  const [{ map, cell, thing: found }] = stroke.targets;
  // While a way is drawn, only its points go.
  if (pending?.kind === 'way' && isObject(found)) return [];
  const changes = removeHandle(stroke, context);
  if (changes.length > 0 || found !== null || cell === null) return changes;
  return plainAt(scene, map, cell);
}

// ---- Portals

function portal(target, { scene, pending }) {
  const { thing: found } = target;
  if (pending === null && found?.[2] === 'portals') return []; // chosen
  const end = portalEnd(scene, target);
  if (end === null) return { words: kEdgeWords };
  if (pending === null) return { pending: { kind: 'portal', end } };
  const made = portalBetween(scene, pending.end, end);
  if (made.words !== undefined) return { words: made.words };
  return {
    label: 'Portal',
    changes: [made],
    pending: null,
    edited: made.path,
    words: made.value.twoWay ? undefined : 'A portal in one direction: its ends are not alike.',
  };
}

// ---- Gates

function gate({ map, cell, thing: found }, { scene, pending }) {
  const { value } = scene;
  if (pending !== null && isObject(found))
    return {
      label: 'What opens a gate',
      changes: openedByFind(scene, pending.name, found),
      edited: pending.path,
    };
  const block = cell === null ? null : blueprintAt(value, map, cell);
  if (block === null) {
    if (pending === null) return { words: kHelp.gate };
    const { needs, follows } = value.blueprints[pending.name].gate;
    const isOpen = needs === undefined && follows === undefined;
    return { pending: null, words: isOpen ? 'It opens when somebody walks up to it.' : undefined };
  }
  const isOther = block.blueprint.gate !== undefined && block.name !== pending?.name;
  if (pending !== null && isOther)
    return {
      label: 'What opens a gate',
      changes: openedByGate(scene, pending.name, block.name),
      edited: pending.path,
    };
  const made = gateAt(scene, map, cell);
  if (made.words !== undefined) return { words: made.words };
  const path = ['blueprints', made.name, 'gate'];
  return {
    label: 'Gate',
    changes: made.changes,
    edited: path,
    pending: { kind: 'gate', name: made.name, path },
  };
}

// ---- Ways

function way(target, context) {
  const { scene, pending } = context;
  const { map, mapName, cell, point, thing: found } = target;
  if (pending?.kind === 'mover') {
    if (point === null) return [];
    const made = moverAt(scene, pending.map, pending.cell, point);
    if (made.words !== undefined) return { words: made.words };
    const { motion } =
      made.changes.find(({ path }) => path?.[0] === 'blueprints')?.value ??
      scene.value.blueprints[made.name];
    return { label: 'Way', changes: made.changes, pending: null, edited: ['motions', motion] };
  }
  if (pending?.kind === 'way') {
    const last = lastPoint(scene.value, pending.path);
    const isPoint = found !== null && String(found).startsWith(`${pending.path},motion,path`);
    const isSameAgain =
      isPoint ||
      (last !== null &&
        point !== null &&
        last.mapName === mapName &&
        Math.hypot(last.x - point[0], last.y - point[1]) < kSamePlace);
    if (isSameAgain) return { pending: null, edited: pending.path };
    if (point === null || !isInside(scene, map, { x: point[0], y: point[1] })) return [];
    return { label: 'Way', changes: withPoint(scene, pending.path, map, point) };
  }
  if (isObject(found)) return { pending: { kind: 'way', path: found }, edited: found };
  if (found !== null) return [];
  const at = point === null ? null : segmentNear(context, map, point);
  if (at !== null) return { label: 'Way', ...insertPoint(at, point) };
  if (cell !== null && blueprintAt(scene.value, map, cell) !== null)
    return { pending: { kind: 'mover', map, cell } };
  return { words: kHelp.way };
}

const rounded = (number) => Math.round(number * 20) / 20;

function lastPoint(value, path) {
  const { motion } = valueAt(value, path) ?? {};
  const last = motion?.path?.at(-1);
  return last === undefined ? null : { mapName: value.maps[path[1]].name, ...named(last) };
}

const named = ({ map, x, y }) => ({ x, y, ...(map === undefined ? {} : { mapName: map }) });

function withPoint(scene, path, map, [x, y]) {
  const { value } = scene;
  const { motion, sprite } = valueAt(value, path);
  const isElsewhere = map !== path[1];
  const point = {
    ...(isElsewhere ? { map: value.maps[map].name } : {}),
    x: rounded(x),
    y: rounded(y),
  };
  if (motion?.kind === 'patrol') {
    const at = (motion.path ?? []).length;
    return [{ path: [...path, 'motion', 'path', at], value: point }];
  }
  const { alert, solid, sprites = walkOf(value, sprite) } = motion ?? {};
  const patrol = {
    kind: 'patrol',
    speed: motion?.speed ?? kWalk,
    path: [point],
    alert,
    solid,
    sprites,
  };
  return [{ path: [...path, 'motion'], value: JSON.parse(JSON.stringify(patrol)) }];
}

// "guard" walks as "guard walking", where the scene has that.
function walkOf(value, sprite) {
  const walk = [`${sprite} walking`, `${sprite}-walking`].find(
    (name) => pictureOf(value, 'sprites', name) !== undefined,
  );
  return walk === undefined ? undefined : { walk };
}

// The segment of a patrol at that place: {path, index} of the point behind it.
function segmentNear({ links }, map, [x, y]) {
  for (const { kind, path, points, ends, isClosed, closesAt } of links.of(map)) {
    const isWhole = kind === 'way' && ends.length > 0 && ends.every((end) => end.map === map);
    if (!isWhole) continue;
    const round = isClosed ? [...points, points[closesAt]] : points;
    for (let index = 1; index < round.length; ++index)
      if (farFromSegment([x, y], round[index - 1], round[index]) < kNear)
        return { path: [...path, 'path'], index: index - closesAt };
  }
  return null;
}

function farFromSegment([x, y], [fromX, fromY], [toX, toY]) {
  const [east, south] = [toX - fromX, toY - fromY];
  const length = east * east + south * south;
  const along = length === 0 ? 0 : ((x - fromX) * east + (y - fromY) * south) / length;
  const at = Math.min(1, Math.max(0, along));
  return Math.hypot(x - fromX - at * east, y - fromY - at * south);
}

function insertPoint({ path, index }, [x, y]) {
  const at = [...path, index];
  return {
    changes: [{ path: at, value: { x: rounded(x), y: rounded(y) }, insert: true }],
    edited: at,
  };
}

// ---- Areas

function areaOf({ targets }, { scene }) {
  const places = targets.map(({ before, cell }) => before ?? cell).filter(Boolean);
  if (places.length === 0) return null;
  const { level } = places[0];
  return clipped(scene, targets[0].map, boxOfCells(places[0], { ...places.at(-1), level }));
}

function area(stroke, context) {
  const { scene, way: kind } = context;
  const [{ thing: found, map }] = stroke.targets;
  if (found !== null) return []; // chosen, or moved
  const box = areaOf(stroke, context);
  if (box === null) return [];
  return areaChanges(scene, kind, map, tilesOf(box));
}

// ---- What would be made

function preview(target, { scene, way: kind, pending, removes }) {
  const { map, mapName, cell, before, point, thing: found } = target;
  if (found !== null) return [];
  const colour = removes ? kCoral : kBrass;
  const begun =
    pending?.kind === 'portal' ? frameLines(scene, pending.end, '#ffffff') : mover(scene, pending);
  if (kind === 'portal') {
    const end = portalEnd(scene, target);
    return [...begun, ...(end === null ? [] : frameLines(scene, end, colour))];
  }
  if (kind === 'gate') {
    const block = cell === null ? null : blueprintAt(scene.value, map, cell);
    return block === null ? [] : cellLines(mapName, cell, colour, extentOf(block.blueprint));
  }
  if (kind === 'way' && pending?.kind === 'way' && point !== null) {
    const last = lastPoint(scene.value, pending.path) ?? fromObject(scene.value, pending.path);
    if (last === null || last.mapName !== mapName) return begun;
    const z = point[2] + 0.05;
    return [{ map: mapName, from: [last.x, last.y, z], to: [point[0], point[1], z], colour }];
  }
  if (isArea(kind) && before !== null) return cellLines(mapName, before, colour);
  return begun;
}

function fromObject(value, path) {
  const object = valueAt(value, path);
  return object === undefined
    ? null
    : { x: object.x, y: object.y, mapName: value.maps[path[1]].name };
}

function mover(scene, pending) {
  if (pending?.kind !== 'mover') return [];
  const { map, cell } = pending;
  const { blueprint } = blueprintAt(scene.value, map, cell) ?? {};
  return cellLines(scene.value.maps[map].name, cell, '#ffffff', extentOf(blueprint));
}

function frameLines(scene, { map, x, y, level, face }, colour) {
  const { name } = scene.value.maps[map];
  const { blueprint } = blueprintAt(scene.value, map, { x, y, level }) ?? {};
  const extent = extentOf(blueprint);
  const lines = boxLines(name, sideBox({ x, y, level }, face, extent), colour);
  if (face === undefined) return lines;
  // A stroke out of the face shows which side it is.
  const out = beside({ x: x + 0.5, y: y + 0.5, level }, face);
  const up = { top: 1.3, bottom: -0.3 }[face] ?? 0.5;
  const middle = [x + 0.5, y + 0.5, level + up];
  return [
    ...lines,
    { map: name, from: [x + 0.5, y + 0.5, level + 0.5], to: [out.x, out.y, middle[2]], colour },
    ...cross(name, [(x + 0.5 + out.x) / 2, (y + 0.5 + out.y) / 2, middle[2]], colour),
  ];
}
