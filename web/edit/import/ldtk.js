// Reads projects of LDtk into a draft: each level becomes a map, IntGrid values, tiles and
// automatic tiles become layers, entities become objects. Levels in files of their own and pictures
// come through `files`. A layer of values takes the look of its blocks from its automatic tiles.
//
//     await readLdtk(project, 'world.ldtk', files);            // a draft

import { startDraft } from './draft.js';
import { ImportError, quoted } from './import-error.js';
import { counted } from './notes.js';
import { commentOf, isTrue, numberOf } from './properties.js';
import { parseJson, textOfBytes } from './tiled-text.js';
import { titleOf } from './titles.js';

const kTypes = ['IntGrid', 'Tiles', 'AutoLayer', 'Entities'];
const kMostStack = 16; // tiles of one layer in one cell

const listOf = (value) => (Array.isArray(value) ? value : []);

export async function readLdtk(project, file, files) {
  const levels = [
    ...listOf(project.levels),
    ...listOf(project.worlds).flatMap((world) => listOf(world?.levels)),
  ];
  const { defs } = project;
  if (levels.length === 0 || typeof defs !== 'object' || defs === null)
    throw new ImportError(file, '', 'no levels or definitions', 'a project of LDtk');
  const draft = startDraft(file, 'LDtk', titleOf(new Map(), file));
  const reading = {
    file,
    files,
    draft,
    layerNumbers: new Map(),
    byUid: (list, uid) => listOf(defs[list]).find((one) => one?.uid === uid),
  };
  for (const level of levels) await readLevel(await wholeLevel(level, reading), reading);
  if (levels.length > 1)
    draft.note('the world', 'no portals lead from a level to its neighbours; add them by hand');
  return draft;
}

async function wholeLevel(level, { file, files }) {
  if (typeof level !== 'object' || level === null)
    throw new ImportError(file, '', quoted(level), 'a level');
  if (Array.isArray(level.layerInstances)) return level;
  const place = `level ${quoted(level.identifier)}`;
  const name = files.resolve(file, level.externalRelPath, place);
  const whole = parseJson(textOfBytes(await files.read(name, file, place), name), name);
  if (Array.isArray(whole.layerInstances)) return whole;
  throw new ImportError(name, '', 'no layers', 'a level of LDtk');
}

async function readLevel(level, reading) {
  const { file, draft } = reading;
  const name = String(level.identifier ?? 'level');
  const instances = listOf(level.layerInstances).filter(Boolean);
  const isGrid = ({ __type }) => __type !== 'Entities';
  // Values make walls, so their grid is the map's.
  const main =
    instances.find(({ __type }) => __type === 'IntGrid') ?? instances.find(isGrid) ?? instances[0];
  const grid = Number(main?.__gridSize) || 16;
  const width = main?.__cWid ?? Math.ceil(level.pxWid / grid);
  const depth = main?.__cHei ?? Math.ceil(level.pxHei / grid);
  draft.room(`level ${quoted(name)}`, width, depth);
  const map = {
    name,
    width,
    depth,
    background: /^#[0-9a-f]{6}$/i.test(level.__bgColor) ? level.__bgColor : null,
    floor: null,
    comment: commentOf('', fieldsOf(level)),
    cells: [],
    objects: [],
  };
  if (level.bgRelPath)
    draft.note(`level ${quoted(name)}`, `its background ${quoted(level.bgRelPath)} is left out`);
  // The first one lies on top.
  for (const instance of [...instances].reverse()) {
    const place = `level ${quoted(name)}, layer ${quoted(instance.__identifier)}`;
    if (!kTypes.includes(instance.__type))
      throw new ImportError(file, place, `the type ${quoted(instance.__type)}`, kTypes.join(', '));
    if (isGrid(instance) && Number(instance.__gridSize) !== grid)
      draft.note(place, `its grid of ${instance.__gridSize} pixels is not the level's, ${grid}`);
    else readLayer(instance, { ...reading, map, grid, place });
  }
  for (const instance of instances) lookOfSource(instance, reading);
  draft.map(map);
}

// A layer of values may have its automatic tiles in a layer of their own.
function lookOfSource(instance, { draft, layerNumbers, byUid }) {
  const source = byUid('layers', instance.layerDefUid)?.autoSourceLayerDefUid ?? null;
  const name = byUid('layers', source)?.identifier;
  const [tiles, values] = [
    layerNumbers.get(`${instance.__identifier} tiles`),
    layerNumbers.get(`${name} values`),
  ];
  if (instance.__type !== 'AutoLayer' || tiles === undefined || values === undefined) return;
  draft.layers[values].look ??= tiles;
  draft.layers[tiles].use ??= 'floor';
}

function readLayer(instance, reading) {
  const { draft, map, place } = reading;
  const name = String(instance.__identifier ?? instance.__type);
  if (instance.__opacity !== undefined && instance.__opacity !== 1)
    draft.note(place, `its opacity of ${quoted(instance.__opacity)} is left out`);
  const hidden = instance.visible === false ? { use: 'leave out' } : {};
  if (instance.__type === 'Entities') {
    const layer = numbered(reading, `${name} entities`, () =>
      draft.objectLayer({ name, ...hidden, level: 0, comment: '' }),
    );
    for (const entity of listOf(instance.entityInstances)) readEntity(entity, layer, reading);
    return;
  }
  const tiles = [...listOf(instance.autoLayerTiles), ...listOf(instance.gridTiles)];
  const isValues = instance.__type === 'IntGrid';
  let look = null;
  if (tiles.length > 0) {
    look = numbered(reading, `${name} tiles`, () =>
      draft.layer({
        name: isValues ? `${name} tiles` : name,
        ...(isValues && { use: 'floor' }),
        ...hidden,
      }),
    );
    map.cells[look] = cellsOfTiles(tiles, instance, reading);
  }
  const values = listOf(instance.intGridCsv);
  if (!isValues || values.length === 0) return;
  const layer = numbered(reading, `${name} values`, () =>
    draft.layer({ name, use: 'level', level: 0, ...hidden }),
  );
  if (look !== null) draft.layers[layer].look = look;
  map.cells[layer] = cellsOfValues(values, instance, reading);
}

// The layers of all levels share their definitions.
function numbered({ layerNumbers }, name, add) {
  if (!layerNumbers.has(name)) layerNumbers.set(name, add());
  return layerNumbers.get(name);
}

function cellsOfValues(values, instance, { file, draft, map, byUid, place }) {
  draft.room(place, map.width, map.depth);
  if (values.length !== map.width * map.depth)
    throw new ImportError(file, place, `${values.length} values`, `${map.width * map.depth}`);
  const known = listOf(byUid('layers', instance.layerDefUid)?.intGridValues);
  return Uint32Array.from(values, (value) => {
    if (!Number.isInteger(value) || value < 0)
      throw new ImportError(file, place, quoted(value), 'whole numbers from 0');
    if (value === 0) return 0;
    return draft.kind(`${instance.layerDefUid}/${value}`, () => {
      const { identifier, color } = known.find((one) => one?.value === value) ?? {};
      const name = identifier || `${instance.__identifier} ${value}`;
      const isFlat = /floor|ground|grass|path|road|sand|water|empty|air/i.test(name);
      return {
        name,
        use: isFlat ? 'floor' : 'by layer',
        show: /^#[0-9a-f]{6}$/i.test(color) ? color.toLowerCase() : 'stone-blocks-worn',
        size: { width: 1, height: 1 },
      };
    });
  });
}

function cellsOfTiles(tiles, instance, reading) {
  const { file, files, draft, map, grid, byUid, place } = reading;
  draft.room(place, map.width, map.depth);
  const set = byUid('tilesets', instance.__tilesetDefUid);
  const image = instance.__tilesetRelPath ?? set?.relPath;
  const side = set?.tileGridSize ?? grid;
  if (typeof image !== 'string') {
    draft.note(place, 'its tiles have no picture file, as those of LDtk itself');
    return new Uint32Array(map.width * map.depth);
  }
  const name = files.resolve(file, image, place);
  const picture = draft.picture(name, () => ({
    file: name,
    from: file,
    bytes: null,
    transparent: null,
  }));
  const stacks = new Map(); // cell -> parts, the lowest first
  const offset = [instance.__pxTotalOffsetX ?? 0, instance.__pxTotalOffsetY ?? 0].map(Number);
  let between = 0;
  let outside = 0;
  for (const tile of tiles) {
    const [x, y] = listOf(tile?.px).map((at, axis) => (at + offset[axis]) / grid);
    const [fromX, fromY] = listOf(tile?.src);
    if (![x, y, fromX, fromY].every(Number.isFinite))
      throw new ImportError(file, place, 'a tile without a place', '"px" and "src"');
    const [column, row] = [Math.round(x), Math.round(y)];
    if (column !== x || row !== y) between += 1;
    if (column < 0 || row < 0 || column >= map.width || row >= map.depth) {
      outside += 1;
      continue;
    }
    const cell = row * map.width + column;
    const parts = stacks.get(cell) ?? [];
    if (parts.length < kMostStack)
      parts.push({ picture, x: fromX, y: fromY, width: side, height: side, flip: tile.f & 3 });
    else draft.note(`${place}, tile ${column},${row}`, `more than ${kMostStack} tiles`);
    stacks.set(cell, parts);
  }
  const faint = tiles.filter(({ a = 1 }) => a !== 1).length;
  if (faint > 0) draft.note(place, `${counted(faint, 'faint tile')} drawn whole`);
  if (between > 0)
    draft.note(place, `${counted(between, 'tile')} between cells, moved into whole ones`);
  if (outside > 0) draft.note(place, `${counted(outside, 'tile')} outside the level, left out`);
  const cells = new Uint32Array(map.width * map.depth);
  const columns = Math.max(1, Math.floor((set?.pxWid ?? side) / side));
  const idOf = ({ x, y, flip }) =>
    `${Math.floor(y / side) * columns + Math.floor(x / side)}${flip === 0 ? '' : ` turned ${flip}`}`;
  for (const [cell, parts] of stacks) {
    const key = parts.map(({ x, y, flip }) => `${x},${y},${flip}`).join('/');
    cells[cell] = draft.kind(`${name}/${side}/${key}`, () => ({
      name: `${set?.identifier ?? instance.__identifier} ${parts.map(idOf).join(' ')}`.slice(0, 90),
      size: { width: side / grid, height: side / grid },
      parts,
    }));
  }
  return cells;
}

function fieldsOf(instance) {
  return new Map(
    listOf(instance.fieldInstances)
      .filter((field) => field?.__value !== null && field?.__value !== undefined)
      .map(({ __identifier, __value }) => [String(__identifier), __value]),
  );
}

function readEntity(entity, layer, { file, files, draft, map, grid, byUid, place }) {
  const [left, top] = listOf(entity?.px).map(Number);
  if (![left, top].every(Number.isFinite))
    throw new ImportError(file, place, 'an entity without a place', '"px"');
  const [pivotX = 0, pivotY = 0] = listOf(entity.__pivot).map(Number);
  const width = (Number(entity.width) || grid) / grid;
  const height = (Number(entity.height) || grid) / grid;
  const fields = fieldsOf(entity);
  const name = String(entity.__identifier ?? 'entity');
  const kind = kindOfEntity(entity, { file, files, draft, grid, byUid, place });
  const isTile = kind !== 0;
  draft.object(map.objects, {
    id: String(entity.iid ?? ''),
    name: '',
    class: name,
    of: name.slice(0, 200),
    layer,
    x: left / grid + (0.5 - pivotX) * width,
    y: top / grid + (1 - pivotY) * height - (isTile ? Math.min(height, 1) : height) / 2,
    width,
    height,
    rotation: numberOf(fields, 'rotation') ?? 0,
    shape: isTile ? 'tile' : 'rectangle',
    kind,
    isHidden: isTrue(fields, 'hidden'),
    text: '',
    properties: Object.fromEntries(fields),
  });
}

function kindOfEntity(entity, { file, files, draft, grid, byUid, place }) {
  const rect = entity.__tile;
  const set = rect ? byUid('tilesets', rect.tilesetUid) : undefined;
  if (typeof set?.relPath !== 'string') return 0;
  const { x, y, w: width, h: height } = rect;
  if (![x, y, width, height].every(Number.isInteger))
    throw new ImportError(file, place, 'a picture without a place', 'x, y, w and h of "__tile"');
  const name = files.resolve(file, set.relPath, place);
  const picture = draft.picture(name, () => ({
    file: name,
    from: file,
    bytes: null,
    transparent: null,
  }));
  return draft.kind(`${name}/${x},${y},${width},${height}`, () => ({
    name: String(entity.__identifier),
    class: String(entity.__identifier),
    size: { width: width / grid, height: height / grid },
    parts: [{ picture, x, y, width, height, flip: 0 }],
  }));
}
