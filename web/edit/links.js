// What refers to a place in a map: portals, gates and what opens them, movers, the ways of figures,
// messages, finds and the goal.
// Takes the value of a scene; gives lists. Knows no document, no tool and no view.
//
//     linksOf(value, 0)        // of map 0, see below; also what leads into it from elsewhere
//     placesOf(value)          // [{path, map, x, y, width, depth}]: whatever has an x and a y
//     new Links(scene).of(0)   // the same as linksOf, made anew only after changes
//
//     { path, kind, map,       // where it stands in the document; its kind; the map's number
//       area, radius,          // {west, north, east, south, low, high}; of a ring around points[0]
//       points, isClosed,      // [[x, y, z], ...]: a way, or the one place of a find
//       isBack,                // there and back along the points, or through the portal
//       ends, text }           // [{path, map, mapName, x, y, z}] of what belongs to it; words
//
// Portals have `areas`, one for each end in this map, and `away`, where the first one leads to.

import { signsOf } from '../engine/signs.js';
import { levelsOf } from './levels.js';
import { kPlaces } from './map-size.js';
import { extentOf } from './shapes.js';

export const kSides = ['north', 'east', 'south', 'west']; // clockwise
const kStep = { north: [0, -1], east: [1, 0], south: [0, 1], west: [-1, 0] };
const kRingPoints = 24; // of the way of what flies in circles
const kOverGround = 0.1; // where ways are drawn, units
const kMessageNear = 1.5; // as the schema has it

// Where a scene may have an x and a y. "*" is any name or number.
const kPoints = Object.entries(kPlaces).flatMap(([place, { keys }]) => {
  const pattern = place.replace(/\[\]|\{\}/g, '/*').replaceAll('.', '/');
  return [
    ...(keys.includes('x') ? [pattern] : []),
    ...(keys.includes('to.x') ? [`${pattern}/to`] : []),
  ];
});

// The same scene, where what is said by the name of a place has the numbers of that place.
const resolved = new WeakMap();

export function withoutNames(value) {
  if (!value.maps.some(({ places }) => places !== undefined)) return value;
  if (!resolved.has(value)) resolved.set(value, resolve(value));
  return resolved.get(value);
}

// Rows are shared: they change in place.
function resolve(value) {
  const { maps, ...rest } = value;
  const copy = structuredClone(rest);
  copy.maps = maps.map(({ levels, floor, ceiling, ...map }) => ({
    ...structuredClone(map),
    ...(levels === undefined ? {} : { levels }),
    ...(floor === undefined ? {} : { floor }),
    ...(ceiling === undefined ? {} : { ceiling }),
  }));
  for (const pattern of kPoints) {
    for (const [path, said] of matchesOf(copy, pattern)) {
      const name = typeof said === 'string' ? said : said?.place;
      const place = copy.maps[mapOfPlace(copy, path, said)]?.places?.[name];
      if (name === undefined || place === undefined) continue;
      const parent = path.slice(0, -1).reduce((node, key) => node[key], copy);
      const isCell = path.includes('portals');
      const { x, y } = place;
      const numbers = isCell ? { x: Math.floor(x), y: Math.floor(y) } : { ...place };
      parent[path.at(-1)] = { ...numbers, ...(typeof said === 'string' ? {} : said) };
    }
  }
  return copy;
}

function mapOfPlace(value, [first, index], { map }) {
  if (map !== undefined) return mapNumber(value, map);
  return first === 'maps' ? index : mapNumber(value, startMap(value));
}

// All values that a pattern names: [path, value], ...
export function matchesOf(value, pattern) {
  let found = [[[], value]];
  for (const part of pattern.split('/')) {
    found = found.flatMap(([path, node]) => {
      if (typeof node !== 'object' || node === null) return [];
      if (part !== '*') return Object.hasOwn(node, part) ? [[[...path, part], node[part]]] : [];
      return Array.isArray(node)
        ? node.map((child, index) => [[...path, index], child])
        : Object.entries(node).map(([key, child]) => [[...path, key], child]);
    });
  }
  return found;
}

export function mapNumber(value, name) {
  return value.maps.findIndex((map) => map.name === name);
}

export const startMap = (value) => value.start?.map ?? value.maps[0].name;

export function placesOf(value) {
  return kPoints
    .flatMap((pattern) => matchesOf(value, pattern))
    .filter(([, place]) => isPlaced(place))
    .map(([path, place]) => {
      const { x, y, width = 1, depth = 1 } = place;
      const isArea = path.includes('messages') || path[0] === 'game';
      return {
        path,
        map: mapOfPlace(value, path, place),
        x,
        y,
        width: isArea ? width : 0,
        depth: isArea ? depth : 0,
      };
    });
}

// The blueprint in a cell: {name, blueprint}, or null.
export function blueprintAt(value, map, { level, x, y }) {
  const { legend } = value.maps[map];
  const sign = signsOf(levelsOf(value.maps[map])[level]?.rows[y] ?? '')[x];
  const name = legend?.[sign] ?? value.legend?.[sign];
  const { blueprints = {} } = value;
  const isKnown = Object.hasOwn(blueprints, name ?? '') && blueprints[name] !== null;
  return isKnown ? { name, blueprint: blueprints[name] } : null;
}

export function turned(side, degrees) {
  const at = kSides.indexOf(side);
  if (at >= 0) return kSides[(at + degrees / 90) % 4];
  return side;
}

export function opposite(face) {
  const at = kSides.indexOf(face);
  if (at >= 0) return kSides[(at + 2) % 4];
  return { top: 'bottom', bottom: 'top' }[face];
}

export function beside({ x, y, level }, side) {
  const [east, south] = kStep[side] ?? [0, 0];
  return { x: x + east, y: y + south, level };
}

// One side of a cell, as a box without thickness.
export function sideBox({ x, y, level }, side, { low, high } = { low: 0, high: 1 }) {
  const [west, north, east, south] = [x, y, x + 1, y + 1];
  const box = { west, north, east, south, low: level + low, high: level + high };
  switch (side) {
    case 'north':
      return { ...box, south: north };
    case 'south':
      return { ...box, north: south };
    case 'west':
      return { ...box, east: west };
    case 'east':
      return { ...box, west: east };
    case 'top':
      return { ...box, low: box.high };
    case 'bottom':
      return { ...box, high: box.low };
    default:
      return box;
  }
}

export function middleOf({ west, east, north, south, low, high }) {
  return { x: (west + east) / 2, y: (north + south) / 2, z: (low + high) / 2 };
}

export class Links {
  #scene;
  #known = new Map();

  constructor(scene) {
    this.#scene = scene;
    scene.listen(() => this.#known.clear());
  }

  of(map) {
    if (!this.#known.has(map)) this.#known.set(map, this.#read(map));
    return this.#known.get(map);
  }

  // A scene with faults, as it is while somebody types, may have none.
  #read(map) {
    try {
      return linksOf(this.#scene.value, map);
    } catch (error) {
      if (!(error instanceof TypeError)) throw error;
      return [];
    }
  }
}

export function linksOf(scene, map) {
  const value = withoutNames(scene);
  return [
    ...portals(value, map),
    ...gates(value, map),
    ...movers(value, map),
    ...ways(value, map),
    ...messages(value, map),
    ...findsOf(value).filter((find) => find.map === map),
    ...goal(value, map),
  ];
}

const link = (path, kind, map, rest) => ({
  path,
  kind,
  map,
  area: null,
  radius: null,
  points: [],
  isClosed: false,
  isBack: false,
  ends: [],
  text: '',
  ...rest,
});

const list = (value) => (Array.isArray(value) ? value : []);
export const isPlaced = (at) => typeof at?.x === 'number' && typeof at.y === 'number';

// ---- Portals

// Its two frames: `from`, on the face of the block or around the tile, and `to`, on the `side` of
// the exit where one comes in.
export function framesOf(value, map, { x, y, level = 0, face, to, turn = 0 }) {
  const cell = { x, y, level };
  const exit = { x: to.x, y: to.y, level: to.level ?? level };
  if (face === undefined) return { from: sideBox(cell), to: sideBox(exit), side: null };
  const { low, high } = extentOf(blueprintAt(value, map, cell)?.blueprint);
  const isFlat = face === 'top' || face === 'bottom';
  const side = isFlat ? face : opposite(turned(opposite(face), turn));
  return {
    from: sideBox(cell, face, { low, high }),
    to: sideBox(exit, side, { low, high }),
    side,
  };
}

function portals(value, map) {
  return value.maps.flatMap(({ portals: all }, from) =>
    list(all).flatMap((portal, index) => {
      if (!isPlaced(portal) || !isPlaced(portal.to)) return [];
      const to = portal.to.map === undefined ? from : mapNumber(value, portal.to.map);
      if (from !== map && to !== map) return [];
      const path = ['maps', from, 'portals', index];
      const frames = framesOf(value, from, portal);
      const ends = [
        { path, map: from, mapName: value.maps[from].name, ...middleOf(frames.from) },
        { path: [...path, 'to'], map: to, mapName: portal.to.map, ...middleOf(frames.to) },
      ];
      const areas = [...(from === map ? [frames.from] : []), ...(to === map ? [frames.to] : [])];
      const isBack = portal.twoWay === true;
      const behind = from === map ? opposite(portal.face) : frames.side;
      const away = kStep[behind] ?? [0.7, -0.7];
      return [link(path, 'portal', map, { area: areas[0], areas, ends, isBack, away })];
    }),
  );
}

// ---- Blocks that open or move

// Groups of touching cells of one blueprint: [{cells, area}].
export function groupsOf(value, map, name) {
  const { legend = {} } = value.maps[map];
  const signs = new Set(
    Object.entries({ ...value.legend, ...legend })
      .filter(([, meaning]) => meaning === name)
      .map(([sign]) => sign),
  );
  if (signs.size === 0) return [];
  const cells = new Map();
  levelsOf(value.maps[map]).forEach(({ rows }, level) =>
    list(rows).forEach((row, y) => {
      if (![...signs].some((sign) => row.includes(sign))) return;
      signsOf(row).forEach((sign, x) => {
        if (signs.has(sign)) cells.set(`${level} ${x} ${y}`, { level, x, y });
      });
    }),
  );
  const groups = [];
  for (const [key, first] of cells) {
    if (!cells.delete(key)) continue;
    const group = [first];
    for (const { level, x, y } of group) {
      for (const [up, east, south] of [
        [0, 1, 0],
        [0, -1, 0],
        [0, 0, 1],
        [0, 0, -1],
        [1, 0, 0],
        [-1, 0, 0],
      ]) {
        const next = `${level + up} ${x + east} ${y + south}`;
        if (cells.has(next)) group.push(cells.get(next));
        cells.delete(next);
      }
    }
    groups.push({ cells: group, area: areaOf(group, value.blueprints[name]) });
  }
  return groups;
}

function areaOf(cells, blueprint) {
  const { low, high } = extentOf(blueprint);
  const least = (key) => Math.min(...cells.map((cell) => cell[key]));
  const most = (key) => Math.max(...cells.map((cell) => cell[key]));
  return {
    west: least('x'),
    east: most('x') + 1,
    north: least('y'),
    south: most('y') + 1,
    low: least('level') + low,
    high: most('level') + high,
  };
}

// Finds that a gate or the game needs: all where it wants a number.
export function neededOf(value, needs) {
  if (needs === undefined) return [];
  const names = typeof needs === 'number' ? null : new Set([needs].flat());
  return findsOf(value).filter(({ text }) => names === null || names.has(text));
}

function gates(value, map) {
  return Object.entries(value.blueprints ?? {}).flatMap(([name, { gate }]) => {
    if (gate === undefined) return [];
    const groups = groupsOf(value, map, name);
    if (groups.length === 0) return [];
    const others = [gate.follows ?? []].flat().flatMap((other) =>
      value.maps.flatMap(({ name: mapName }, index) =>
        Object.hasOwn(value.blueprints, other)
          ? groupsOf(value, index, other).map(({ area }) => ({
              path: ['blueprints', other, 'gate'],
              map: index,
              mapName,
              ...middleOf(area),
            }))
          : [],
      ),
    );
    const finds = neededOf(value, gate.needs)
      .filter(({ points }) => points.length > 0)
      .map(({ path, map: at, points: [[x, y, z]] }) => ({
        path,
        map: at,
        mapName: value.maps[at].name,
        x,
        y,
        z,
      }));
    const path = ['blueprints', name, 'gate'];
    return groups.map(({ area }) =>
      link(path, 'gate', map, {
        area,
        points: [pointOf(middleOf(area))],
        radius: gate.approach ?? null,
        ends: [...finds, ...others],
        text: openedBy(gate),
      }),
    );
  });
}

function openedBy({ needs, follows, approach, every, keyed = follows === undefined }) {
  const how = [
    ...(needs === undefined
      ? []
      : [`needs ${typeof needs === 'number' ? `${needs} finds` : [needs].flat().join(', ')}`]),
    ...(follows === undefined ? [] : [`follows ${[follows].flat().join(', ')}`]),
    ...(approach === undefined ? [] : ['opens when somebody comes near']),
    ...(every === undefined ? [] : [`opens every ${every} s`]),
    ...(keyed ? ['opens by key'] : []),
  ];
  return how.join('; ');
}

function movers(value, map) {
  return Object.entries(value.blueprints ?? {}).flatMap(([name, { motion, gate }]) => {
    const { motions = {} } = value;
    if (gate !== undefined || !Object.hasOwn(motions, motion ?? '')) return [];
    const how = motions[motion];
    const axis = { x: 0, y: 1, z: 2 }[how.along ?? 'z'];
    return groupsOf(value, map, name).map(({ area }) => {
      const ends = [how.from ?? 0, how.to].map((by) => {
        const point = pointOf(middleOf(area));
        point[axis] += by;
        return point;
      });
      const path = ['motions', motion];
      return link(path, 'mover', map, { area, points: ends, isBack: true, text: name });
    });
  });
}

const pointOf = ({ x, y, z = 0 }) => [x, y, z];

// ---- Figures

function ways(value, map) {
  const own = list(value.maps[map].objects).flatMap((object, index) => {
    const path = ['maps', map, 'objects', index, 'motion'];
    const { motion, x, y, z = 0 } = object;
    if (motion === undefined) return [];
    const from = [x, y, z + kOverGround];
    const text = object.sprite;
    switch (motion.kind) {
      case 'pace': {
        const angle = ((motion.heading ?? 0) * Math.PI) / 180;
        const { reach = 0 } = motion;
        const to = [x + reach * Math.cos(angle), y + reach * Math.sin(angle), from[2]];
        return [link(path, 'way', map, { points: [from, to], isBack: true, text })];
      }
      case 'circle':
        return [link(path, 'way', map, { points: ring(from, motion.reach), isClosed: true, text })];
      case 'wander':
        if (motion.reach === undefined) return [];
        return [link(path, 'way', map, { points: [from], radius: motion.reach, text })];
      case 'patrol':
        return patrol(value, map, path, motion, [from], text);
      default:
        return [];
    }
  });
  const sown = list(value.maps[map].sow).flatMap(({ motion, sprite }, index) =>
    motion?.kind === 'patrol'
      ? patrol(value, map, ['maps', map, 'sow', index, 'motion'], motion, [], sprite)
      : [],
  );
  return [...own, ...sown];
}

function ring([x, y, z], reach = 0) {
  return Array.from({ length: kRingPoints }, (_, index) => {
    const angle = (2 * Math.PI * index) / kRingPoints;
    return [x + reach * Math.cos(angle), y + reach * Math.sin(angle), z];
  });
}

function patrol(value, map, path, motion, start, text) {
  const { loop = true } = motion;
  const stops = list(motion.path).map(({ map: name, x, y, z }, index) => ({
    path: [...path, 'path', index],
    map: name === undefined ? map : mapNumber(value, name),
    mapName: name ?? value.maps[map].name,
    x,
    y,
    z: (z ?? start[0]?.[2] ?? 0) + (z === undefined ? 0 : kOverGround),
  }));
  const here = stops.filter((stop) => stop.map === map);
  return [
    link(path, 'way', map, {
      points: [...start, ...here.map(pointOf)],
      closesAt: start.length, // the figure's own place is not part of the round
      isClosed: loop && stops.length > 2,
      isBack: !loop || stops.length === 2,
      ends: stops,
      text,
    }),
  ];
}

// ---- Texts, finds and the goal

function areaBox({ x, y, width = 1, depth = 1, bottom = 0, top = bottom + 1 }) {
  return { west: x, north: y, east: x + width, south: y + depth, low: bottom, high: top };
}

function messages(value, map) {
  const { messages: areas, objects } = value.maps[map];
  return [
    ...list(areas).map((area, index) =>
      link(['maps', map, 'messages', index], 'message', map, {
        area: areaBox(area),
        text: area.text,
      }),
    ),
    ...list(objects).flatMap(({ message, x, y, z = 0 }, index) =>
      message === undefined
        ? []
        : [
            link(['maps', map, 'objects', index, 'message'], 'message', map, {
              points: [[x, y, z + kOverGround]],
              radius: message.near ?? kMessageNear,
              text: message.text ?? message,
            }),
          ],
    ),
  ];
}

// Of all maps; what is sown has no place.
export function findsOf(value) {
  return value.maps.flatMap(({ objects, sow }, map) => [
    ...list(objects).flatMap(({ find, x, y, z = 0, height = 0 }, index) =>
      find === undefined
        ? []
        : [
            link(['maps', map, 'objects', index, 'find'], 'find', map, {
              points: [[x, y, z + height / 2]],
              text: find.kind ?? find,
            }),
          ],
    ),
    ...list(sow).flatMap(({ find }, index) =>
      find === undefined
        ? []
        : [link(['maps', map, 'sow', index, 'find'], 'find', map, { text: find.kind ?? find })],
    ),
  ]);
}

function goal(value, map) {
  const { at, aim, needs } = value.game ?? {};
  if (at === undefined || (at.map ?? startMap(value)) !== value.maps[map].name) return [];
  const ends = neededOf(value, needs)
    .filter((find) => find.points.length > 0)
    .map(({ path, map: where, points: [[x, y, z]] }) => ({
      path,
      map: where,
      mapName: value.maps[where].name,
      x,
      y,
      z,
    }));
  return [link(['game', 'at'], 'goal', map, { area: areaBox(at), ends, text: aim })];
}
