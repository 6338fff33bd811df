// Projects of LDtk: values, tiles, automatic tiles and entities, in one file or in one for each
// level. Each scene that is made is loaded by the engine.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { decode, kTileColours, make, refused, tilesPicture } from './load.mjs';

const kFiles = { 'art/town.png': tilesPicture() };

const layerOf = (name, type, more) => ({
  __identifier: name,
  __type: type,
  __cWid: 4,
  __cHei: 3,
  __gridSize: 16,
  __opacity: 1,
  __pxTotalOffsetX: 0,
  __pxTotalOffsetY: 0,
  __tilesetDefUid: null,
  __tilesetRelPath: null,
  iid: name,
  layerDefUid: 1,
  visible: true,
  intGridCsv: [],
  autoLayerTiles: [],
  gridTiles: [],
  entityInstances: [],
  ...more,
});
const tile = (x, y, id, f = 0) => ({
  px: [16 * x, 16 * y],
  src: [16 * (id % 3), 16 * Math.floor(id / 3)],
  f,
  t: id,
  d: [1, 4 * y + x],
  a: 1,
});
const all = [0, 1, 2].flatMap((y) =>
  [0, 1, 2, 3].map((x) => tile(x, y, x > 0 && x < 3 && y === 1 ? 1 : 0)),
);
const entity = (name, x, y, more = {}) => ({
  __identifier: name,
  __grid: [x, y],
  __pivot: [0.5, 1],
  __tags: [],
  __tile: null,
  iid: `${name}-1`,
  width: 16,
  height: 16,
  defUid: 3,
  px: [16 * x + 8, 16 * y + 16],
  fieldInstances: [],
  ...more,
});
// The first layer lies on top.
const layers = [
  layerOf('Entities', 'Entities', {
    entityInstances: [
      entity('Player', 1, 1),
      entity('Chest', 2, 1, {
        __tile: { tilesetUid: 7, x: 32, y: 16, w: 16, h: 16 },
        fieldInstances: [
          { __identifier: 'gold', __type: 'Int', __value: 5, defUid: 1, realEditorValues: [] },
          { __identifier: 'items', __type: 'Array<String>', __value: ['key', 'map'] },
        ],
      }),
      entity('Camera', 2, 1),
    ],
  }),
  layerOf('Collisions', 'IntGrid', {
    __tilesetDefUid: 7,
    __tilesetRelPath: 'art/town.png',
    intGridCsv: [1, 1, 1, 1, 1, 0, 2, 1, 1, 1, 1, 1],
    autoLayerTiles: [...all, tile(1, 1, 5, 1)],
  }),
];
const level = (name, more = {}) => ({
  identifier: name,
  iid: name,
  uid: 0,
  worldX: 0,
  worldY: 0,
  worldDepth: 0,
  pxWid: 64,
  pxHei: 48,
  __bgColor: '#40465B',
  bgRelPath: null,
  externalRelPath: null,
  fieldInstances: [],
  layerInstances: layers,
  __neighbours: [],
  ...more,
});
const projectOf = (levels, more = {}) => ({
  __header__: { fileType: 'LDtk Project JSON', app: 'LDtk', appVersion: '1.5.3' },
  jsonVersion: '1.5.3',
  defaultGridSize: 16,
  externalLevels: false,
  worldLayout: 'Free',
  defs: {
    layers: [
      {
        identifier: 'Collisions',
        uid: 1,
        type: 'IntGrid',
        gridSize: 16,
        intGridValues: [
          { value: 1, identifier: 'walls', color: '#FFFFFF' },
          { value: 2, identifier: 'water', color: '#3060A0' },
        ],
      },
    ],
    entities: [],
    tilesets: [
      {
        identifier: 'Town',
        uid: 7,
        relPath: 'art/town.png',
        pxWid: 48,
        pxHei: 32,
        tileGridSize: 16,
        spacing: 0,
        padding: 0,
      },
    ],
    enums: [],
  },
  levels,
  worlds: [],
  ...more,
});

test('values become blocks that look like their tiles; entities become objects', async () => {
  const { scene, pictures, notTaken } = await make(
    'dungeon.ldtk',
    projectOf([level('Entry')]),
    kFiles,
  );
  const [map] = scene.maps;
  assert.deepEqual(map.levels, [['####', '#..#', '####']]);
  const { all: texture } = scene.blueprints[scene.legend['#']].faces;
  const wall = decode(pictures.get(scene.textures[texture]));
  assert.deepEqual([...wall.data.slice(-4)], kTileColours[0]);
  // Flat values look like their tiles, too. Of two tiles in a cell the lower one shows through.
  const sign = map.floor.tiles[1][1];
  const stack = decode(pictures.get(scene.textures[map.floor.legend[sign]]));
  assert.deepEqual([...stack.data.slice(-4)], kTileColours[1]);
  assert.deepEqual([...stack.data.slice(4 * 16 * 6, 4 * 16 * 6 + 4)], kTileColours[5]);
  const water = map.floor.legend[map.floor.tiles[1][2]] ?? map.floor.texture;
  assert.deepEqual(
    [...decode(pictures.get(scene.textures[water])).data.slice(-4)],
    kTileColours[1],
  );
  const { comment, data, x, y } = map.objects[0];
  assert.deepEqual([comment, x, y], ['Chest', 2.5, 1.5]);
  assert.deepEqual(data, { gold: 5, items: ['key', 'map'] });
  assert.deepEqual([scene.start.x, scene.start.y], [1.5, 1.5]);
  assert.match(JSON.stringify(notTaken), /object Camera-1 .*a rectangle without a picture/);
});

test('each level becomes a map; the start lies where the player does', async () => {
  const without = layers.map((layer) => ({ ...layer, entityInstances: [] }));
  const project = projectOf([level('Hall', { layerInstances: without }), level('Entry')]);
  const { scene, world, notTaken } = await make('d.ldtk', project, kFiles);
  assert.deepEqual(
    world.maps.map(({ name }) => name),
    ['Hall', 'Entry'],
  );
  assert.equal(scene.start.map, 'Entry');
  assert.match(JSON.stringify(notTaken), /no portals lead from a level to its neighbours/);
  assert.match(notTaken.find(({ place }) => place.includes('Camera-1')).place, /^map "\w+", layer/);
});

test('levels may lie in files of their own, and in several worlds', async () => {
  const expected = await make('d.ldtk', projectOf([level('Entry')]), kFiles);
  const outer = level('Entry', { layerInstances: null, externalRelPath: 'd/Entry.ldtkl' });
  const files = { ...kFiles, 'd/Entry.ldtkl': level('Entry') };
  const project = projectOf([], { externalLevels: true, worlds: [{ levels: [outer] }] });
  assert.deepEqual((await make('d.ldtk', project, files)).scene, expected.scene);
  await refused(
    'd.ldtk',
    projectOf([outer]),
    kFiles,
    /^d\.ldtk needs "d\/Entry\.ldtkl": no such file$/,
  );
});

test('layers of another grid, tiles between cells and pictures behind are told', async () => {
  const fine = layerOf('Fine', 'Tiles', { __gridSize: 8, gridTiles: [tile(0, 0, 1)] });
  const loose = layerOf('Loose', 'Tiles', {
    __tilesetDefUid: 7,
    gridTiles: [{ ...tile(1, 1, 3), px: [19, 16] }, tile(40, 1, 3)],
  });
  const project = projectOf([
    level('Entry', { layerInstances: [fine, loose, ...layers], bgRelPath: 'art/sky.png' }),
  ]);
  const { notTaken } = await make('d.ldtk', project, kFiles);
  const told = JSON.stringify(notTaken);
  assert.match(told, /layer \\"Fine\\"","reason":"its grid of 8 pixels is not the level's, 16/);
  assert.match(told, /layer \\"Loose\\"","reason":"1 tile between cells/);
  assert.match(told, /1 tile outside the level/);
  assert.match(told, /its background/);
});

test('automatic tiles in a layer of their own are the look of their values', async () => {
  const [entities, values] = layers;
  const own = [
    entities,
    layerOf('Looks', 'AutoLayer', {
      ...values,
      __identifier: 'Looks',
      __type: 'AutoLayer',
      intGridCsv: [],
      layerDefUid: 2,
    }),
    { ...values, autoLayerTiles: [] },
  ];
  const project = projectOf([level('Entry', { layerInstances: own })]);
  project.defs.layers.push({
    identifier: 'Looks',
    uid: 2,
    type: 'AutoLayer',
    autoSourceLayerDefUid: 1,
  });
  const { scene } = await make('d.ldtk', project, kFiles);
  const one = await make('d.ldtk', projectOf([level('Entry')]), kFiles);
  assert.deepEqual(scene.maps[0].levels, one.scene.maps[0].levels);
  assert.deepEqual(scene.textures, one.scene.textures);
});

test('layers lie one over another as they are drawn', async () => {
  const flat = (name, id) =>
    layerOf(name, 'Tiles', {
      __tilesetDefUid: 7,
      __tilesetRelPath: 'art/town.png',
      gridTiles: [tile(0, 0, id)],
    });
  const own = [flat('Path', 2), flat('Ground', 1)];
  const project = projectOf([level('Entry', { layerInstances: own })]);
  const { scene, pictures } = await make('d.ldtk', project, kFiles);
  const { floor } = scene.maps[0];
  const { data } = decode(pictures.get(scene.textures[floor.legend[floor.tiles[0][0]]]));
  assert.deepEqual([...data.slice(-4)], kTileColours[2]);
});

test('what is no project is refused', async () => {
  await refused('d.ldtk', { defs: {} }, {}, /d\.ldtk: found no levels or definitions/);
  const bad = layerOf('Collisions', 'IntGrid', { intGridCsv: [1, 2] });
  await refused(
    'd.ldtk',
    projectOf([level('Entry', { layerInstances: [bad] })]),
    {},
    /level "Entry", layer "Collisions": found 2 values, expected 12/,
  );
});
