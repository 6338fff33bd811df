// Reads maps of Tiled into a draft: what its JSON files hold, or its XML files once tiled-xml.js
// has turned them into that. Tilesets, templates and pictures come through `files`. What Tiled has
// and a scene has not is noted in the draft, each with its place.
//
//     await readTiled(source, 'town.tmx', files);              // a draft

import { startDraft } from './draft.js';
import { ImportError, quoted } from './import-error.js';
import { kMostFrames, kMostLayers, kMostNesting } from './import-limits.js';
import { counted } from './notes.js';
import { commentOf, isTrue, numberOf, propertiesOf } from './properties.js';
import { readCells } from './tiled-cells.js';
import { parseTiled } from './tiled-text.js';
import { titleOf } from './titles.js';
import { signsOf } from '../../engine/signs.js';

const kFlips = [
  [0x80000000, 1], // horizontally
  [0x40000000, 2], // vertically
  [0x20000000, 4], // along the diagonal
];
const kIdMask = 0x0fffffff; // the fourth bit is for hexagonal maps
const kShapes = ['ellipse', 'point', 'capsule', 'polygon', 'polyline'];
const kToldOfLayers = ['level', 'floor', 'ceiling', 'bottom', 'top'];

export async function readTiled(source, file, files) {
  const { orientation = 'orthogonal', tilewidth, tileheight } = source;
  if (source.type === 'tileset' || source.type === 'template' || !Array.isArray(source.layers))
    throw new ImportError(file, '', `a ${source.type ?? 'file'} without layers`, 'a map of Tiled');
  if (orientation !== 'orthogonal')
    throw new ImportError(file, '', `the orientation ${quoted(orientation)}`, 'orthogonal');
  if (!(tilewidth >= 1) || !(tileheight >= 1))
    throw new ImportError(file, '', `tiles of ${tilewidth} x ${tileheight}`, 'a size from 1 x 1');

  const own = propertiesOf(source.properties);
  const draft = startDraft(file, 'Tiled', titleOf(own, file));
  draft.base = baseOfMap(own, draft);
  const tiles = await tilesOf(source, file, files, draft);
  const layers = flatLayers(source.layers, file, draft);
  const area = areaOf(source, layers, file, draft);
  const map = {
    name: draft.title,
    width: area.width,
    depth: area.depth,
    background: colourOf(source.backgroundcolor),
    floor: null,
    comment: commentOf(source.class ?? '', own, ['title', 'name', 'slicecast']),
    cells: [],
    objects: [],
  };
  for (const layer of layers) {
    if (layer.type === 'tilelayer')
      map.cells[addLayer(layer, draft)] = await cellsOf(layer, area, source, tiles, file, draft);
    else if (layer.type === 'objectgroup')
      await readObjects(layer, { area, source, tiles, file, files, draft, map });
    else draft.note(layer.place, `layers of the type ${quoted(layer.type)} have no counterpart`);
  }
  draft.map(map);
  return draft;
}

// An absent list is empty; anything else than a list is an error.
function listOf(value, file, place) {
  if (value === undefined || value === null) return [];
  if (Array.isArray(value)) return value;
  throw new ImportError(file, place, quoted(value), 'a list');
}

// ---- Layers

// In drawing order, without groups; offsets, properties and what hides them come from the groups.
function flatLayers(list, file, draft, outer = {}, depth = 0, flat = []) {
  const { path = '', x = 0, y = 0, isHidden = false, own: outerOwn = new Map() } = outer;
  if (!Array.isArray(list)) throw new ImportError(file, path, 'no layers', 'a list of layers');
  if (depth > kMostNesting)
    throw new ImportError(file, path, 'groups within groups', `at most ${kMostNesting} deep`);
  for (const layer of list) {
    if (typeof layer !== 'object' || layer === null)
      throw new ImportError(file, path, quoted(layer), 'a layer');
    const name = String(layer.name || layer.type).slice(0, 200);
    const whole = {
      ...layer,
      path: `${path}${name}`,
      place: `layer ${quoted(path + name)}`,
      x: x + (Number(layer.offsetx) || 0),
      y: y + (Number(layer.offsety) || 0),
      isHidden: isHidden || layer.visible === false || layer.visible === 0,
      own: new Map([...outerOwn, ...propertiesOf(layer.properties)]),
    };
    noteLooks(layer, whole.place, draft);
    if (layer.type === 'group')
      flatLayers(
        layer.layers,
        file,
        draft,
        { ...whole, path: `${whole.path}/`.slice(-1000) },
        depth + 1,
        flat,
      );
    else flat.push(whole);
    if (flat.length > kMostLayers)
      throw new ImportError(file, '', `${flat.length} layers`, `at most ${kMostLayers}`);
  }
  return flat;
}

function noteLooks(layer, place, draft) {
  if (layer.opacity !== undefined && Number(layer.opacity) !== 1)
    draft.note(place, `its opacity of ${quoted(layer.opacity)} is left out`);
  if (layer.tintcolor) draft.note(place, `its tint ${quoted(layer.tintcolor)} is left out`);
  if (layer.mode !== undefined && layer.mode !== 'normal')
    draft.note(place, `its blending ${quoted(layer.mode)} is left out`);
  const parallax = [layer.parallaxx ?? 1, layer.parallaxy ?? 1].map(Number);
  if (parallax.some((factor) => factor !== 1)) draft.note(place, 'its parallax is left out');
}

function addLayer({ path, own, isHidden, class: kind = '' }, draft) {
  const level = numberOf(own, 'level', 0, 1000);
  const ceiling = numberOf(own, 'ceiling', 0, 1000);
  const use = isHidden
    ? 'leave out'
    : isTrue(own, 'floor')
      ? 'floor'
      : isTrue(own, 'ceiling') || ceiling !== null
        ? 'ceiling'
        : level !== null || own.has('bottom') || own.has('top')
          ? 'level'
          : null;
  return draft.layer({
    name: path,
    use,
    level: use === 'ceiling' ? ceiling : level,
    bottom: numberOf(own, 'bottom', 0, 1),
    top: numberOf(own, 'top', 0, 1),
    comment: commentOf(kind, own, kToldOfLayers),
  });
}

// The tiles that the map takes, and in which of its tiles the origin lies. Maps without end take
// what their chunks cover.
function areaOf(source, layers, file, draft) {
  const chunks = layers
    .filter(({ type }) => type === 'tilelayer')
    .flatMap((layer) => listOf(layer.chunks, file, layer.place));
  const isEndless = source.infinite === true || source.infinite === 1;
  const area = { x: 0, y: 0, width: source.width, depth: source.height };
  if (isEndless && chunks.length > 0) {
    for (const chunk of chunks) {
      const { x, y, width, height } = chunk ?? {};
      if (![x, y].every(Number.isInteger) || !(width >= 1 && height >= 1))
        throw new ImportError(
          file,
          '',
          `a chunk of ${quoted(width)} x ${quoted(height)} at ${quoted(x)},${quoted(y)}`,
          'whole numbers',
        );
    }
    const least = (of) => chunks.reduce((most, chunk) => Math.min(most, of(chunk)), Infinity);
    area.x = least(({ x }) => x);
    area.y = least(({ y }) => y);
    area.width = -least(({ x, width }) => -x - width) - area.x;
    area.depth = -least(({ y, height }) => -y - height) - area.y;
  }
  const places = layers.filter(({ type }) => type === 'tilelayer').map(({ place }) => place);
  for (const place of places.length > 0 ? places : ['the map'])
    draft.room(place, area.width, area.depth);
  return area;
}

async function cellsOf(layer, area, source, tiles, file, draft) {
  const cells = new Uint32Array(area.width * area.depth);
  const shift = { x: layer.x / source.tilewidth, y: layer.y / source.tileheight };
  const whole = { x: Math.round(shift.x), y: Math.round(shift.y) };
  if (whole.x !== shift.x || whole.y !== shift.y)
    draft.note(layer.place, `its offset of ${layer.x},${layer.y} pixels is rounded to whole tiles`);
  const fault = (found, expected) => new ImportError(file, layer.place, found, expected);
  let outside = 0;
  const unknown = new Map();
  const chunks = layer.chunks ?? [
    { x: 0, y: 0, width: layer.width ?? area.width, height: layer.height ?? area.depth, ...layer },
  ];
  for (const { width, height, data, ...chunk } of chunks) {
    const [x, y] = layer.chunks === undefined ? [0, 0] : [chunk.x, chunk.y];
    draft.room(layer.place, width, height);
    const gids = await readCells(data, layer, width * height, fault);
    gids.forEach((gid, index) => {
      if ((gid & kIdMask) === 0) return;
      const kind = tiles.kindOf(gid);
      if (kind === 0) {
        unknown.set(gid & kIdMask, (unknown.get(gid & kIdMask) ?? 0) + 1);
        return;
      }
      const toX = x + (index % width) - area.x + whole.x;
      const toY = y + Math.floor(index / width) - area.y + whole.y;
      if (toX < 0 || toY < 0 || toX >= area.width || toY >= area.depth) outside += 1;
      else cells[toY * area.width + toX] = kind;
    });
  }
  if (outside > 0) draft.note(layer.place, `${counted(outside, 'tile')} outside the map, left out`);
  for (const [gid, count] of unknown)
    draft.note(layer.place, `tile ${gid}, which no tileset has, at ${counted(count, 'place')}`);
  return cells;
}

// ---- Tilesets

async function tilesOf(source, file, files, draft) {
  const sets = [];
  for (const entry of listOf(source.tilesets, file, 'tilesets'))
    sets.push(await tilesetOf(entry, file, files, draft));
  sets.sort((a, b) => a.first - b.first);
  const known = new Map();
  const kindOf = (gid) => {
    if (!known.has(gid)) known.set(gid, kindIn(setWith(sets, gid & kIdMask), gid));
    return known.get(gid);
  };
  const kindIn = (set, gid) => {
    const found = set === undefined ? null : tileIn(set, gid, files, draft);
    if (found === null) return 0;
    const { id, flip, part, own } = found;
    const tile = set.tiles.get(id);
    const properties = propertiesOf(tile?.properties);
    const name = `${set.name} ${id}`;
    const kind = tile?.class || tile?.type || '';
    return draft.kind(`${set.key}/${id}/${flip}`, () => ({
      name: flip === 0 ? name : `${name} turned ${flip}`,
      class: kind,
      size: { width: own.width / source.tilewidth, height: own.height / source.tileheight },
      parts: part === null ? [] : [{ ...part, flip }],
      ...framesOf(tile, set, gid, name),
      use: useOf(kind, properties),
      bottom: numberOf(properties, 'bottom', 0, 1),
      top: numberOf(properties, 'top', 0, 1),
      comment: commentOf(kind, properties, ['bottom', 'top', 'floor', 'sprite']),
      ...keptOf(properties, draft.base),
    }));
  };
  // The pictures of an animated tile, and how many it shows in a second.
  const framesOf = (tile, set, gid, name) => {
    const list = Array.isArray(tile?.animation) ? tile.animation : [];
    if (list.length < 2) return {};
    const place = `tile ${quoted(name)}`;
    if (list.length > kMostFrames)
      draft.note(place, `only ${kMostFrames} pictures of its animation are taken`);
    const frames = list.slice(0, kMostFrames).map((frame) => {
      const found = tileIn(
        set,
        gid - (gid & kIdMask) + set.first + Number(frame?.tileid),
        files,
        draft,
      );
      return found === null || found.part === null ? [] : [{ ...found.part, flip: found.flip }];
    });
    const durations = list.map((frame) => Number(frame?.duration) || 100);
    if (durations.some((one) => one !== durations[0]))
      draft.note(place, 'the pictures of its animation are shown equally long');
    const mean = durations.reduce((sum, one) => sum + one, 0) / durations.length;
    return { frames, rate: Math.min(120, Math.max(0.01, Math.round(1e5 / mean) / 100)) };
  };
  return { kindOf, sets, kindIn };
}

// What export-tmj.js writes beside a tile: its character, and the blueprint that this stands for.
function keptOf(properties, base) {
  const [sign, blueprint] = [properties.get('character'), properties.get('blueprint')];
  if (base === null || typeof sign !== 'string' || signsOf(sign).length !== 1) return {};
  return { sign, ...(Object.hasOwn(base.scene.blueprints ?? {}, blueprint) && { blueprint }) };
}

// The scene that the map came from, without the map's cells; null if it came from elsewhere.
function baseOfMap(own, draft) {
  const text = own.get('slicecast');
  if (typeof text !== 'string') return null;
  try {
    const { scene, map } = JSON.parse(text);
    if (Array.isArray(scene.maps[map].levels)) return { scene, map };
  } catch {
    // Told below.
  }
  draft.note('the map', 'its property "slicecast" holds no scene');
  return null;
}

function useOf(kind, properties) {
  if (isTrue(properties, 'floor')) return 'floor';
  if (isTrue(properties, 'sprite')) return 'sprite';
  const isSolid = ['wall', 'solid', 'collides'].some((name) => isTrue(properties, name));
  return isSolid || /^(wall|solid|block)s?$/i.test(kind) ? 'block' : 'by layer';
}

// The set whose first number is the greatest that is not above `id`.
function setWith(sets, id) {
  let low = 0;
  let high = sets.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (sets[middle].first <= id) low = middle + 1;
    else high = middle;
  }
  return sets[low - 1];
}

async function tilesetOf(entry, file, files, draft) {
  if (typeof entry !== 'object' || entry === null)
    throw new ImportError(file, '', quoted(entry), 'a tileset');
  const { firstgid: first = 1, source } = entry;
  const place = `tileset ${quoted(source ?? entry.name ?? '')}`;
  const name = source === undefined ? file : files.resolve(file, source, place);
  const set =
    source === undefined
      ? entry
      : parseTiled(await files.read(name, file, place), name, ['tileset']);
  if (source !== undefined && !(set.tilewidth >= 1))
    throw new ImportError(name, '', `tiles ${quoted(set.tilewidth)} wide`, 'a tileset of Tiled');
  const list = Array.isArray(set.tiles)
    ? set.tiles
    : Object.entries(set.tiles ?? {}).map(([id, tile]) => ({ ...tile, id: Number(id) }));
  const title = String(set.name ?? 'tiles').slice(0, 60);
  if (Object.keys(set.tileoffset ?? {}).some((axis) => Number(set.tileoffset[axis]) !== 0))
    draft.note(`tileset ${quoted(title)}`, 'its drawing offset is left out');
  const own = commentOf('', propertiesOf(set.properties));
  if (own !== '') draft.note(`tileset ${quoted(title)}`, `its properties are left out: ${own}`);
  const shapes = list.filter((tile) => tile?.objectgroup).length;
  if (shapes > 0)
    draft.note(
      `tileset ${quoted(title)}`,
      `the collision shapes of ${counted(shapes, 'tile')} are left out`,
    );
  return {
    ...set,
    first,
    file: name,
    key: source === undefined ? `${first}` : name,
    name: title,
    tiles: new Map(list.filter(Boolean).map((tile) => [tile.id, tile])),
  };
}

// The part of a picture that is the tile, or null if the set has no such tile.
function tileIn(set, gid, files, draft) {
  const id = (gid & kIdMask) - set.first;
  const flip = kFlips.reduce((sum, [bit, value]) => sum + ((gid & bit) !== 0 ? value : 0), 0);
  const tile = set.tiles.get(id);
  const place = `tileset ${quoted(set.name)}`;
  const pictureOf = (image, transparent) => {
    const name = files.resolve(set.file, image, place);
    const colour = colourOf(transparent);
    return draft.picture(`${name} ${colour}`, () => ({
      file: name,
      from: set.file,
      bytes: null,
      transparent: colour,
    }));
  };
  if (tile?.image !== undefined) {
    const width = tile.width ?? tile.imagewidth ?? set.tilewidth;
    const height = tile.height ?? tile.imageheight ?? set.tileheight;
    const picture = pictureOf(tile.image, tile.transparentcolor);
    const part = { picture, x: tile.x ?? 0, y: tile.y ?? 0, width, height };
    return { id, flip, part, own: part };
  }
  const { tilewidth: width, tileheight: height, margin = 0, spacing = 0 } = set;
  if (set.image === undefined || (set.tilecount > 0 && id >= set.tilecount)) return null;
  const columns =
    set.columns > 0
      ? set.columns
      : Math.floor((set.imagewidth - 2 * margin + spacing) / (width + spacing));
  if (!(columns >= 1)) return { id, flip, part: null, own: { width, height } };
  const part = {
    picture: pictureOf(set.image, set.transparentcolor),
    x: margin + (id % columns) * (width + spacing),
    y: margin + Math.floor(id / columns) * (height + spacing),
    width,
    height,
  };
  return { id, flip, part, own: part };
}

// ---- Objects

async function readObjects(layer, { area, source, tiles, file, files, draft, map }) {
  const number = draft.objectLayer({
    name: layer.path,
    use: layer.isHidden ? 'leave out' : 'take',
    level: numberOf(layer.own, 'level', 0, 31) ?? 0,
    comment: commentOf(layer.class ?? '', layer.own, ['level']),
  });
  for (const raw of listOf(layer.objects, file, layer.place)) {
    const place = `object ${quoted(raw?.id)}`;
    if (typeof raw !== 'object' || raw === null)
      throw new ImportError(file, layer.place, quoted(raw), 'an object');
    const { object, kind, align } = await wholeObject(raw, { tiles, file, files, draft, place });
    const { tilewidth, tileheight } = source;
    const size = kind === 0 ? null : draft.kinds[kind - 1].size;
    const width = Number(object.width) / tilewidth || size?.width || 0;
    const height = Number(object.height) / tileheight || size?.height || 0;
    const rotation = Number(object.rotation) || 0;
    const [x, y] = standsAt({
      object,
      kind,
      align,
      width,
      height,
      rotation,
      tilewidth,
      tileheight,
    });
    const own = propertiesOf(object.properties);
    const shape =
      kind !== 0
        ? 'tile'
        : object.text !== undefined
          ? 'text'
          : (kShapes.find((one) => object[one]) ?? 'rectangle');
    const type = String(object.class || object.type || (kind && draft.kinds[kind - 1].class) || '');
    const name = String(object.name ?? '');
    draft.object(map.objects, {
      id: String(raw.id ?? ''),
      name,
      class: type,
      of: (type || name || shape).slice(0, 200),
      layer: number,
      x: x + layer.x / tilewidth - area.x,
      y: y + layer.y / tileheight - area.y,
      width,
      height,
      rotation,
      shape,
      kind,
      isHidden: object.visible === false || object.visible === 0,
      text: String(object.text?.text ?? ''),
      properties: Object.fromEntries(own),
    });
  }
}

// The object with what its template says.
async function wholeObject(raw, { tiles, file, files, draft, place }) {
  const ofMap = (object) => {
    const gid = Number(object.gid ?? 0) >>> 0;
    const kind = gid === 0 ? 0 : tiles.kindOf(gid);
    if (gid !== 0 && kind === 0) draft.note(place, `its tile ${gid & kIdMask} is in no tileset`);
    return { object, kind, align: setWith(tiles.sets, gid & kIdMask)?.objectalignment };
  };
  if (raw.template === undefined) return ofMap(raw);
  const name = files.resolve(file, raw.template, place);
  const template = parseTiled(await files.read(name, file, place), name, ['template']);
  const base = template.object ?? {};
  const object = {
    ...base,
    ...raw,
    properties: [...propertiesOf(base.properties), ...propertiesOf(raw.properties)].map(
      ([key, value]) => ({ name: key, value }),
    ),
  };
  if (raw.gid !== undefined || base.gid === undefined || template.tileset === undefined)
    return ofMap(object);
  const set = await tilesetOf(template.tileset, name, files, draft);
  return {
    object,
    kind: tiles.kindIn(set, Number(base.gid) >>> 0),
    align: set.objectalignment,
  };
}

// Where the object stands, in tiles: for a picture the middle of the lowest tile that it covers.
function standsAt({ object, kind, align, width, height, rotation, tilewidth, tileheight }) {
  const points = object.polygon ?? object.polyline;
  const [left, up] = kind === 0 ? [0, 0] : alignmentOf(align);
  let x = (0.5 - left) * width;
  let y = kind === 0 ? height / 2 : (1 - up) * height - Math.min(height, 1) / 2;
  if (Array.isArray(points) && points.length > 0) {
    const mean = (axis, side) =>
      points.reduce((sum, point) => sum + (Number(point?.[axis]) || 0), 0) / points.length / side;
    [x, y] = [mean('x', tilewidth), mean('y', tileheight)];
  }
  const angle = (rotation * Math.PI) / 180;
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return [
    (Number(object.x) || 0) / tilewidth + x * cos - y * sin,
    (Number(object.y) || 0) / tileheight + x * sin + y * cos,
  ];
}

function alignmentOf(align = 'unspecified') {
  if (align === 'unspecified') return [0, 1];
  const left = align.endsWith('left') ? 0 : align.endsWith('right') ? 1 : 0.5;
  const up = align.startsWith('top') ? 0 : align.startsWith('bottom') ? 1 : 0.5;
  return [left, up];
}

// "#rrggbb", "rrggbb" or "#aarrggbb" as "#rrggbb", or null.
function colourOf(text) {
  const [, digits] = /^#?(?:[0-9a-f]{2})?([0-9a-f]{6})$/i.exec(text ?? '') ?? [];
  return digits === undefined ? null : `#${digits.toLowerCase()}`;
}
