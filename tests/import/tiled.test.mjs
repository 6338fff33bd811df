// Maps of Tiled: every encoding of cells, both kinds of files, tilesets, groups, offsets, turns,
// objects and templates. Each scene that is made is loaded by the engine.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import {
  base64,
  bytesOf,
  decode,
  gzipSync,
  kTileColours,
  make,
  packedCells,
  picture,
  proposalOf,
  readerOf,
  refused,
  tilesPicture,
  zlibSync,
} from './load.mjs';

const kTileset = {
  firstgid: 1,
  name: 'town',
  tilewidth: 16,
  tileheight: 16,
  margin: 0,
  spacing: 0,
  columns: 3,
  tilecount: 6,
  image: 'town.png',
  imagewidth: 48,
  imageheight: 32,
};
const kFiles = { 'town.png': tilesPicture() };
// A wall around a lawn, with a block in it.
const kGround = [2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2];
const kWalls = [1, 1, 1, 1, 1, 1, 0, 0, 0, 1, 1, 0, 4, 0, 1, 1, 1, 1, 1, 1];
const kRows = ['#####', '#...#', '#.t.#', '#####'];

const tileLayer = (name, data, more = {}) => ({
  id: 1,
  name,
  type: 'tilelayer',
  x: 0,
  y: 0,
  width: 5,
  height: 4,
  opacity: 1,
  visible: true,
  data,
  ...more,
});
const objectLayer = (name, objects, more = {}) => ({
  id: 2,
  name,
  type: 'objectgroup',
  objects,
  opacity: 1,
  visible: true,
  ...more,
});
const mapOf = (layers, more = {}) => ({
  type: 'map',
  version: '1.10',
  tiledversion: '1.11.0',
  orientation: 'orthogonal',
  renderorder: 'right-down',
  compressionlevel: -1,
  infinite: false,
  width: 5,
  height: 4,
  tilewidth: 16,
  tileheight: 16,
  nextlayerid: 9,
  nextobjectid: 99,
  tilesets: [kTileset],
  layers,
  ...more,
});
const yard = (more) => mapOf([tileLayer('Ground', kGround), tileLayer('Walls', kWalls)], more);

const levelsOf = ({ scene }) => scene.maps[0].levels;

// The same map as Tiled writes it in XML.
const tmxOf = (data) => `<?xml version="1.0" encoding="UTF-8"?>
<map version="1.10" tiledversion="1.10.2" orientation="orthogonal" renderorder="right-down" width="5" height="4" tilewidth="16" tileheight="16" infinite="0" nextlayerid="3" nextobjectid="1">
 <tileset firstgid="1" name="town" tilewidth="16" tileheight="16" tilecount="6" columns="3">
  <image source="town.png" width="48" height="32"/>
 </tileset>
 <layer id="1" name="Ground" width="5" height="4">
  <data encoding="csv">
${kGround.join(',')}
</data>
 </layer>
 <layer id="2" name="Walls" width="5" height="4">
  ${data}
 </layer>
</map>
`;

test('a map becomes a floor and a level, and looks like its tiles', async () => {
  const { scene, pictures, notTaken, world } = await make('a yard.tmj', yard(), kFiles);
  assert.deepEqual(scene.maps[0].levels, [kRows]);
  assert.deepEqual(scene.maps[0].floor.tiles, ['ttttt', 'ttttt', 'ttttt', 'ttttt']);
  assert.equal(scene.title, 'A yard');
  assert.deepEqual(world.maps, [{ name: 'A yard', width: 5, depth: 4, levels: 1 }]);
  assert.deepEqual(
    notTaken.map(({ place }) => place),
    ['the start'],
  );
  const wall = decode(pictures.get(scene.textures[scene.blueprints[scene.legend['#']].faces.all]));
  assert.deepEqual([wall.width, wall.height], [16, 16]);
  assert.deepEqual([...wall.data.slice(-4)], kTileColours[0]);
  assert.deepEqual([...wall.data.slice(0, 4)], [250, 250, 250, 255], 'the corner is upper left');
});

test('every encoding of JSON and XML gives the same scene', async () => {
  const expected = await make('yard.tmj', yard(), kFiles);
  const bytes = packedCells(kWalls);
  const zstd = await readFile(new URL('walls.zst', import.meta.url));
  const packed = [
    ['base64', undefined, bytes],
    ['base64', '', bytes],
    ['base64', 'zlib', zlibSync(bytes)],
    ['base64', 'gzip', gzipSync(bytes)],
    ['base64', 'zstd', zstd],
  ];
  for (const [encoding, compression, cells] of packed) {
    const layer = tileLayer('Walls', base64(cells), { encoding, compression });
    const map = mapOf([tileLayer('Ground', kGround), layer]);
    const made = await make('yard.tmj', map, kFiles);
    assert.deepEqual(made.scene, expected.scene, `JSON, ${compression}`);
    const named = compression ? ` compression="${compression}"` : '';
    const data = `<data encoding="base64"${named}>\n   ${base64(cells)}\n  </data>`;
    const xml = await make('yard.tmx', tmxOf(data), kFiles);
    assert.deepEqual(xml.scene, expected.scene, `XML, ${compression}`);
  }
  const csv = `<data encoding="csv">\n${kWalls.join(',')}\n</data>`;
  const elements = `<data>${kWalls.map((gid) => (gid ? `<tile gid="${gid}"/>` : '<tile/>')).join('')}</data>`;
  for (const data of [csv, elements])
    assert.deepEqual((await make('yard.tmx', tmxOf(data), kFiles)).scene, expected.scene);
});

test('a map without end takes what its chunks cover, west and north of nought too', async () => {
  const chunk = (x, y, data) => ({ x, y, width: 2, height: 2, data });
  const layer = tileLayer('Walls', undefined, {
    chunks: [chunk(-2, -2, [1, 1, 1, 0]), chunk(2, 0, [0, 1, 1, 1])],
  });
  const object = { id: 5, name: '', type: 'start', x: 16, y: 16, width: 0, height: 0, point: true };
  const map = mapOf([layer, objectLayer('Things', [object])], { infinite: true });
  const made = await make('endless.tmj', map, kFiles);
  assert.deepEqual(levelsOf(made), [['##....', '#.....', '.....#', '....##']]);
  assert.deepEqual([made.scene.start.x, made.scene.start.y], [3, 3], 'the origin moves along');
  const xml = `<map orientation="orthogonal" width="5" height="4" tilewidth="16" tileheight="16" infinite="1">
    <tileset firstgid="1" name="town" tilewidth="16" tileheight="16" tilecount="6" columns="3"><image source="town.png" width="48" height="32"/></tileset>
    <layer id="1" name="Walls" width="5" height="4"><data encoding="csv">
      <chunk x="-2" y="-2" width="2" height="2">1,1,\n1,0</chunk>
      <chunk x="2" y="0" width="2" height="2">0,1,\n1,1</chunk>
    </data></layer></map>`;
  assert.deepEqual(levelsOf(await make('endless.tmx', xml, kFiles)), levelsOf(made));
});

test('tilesets may be files of their own, have margins, or a picture for each tile', async () => {
  const expected = await make('yard.tmj', yard(), kFiles);
  const wide = { ...kTileset, margin: 2, spacing: 1, imagewidth: 54, imageheight: 37 };
  const framed = { 'sets/town.png': tilesPicture({ margin: 2, spacing: 1 }) };
  const { firstgid: _, ...set } = wide;
  const tsx = `<?xml version="1.0"?><tileset version="1.10" name="town" tilewidth="16" tileheight="16" spacing="1" margin="2" tilecount="6" columns="3"><image source="town.png" width="54" height="37"/></tileset>`;
  for (const [name, file] of [
    ['sets/town.tsj', set],
    ['sets/town.tsx', tsx],
  ]) {
    const map = yard({ tilesets: [{ firstgid: 1, source: name }] });
    const made = await make('yard.tmj', map, { ...framed, [name]: file });
    assert.deepEqual(made.scene, expected.scene, name);
    assert.deepEqual([...made.pictures], [...expected.pictures], name);
  }
  const one = (colour) => picture(8, 8, () => colour);
  const collection = {
    firstgid: 1,
    name: 'things',
    tilewidth: 8,
    tileheight: 8,
    columns: 0,
    tilecount: 2,
    tiles: [0, 1, 3].map((id) => ({ id, image: `${id}.png`, imagewidth: 8, imageheight: 8 })),
  };
  const files = {
    '0.png': one([1, 2, 3, 255]),
    '1.png': one([4, 5, 6, 255]),
    '3.png': one([7, 8, 9, 255]),
  };
  const made = await make('yard.tmj', yard({ tilesets: [collection] }), files);
  assert.deepEqual(levelsOf(made), [kRows]);
  assert.equal(made.pictures.size, 3);
});

test('groups, offsets and properties of layers are kept, hidden layers are told', async () => {
  const level = (value) => [{ name: 'level', type: 'int', value }];
  const group = (name, layers, more = {}) => ({ id: 7, name, type: 'group', layers, ...more });
  const one = [1, ...new Array(19).fill(0)];
  const inner = group('inner', [tileLayer('a', one, { offsetx: 16 })], { offsety: 32 });
  const made = await make(
    'groups.tmj',
    mapOf([
      tileLayer('base', kGround, { properties: [{ name: 'floor', type: 'bool', value: true }] }),
      group('outer', [inner], { properties: level(2), offsetx: 16 }),
      tileLayer('b', one, { properties: level(0), offsetx: 5 }),
      group('off', [tileLayer('unseen', one)], { visible: false }),
      tileLayer('Roof', [0, 0, 0, 0, 0, 0, 3, 3, ...new Array(12).fill(0)]),
      tileLayer('half', [0, 2, ...new Array(18).fill(0)], {
        properties: [...level(0), { name: 'top', type: 'float', value: 0.5 }],
      }),
    ]),
    kFiles,
  );
  const blank = ['.....', '.....', '.....', '.....'];
  const [ground, middle, above, roof] = levelsOf(made);
  assert.deepEqual(ground[0].slice(0, 3), '#T.', 'b and the half block');
  assert.deepEqual(middle, []);
  assert.deepEqual(above, [...blank.slice(0, 2), '..#..', blank[3]]);
  assert.equal(made.scene.blueprints[made.scene.legend.T].top, 0.5);
  assert.deepEqual(roof[1], '.tt..');
  const told = made.notTaken.map(({ place, reason }) => `${place}: ${reason}`).join('\n');
  assert.match(told, /layer "off\/unseen": left out, with 1 tile\b/);
  assert.match(told, /layer "b": its offset of 5,0 pixels is rounded/);
});

test('turned tiles become turned pictures; the fourth bit is ignored', async () => {
  const [h, v, d, hex] = [0x80000000, 0x40000000, 0x20000000, 0x10000000];
  // Where the light bar lies then: left or right, upper or lower; and whether it is upright.
  const cases = [
    [0, 0, 0, false],
    [h, 1, 0, false],
    [v, 0, 1, false],
    [h + v, 1, 1, false],
    [d, 0, 0, true],
    [d + h, 1, 0, true],
    [d + v, 0, 1, true],
    [hex, 0, 0, false],
  ];
  const cells = new Array(20).fill(0);
  cases.forEach(([bits], index) => (cells[index] = bits + 1));
  const { scene, pictures } = await make('turned.tmj', mapOf([tileLayer('Walls', cells)]), kFiles);
  const signs = scene.maps[0].levels[0].join('');
  cases.forEach(([bits, right, lower, isUpright], index) => {
    const texture = scene.textures[scene.blueprints[scene.legend[signs[index]]].faces.all];
    const { data } = decode(pictures.get(texture));
    const redAt = (x, y) => data[4 * (16 * (lower ? 15 - y : y) + (right ? 15 - x : x))];
    const found = [redAt(0, 0), redAt(6, 0), redAt(0, 6)].map((red) => red === 250);
    assert.deepEqual(found, [true, !isUpright, isUpright], `bits ${bits.toString(16)}`);
  });
  assert.equal(pictures.size, 7, 'pictures that look alike are one file');
});

test('animated tiles become sheets of frames, turned as they are', async () => {
  const frames = [0, 3, 2].map((tileid) => ({ tileid, duration: 200 }));
  const set = { ...kTileset, tiles: [{ id: 0, animation: frames }] };
  const cells = kWalls.map((gid) => (gid === 4 ? 0x80000001 : gid));
  const map = mapOf(
    [
      tileLayer(
        'Ground',
        kWalls.map(() => 1),
      ),
      tileLayer('Walls', cells),
    ],
    {
      tilesets: [set],
    },
  );
  const { scene, pictures, notTaken } = await make('m.tmj', map, kFiles);
  const texture = scene.textures['town 0'];
  assert.deepEqual([texture.frames, texture.rate], [3, 5]);
  const sheet = decode(pictures.get(texture.file));
  assert.deepEqual([sheet.width, sheet.height], [48, 16]);
  const at = (x) => [...sheet.data.slice(4 * (48 * 15 + x), 4 * (48 * 15 + x + 1))];
  assert.deepEqual(
    [at(0), at(16), at(32)],
    [0, 3, 2].map((id) => kTileColours[id]),
  );
  const turned = decode(pictures.get(scene.textures['town 0 turned 1'].file));
  assert.deepEqual([turned.data[4 * 15], turned.data[4 * 31]], [250, 250]);
  assert.equal(notTaken.length, 1, 'only that there is no start');
  const xml = tmxOf(`<data encoding="csv">${kWalls.join(',')}</data>`).replace(
    '</tileset>',
    '<tile id="0"><animation><frame tileid="0" duration="200"/><frame tileid="3" duration="200"/></animation></tile></tileset>',
  );
  assert.equal((await make('m.tmx', xml, kFiles)).scene.textures['town 0'].frames, 2);
  const tree = { id: 1, type: 'tree', gid: 1, x: 32, y: 32, width: 16, height: 16 };
  const things = mapOf([...yard().layers, objectLayer('o', [tree])], { tilesets: [set] });
  assert.equal((await make('m.tmj', things, kFiles)).scene.sprites['town 0 2'].rate, 5);
});

test('tiles of other sizes become the next size that textures have', async () => {
  const sizes = [
    [5, 8],
    [16, 16],
    [24, 32],
    [33, 64],
  ];
  for (const [side, expected] of sizes) {
    const tileset = { ...kTileset, tilewidth: side, tileheight: side, imagewidth: 3 * side };
    const map = yard({ tilewidth: side, tileheight: side, tilesets: [tileset] });
    const { pictures } = await make('sizes.tmj', map, { 'town.png': tilesPicture({ side }) });
    for (const bytes of pictures.values()) assert.equal(decode(bytes).width, expected);
  }
});

test('without telling names the lowest layer without a hole is the floor', async () => {
  const layers = ['A', 'B', 'C'].map((name, index) =>
    tileLayer(`Tile Layer ${name}`, [kWalls, kGround, kWalls][index]),
  );
  const { proposal, scene } = await make('m.tmj', mapOf(layers), kFiles);
  assert.deepEqual(
    proposal.layers.map(({ use, level }) => [use, level]),
    [
      ['level', 0],
      ['floor', 0],
      ['level', 1],
    ],
  );
  assert.equal(scene.maps[0].levels.length, 2);
});

test('floors lie one over another; what is see-through shows the one below', async () => {
  const path = [6, ...new Array(19).fill(0)];
  const map = mapOf([tileLayer('Ground', kGround), tileLayer('Path', path)]);
  const { scene, pictures } = await make('floors.tmj', map, kFiles);
  const { floor } = scene.maps[0];
  const { data } = decode(pictures.get(scene.textures[floor.legend[floor.tiles[0][0]]]));
  assert.deepEqual([...data.slice(4 * (16 * 7 + 15), 4 * (16 * 7 + 16))], kTileColours[5]);
  assert.deepEqual([...data.slice(-4)], kTileColours[1]);
});

test('objects become sprites, starts, lamps and messages, or are told with their ids', async () => {
  const object = (id, type, more) => ({
    id,
    type,
    name: '',
    x: 16,
    y: 16,
    width: 16,
    height: 16,
    rotation: 0,
    visible: true,
    ...more,
  });
  const objects = [
    object(1, 'tree', { gid: 6, x: 32, y: 32, width: 16, height: 32 }),
    object(2, 'start', { rotation: 90, x: 32, y: 16 }),
    object(3, 'torch', {
      ellipse: true,
      properties: [{ name: 'color', type: 'color', value: '#ff102030' }],
    }),
    object(4, '', { name: 'sign', text: { text: 'Welcome', wrap: true } }),
    object(5, 'zone', {
      polygon: [
        { x: 0, y: 0 },
        { x: 9, y: 0 },
        { x: 9, y: 9 },
      ],
    }),
    object(6, 'tree', { gid: 6, rotation: 45 }),
    object(7, 'tree', { gid: 6, x: 1000 }),
    object(8, 'player', { point: true, width: 0, height: 0 }),
    object(9, 'tree', { gid: 6, visible: false }),
    object(11, 'tree', { gid: 6, x: 0, y: 16 }),
    object(10, 'tree', {
      gid: 0x80000000 + 6,
      properties: [
        { name: 'gold', type: 'int', value: 5 },
        { name: 'dialog', type: 'string', value: 'Take an apple.' },
        { name: 'stock', type: 'class', propertytype: 'Stock', value: { apples: 2 } },
      ],
    }),
  ];
  const map = mapOf([...yard().layers, objectLayer('Things', objects)]);
  const { scene, notTaken, proposal } = await make('objects.tmj', map, kFiles);
  const [{ objects: made, baked, messages }] = scene.maps;
  assert.deepEqual(made[0], {
    comment: 'tree',
    sprite: made[0].sprite,
    x: 2.5,
    y: 1.5,
    height: 2,
    width: 1,
  });
  assert.equal(made.length, 5, '1, 6, 7, 11 and 10');
  assert.equal(made[3].z, 1);
  assert.equal(made[4].comment, 'tree');
  assert.deepEqual(made[4].data, { gold: 5, stock: { apples: 2 } });
  assert.notEqual(made[4].sprite, made[0].sprite, 'its picture is turned');
  assert.equal(made[1].heading, 45);
  assert.equal(made[2].x, 4.99, 'at the edge');
  assert.deepEqual(scene.start, { x: 1.5, y: 1.5, heading: 90 }, 'turned about its corner');
  assert.deepEqual(baked.lamps, [
    { comment: 'torch', x: 1.5, y: 1.5, z: 0.7, colour: '#102030', radius: 0.5 },
  ]);
  assert.deepEqual(messages, [
    { text: 'Welcome', x: 1, y: 1, width: 1, depth: 1 },
    { text: 'Take an apple.', x: 0, y: 0, width: 3, depth: 2 },
  ]);
  const told = notTaken.map(({ place, reason }) => `${place}: ${reason}`).join('\n');
  assert.match(told, /object 5 "zone": a polygon without a picture/);
  assert.match(told, /object 6 "tree": its picture stands upright; its turn of 45/);
  assert.match(told, /object 7 "tree": outside the map, and so moved to its edge/);
  assert.match(told, /object 8 "player": another start/);
  assert.match(told, /object 11 "tree": it stands in a block, and so was put onto it, at 1/);
  assert.match(told, /object 9 "tree": hidden/);
  assert.deepEqual(
    proposal.classes.map(({ name, use }) => `${name}: ${use}`),
    [
      'tree: object',
      'start: start',
      'torch: lamp',
      'sign: message',
      'zone: object',
      'player: start',
    ],
  );
  const left = await make('objects.tmj', map, kFiles, (one) => {
    one.outside = 'leave out';
    one.classes.find(({ name }) => name === 'torch').use = 'leave out';
  });
  assert.equal(left.scene.maps[0].objects.length, 4);
  assert.equal(left.scene.maps[0].baked, undefined);
});

test('what is above the player stands on the walls, and lamps leave the day as it is', async () => {
  const at = (tiles, gid) => kGround.map((_, index) => (tiles.includes(index) ? gid : 0));
  const torch = { id: 1, type: 'torch', name: '', x: 32, y: 16, point: true };
  const map = mapOf([
    ...yard().layers,
    tileLayer('Roofs', at([0, 1, 5, 6], 3)),
    tileLayer('Above player', at([1, 12, 13], 6)),
    tileLayer('Chimneys', at([1], 4), { properties: [{ name: 'level', type: 'int', value: 2 }] }),
    tileLayer('Light', at([7], 5)),
    objectLayer('Lamps', [torch]),
  ]);
  const { scene, proposal, notTaken } = await make('village.tmj', map, kFiles);
  assert.deepEqual(
    proposal.layers.map(({ name, use, level }) => `${name}: ${use} ${level}`),
    [
      'Ground: floor 0',
      'Walls: level 0',
      'Roofs: level 3',
      'Above player: level 3',
      'Chimneys: level 2',
      'Light: leave out 0',
    ],
  );
  assert.equal(scene.maps[0].ceiling, undefined);
  assert.equal(scene.maps[0].baked.ambient, '#ffffff');
  assert.match(JSON.stringify(notTaken), /layer \\"Light\\"","reason":"left out, with 1 tile"/);
  const night = await make('village.tmj', map, kFiles, (one) => (one.light = 'night'));
  assert.equal(night.scene.maps[0].baked.ambient, '#404048');
  const mostly = mapOf([
    ...yard().layers,
    tileLayer('Roof', at([0, 1], 3)),
    tileLayer('Overlay', at([1], 6)),
  ]);
  const { layers } = await proposalOf('village.tmj', mostly, kFiles);
  assert.deepEqual([layers[2].level, layers[3].level], [1, 2], 'it lies on the roof');
});

test('templates give what their objects leave out', async () => {
  const tx = `<?xml version="1.0" encoding="UTF-8"?>
<template>
 <tileset firstgid="1" source="../sets/town.tsx"/>
 <object name="oak" type="tree" gid="6" width="16" height="48">
  <properties><property name="age" type="int" value="90"/><property name="kind" value="oak"/></properties>
 </object>
</template>`;
  const tj = {
    type: 'template',
    tileset: { firstgid: 1, source: '../sets/town.tsx' },
    object: {
      id: 1,
      name: 'oak',
      type: 'tree',
      gid: 6,
      width: 16,
      height: 48,
      rotation: 0,
      properties: [
        { name: 'age', type: 'int', value: 90 },
        { name: 'kind', type: 'string', value: 'oak' },
      ],
    },
  };
  const tsx = `<tileset name="town" tilewidth="16" tileheight="16" tilecount="6" columns="3"><image source="town.png" width="48" height="32"/></tileset>`;
  const files = { ...kFiles, 'sets/town.tsx': tsx, 'sets/town.png': kFiles['town.png'] };
  for (const [name, template] of [
    ['templates/oak.tx', tx],
    ['templates/oak.tj', tj],
  ]) {
    const objects = [
      { id: 3, template: name, x: 32, y: 32, properties: [{ name: 'age', type: 'int', value: 7 }] },
    ];
    const map = mapOf([...yard().layers, objectLayer('Things', objects)]);
    const { scene } = await make('map.tmj', map, { ...files, [name]: template });
    const [oak] = scene.maps[0].objects;
    assert.deepEqual([oak.comment, oak.data], ['tree oak', { age: 7, kind: 'oak' }], name);
    assert.deepEqual([oak.x, oak.y, oak.height, oak.width], [2.5, 1.5, 3, 1], name);
  }
});

test('objects of XML have all shapes and properties', async () => {
  const tmx = tmxOf(`<data encoding="csv">${kWalls.join(',')}</data>`).replace(
    '</map>',
    `<objectgroup id="3" name="Things">
      <properties><property name="level" type="int" value="1"/></properties>
      <object id="1" name="way" type="zone" x="16" y="16"><polyline points="0,0 16,0 16,16"/></object>
      <object id="2" class="start" x="24" y="24"><point/></object>
      <object id="3" type="tree" gid="6" x="48" y="32" width="16" height="16"><properties>
        <property name="note">two
lines</property>
        <property name="stock" type="class" propertytype="Stock"><properties><property name="apples" type="int" value="2"/></properties></property>
        <property name="open" type="bool" value="true"/></properties></object>
      <object id="4" x="16" y="16" width="32" height="16"><text wrap="1">Hello &amp; welcome</text></object>
    </objectgroup></map>`,
  );
  const { scene, notTaken } = await make('things.tmx', tmx, kFiles);
  const [{ objects, messages }] = scene.maps;
  assert.equal(objects[0].comment, 'tree');
  assert.deepEqual(objects[0].data, { note: 'two\nlines', stock: { apples: 2 }, open: true });
  assert.equal(objects[0].z, 1);
  assert.equal(messages[0].text, 'Hello & welcome');
  assert.deepEqual([scene.start.x, scene.start.y, scene.start.z], [1.5, 1.5, 1]);
  assert.match(
    JSON.stringify(notTaken),
    /object 1 \\"zone way\\"",?.*a polyline without a picture/,
  );
});

test('a start within a block is moved, and told', async () => {
  const start = { id: 1, type: 'start', x: 8, y: 8, point: true };
  const map = mapOf([...yard().layers, objectLayer('o', [start])]);
  const { scene, notTaken } = await make('m.tmj', map, kFiles);
  assert.deepEqual([scene.start.x, scene.start.y], [1.5, 1.5]);
  assert.match(JSON.stringify(notTaken), /moved to 1\.5,1\.5,0/);
  const full = mapOf([tileLayer('Walls', new Array(20).fill(1))], {});
  full.layers[0].name = 'Walls';
  assert.equal((await make('m.tmj', full, kFiles)).scene.start.z, 1, 'on top, if there is no room');
});

test('what has no counterpart is told with its place', async () => {
  const set = {
    ...kTileset,
    tileoffset: { x: 0, y: 4 },
    properties: [{ name: 'author', type: 'string', value: 'me' }],
    tiles: [
      {
        id: 0,
        animation: [
          { tileid: 0, duration: 9 },
          { tileid: 1, duration: 8 },
        ],
      },
      { id: 1, objectgroup: { objects: [] } },
    ],
  };
  const layers = [
    { id: 1, name: 'Sky', type: 'imagelayer', image: 'sky.png' },
    tileLayer('Walls', kWalls, { opacity: 0.5, tintcolor: '#ff0000', parallaxx: 0.5 }),
    tileLayer('Walls 2', [0, 70, ...new Array(18).fill(0)], {
      properties: [{ name: 'level', type: 'int', value: 0 }],
    }),
    tileLayer('Solid', [3, ...new Array(19).fill(0)], {
      properties: [{ name: 'level', type: 'int', value: 0 }],
    }),
  ];
  const { notTaken } = await make('m.tmj', mapOf(layers, { tilesets: [set] }), kFiles);
  const told = notTaken.map(({ place, reason }) => `${place}: ${reason}`).join('\n');
  for (const expected of [
    /tileset "town": its drawing offset/,
    /tileset "town": the collision shapes of 1 tile /,
    /tile "town 0": the pictures of its animation are shown equally long/,
    /tileset "town": its properties are left out: author=me/,
    /layer "Sky": layers of the type "imagelayer"/,
    /layer "Walls": its opacity of 0.5/,
    /layer "Walls": its tint/,
    /layer "Walls": its parallax/,
    /layer "Walls 2": tile 70, which no tileset has, at 1 place$/m,
    /layer "Walls": 1 block in the place of those of "Solid"/,
  ])
    assert.match(told, expected);
});

test('a missing picture leaves plain colours; a missing tileset is an error', async () => {
  const { scene, notTaken, pictures } = await make('m.tmj', yard(), {});
  assert.deepEqual(scene.maps[0].levels, [kRows]);
  assert.equal(pictures.size, 0);
  assert.match(JSON.stringify(notTaken), /picture \\"town.png\\""/);
  const map = yard({ tilesets: [{ firstgid: 1, source: 'none.tsx' }] });
  await refused('m.tmj', map, {}, /^m\.tmj needs "none\.tsx": no such file$/);
});

test('a dialog may change what layers and tiles become', async () => {
  const changed = await make('m.tmj', yard(), kFiles, ({ layers, kinds }) => {
    layers[0].use = 'leave out';
    layers[1].level = 1;
    Object.assign(
      kinds.find(({ name }) => name === 'town 0'),
      { show: 'brick', top: 0.25 },
    );
    kinds.find(({ name }) => name === 'town 3').use = 'sprite';
  });
  const [{ levels, objects, floor }] = changed.scene.maps;
  assert.deepEqual(levels, [[], ['#####', '#...#', '#...#', '#####']]);
  assert.equal(objects.length, 1);
  assert.equal(typeof floor, 'string');
  const { top, faces } = changed.scene.blueprints[changed.scene.legend['#']];
  assert.deepEqual([top, faces.all], [0.25, 'brick']);
  assert.match(JSON.stringify(changed.notTaken), /left out, with 20 tiles/);
});

test('names of files are relative to the file that names them; no others are read', async () => {
  const { readForeign } = await (await import('./load.mjs')).importModules();
  const { readFile: read, asked } = readerOf({
    'tiles/town.tsx': `<tileset name="town" tilewidth="16" tileheight="16" tilecount="6" columns="3"><image source="../art/town.png" width="48" height="32"/></tileset>`,
    'art/town.png': kFiles['town.png'],
  });
  const map = yard({ tilesets: [{ firstgid: 1, source: '../tiles/town.tsx' }] });
  await readForeign({
    name: 'maps/m.tmj',
    bytes: bytesOf(JSON.stringify(map)),
    readFile: read,
  });
  assert.deepEqual(asked, ['tiles/town.tsx', 'art/town.png']);
  const proposal = await proposalOf('m.tmj', yard(), kFiles);
  structuredClone(proposal); // it is plain data
});
