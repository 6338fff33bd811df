// Maps that grow, shrink, get and lose levels, are added and removed. All that lies at a
// place in the map moves along, wherever the scene says it.
// Takes and gives values of scenes; a member that goes is undefined in its list, so that
// differences() finds what changed. Changes nothing in place, and knows no document.
//
//     resized(value, 0, { west: 0, north: 2, east: 0, south: -1 })    // tiles added at each side
//     withLevel(value, 0, 1)        withoutLevel(value, 0, 1)
//     withoutMap(value, 0)          withMap(value, { name, ... }, 0)
//     lossesOf(before, after)       // what went, as words: ['3 objects', 'a portal']

import { signsOf } from '../engine/signs.js';
import { levelsOf, sizeOfMap } from './levels.js';

export const kMostTiles = 4096; // of a side

// Where scenes say places: `map` is the name of another map than the one around, if there is one.
// '{}' stands for any name. Who says a place by its name moves along with the place.
// A test compares this with the schema.
export const kPlaces = {
  'maps[].objects[]': { kind: 'thing', keys: ['x', 'y', 'z'] },
  'maps[].objects[].motion.path[]': { kind: 'point', keys: ['map', 'x', 'y', 'z'] },
  'maps[].sow[].motion.path[]': { kind: 'point', keys: ['map', 'x', 'y', 'z'] },
  'maps[].objectRows.legend{}': { kind: 'raised', keys: ['z'] },
  'maps[].objectRows.legend{}.motion.path[]': { kind: 'point', keys: ['map', 'x', 'y', 'z'] },
  'maps[].places{}': { kind: 'start', keys: ['x', 'y', 'z'] },
  'maps[].baked.lamps[]': { kind: 'thing', keys: ['x', 'y', 'z'] },
  'maps[].messages[]': {
    kind: 'area',
    keys: ['x', 'y', 'width', 'depth', 'bottom', 'top'],
  },
  'maps[].portals[]': {
    kind: 'portal',
    keys: ['x', 'y', 'level', 'to.map', 'to.x', 'to.y', 'to.level'],
  },
  'maps[].ceiling': { kind: 'ceiling', keys: ['height'] },
  start: { kind: 'start', keys: ['map', 'x', 'y', 'z'] },
  'game.at': { kind: 'area', keys: ['map', 'x', 'y', 'width', 'depth', 'bottom', 'top'] },
};

// ---- Size

export function resized(value, map, { west, north, east, south }) {
  const size = sizeOfMap(value.maps[map]);
  const [width, depth] = [size.width + west + east, size.depth + north + south];
  const isIn = ({ x, y }) => x >= 0 && y >= 0 && x < width && y < depth;
  const shifted = (place) => ({ ...place, x: tidy(place.x + west), y: tidy(place.y + north) });
  const within = (place) => {
    const next = shifted(place);
    if (isIn(next)) return next;
    const limit = (at, end) => Math.max(0.5, Math.min(end - 0.5, at));
    return { ...next, x: limit(next.x, width), y: limit(next.y, depth) };
  };
  const kept = (place) => (isIn(shifted(place)) ? shifted(place) : undefined);
  const moved = moving(value, map, {
    thing: kept,
    point: within,
    start: within,
    ceiling: (ceiling) => ceiling,
    end: kept,
    exit: kept,
    area: (area) => clipped(shifted(area), width, depth),
  });
  const here = moved.maps[map];
  const rows = (layer, around) => resizedRows(layer, { west, north, east, south }, around);
  const next = { ...here };
  if (here.levels !== undefined) next.levels = writtenLevels(here).map((level) => rows(level, '.'));
  if (here.size !== undefined) next.size = [width, depth];
  if (here.objectRows?.rows !== undefined)
    next.objectRows = { ...here.objectRows, rows: rows(here.objectRows.rows, ' ') };
  for (const plane of ['floor', 'ceiling']) {
    const { tiles } = here[plane] ?? {};
    if (tiles === undefined || tiles.length === 0) continue;
    // A ceiling that is open at its corner goes on so.
    const around = plane === 'ceiling' && tiles[0].startsWith(' ') ? ' ' : '.';
    next[plane] = { ...here[plane], tiles: rows(tiles, around) };
  }
  return withMapAt(moved, map, next);
}

// Levels that are filled or repeated cannot grow at a side, or get one between them: they are
// written out.
function writtenLevels(map) {
  const levels = levelsOf(map);
  return levels.every(({ isWritten }) => isWritten) ? map.levels : levels.map(({ rows }) => rows);
}

function resizedRows(rows, { west, north, east, south }, around) {
  if (rows.length === 0) return rows;
  const wide = rows.map((row) => {
    const signs = signsOf(row);
    const from = Math.max(0, -west);
    const to = signs.length - Math.max(0, -east);
    return (
      around.repeat(Math.max(0, west)) +
      signs.slice(from, to).join('') +
      around.repeat(Math.max(0, east))
    );
  });
  const line = around.repeat(signsOf(rows[0]).length + west + east);
  return [
    ...Array(Math.max(0, north)).fill(line),
    ...wide.slice(Math.max(0, -north), wide.length - Math.max(0, -south)),
    ...Array(Math.max(0, south)).fill(line),
  ];
}

function clipped(area, width, depth) {
  const [west, north] = [Math.max(0, area.x), Math.max(0, area.y)];
  const east = Math.min(width, area.x + (area.width ?? 1));
  const south = Math.min(depth, area.y + (area.depth ?? 1));
  if (west >= east || north >= south) return undefined;
  const next = { ...area, x: west, y: north };
  if (area.width !== undefined) next.width = east - west;
  if (area.depth !== undefined) next.depth = south - north;
  return next;
}

// ---- Levels

// A new empty level, below the one that had this number.
export function withLevel(value, map, at) {
  const up = (height) => (height >= at ? tidy(height + 1) : height);
  const moved = lifting(value, map, {
    up,
    edge: (height) => (height > at ? tidy(height + 1) : height),
    level: up,
  });
  const levels = writtenLevels(moved.maps[map]) ?? [];
  return withMapAt(moved, map, {
    ...moved.maps[map],
    levels: [...levels.slice(0, at), [], ...levels.slice(at)],
  });
}

// What stands in the level comes to stand at its ground.
export function withoutLevel(value, map, at) {
  const down = (height) => (height >= at + 1 ? tidy(height - 1) : Math.min(height, at));
  const moved = lifting(value, map, {
    up: down,
    edge: down,
    level: (level, isCell) => (isCell && level === at ? undefined : down(level)),
  });
  const levels = writtenLevels(moved.maps[map]) ?? [];
  return withMapAt(moved, map, {
    ...moved.maps[map],
    levels: levels.filter((_, level) => level !== at),
  });
}

function lifting(value, map, { up, edge, level }) {
  const raised = (place) => {
    const z = up(place.z ?? 0);
    return z === (place.z ?? 0) ? place : { ...place, z };
  };
  const ifSaid = (place) => (place.z === undefined ? place : raised(place));
  const set = (object, key, height) =>
    object[key] === undefined || object[key] === height ? object : { ...object, [key]: height };
  const end = (cell, isCell) => {
    const next = level(cell.level, isCell);
    return next === undefined ? undefined : { ...cell, level: next };
  };
  return moving(value, map, {
    thing: raised,
    start: raised,
    point: ifSaid,
    raised: ifSaid,
    ceiling: (ceiling) => set(ceiling, 'height', edge(ceiling.height) || ceiling.height),
    area: (area) =>
      set(set(area, 'bottom', up(area.bottom)), 'top', Math.min(1000, edge(area.top))),
    end: (cell, portal) => end(cell, portal.face !== undefined),
    exit: (cell) => end(cell, true),
  });
}

// ---- Maps

// What leads to the map goes, too. The start comes to the middle of the first map that is left.
export function withoutMap(value, map) {
  const old = value.maps[map].name;
  const other = value.maps.find((_, index) => index !== map);
  const gone = (place, home) => ((place.map ?? home) === old ? undefined : place);
  const next = overPlaces(value, {
    point: gone,
    area: gone,
    portal: (portal, home) => (gone(portal.to, home) === undefined ? undefined : portal),
    start: (start, home) => {
      if ((start.map ?? home) !== old) return start;
      const { width, depth } = sizeOfMap(other);
      return { map: other.name, x: width / 2, y: depth / 2 };
    },
  });
  return {
    ...next,
    maps: next.maps.map((one, index) => (index === map ? undefined : withoutEmptyPaths(one))),
  };
}

// Whose path has gone stands still.
function withoutEmptyPaths(map) {
  const still = (one) => {
    const { path } = one?.motion ?? {};
    if (path === undefined || path.some((point) => point !== undefined)) return one;
    const { motion, ...rest } = one;
    return motion.kind === 'patrol' ? rest : one;
  };
  const next = { ...map };
  for (const list of ['objects', 'sow'])
    if (map[list]?.some((one) => still(one) !== one)) next[list] = map[list].map(still);
  return next;
}

// Empty, under the sky and in the light of another one.
export function withMap(value, { name, width, depth, floor }, like) {
  const { sky, light, baked, fog, haze } = value.maps[like];
  const lit = baked === undefined ? undefined : { ...baked, lamps: undefined };
  const map = {
    name,
    levels: [Array(depth).fill('.'.repeat(width))],
    floor,
    sky,
    light,
    baked: lit,
    fog,
    haze,
  };
  return { ...value, maps: [...value.maps, JSON.parse(JSON.stringify(map))] };
}

// ---- Places

// The values at places of one map: `end` and `exit` are the two cells of a portal.
function moving(value, map, { thing, point, start, raised, area, ceiling, end, exit }) {
  const { name } = value.maps[map];
  const ifHere = (act) => (place, home) =>
    (place.map ?? home) === name && isSaid(place) ? act(place) : place;
  const portal = (one, home) => {
    const level = one.level ?? 0;
    const own = home === name ? end({ ...one, level }, one) : { ...one, level };
    const there = { ...one.to, level: one.to.level ?? level };
    const isHere = (one.to.map ?? home) === name && isSaid(one.to);
    const to = isHere ? exit(there) : isSaid(one.to) ? there : one.to;
    if (own === undefined || to === undefined) return undefined;
    const next = { ...own, to };
    if (one.level === undefined && own.level === 0) delete next.level;
    if (one.to.level === undefined && isSaid(to) && to.level === own.level) delete to.level;
    return JSON.stringify(next) === JSON.stringify(one) ? one : next;
  };
  return overPlaces(value, {
    thing: ifHere(thing),
    point: ifHere(point),
    start: ifHere(start),
    raised: ifHere(raised ?? ((one) => one)),
    area: ifHere(area),
    ceiling: (one, home) => (home === name ? ceiling(one) : one),
    portal,
  });
}

// By its numbers, not by a name.
const isSaid = (place) => typeof place === 'object' && place.place === undefined;

// Each place of the kinds, with the name of the map where it lies if it names none.
function overPlaces(value, acts) {
  let next = value;
  for (const [path, { kind }] of Object.entries(kPlaces)) {
    if (acts[kind] === undefined) continue;
    const first = value.maps[0].name;
    const home = path === 'game.at' ? (value.start?.map ?? first) : first;
    next = over(next, path.split('.'), home, acts[kind]);
  }
  return next;
}

function over(node, [step, ...rest], home, act) {
  if (node === undefined) return undefined;
  if (step === undefined) return act(node, home);
  const key = step.replace(/\[\]|\{\}/, '');
  const child = node[key];
  if (child === undefined || typeof child !== 'object') return node;
  if (step.endsWith('{}')) {
    const entries = Object.entries(child).map(([one, value]) => [
      one,
      over(value, rest, home, act),
    ]);
    const isSame = entries.every(([one, value]) => value === child[one]);
    return isSame ? node : { ...node, [key]: Object.fromEntries(entries) };
  }
  const next =
    step === key
      ? over(child, rest, home, act)
      : child.map((one) => over(one, rest, key === 'maps' ? one.name : home, act));
  const isSame = step === key ? next === child : next.every((one, index) => one === child[index]);
  return isSame ? node : { ...node, [key]: next };
}

const withMapAt = (value, map, next) => ({
  ...value,
  maps: value.maps.map((one, index) => (index === map ? next : one)),
});

const kPrecise = 1e9; // a step there and back leaves no trace
const tidy = (number) => Math.round(number * kPrecise) / kPrecise;

// ---- What goes

const kLists = {
  object: (map) => map.objects,
  lamp: (map) => map.baked?.lamps,
  message: (map) => map.messages,
  portal: (map) => map.portals,
};

export function lossesOf(before, after) {
  const losses = [];
  for (const [what, listOf] of Object.entries(kLists)) {
    const count = before.maps.reduce((sum, map, index) => {
      const next = after.maps[index];
      const left = next === undefined ? [] : (listOf(next) ?? []).filter(Boolean);
      return sum + (listOf(map) ?? []).length - left.length;
    }, 0);
    if (count > 0) losses.push(count === 1 ? `1 ${what}` : `${count} ${what}s`);
  }
  const blocks = blocksIn(before) - blocksIn(after);
  if (blocks > 0) losses.push(blocks === 1 ? '1 block' : `${blocks} blocks`);
  if (before.game?.at !== undefined && after.game?.at === undefined)
    losses.push('the place of the goal');
  return losses;
}

const blocksIn = ({ maps }) =>
  maps
    .filter(Boolean)
    .flatMap((map) => levelsOf(map).flatMap(({ rows }) => rows))
    .reduce((sum, row) => sum + signsOf(row).filter((sign) => !'. '.includes(sign)).length, 0);
