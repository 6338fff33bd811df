// Makes a scene of a proposal: blocks, floors and ceilings from its layers, objects, lamps and the
// start from its objects. It changes nothing in the proposal, and reads no file.
//
//     const { scene, pictures, notTaken } = await makeScene(proposal);
//
// `scene` is an object as in a scene file; `pictures` has the PNG bytes of each file that it names,
// but for shipped ones, which it names as scenes in assets/scenes do; `notTaken` lists what is
// missing or changed as { place, reason }. It throws an ImportError beyond the engine's limits.

import { startBlocks } from './blocks.js';
import { ImportError, quoted } from './import-error.js';
import {
  kMostCells,
  kMostKinds,
  kMostLegend,
  kMostLevels,
  kMostNotes,
  kMostObjects,
  kMostTitle,
} from './import-limits.js';
import { startLegend } from './legend-signs.js';
import { startLooks } from './looks.js';
import { counted, listNotes } from './notes.js';
import { placeObjects } from './place-objects.js';
import { groundOf, bestPlace, headingAt, placeNear } from './start-place.js';
import { cleanName, uniqueNames } from './titles.js';

const kChoices = {
  layers: ['level', 'floor', 'ceiling', 'sprites', 'leave out'],
  kinds: ['by layer', 'block', 'floor', 'sprite', 'start', 'empty'],
  objectLayers: ['take', 'leave out'],
  classes: ['object', 'start', 'lamp', 'message', 'leave out'],
};
const kByLayer = { level: 'block', floor: 'floor', ceiling: 'ceiling', sprites: 'sprite' };
const kGround = '#76806a'; // where no floor is painted
const kAmbient = { day: '#ffffff', dusk: '#9a9a9a', night: '#404048' }; // of maps with lamps
const kSurroundings = {
  sky: { low: '#d4e0d9', high: '#5b8fc7' },
  light: { multiplier: 8, darkest: 0.75 },
  fog: { start: 30, end: 1500 },
  haze: '#d4e0d9',
};

export async function makeScene(proposal) {
  const fault = (place, found, expected) => new ImportError(proposal.file, place, found, expected);
  checkChoices(proposal, fault);
  const notes = listNotes(kMostNotes);
  for (const { place, reason } of proposal.notTaken) notes.add(place, reason);
  noteLeftOut(proposal, notes);

  // A map that came from a scene keeps what its cells do not say: see export-tmj.js.
  const base = proposal.base?.scene ?? null;
  const old = base?.maps[proposal.base.map] ?? null;
  const looks = startLooks(proposal, base, notes, fault);
  const blocks = startBlocks(proposal, base, old, looks, notes);
  const nameOf = uniqueNames();
  const names = proposal.maps.map(({ name }) => old?.name ?? nameOf(name, 'map'));
  const grids = proposal.maps.map((map, index) => {
    const place = proposal.maps.length === 1 ? '' : `map ${quoted(names[index])}, `;
    return gridsOf(map, proposal, old, blocks, notes, place);
  });
  const cells = grids.reduce((sum, { levels, size }) => sum + size * levels.length, 0);
  if (cells > kMostCells) throw fault('', `${cells} cells on all levels`, `at most ${kMostCells}`);

  const legend = blocks.legend(fault);
  const makeMap = (map, index) => {
    const grid = grids[index];
    const floor = floorOf(map, grid, proposal, old, looks, fault);
    const ceiling = ceilingOf(grid, proposal, old, looks, fault);
    const standing = (x, y, z) => {
      const stack = blocks.stack(grid.levels, Math.floor(y) * map.width + Math.floor(x));
      // The lowest first, so those above raise it further.
      return stack.reduce((feet, [low, high]) => (feet >= low && feet < high ? high : feet), z);
    };
    const placed = placeObjects(map, { ...grid, standing }, proposal, looks, notes, fault);
    const { lamps, messages } = placed;
    const objects = [...(old?.objects ?? []), ...placed.objects];
    const comment = commentOfMap(map, proposal);
    const own = old ?? { name: names[index], ...kSurroundings };
    return {
      starts: [...grid.starts, ...placed.starts],
      map: {
        ...own,
        ...(old === null && comment !== '' && { comment }),
        levels: rowsOf(grid, legend.signs),
        floor,
        ...ceiling,
        ...(objects.length > 0 && { objects }),
        ...(messages.length > 0 && { messages: [...(own.messages ?? []), ...messages] }),
        ...((lamps.length > 0 || placed.isLit) && {
          baked: {
            ...(own.baked ?? { ambient: kAmbient[proposal.light] }),
            lamps: [...(own.baked?.lamps ?? []), ...lamps],
          },
        }),
      },
    };
  };
  const made = proposal.maps.map(makeMap);
  const objects = made.reduce((sum, { map }) => sum + (map.objects?.length ?? 0), 0);
  if (objects > kMostObjects) throw fault('', `${objects} objects`, `at most ${kMostObjects}`);
  const maps = made.map(({ map }) => map);
  const start =
    base?.start ?? startOf({ proposal, made, grids, blocks, ceilings: maps, names, notes });
  const scene = {
    ...(base ?? { title: cleanName(proposal.title, kMostTitle) || 'A map' }),
    textures: looks.textures,
    ...(Object.keys(looks.sprites).length > 0 && { sprites: looks.sprites }),
    blueprints: blocks.blueprints,
    legend: legend.table,
    maps: old === null ? maps : base.maps.map((map) => (map === old ? maps[0] : map)),
    start,
  };
  return { scene, pictures: looks.pictures, notTaken: notes.list() };
}

// What the map and its layers say beyond what the scene shows.
function commentOfMap({ comment }, { maps, layers, objectLayers }) {
  const ofLayers = [...layers, ...objectLayers]
    .filter((layer) => maps.length === 1 && layer.comment !== '')
    .map((layer) => `${layer.name}: ${layer.comment}`);
  return [comment, ...ofLayers].filter((part) => part !== '').join('; ');
}

function checkChoices(proposal, fault) {
  for (const [list, uses] of Object.entries(kChoices))
    for (const { name, use } of proposal[list])
      if (!uses.includes(use))
        throw fault(`${list} ${quoted(name)}`, `the use ${quoted(use)}`, uses.join(', '));
  if (!Object.hasOwn(kAmbient, proposal.light))
    throw fault('', `the light ${quoted(proposal.light)}`, Object.keys(kAmbient).join(', '));
  for (const { name, use, level } of proposal.layers) {
    const isFit = use === 'ceiling' ? level > 0 && level <= 1000 : Number.isInteger(level);
    if (use !== 'leave out' && !(isFit && level >= 0 && (use !== 'level' || level < kMostLevels)))
      throw fault(`layer ${quoted(name)}`, `the level ${quoted(level)}`, 'one from 0 to 31');
  }
}

function noteLeftOut({ layers, kinds, objectLayers }, notes) {
  for (const { name, use, tiles } of layers)
    if (use === 'leave out' && tiles > 0)
      notes.add(`layer ${quoted(name)}`, `left out, with ${counted(tiles, 'tile')}`);
  for (const { name, use, parts, count } of kinds)
    if (use === 'empty' && parts.length > 0 && count > 0)
      notes.add(`tile ${quoted(name)}`, `left out, at ${counted(count, 'place')}`);
  for (const { name, use } of objectLayers)
    if (use === 'leave out') notes.add(`layer ${quoted(name)}`, 'left out, with its objects');
}

// What stands in each cell: blocks by level; for floor and ceiling the kinds one over another.
function gridsOf(map, { layers, kinds, outside }, old, blocks, notes, place) {
  const { width, depth } = map;
  const size = width * depth;
  const grid = {
    width,
    depth,
    size,
    outside,
    levels: [],
    floor: stacksOf(size),
    ceiling: stacksOf(size),
    ceilingHeight: null,
    sprites: [],
    starts: [],
  };
  const owners = [];
  const covered = new Map();
  layers.forEach((layer, number) => {
    const cells = map.cells[number];
    if (layer.use === 'leave out' || cells === undefined || cells === null) return;
    const looks = layer.look === null ? null : map.cells[layer.look];
    const level = Math.min(kMostLevels - 1, Math.floor(layer.level));
    const blockOf = blocks.ofLayer(layer);
    for (let cell = 0; cell < size; ++cell) {
      const kindNumber = cells[cell];
      if (kindNumber === 0) continue;
      const kind = kinds[kindNumber - 1];
      const use = kind.use === 'by layer' ? kByLayer[layer.use] : kind.use;
      if (use === 'block') {
        const rows = (grid.levels[level] ??= new Uint32Array(size));
        owners[level] ??= new Uint16Array(size);
        if (rows[cell] !== 0) {
          const key = `${owners[level][cell]} ${number}`;
          covered.set(key, (covered.get(key) ?? 0) + 1);
        }
        rows[cell] = blockOf(kindNumber, looks?.[cell] ?? 0);
        owners[level][cell] = number;
      } else if (use === 'floor') {
        const look = looks?.[cell] ?? 0;
        if (look === 0) grid.floor.add(cell, kindNumber);
        else if (layers[layer.look].use !== 'floor') grid.floor.add(cell, look);
      } else if (use === 'ceiling') {
        grid.ceiling.add(cell, kindNumber);
        grid.ceilingHeight = Math.max(grid.ceilingHeight ?? 0, layer.level);
      } else if (use === 'sprite' || use === 'start') {
        const at = { x: (cell % width) + 0.5, y: Math.floor(cell / width) + 0.5, z: layer.level };
        if (use === 'sprite') grid.sprites.push({ ...at, kind: kindNumber, layer: layer.name });
        else
          grid.starts.push({
            ...at,
            heading: kind.heading,
            place: `tile ${at.x - 0.5},${at.y - 0.5}`,
          });
      }
    }
  });
  for (const [key, count] of covered) {
    const [lower, upper] = key.split(' ').map((number) => layers[number].name);
    notes.add(
      `${place}layer ${quoted(lower)}`,
      `${counted(count, 'block')} in the place of those of ${quoted(upper)}, which are taken`,
    );
  }
  // At least one level has rows, and those of the scene that the map came from.
  const count = Math.max(grid.levels.length, old?.levels.length ?? 0);
  for (let level = 0; level < count; ++level)
    grid.levels[level] ??= old?.levels[level]?.length > 0 ? new Uint32Array(size) : null;
  if (grid.levels.every((cells) => cells === null)) grid.levels[0] = new Uint32Array(size);
  return grid;
}

// Lists of kinds that lie one over another, each list once: `lists[at[cell]]`.
function stacksOf(size) {
  const at = new Uint32Array(size);
  const lists = [[]];
  const known = new Map();
  return {
    at,
    lists,
    add(cell, kind) {
      const key = at[cell] * (kMostKinds + 1) + kind;
      if (!known.has(key)) {
        known.set(key, lists.length);
        lists.push([...lists[at[cell]], kind]);
      }
      at[cell] = known.get(key);
    },
  };
}

function rowsOf({ levels, width, depth }, signs) {
  return levels.map((cells) =>
    cells === null
      ? []
      : Array.from({ length: depth }, (_, y) =>
          Array.from(cells.subarray(y * width, (y + 1) * width), (block) => signs[block]).join(''),
        ),
  );
}

// Draws the stacks as rows of characters: { legend, tiles, first }; the first is the commonest.
function paint(grid, stacks, { kinds }, legendOf, textureOf, bare, fault, what) {
  const counts = new Uint32Array(stacks.lists.length);
  for (const stack of stacks.at) counts[stack] += 1;
  const signs = [bare];
  const legend = startLegend(legendOf);
  const order = [...counts.keys()].filter((stack) => stack !== 0 && counts[stack] > 0);
  order.sort((a, b) => counts[b] - counts[a]);
  if (order.length > kMostLegend - Object.keys(legendOf).length)
    throw fault('', `${order.length} different ${what} tiles`, `at most ${kMostLegend}`);
  for (const stack of order) {
    const list = stacks.lists[stack];
    const own = kinds[list.at(-1) - 1].sign;
    if (own !== undefined && list.length === 1) signs[stack] = own;
    else signs[stack] = legend.add(textureOf(list), kinds[list.at(-1) - 1].name);
  }
  const { width, depth } = grid;
  const tiles = Array.from({ length: depth }, (_, y) =>
    Array.from(stacks.at.subarray(y * width, (y + 1) * width), (stack) => signs[stack]).join(''),
  );
  const hasLegend = Object.keys(legend.table).length > 0;
  return { legend: hasLegend ? { legend: legend.table } : {}, tiles, first: order[0] };
}

function floorOf(map, grid, proposal, old, looks, fault) {
  const own = typeof old?.floor === 'string' ? { texture: old.floor } : (old?.floor ?? {});
  const background = map.background ?? kGround;
  const textureOf = (list) => looks.texture(list, background);
  const legendOf = { ...own.legend };
  const { legend, tiles } = paint(
    grid,
    grid.floor,
    proposal,
    legendOf,
    textureOf,
    '.',
    fault,
    'floor',
  );
  const texture = own.texture ?? looks.plain(map.floor ?? background, 'floor');
  if (grid.floor.lists.length === 1 && own.tiles === undefined) return old?.floor ?? texture;
  return { ...own, texture, ...legend, tiles };
}

function ceilingOf(grid, proposal, old, looks, fault) {
  const own = old?.ceiling;
  if (grid.ceiling.lists.length === 1 && own?.tiles === undefined)
    return own === undefined ? {} : { ceiling: own };
  const textureOf = (list) => looks.texture(list, null);
  const { legend, tiles, first } = paint(
    grid,
    grid.ceiling,
    proposal,
    { ...own?.legend },
    textureOf,
    ' ',
    fault,
    'ceiling',
  );
  const texture = own?.texture ?? textureOf(grid.ceiling.lists[first]);
  const height = own?.height ?? grid.ceilingHeight;
  return { ceiling: { ...own, height, texture, ...legend, tiles } };
}

function startOf({ proposal, made, grids, blocks, ceilings, names, notes }) {
  const wanted = made.findIndex(({ starts }) => starts.length > 0);
  const index = Math.max(0, wanted);
  made.forEach(({ starts }, number) =>
    starts
      .slice(number === index ? 1 : 0)
      .forEach(({ place }) => notes.add(place, 'another start; a scene has one')),
  );
  const grid = grids[index];
  const ground = groundOf(
    grid.width,
    grid.depth,
    (tile) => blocks.stack(grid.levels, tile),
    (tile) => grid.floor.at[tile] !== 0,
    (tile) => (grid.ceiling.at[tile] === 0 ? null : ceilings[index].ceiling.height),
  );
  const [start] = made[index].starts;
  const place =
    start === undefined ? bestPlace(ground) : placeNear(ground, start.x, start.y, start.z);
  if (start === undefined)
    notes.add('the start', `there is none; it is put at ${place.x},${place.y}`);
  else if (place.x !== start.x || place.y !== start.y || place.z !== start.z)
    notes.add(start.place, `moved to ${place.x},${place.y},${place.z}, where the player has room`);
  const heading = start?.heading ?? headingAt(ground, place.x, place.y);
  return {
    ...(proposal.maps.length > 1 && { map: names[index] }),
    x: place.x,
    y: place.y,
    ...(place.z > 0 && { z: place.z }),
    heading: heading % 360,
  };
}
