// Maps from strangers: each is refused with a clear error or taken in part, at a bounded cost, and
// reaches nothing that it was not given.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import fc from 'fast-check';

import {
  base64,
  bytesOf,
  gzipSync,
  importModules,
  make,
  packedCells,
  picture,
  readerOf,
  refused,
  tilesPicture,
  zlibSync,
} from './load.mjs';

const kFiles = { 'town.png': tilesPicture() };
const kSet = {
  firstgid: 1,
  name: 'town',
  tilewidth: 16,
  tileheight: 16,
  columns: 3,
  tilecount: 6,
  image: 'town.png',
  imagewidth: 48,
  imageheight: 32,
};
const layerOf = (more) => ({ name: 'Walls', type: 'tilelayer', width: 3, height: 2, ...more });
const mapOf = (layer, more = {}) => ({
  type: 'map',
  orientation: 'orthogonal',
  width: 3,
  height: 2,
  tilewidth: 16,
  tileheight: 16,
  tilesets: [kSet],
  layers: [layerOf(layer)],
  ...more,
});
const kCells = [1, 1, 1, 0, 0, 1];

async function within(milliseconds, act) {
  const begin = performance.now();
  await act();
  const took = performance.now() - begin;
  assert.ok(took < milliseconds, `${took} ms`);
}

test('data that unpack to more than the map holds are refused', async () => {
  const bomb = new Uint8Array(5e7);
  const packers = { zlib: zlibSync, gzip: gzipSync };
  for (const [compression, pack] of Object.entries(packers)) {
    const layer = { encoding: 'base64', compression, data: base64(pack(bomb)) };
    await within(4000, () =>
      refused('m.tmj', mapOf(layer), kFiles, /layer "Walls": found cells packed by \w+ with more/),
    );
  }
  // A frame of zstd with blocks that repeat one byte 128 KB, 2000 times.
  const header = [0x28, 0xb5, 0x2f, 0xfd, 0x00, 0x58];
  const blocks = Array.from({ length: 2000 }, () => [0x02, 0x00, 0x10, 0x00]).flat();
  const zstd = Uint8Array.from([...header, ...blocks, 0x03, 0x00, 0x10, 0x00]);
  const layer = { encoding: 'base64', compression: 'zstd', data: base64(zstd) };
  await within(4000, () =>
    refused('m.tmj', mapOf(layer), kFiles, /zstd data that do not make 24 bytes/),
  );
  for (const compression of ['zlib', 'gzip', 'zstd']) {
    const broken = { encoding: 'base64', compression, data: base64(bytesOf('no such data')) };
    await refused('m.tmj', mapOf(broken), kFiles, /layer "Walls": found cells packed by/);
  }
  const short = { encoding: 'base64', compression: 'zlib', data: base64(zlibSync(bytesOf('a'))) };
  await refused('m.tmj', mapOf(short), kFiles, /1 bytes of data instead of 24/);
});

test('entities of XML are not expanded, and elements nest only so deep', async () => {
  const laughs = `<?xml version="1.0"?><!DOCTYPE map [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;&a;&a;&a;&a;">]>
    <map orientation="orthogonal" width="1" height="1" tilewidth="1" tileheight="1"><layer name="&b;"/></map>`;
  await refused('m.tmx', laughs, {}, /m\.tmx: found XML that cannot be read: Named entity/);
  const outer = '<!DOCTYPE map [<!ENTITY x SYSTEM "file:///etc/passwd">]><map>&x;</map>';
  await refused('m.tmx', outer, {}, /found XML that cannot be read/);
  const deep = `<map orientation="orthogonal">${'<group>'.repeat(1e5)}${'</group>'.repeat(1e5)}</map>`;
  await within(5000, () => refused('m.tmx', deep, {}, /m\.tmx: found /));
  const groups = `<map>${'<group>'.repeat(40)}${'</group>'.repeat(40)}</map>`;
  await refused('m.tmx', groups, {}, /found groups within groups, expected at most 32 deep/);
  await refused('m.tmx', '<map', {}, /found XML that cannot be read/);
  await refused('m.tmx', '<svg/>', {}, /found <svg>, expected <map>/);
  await refused('m.tmx', '<tileset/>', {}, /found <tileset>, expected <map>/);
});

test('JSON nested deep, and groups in it, end in an error', async () => {
  await refused('m.tmj', `${'['.repeat(1e5)}`, {}, /JSON that cannot be read/);
  let layers = [];
  for (let depth = 0; depth < 40; ++depth) layers = [{ type: 'group', name: 'g', layers }];
  await refused('m.tmj', mapOf({}, { layers }), {}, /groups within groups/);
  const properties = [{ name: 'p', type: 'class', value: 'here' }];
  const text = JSON.stringify(mapOf({ data: kCells }, { properties }));
  const value = `${'{"a":'.repeat(1e5)}1${'}'.repeat(1e5)}`;
  await make('m.tmj', text.replace('"here"', value), kFiles);
});

test('sizes beyond the limits take no memory', async () => {
  const far = (x) => ({ x, y: 0, width: 1, height: 1, data: [1] });
  const cases = [
    [mapOf({ data: [] }, { width: 1e9, height: 1e9 }), /a size of 1000000000 x 1000000000 tiles/],
    [mapOf({ data: [], width: 1e9 }), /layer "Walls": found a size of 1000000000 x 2/],
    [mapOf({ data: [] }, { width: -3 }), /a size of -3 x 2/],
    [mapOf({ data: [] }, { width: 2.5 }), /a size of 2\.5 x 2/],
    [mapOf({ chunks: [far(0), far(2e9)] }, { infinite: true }), /a size of 2000000001 x 1/],
    [mapOf({ chunks: [{ ...far(0), width: 1e9 }] }, { infinite: true }), /a size of 1000000000/],
    [mapOf({ chunks: [{ ...far(0), x: 'a' }] }, { infinite: true }), /a chunk of 1 x 1 at "a",0/],
    [mapOf({ data: kCells }, { tilewidth: 0 }), /tiles of 0 x 16, expected a size from 1 x 1/],
    [mapOf({ data: kCells.slice(1) }), /layer "Walls": found 5 cells, expected 6/],
    [mapOf({ data: [1, 2, 'x', 0, 0, 0] }), /found the cell "x"/],
    [mapOf({ data: [1, 2, -1, 0, 0, 0] }), /found the cell -1/],
    [mapOf({ data: 'AAAA', encoding: 'base64' }), /found 3 bytes of cells, expected 24/],
    [mapOf({ data: '???', encoding: 'base64' }), /cells that are no base64/],
    [mapOf({ data: '', encoding: 'rle' }), /the encoding "rle"/],
    [mapOf({ data: '', encoding: 'base64', compression: 'xz' }), /packed by "xz"/],
    [mapOf({ data: kCells }, { orientation: 'isometric' }), /"isometric", expected orthogonal/],
    [mapOf({}, { layers: [null] }), /found null, expected a layer/],
    [mapOf({ data: kCells }, { tilesets: 5 }), /m\.tmj, tilesets: found 5, expected a list/],
    [mapOf({}, { layers: 5 }), /m\.tmj: found a map without layers/],
    [{ type: 'tileset', layers: [] }, /found a tileset without layers/],
    [
      { defs: {}, levels: [{ layerInstances: [{ __type: 'x' }], pxWid: 1, pxHei: 1 }] },
      /the type "x"/,
    ],
  ];
  await within(10_000, async () => {
    for (const [map, expected] of cases) await refused('m.tmj', map, kFiles, expected);
    const layers = Array.from({ length: 40 }, () =>
      layerOf({ width: 4096, height: 4096, encoding: 'base64', data: '' }),
    );
    const map = mapOf({}, { layers, width: 4096, height: 4096 });
    await refused('m.tmj', map, kFiles, /tiles on all layers, expected at most/);
  });
});

test('names that leave the folder, or are addresses, are refused before reading', async () => {
  const { readForeign, ImportError } = await importModules();
  const names = [
    '../town.tsx',
    'a/../../town.tsx',
    '/etc/passwd',
    'C:/town.tsx',
    'https://example.org/town.tsx',
    '//example.org/town.tsx',
    'file:///etc/passwd',
    'data:text/xml,<tileset/>',
    '..\\town.tsx',
    '%2e%2e/town.tsx',
    'town.tsx?x',
    'town\u0000.tsx',
    '',
    'a'.repeat(2000),
    5,
  ];
  for (const name of names) {
    const object = { id: 1, x: 0, y: 0, template: name };
    const tiles = [{ id: 0, image: name }];
    const maps = [
      mapOf({ data: kCells }, { tilesets: [{ firstgid: 1, source: name }] }),
      mapOf({ data: kCells }, { tilesets: [{ ...kSet, image: name }] }),
      mapOf({ data: kCells }, { tilesets: [{ ...kSet, image: undefined, tiles }] }),
      mapOf({}, { layers: [{ type: 'objectgroup', name: 'o', objects: [object] }] }),
      {
        defs: {},
        levels: [{ identifier: 'a', layerInstances: null, externalRelPath: name }],
      },
    ];
    for (const map of maps) {
      const { readFile, asked } = readerOf({});
      await assert.rejects(
        readForeign({ name: 'm.tmj', bytes: bytesOf(JSON.stringify(map)), readFile }),
        (error) => error instanceof ImportError && /the file name/.test(error.message),
        `${name}`,
      );
      assert.deepEqual(asked, []);
    }
  }
});

test('pictures cost what their size says, whatever they claim', async () => {
  const good = tilesPicture();
  const changed = (change) => {
    const bytes = good.slice();
    change(new DataView(bytes.buffer), bytes);
    return bytes;
  };
  const chunk = (type, data) => {
    const bytes = new Uint8Array(12 + data.length);
    new DataView(bytes.buffer).setUint32(0, data.length);
    bytes.set(bytesOf(type), 4);
    bytes.set(data, 8);
    return [...bytes];
  };
  const bomb = zlibSync(new Uint8Array(5e7));
  const profile = Uint8Array.from([
    ...good.slice(0, 33),
    ...chunk('iCCP', [97, 0, 0, ...bomb]),
    ...good.slice(33),
  ]);
  const packed = Uint8Array.from([
    ...good.slice(0, 33),
    ...chunk('IDAT', bomb),
    ...chunk('IEND', []),
  ]);
  const cases = [
    [changed((view) => view.setUint32(16, 2 ** 31)), /it is 2147483648 x 32/],
    [changed((view) => view.setUint32(16, 16000) + view.setUint32(20, 16000)), /16000 x 16000/],
    [packed, /more data than its size says/],
    [good.slice(0, 60), /its tiles get plain colours/],
    [bytesOf('GIF89a'), /it is no PNG file/],
    [new Uint8Array(0), /it is no PNG file/],
  ];
  await within(10_000, async () => {
    for (const [bytes, expected] of cases) {
      const { notTaken, scene } = await make('m.tmj', mapOf({ data: kCells }), {
        'town.png': bytes,
      });
      assert.match(JSON.stringify(notTaken), expected);
      assert.equal(scene.maps[0].levels.length, 1);
    }
    const { pictures } = await make('m.tmj', mapOf({ data: kCells }), { 'town.png': profile });
    assert.equal(pictures.size, 1, 'its colour profile is not unpacked');
  });
});

test('tiles beside their picture, and of any size, are drawn or refused', async () => {
  for (const more of [
    { tilewidth: 1e9, tileheight: 1e9 },
    { tilewidth: 1, tileheight: 3000 },
    { margin: 1e6 },
    { spacing: -16 },
    { columns: -1, imagewidth: undefined },
    { tilewidth: 'a' },
    { tiles: [{ id: 0, x: -5, y: 1e9, width: 3, height: 4, image: 'town.png' }] },
  ])
    await make(
      'm.tmj',
      mapOf({ data: kCells }, { tilesets: [{ ...kSet, ...more }] }),
      kFiles,
    ).catch((error) =>
      assert.equal(error.name, 'ImportError', `${JSON.stringify(more)} ${error.stack}`),
    );
});

test('objects of any kind make a scene that loads', async () => {
  const objects = [
    { id: 1, x: 1e300, y: -1e300, width: 1e300, height: 1e300, gid: 1, rotation: 1e300 },
    { id: 2, x: 'a', y: null, polygon: [null, {}, { x: 1 }] },
    { id: 3, type: 'start', x: 0, y: 0, properties: [{ name: 'heading', value: 1e9 }] },
    {
      id: 4,
      type: 'lamp',
      x: 1,
      y: 1,
      properties: [
        { name: 'radius', value: 1e9 },
        { name: 'z', value: -5 },
      ],
    },
    { id: 5, type: 'constructor', name: '__proto__', x: 5, y: 5, gid: 2 },
    { id: 6, type: 'sign', x: 5, y: 5, text: { text: '\u0000\u0007x'.repeat(500) } },
    { id: 7, type: 'sign', x: 5, y: 5, width: 1e6, height: 1e6, text: { text: ' \n ' } },
    {
      id: 8,
      x: 5,
      y: 5,
      gid: 1,
      width: 0.0001,
      height: -4,
      properties: { __proto__: 5, old: 'way' },
    },
    { id: 9, x: 5, y: 5, properties: [{ name: 'sprite', value: 'oak' }, null, { name: 3 }] },
    { id: 10, x: 5, y: 5, gid: 2 ** 40, type: { a: 1 }, name: ['x'] },
  ];
  const layers = [layerOf({ data: kCells }), { type: 'objectgroup', name: 'o', objects }];
  await make('m.tmj', mapOf({}, { layers }), kFiles);
  await refused(
    'm.tmj',
    mapOf({}, { layers: [{ type: 'objectgroup', objects: [7] }] }),
    {},
    /an object/,
  );
});

test('names of any kind make a scene that loads', async () => {
  for (const name of [
    '\u0000\u0001',
    '😀'.repeat(300),
    '__proto__',
    '',
    '../../x',
    '"\\',
    ' \u200d ',
  ]) {
    const map = mapOf(
      { data: kCells, name },
      {
        tilesets: [{ ...kSet, name }],
        properties: [{ name: 'title', type: 'string', value: name }],
      },
    );
    await make('m.tmj', map, kFiles);
  }
});

test('many kinds of tiles get a legend, or an error', async () => {
  const side = 70;
  const cells = Array.from({ length: side * side }, (_, index) => index + 1);
  const set = {
    ...kSet,
    tilewidth: 1,
    tileheight: 1,
    columns: 100,
    tilecount: 1e4,
    imagewidth: 100,
  };
  const noise = picture(100, 100, (x, y) => [x, y, 0, 255]);
  const map = (count) =>
    mapOf(
      { data: cells.map((cell) => Math.min(cell, count)), width: side, height: side },
      { width: side, height: side, tilesets: [set] },
    );
  const { scene } = await make('m.tmj', map(1200), { 'town.png': noise });
  assert.equal(Object.keys(scene.legend).length, 1200);
  await refused(
    'm.tmj',
    map(4900),
    { 'town.png': noise },
    /found 4900 kinds of blocks, expected at/,
  );
});

test('a dialog that asks for what is not possible is told so', async () => {
  const { makeScene } = await importModules();
  const { proposal } = await make('m.tmj', mapOf({ data: kCells }), kFiles);
  const refuse = (change, expected) => {
    const changed = structuredClone(proposal);
    change(changed);
    return assert.rejects(makeScene(changed), expected);
  };
  await refuse(({ layers }) => (layers[0].use = 'wall'), /layers "Walls": found the use "wall"/);
  await refuse(({ layers }) => (layers[0].level = 32), /layer "Walls": found the level 32/);
  await refuse(({ kinds }) => (kinds[0].show = '../x'), /tile "town 0": found the look/);
});

test('a map of Tiled that is altered at random is refused or loads', async () => {
  const objects = [{ id: 1, type: 'start', x: 20, y: 20, width: 4, height: 4, gid: 3 }];
  const packed = base64(zlibSync(packedCells(kCells)));
  const whole = mapOf(
    { data: kCells },
    {
      layers: [
        layerOf({ data: kCells }),
        layerOf({ data: packed, encoding: 'base64', compression: 'zlib', name: 'Roof' }),
        { type: 'objectgroup', name: 'o', objects },
      ],
    },
  );
  const places = [];
  const walk = (value, path) => {
    if (path.length > 0) places.push(path);
    if (typeof value === 'object' && value !== null)
      for (const key of Object.keys(value)) walk(value[key], [...path, key]);
  };
  walk(whole, []);
  const junk = fc.oneof(
    fc.constantFrom(null, true, -1, 0.5, 1e9, 2 ** 32, '', 'x', [], {}, [[]], undefined),
    fc.jsonValue({ maxDepth: 2 }),
  );
  await fc.assert(
    fc.asyncProperty(fc.constantFrom(...places), junk, async (path, value) => {
      const map = structuredClone(whole);
      const holder = path.slice(0, -1).reduce((one, key) => one[key], map);
      holder[path.at(-1)] = value;
      await make('m.tmj', map, kFiles).catch((error) => {
        if (error.name !== 'ImportError') throw error;
      });
    }),
    { numRuns: 300 },
  );
});
