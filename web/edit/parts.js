// Parts of worlds: what selected cells hold, to be put elsewhere. A part names its kinds, textures
// and sprites as a scene does, so that other worlds can take it.
// Takes a document and cells (selection.js); gives parts and changes. Changes nothing itself.
//
//     const part = partOf(scene, 0, cells);
//     turnedPart(part, kTurns.right)
//     pasteChanges(scene, 0, part, { level: 0, x: 3, y: 4 })     // its low north-western corner
//     cellsOfPart(part, at)                                      // the set of them
//
// {width, depth, levels, cells: [{level, x, y, sign}], legend, blueprints, motions, textures,
// sprites, objects, lamps, portals, map, world}: places count from that corner. An exit that names
// a map lies outside the part, in the world with that name.

import { cellChanges, isInside, signReader } from './cells.js';
import { carriedLamp, carriedObject, isWithin, placeOfThing } from './carrying.js';
import { draftOf, freeName, isSame, kindFor } from './kinds.js';
import { boxAround, cellOf, keyOf, transformed, transformOf } from './selection.js';
import { shippedPicture } from './files/shipped.js';
import { turnedKinds } from './turned-kinds.js';
import { isStill, kStill, turnedFace, turnedPortal } from './turning.js';

export function partOf(scene, map, cells, world = '') {
  const { from, to } = boxAround(cells);
  const by = { level: -from.level, x: -from.x, y: -from.y };
  const transform = transformOf({ from, to }, kStill, by);
  const { legend = {}, blueprints = {}, maps } = scene.value;
  const here = maps[map];
  const names = { ...legend, ...here.legend };
  const part = {
    width: to.x - from.x + 1,
    depth: to.y - from.y + 1,
    levels: to.level - from.level + 1,
    cells: [],
    legend: {},
    blueprints: {},
    motions: {},
    textures: {},
    sprites: {},
    objects: [],
    lamps: [],
    portals: [],
    map: here.name,
    world,
  };
  const signAt = signReader(scene, map);
  for (const key of cells) {
    const cell = cellOf(key);
    const sign = signAt(cell.level, cell.x, cell.y);
    if (!Object.hasOwn(blueprints, names[sign])) continue;
    part.cells.push({ ...transform.cell(cell), sign });
    part.legend[sign] = names[sign];
  }
  const isIn = (thing) => isWithin(scene, map, cells, placeOfThing(thing));
  part.objects = (here.objects ?? [])
    .filter(isIn)
    .map((object) => withOwnPath(carriedObject(object, transform, here.name, {}), here.name));
  part.lamps = (here.baked?.lamps ?? []).filter(isIn).map((lamp) => carriedLamp(lamp, transform));
  for (const portal of here.portals ?? []) {
    const { x, y, level = 0, to: exit } = portal;
    if (!cells.has(keyOf({ level, x, y }))) continue;
    const there = { level: exit.level ?? level, x: exit.x, y: exit.y };
    const isOwn = (exit.map ?? here.name) === here.name && cells.has(keyOf(there));
    part.portals.push({
      ...portal,
      ...transform.cell({ level, x, y }),
      to: isOwn ? transform.cell(there) : { ...exit, ...there, map: exit.map ?? here.name },
    });
  }
  collect(part, scene.value);
  return part;
}

// Points in the part's map name none, so that they lie in the map where it is pasted.
function withOwnPath(object, name) {
  const { motion } = object;
  if (motion?.path === undefined) return object;
  const path = motion.path.map(({ map, ...point }) =>
    map === undefined || map === name ? point : { map, ...point },
  );
  return { ...object, motion: { ...motion, path } };
}

export function isEmptyPart({ cells, objects, lamps }) {
  return cells.length + objects.length + lamps.length === 0;
}

// What the part's blocks and objects are made of.
function collect(part, { blueprints = {}, motions = {}, textures = {}, sprites = {} }) {
  const take = (kind, all, name, then = () => {}) => {
    if (name === undefined || Object.hasOwn(part[kind], name)) return;
    const entry = Object.hasOwn(all, name) ? all[name] : shippedPicture(kind, name);
    if (entry === undefined) return;
    part[kind][name] = entry;
    then(entry);
  };
  const texture = (name) =>
    take('textures', textures, name, ({ variants = [] }) => variants.forEach(texture));
  const blueprint = (name) =>
    take('blueprints', blueprints, name, ({ faces, motion, gate }) => {
      const looks = typeof faces === 'string' ? [faces] : Object.values(faces ?? {});
      for (const look of looks) texture(look.texture ?? look);
      take('motions', motions, motion);
      for (const followed of [gate?.follows ?? []].flat()) blueprint(followed);
    });
  Object.values(part.legend).forEach(blueprint);
  for (const { sprite, motion } of part.objects)
    for (const name of [sprite, motion?.sprites?.walk, motion?.sprites?.alert])
      take('sprites', sprites, name);
}

export function turnedPart(part, turn) {
  if (isStill(turn)) return part;
  const { width, depth, levels } = part;
  const box = {
    from: { level: 0, x: 0, y: 0 },
    to: { level: levels - 1, x: width - 1, y: depth - 1 },
  };
  const isAcross = turn[0] === 0;
  const { from } = boxAround(transformed(cornersOf(box), transformOf(box, turn)));
  const transform = transformOf(box, turn, { level: 0, x: -from.x, y: -from.y });
  const wanted = Object.values(part.legend);
  const { blueprints, motions, names } = turnedKinds(part, wanted, turn);
  return {
    ...part,
    blueprints,
    motions,
    width: isAcross ? depth : width,
    depth: isAcross ? width : depth,
    legend: Object.fromEntries(
      Object.entries(part.legend).map(([sign, name]) => [sign, names.get(name)]),
    ),
    cells: part.cells.map((cell) => ({ ...transform.cell(cell), sign: cell.sign })),
    objects: part.objects.map((object) => carriedObject(object, transform, part.map, part.sprites)),
    lamps: part.lamps.map((lamp) => carriedLamp(lamp, transform)),
    portals: part.portals.map((portal) => {
      const isOwn = portal.to.map === undefined;
      const turned = {
        ...portal,
        ...transform.cell({ level: portal.level ?? 0, x: portal.x, y: portal.y }),
        to: isOwn ? transform.cell(portal.to) : portal.to,
        turn: turnedPortal(portal, turn, isOwn ? turn : kStill),
      };
      if (portal.face !== undefined) turned.face = turnedFace(portal.face, turn);
      return turned;
    }),
  };
}

const cornersOf = ({ from, to }) => [keyOf(from), keyOf(to)];

export function cellsOfPart(part, at) {
  const cells = new Set(part.cells.map((cell) => keyOf(movedCell(cell, at))));
  for (const thing of [...part.objects, ...part.lamps])
    cells.add(keyOf(movedCell(placeOfThing(thing), at)));
  return cells;
}

const movedCell = ({ level, x, y }, at) => ({ level: level + at.level, x: x + at.x, y: y + at.y });

export function pasteChanges(scene, map, part, at, world = '') {
  const draft = draftOf(scene);
  const renamed = { textures: new Map(), motions: new Map(), sprites: new Map() };
  // The same entry of the scene, or a new one; the name in the scene.
  const bring = (kind, name) => {
    const entry = part[kind][name];
    if (entry === undefined || renamed[kind].has(name)) return renamed[kind].get(name) ?? name;
    const known = draft.value[kind] ?? {};
    if (!Object.hasOwn(known, name) && isSame(shippedPicture(kind, name), entry)) return name;
    const same = [name, ...Object.keys(known)].find(
      (other) => Object.hasOwn(known, other) && isSame(known[other], entry),
    );
    const chosen = same ?? freeName(name, known);
    renamed[kind].set(name, chosen);
    if (same !== undefined) return chosen;
    const { variants } = entry;
    draft.take([{ path: [kind, chosen], value: entry }]);
    if (variants !== undefined) {
      const named = variants.map((other) => bring(kind, other));
      draft.take([{ path: [kind, chosen], value: { ...entry, variants: named } }]);
    }
    return chosen;
  };
  const settled = (blueprint) => {
    const look = (face) =>
      typeof face === 'string'
        ? bring('textures', face)
        : { ...face, texture: bring('textures', face.texture) };
    const { faces, motion } = blueprint;
    const next = { ...blueprint };
    if (faces !== undefined)
      next.faces =
        typeof faces === 'string'
          ? look(faces)
          : Object.fromEntries(
              Object.entries(faces).map(([name, face]) => [
                name,
                name === 'comment' ? face : look(face),
              ]),
            );
    if (motion !== undefined) next.motion = bring('motions', motion);
    return next;
  };

  const signs = new Map();
  for (const [sign, name] of Object.entries(part.legend)) {
    const blueprint = settled(part.blueprints[name]);
    const { legend = {}, blueprints = {}, maps } = draft.value;
    const own = { ...legend, ...maps[map].legend }[sign];
    if (own === name && isSame(blueprints[name], blueprint)) {
      signs.set(sign, sign);
      continue;
    }
    const kind = kindFor(draft, map, name, blueprint);
    draft.take(kind.changes);
    signs.set(sign, kind.sign);
  }
  // Gates that others follow are there, too.
  const inLegend = new Set(Object.values(part.legend));
  for (const [name, blueprint] of Object.entries(part.blueprints))
    if (!inLegend.has(name) && !Object.hasOwn(draft.value.blueprints ?? {}, name))
      draft.take([{ path: ['blueprints', name], value: settled(blueprint) }]);

  const cells = part.cells.map((cell) => {
    const { level, x, y } = movedCell(cell, at);
    return { layer: level, x, y, sign: signs.get(cell.sign) };
  });
  const here = scene.value.maps[map];
  const box = { from: { level: 0, x: 0, y: 0 }, to: { level: 0, x: 0, y: 0 } };
  const transform = transformOf(box, kStill, at);
  const isIn = ({ x, y, z = 0 }) => isInside(scene, map, { x, y }) && z >= 0;
  const sprite = (name) => (name === undefined ? undefined : bring('sprites', name));
  const objects = part.objects
    .map((object) => carriedObject(object, transform, part.map, {}))
    .filter(isIn)
    .map((object) => withSprites(withPath(object, scene), sprite));
  const lamps = here.baked === undefined ? [] : part.lamps;
  const isHome = part.world === world;
  const isFree = (portal) => !(here.portals ?? []).some((other) => isSameEnd(other, portal));
  const portals = part.portals
    .filter(({ to }) => to.map === undefined || (isHome && hasMap(scene, to.map)))
    .map((portal) => ({
      ...portal,
      ...movedCell({ level: portal.level ?? 0, x: portal.x, y: portal.y }, at),
      to: portal.to.map === undefined ? movedCell(portal.to, at) : portal.to,
    }))
    .filter(
      (portal) =>
        isInside(scene, map, portal) &&
        (portal.to.map !== undefined || isInside(scene, map, portal.to)) &&
        isFree(portal),
    );
  return [
    ...draft.changes(),
    ...cellChanges(scene, map, cells),
    ...appended(scene, ['maps', map, 'objects'], objects),
    ...appended(
      scene,
      ['maps', map, 'baked', 'lamps'],
      lamps.map((lamp) => carriedLamp(lamp, transform)).filter(isIn),
    ),
    ...appended(scene, ['maps', map, 'portals'], portals),
  ];
}

const hasMap = (scene, name) => scene.value.maps.some((map) => map.name === name);

const isSameEnd = (one, other) =>
  one.x === other.x &&
  one.y === other.y &&
  one.face === other.face &&
  (one.face === undefined || (one.level ?? 0) === (other.level ?? 0));

// Points in maps that are not there are left out; whose path is gone stands still.
function withPath(object, scene) {
  const { motion, ...rest } = object;
  if (motion?.path === undefined) return object;
  const path = motion.path.filter(({ map }) => map === undefined || hasMap(scene, map));
  return path.length === 0 ? rest : { ...object, motion: { ...motion, path } };
}

function withSprites(object, sprite) {
  const next = { ...object, sprite: sprite(object.sprite) };
  const { sprites } = object.motion ?? {};
  if (sprites !== undefined) {
    const named = { ...sprites };
    for (const key of ['walk', 'alert'])
      if (sprites[key] !== undefined) named[key] = sprite(sprites[key]);
    next.motion = { ...object.motion, sprites: named };
  }
  return next;
}

function appended(scene, path, things) {
  if (things.length === 0) return [];
  const present = path.reduce((node, key) => node?.[key], scene.value) ?? [];
  if (present.length === 0) return [{ path, value: things }];
  const values = things.map((value, index) => ({ path: [...path, present.length + index], value }));
  return [{ together: values }];
}
