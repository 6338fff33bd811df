// The parts of <ray-caster> that need no browser: rows of characters, the view in words, faults
// with codes, and what elements share.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { errorCodes, explain, faultOf } from '../../web/element/faults.js';
import { fetchOnce, holdCache } from '../../web/element/page-cache.js';
import { sceneFault } from '../../web/engine/trouble.js';
import { sceneOfRows } from '../../web/engine/rows.js';
import { describeView } from '../../web/element/view-text.js';
import { fetchBytes } from '../../web/engine/fetch-bytes.js';
import { formatView, parseView } from '../../web/engine/address.js';
import { Session, loadModule, root } from '../wasm/load.mjs';

const kEverything = `
  %%%%%%%%%%%%
  %.,~ ....tT%
  %.12345...*%
  %.6789...i.%
  #b=s=r=w=p=#
  O>.h.mm+...o
  %%%+%BSRWPMH
`;

// Plays these rows as the element would.
async function play(text, options) {
  const session = new Session(await loadModule('simd'));
  const scene = sceneOfRows(text, options);
  const faults = session.loadText(JSON.stringify(scene), 'rows', (name) =>
    readFileSync(join(root, 'assets/scenes', name)),
  );
  return { session, scene, faults };
}

function faultsOf(text) {
  try {
    sceneOfRows(text);
  } catch (error) {
    return explain(error);
  }
  return null;
}

// The parts of an engine that describeView uses.
function engineOf(session) {
  return {
    questions: session.questions,
    get world() {
      return session.world();
    },
  };
}

test('the engine accepts every character of the legend without a warning', async () => {
  const { session, faults } = await play(kEverything, { title: 'All of it' });
  assert.deepEqual(faults, []);
  assert.deepEqual(session.warnings, []);
  assert.equal(session.world().title, 'All of it');
  assert.deepEqual(
    [session.world().maps[0].width, session.world().maps[0].depth, session.world().maps[0].levels],
    [12, 7, 2],
  );
  assert.equal(session.world().gates, 2);
});

test('rows: indentation, empty rows around and short rows', async () => {
  const { session, faults } = await play('\r\n\n     ####\n     #v\n     ####\n\n   ', {});
  assert.deepEqual(faults, []);
  const { x, y, heading } = session.state();
  assert.deepEqual([x, y, heading], [1.5, 1.5, 90]);
  assert.deepEqual(sceneOfRows('  ##\n  #v').maps[0].levels, [['##', '#.']]);
});

for (const [character, heading] of [
  ['>', 0],
  ['v', 90],
  ['<', 180],
  ['^', 270],
]) {
  test(`${character} looks to ${heading} degrees`, () =>
    assert.equal(sceneOfRows(`.${character}`).start.heading, heading));
}

test('heights: a letter is one block, its other one two, a digit so many tenths', async () => {
  const { session } = await play('>..5.b.B', {});
  const slice = session.hits(100, 100, 50);
  assert.deepEqual(
    slice.hits.map(({ blueprint, bottom, top }) => [blueprint, bottom, top]),
    [
      ['step 5', 0, 0.5],
      ['brick wall', 0, 1],
      ['brick wall', 0, 1],
      ['brick wall', 1, 2],
    ],
  );
});

test('only pictures that the rows use are fetched', () => {
  const { textures, sprites } = sceneOfRows('#>#');
  assert.deepEqual(Object.keys(textures).sort(), [
    'flagstones',
    'grass-meadow',
    'stone-blocks-worn',
  ]);
  assert.deepEqual(sprites, {});
});

test('a door faces the side that one comes from', () => {
  const { maps } = sceneOfRows('.>.\n#+#\n...\n.#.\n.+.\n.#.');
  assert.deepEqual(maps[0].levels[0].map((row) => row[1]).join(''), '.+.#‖#');
});

test('rows of numbers, and a legend that says what they mean', async () => {
  const map = [
    [1, 1, 1, 1],
    [1, 0, 2, 1],
    [1, 1, 1, 1],
  ];
  const legend = { 0: '.', 1: '#', 2: '>' };
  const asTyped = sceneOfRows('####\n#.>#\n####');
  assert.deepEqual(sceneOfRows(map, { legend }), asTyped);
  assert.deepEqual(sceneOfRows('1111\nE0N1\n1111\n--- legend\n1=#\n0=.\nN=>\nE=#'), asTyped);
  assert.deepEqual(
    sceneOfRows([map, [[0, 1, 1, 0]]], { legend }),
    sceneOfRows([['####', '#.>#', '####'], ['.##.']]),
  );
  const { faults } = await play(map, { legend });
  assert.deepEqual(faults, []);
  // Without a legend 1 and 2 are steps, and 0 is nothing.
  assert.match(faultsOf(map).faults[0].message, /^rows:2:2: found "0", expected one of/);
});

test('rows that are no rows are a fault', () => {
  const expected =
    'expected a text, a list of rows, or a list of levels of rows; a row is a text, or a list of numbers from 0 to 9';
  for (const [rows, found] of [
    [5, '5'],
    [null, 'null'],
    [undefined, 'undefined'],
    [{ length: 2 }, 'an object'],
    [['##', 7], '7'],
    [[[1, 12]], '1'],
    [[[[1, 0]], [true]], 'true'],
    [[[[[1]]]], 'an object'],
  ])
    assert.equal(faultsOf(rows).faults[0].message, `rows: found the rows ${found}, ${expected}`);
});

test('levels of rows are stacked, in text and in lists', async () => {
  const text = `
    #####
    #>.s#
    #####
    ---
    ##
    ..  +
    ##
    --- level
      t`;
  const lists = [['#####', '#>.s#', '#####'], ['##', '..  +', '##'], ['  t']];
  assert.deepEqual(sceneOfRows(lists), sceneOfRows(text));
  assert.deepEqual(
    sceneOfRows(lists.map((rows) => rows.join('\n'))).maps[0].levels,
    sceneOfRows(text).maps[0].levels,
  );
  const { session, faults, scene } = await play(text, {});
  assert.deepEqual(faults, []);
  assert.deepEqual(session.warnings, []);
  assert.deepEqual(scene.maps[0].levels, [
    ['#####', '#..s#', '#####'],
    ['##...', '....‖', '##...'],
  ]);
  assert.deepEqual(scene.maps[0].objects, [{ sprite: 'birch', height: 2.4, x: 2.5, y: 0.5, z: 2 }]);
  // A high wall under something else keeps its lower half.
  assert.deepEqual(sceneOfRows('>B%\n---\n .s').maps[0].levels, [['.b#'], ['.bs']]);
  assert.deepEqual(sceneOfRows('.#\n---\n >').start, { x: 1.5, y: 0.5, z: 1, heading: 0 });
});

test('your own legend: colours, shipped textures, pictures, heights, floors, blueprints', () => {
  const scene = sceneOfRows(
    `
    #####
    #>xg#
    #ykz#
    --- legend
    x = #c32
    y = sandstone 0.5
    g = sand floor
    k = pictures/wall.png
    # = brick
    z = mine
    blank = #508040
    sky = #88a0b8`,
    { textures: { mine: { file: 'pictures/sheet.png', frames: 4, rate: 2 } } },
  );
  const { textures, blueprints, maps, legend } = scene;
  assert.deepEqual(textures, {
    mine: { file: 'pictures/sheet.png', frames: 4, rate: 2 },
    '#508040': '#508040',
    '#cc3322': '#cc3322',
    flagstones: '../textures/flagstones.png',
    sand: '../textures/sand.png',
    brick: '../textures/brick.png',
    sandstone: '../textures/sandstone.png',
    'pictures/wall.png': 'pictures/wall.png',
  });
  assert.equal(blueprints['stone wall'].faces.all, 'brick');
  assert.equal(blueprints['block x'].faces.top, '#cc3322');
  assert.deepEqual([blueprints['block y'].top, blueprints['block x'].top], [0.5, undefined]);
  assert.deepEqual(Object.keys(legend).sort(), ['#', 'k', 'x', 'y', 'z']);
  assert.deepEqual(maps[0].floor.texture, '#508040');
  assert.equal(maps[0].floor.legend.g, 'sand');
  assert.deepEqual([maps[0].sky, maps[0].haze], ['#88a0b8', '#88a0b8']);
  const glass = { join: false, faces: { all: 'brick', top: { texture: '#ff0000', glow: true } } };
  assert.deepEqual(sceneOfRows('>x', { legend: { x: glass } }).blueprints, { 'block x': glass });
});

test('with colours, only doors and objects need files', async () => {
  const session = new Session(await loadModule('simd'));
  const text = kEverything.replace(/[+tT*i]/g, '.');
  const scene = sceneOfRows(`${text}\n--- colours`);
  assert.deepEqual(session.parse(JSON.stringify(scene), 'rows').files, []);
  assert.deepEqual(sceneOfRows(text, { colours: true }), scene);
  assert.notDeepEqual(sceneOfRows(text), scene);
  assert.deepEqual(
    session.loadText(JSON.stringify(scene), 'rows', () => null),
    [],
  );
});

test('the water of rows can be waded in', async () => {
  const { session } = await play('>~~~~~', {});
  session.step([1, 0, 0, 0, 0, 0, 0, 0], 60);
  assert.ok(session.state().feet < -0.1, `feet at ${session.state().feet}`);
  session.free();
  assert.equal(sceneOfRows('>..').maps[0].floor.water, undefined);
  assert.equal(sceneOfRows('>~', { legend: { '~': 'sand floor' } }).maps[0].floor.water, undefined);
});

// The same as for shipped scenes in tests/scenes/horizon_test.cpp.
test('the ground of rows meets the sky without an edge and without a band of haze', async () => {
  const width = 480;
  const height = 300;
  const horizon = height / 2;
  for (const options of [{}, { colours: true }]) {
    const { session, scene } = await play('>', options);
    assert.ok(session.setEye({ x: 0.5, y: 0.5, z: 6 }));
    const picture = session.draw(width, height);
    const row = (y) => picture.subarray(y * width * 4, (y + 1) * width * 4);
    const apart = (a, b) => Math.max(...a.map((channel, i) => Math.abs(channel - b[i])));
    assert.ok(apart([...row(horizon - 1)], row(horizon)) <= 4, 'an edge');
    const haze = [...Buffer.from(scene.maps[0].haze.slice(1), 'hex'), 255];
    const plain = Array.from({ length: width }, () => haze).flat();
    const isHaze = (y) => apart(plain, row(y)) <= 3;
    let band = 0;
    while (isHaze(horizon + band)) ++band;
    assert.ok(band > 0 && band <= height * 0.04, `${band} rows of plain haze`);
    session.free();
  }
});

test('faults of a legend are reported', () => {
  const faults = (text, options) => {
    try {
      sceneOfRows(text, options);
    } catch (error) {
      return error.faults.map(({ message }) => message);
    }
    return [];
  };
  const cases = [
    ['>\n--- legend\nx', /found "x", expected CHARACTER = MEANING/],
    ['>\n--- legned\nx = #c03020', /found "--- legned", expected CHARACTER = MEANING, or one of/],
    [
      '>x\n--- legend\nx = #c0302',
      /found the meaning of "x", "#c0302", expected a texture, a colour/,
    ],
    [
      '>x\n--- legend\nx = brick 2',
      /found the meaning of "x", "brick 2", expected .*height up to 1/,
    ],
    ['>\n--- legend\n> = brick', /found the meaning of ">"/],
    ['>\n---\n.Q', /rows, level 1:1:2: found "Q"/],
  ];
  for (const [text, expected] of cases) assert.match(faults(text).join('\n'), expected, text);
  assert.match(faults('>', { fgo: {} })[0], /found the key "fgo", expected some of .*fog/);
  assert.match(faults('>x', { legend: { x: 7 } })[0], /found the meaning of "x", 7/);
});

test('all faults of rows are listed with row and column', () => {
  const { code, faults } = faultsOf('\n  ##?#\n  #>.Z\n  #^\t#\n');
  assert.equal(code, 'scene');
  assert.deepEqual(
    faults.map(({ place, found }) => [place, found]),
    [
      ['rows:1:3', '"?"'],
      ['rows:2:4', '"Z"'],
      ['rows:3:3', '"\\t"'],
      ['rows:3:2', 'another start, ^'],
    ],
  );
  assert.match(faults[0].expected, /^one of .*# b.* or a blank$/);
  assert.match(faults[0].message, /^rows:1:3: found "\?", expected one of/);
});

test('rows without a start, and no rows at all', () => {
  assert.equal(faultsOf('###\n#.#').faults[0].found, 'no start');
  assert.equal(faultsOf(' \n\n').faults[0].found, 'no rows');
});

test('the view in words', async () => {
  const { session } = await play('#######\n#>...b#\n#######', { title: 'A corridor' });
  assert.equal(
    describeView(engineOf(session), 320, 200),
    'A corridor. Facing east. Ahead: brick wall at 3.5 units. To the left: stone wall at 1.3 units. To the right: stone wall at 1.3 units.',
  );
  session.setEye({ x: 1.5, y: 1.5, z: 0.5, heading: -46, look: 0.3 });
  assert.match(
    describeView(engineOf(session), 320, 200),
    /^A corridor\. Facing north-east and up\. Ahead: /,
  );
});

test('the view in words: objects, things behind a step, nothing, and portals', async () => {
  const { session } = await play('>.2.t...B', {});
  assert.match(
    describeView(engineOf(session), 320, 200),
    /Ahead: step 2 at 1\.5 units, then birch at 4 units, then brick wall at 7\.5 units\. To the left: nothing near\./,
  );
  const wayhouse = new Session(await loadModule('simd'));
  wayhouse.load(join(root, 'assets/scenes/wayhouse.json'));
  const told = new Set();
  for (let heading = 0; heading < 360; heading += 10) {
    const { x, y, z } = wayhouse.state();
    wayhouse.setEye({ x, y, z, heading });
    told.add(describeView(engineOf(wayhouse), 320, 200));
  }
  assert.match([...told].join('\n'), /a way to \w+.* at \d/);
  assert.equal(describeView(engineOf(new Session(await loadModule('simd'))), 320, 200), '');
});

test('without a document the element can be imported, and does nothing', async () => {
  assert.equal(globalThis.document, undefined);
  const { RayCaster, apiVersion, errorCodes: exported } = await import('../../web/ray-caster.js');
  assert.equal(typeof RayCaster, 'function');
  assert.equal(apiVersion, 1);
  assert.equal(exported, errorCodes);
});

test('every code says what it means and what to do', () => {
  assert.deepEqual(Object.keys(errorCodes), [
    'fetch',
    'cors',
    'mime',
    'csp',
    'no-webassembly',
    'engine',
    'scene',
    'address',
    'tour',
    'option',
    'not-ready',
  ]);
  for (const [code, { title, means, remedy }] of Object.entries(errorCodes)) {
    for (const text of [means, remedy]) assert.match(text, /^[A-Za-z].*\.$/, code);
    const told = explain(faultOf(code, 'This happened'));
    assert.deepEqual(
      [told.code, told.title, told.message],
      [code, title, `This happened. ${remedy}`],
    );
  }
});

test('every error gets a code', (t) => {
  t.mock.method(console, 'error', () => {});
  const cases = [
    [new TypeError('x is not a function'), 'engine', /x is not a function/],
    ['a text', 'engine', /a text/],
    [new WebAssembly.RuntimeError('unreachable'), 'engine', /unreachable/],
    [
      new RangeError('WebAssembly.Memory(): could not allocate memory'),
      'engine',
      /not enough memory/,
    ],
    [
      Object.assign(new Error('the server does not answer'), { code: 'cors' }),
      'cors',
      /Access-Control-Allow-Origin/,
    ],
    [Object.assign(new Error('strange'), { code: 'toString' }), 'engine', /strange/],
    [sceneFault('a.json', [{ file: 'a.json', line: 3, column: 4 }]), 'scene', /Fix each place/],
  ];
  for (const [thrown, code, message] of cases) {
    const told = explain(thrown);
    assert.equal(told.code, code);
    assert.match(told.message, message);
  }
  assert.throws(
    () => parseView('1,2'),
    (error) => explain(error).code === 'address',
  );
  assert.equal(
    explain(sceneFault('a.json', [{ file: 'a.json', line: 3, column: 4 }])).faults[0].place,
    'a.json:3:4',
  );
});

let server;
let address;
const asked = [];
const answers = { '/slow': 'slow', '/page': '<!DOCTYPE html><title>Welcome</title>' };

before(async () => {
  server = createServer((request, response) => {
    asked.push(request.url);
    if (!Object.hasOwn(answers, request.url)) return response.writeHead(404).end();
    return setTimeout(() => response.end(answers[request.url]), 20);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  address = `http://127.0.0.1:${server.address().port}`;
});

after(() => server.close());

test('a file is fetched once while anybody holds the cache, and again afterwards', async () => {
  const release = holdCache();
  const heard = [];
  const [one, other] = await Promise.all([
    fetchOnce(`${address}/slow`, (loaded) => heard.push(loaded)),
    fetchOnce(`${address}/slow`),
  ]);
  assert.equal(new TextDecoder().decode(one), 'slow');
  assert.equal(one, other);
  await fetchOnce(`${address}/slow`, (loaded, total) => heard.push(`${loaded} of ${total}`));
  assert.deepEqual(heard, [4, '4 of 4']);
  assert.equal(asked.length, 1);
  release();
  release();
  const another = holdCache();
  await fetchOnce(`${address}/slow`);
  assert.equal(asked.length, 2);
  another();
});

test('without a holder nothing is cached, and failures never are', async () => {
  asked.length = 0;
  await fetchOnce(`${address}/slow`);
  await fetchOnce(`${address}/slow`);
  assert.equal(asked.length, 2);
  const release = holdCache();
  await assert.rejects(fetchOnce(`${address}/late`), {
    code: 'fetch',
    message: 'the server answers 404 Not Found',
  });
  answers['/late'] = 'here';
  assert.equal((await fetchOnce(`${address}/late`)).length, 4);
  release();
});

test('a fetch that fails says why', async () => {
  await assert.rejects(fetchBytes(`${address}/page`), { code: 'mime' });
  await assert.rejects(fetchBytes('http://127.0.0.1:9/'), {
    code: 'fetch',
    message: 'the server does not answer',
  });
});

test("a view is read as it was written, even with commas in the map's name", () => {
  for (const map of ['room', 'Hall, upper floor', 'a,b,c']) {
    const view = { x: 1, y: 2.5, z: 0.6, heading: 90, look: -0.25, map };
    assert.deepEqual(parseView(formatView(view)), view);
  }
});
