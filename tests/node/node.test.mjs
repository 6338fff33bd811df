// The package's interface for Node.

import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { copyFile, cp, mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';

import { Engine } from '../../build/web/engine/engine.js';
import { load, SceneError } from '../../build/web/node/index.js';
import { flavours, loadModule, roomScene, root, Session } from '../wasm/load.mjs';
import { crashToo } from './crash.mjs';

const castle = `${root}/assets/scenes/castle.json`;
const kSize = { width: 120, height: 75 };
const run = promisify(execFile);

// Serves these: path -> text, or the path to redirect to.
async function serve(t, answers) {
  const server = createServer(({ url }, response) => {
    const { text, location } = answers[url] ?? {};
    response
      .writeHead(
        location !== undefined ? 302 : text !== undefined ? 200 : 404,
        location === undefined ? {} : { location },
      )
      .end(text);
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => server.close());
  return `http://127.0.0.1:${server.address().port}`;
}

test('a scene is found by name, path, address and as an object, and looks the same', async () => {
  const object = JSON.parse(await readFile(castle, 'utf8'));
  const pictures = [];
  for (const from of ['castle', castle, new URL(`file://${castle}`), `file://${castle}`, object]) {
    const scene = await load(from);
    pictures.push(Buffer.from(scene.pixels(kSize).data));
    scene.free();
  }
  for (const picture of pictures) assert.ok(picture.equals(pictures[0]));
});

// It takes some 100 ms, of which a slice is a few.
test('a scene that takes long is loaded in slices', async () => {
  const wide = JSON.parse(
    roomScene({
      texture: '../textures/brick.png',
      sprites: { bush: '../sprites/bush.png' },
    }),
  );
  const rows = new Array(420).fill('.'.repeat(420));
  wide.maps[0].levels = [rows, ...new Array(30).fill([])];
  wide.maps[0].ceiling = { texture: 'brick', height: 0.9 };
  wide.maps[0].sow = new Array(32).fill({ sprite: 'bush', density: 1, height: 1 });
  const shares = [];
  let others = 0;
  let isOver = false;
  const goOn = () => {
    ++others;
    if (!isOver) setImmediate(goOn);
  };
  setImmediate(goOn);
  const scene = await load(wide, { onProgress: (share) => shares.push(share) });
  isOver = true;
  assert.equal(scene.world.maps[0].width, 420);
  scene.free();
  assert.ok(others > 8, `${others} tasks in between`);
  assert.ok(shares.length > 8, `${shares.length} times`);
  assert.deepEqual(
    shares,
    shares.toSorted((a, b) => a - b),
  );
  assert.equal(shares.at(-1), 1);
  await assert.rejects(
    load('castle', { onProgress: 1 }),
    /^TypeError: onProgress: found 1, expected/,
  );
});

test("a scene's module is the scene, and a URL names a picture anywhere", async (t) => {
  const { default: imported, tour } = await import('../../build/web/scenes/castle.js');
  assert.match(await readFile(new URL(tour), 'utf8'), /^slicecast /);
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-'));
  t.after(() => rm(folder, { recursive: true }));
  // Of another folder, and with the name of one that the scene has already.
  await copyFile(`${root}/assets/textures/brick.png`, path.join(folder, 'moss.png'));
  const moss = pathToFileURL(path.join(folder, 'moss.png'));
  const shipped = '../textures/brick.png';
  const pictures = [];
  for (const from of [
    'castle',
    imported,
    { ...imported, textures: { ...imported.textures, rock: moss } },
    { ...imported, textures: { ...imported.textures, rock: shipped } },
  ]) {
    const scene = await load(from);
    pictures.push(Buffer.from(scene.pixels(kSize).data).toString('base64'));
    scene.free();
  }
  const [named, asModule, elsewhere, beside] = pictures;
  assert.equal(asModule, named);
  assert.equal(elsewhere, beside);
  assert.notEqual(elsewhere, named);
  const missing = pathToFileURL(path.join(folder, 'missing.png'));
  await assert.rejects(
    load({ ...imported, textures: { ...imported.textures, rock: missing } }),
    ({ code, faults }) => code === 'scene' && /missing\.png.*ENOENT/.test(faults[0].found),
  );
});

test('both builds draw what the bindings draw', async () => {
  for (const engine of flavours) {
    const scene = await load('castle', { engine });
    const session = new Session(await loadModule(engine));
    session.load(castle);
    scene.step(60, { forward: 1, turn: 0.5, jump: true });
    session.step([1, 0, 0.5, 0, 0, 0, 0, 1], 60);
    assert.ok(
      Buffer.from(scene.pixels(kSize).data).equals(session.draw(kSize.width, kSize.height)),
      engine,
    );
    scene.free();
  }
});

test('an object names its files from a base: a folder, or a file in it', async () => {
  const folder = `${root}/assets/textures`;
  for (const base of [
    new URL(`file://${folder}/`),
    new URL(`file://${folder}`),
    folder,
    `${folder}/brick.png`,
    path.relative('.', folder),
  ]) {
    const scene = await load(JSON.parse(roomScene()), { base });
    assert.deepEqual(scene.world, {
      title: 'A room',
      maps: [{ name: 'room', width: 8, depth: 6, levels: 1 }],
    });
    scene.free();
  }
  for (const base of [7, null, '', 'data:,x', {}])
    await assert.rejects(load({}, { base }), {
      name: 'TypeError',
      message: /^base: found .*, expected the path or address of a folder/,
    });
  // One at which the system will not even look is nobody's fault but that of the pictures beside
  // it.
  await assert.rejects(load({}, { base: `/${'x'.repeat(5000)}` }), {
    name: 'SceneError',
    code: 'scene',
  });
});

test('a scene in its own address names its files beside the shipped scenes', async () => {
  const scene = await load(
    `data:application/json,${encodeURIComponent(await readFile(castle, 'utf8'))}`,
  );
  assert.equal(scene.world.title, 'The castle in the lake');
  scene.free();
});

test("after a redirect, a scene's files are relative to its final address", async (t) => {
  const address = await serve(t, {
    '/short': { location: '/long/scenes/room.json' },
    '/long/scenes/room.json': { text: roomScene() },
  });
  await assert.rejects(load(`${address}/short`), {
    code: 'scene',
    message: /127\.0\.0\.1:\d+\/long\/scenes\/brick\.png: the server answers 404 Not Found/,
  });
});

test('options, the eye and what it sees', async () => {
  const scene = await load('first-walk');
  scene.set('fov', 75);
  scene.set('light', false);
  assert.equal(scene.get('fov'), '75');
  assert.equal(scene.get('light'), 'off');
  assert.throws(() => scene.set('fov', 1000), { name: 'SceneError', code: 'option' });
  assert.throws(() => scene.get('colour'), { name: 'SceneError', code: 'option' });
  assert.ok(scene.optionList.some(({ name, value }) => name === 'fov' && value === '75'));

  const before = scene.currentView;
  assert.equal(scene.look({ heading: 90 }), true);
  assert.deepEqual(scene.currentView, { ...before, heading: 90 });
  assert.equal(scene.look('3.5,4.5,0.75,180'), true);
  assert.deepEqual(scene.currentView, { ...before, x: 3.5, y: 4.5, z: 0.75, heading: 180 });
  assert.equal(scene.look({ look: 0.5 }), true);
  assert.equal(scene.look('3.5,4.5,0.75,90'), true);
  assert.equal(scene.currentView.look, 0.5);
  assert.equal(scene.look({ map: 'nowhere' }), false);
  assert.equal(scene.look({ z: 0 }), false);
  for (const view of [
    null,
    undefined,
    7,
    '1,2',
    '1,2,3,4,5',
    { x: NaN },
    { x: 32768 },
    { look: -4.1 },
    { north: 1 },
    { toString: 1 },
  ]) {
    assert.throws(() => scene.look(view), {
      name: 'SceneError',
      code: 'address',
      message: /^(look|view): found .*, expected /,
    });
  }
  scene.reset();
  assert.deepEqual(scene.currentView, before);

  const { hits, size } = scene.hits(60, kSize);
  assert.deepEqual(size, [kSize.width, kSize.height]);
  assert.ok(hits.length > 0);
  for (const column of [120, -1, 1.5, 2 ** 32, null, '3']) {
    assert.equal(scene.hits(column, kSize), null);
    assert.equal(scene.trace(column, kSize), null);
  }
  assert.equal(scene.trace(60, kSize).hits.length, hits.length);
  assert.deepEqual(scene.trace(undefined, kSize).size, size);
  for (const size of [
    null,
    {},
    { width: 0, height: 10 },
    { width: 10, height: 1.5 },
    { width: 8193, height: 1 },
    { width: '10', height: 10 },
  ]) {
    for (const ask of ['pixels', 'hits', 'trace']) {
      assert.throws(() => scene[ask](...(ask === 'pixels' ? [size] : [3, size])), {
        name: 'RangeError',
        message: /^size: found .*, expected .* 1 to 8192/,
      });
    }
    await assert.rejects(scene.png(size), RangeError);
  }
  assert.throws(() => scene.set('fov\0', 70), { code: 'option' });
  assert.throws(() => scene.set('light', 'on\0'), { code: 'option' });
  assert.throws(() => scene.step(1, null), /^RangeError: step: found "null", expected forward/);
  assert.throws(
    () => scene.step(1, { constructor: true }),
    /found "constructor", expected forward/,
  );
  scene.free();
});

test('looking elsewhere lets walkers walk on; walk and fly say otherwise', async () => {
  const rows = ['##########', '#>.5..#..#', '##########'];
  const scene = await load({ title: 'A step', rows });
  const twin = await load({ title: 'A step', rows });
  const still = [];
  // Also while the eye still rises after the step up.
  for (let i = 0; i < 60; ++i) {
    scene.step(5, { forward: 1 });
    twin.step(5, { forward: 1 });
    assert.equal(scene.look({ heading: 0 }), true);
    assert.deepEqual(scene.currentView, twin.currentView);
    still.push(scene.currentView.z);
  }
  assert.ok(Math.max(...still) > 0.85 && still.at(-1) < 0.51, 'up the step, and down again');

  // Whoever flies stays at that height; whoever walks falls.
  const fallsFrom = (view) => {
    assert.equal(scene.look(view), true);
    const { z } = scene.currentView;
    scene.step(120);
    return scene.currentView.z < z - 0.3;
  };
  assert.equal(fallsFrom({ z: 1.4, flying: true }), false);
  assert.equal(fallsFrom({ heading: 90 }), false);
  assert.equal(fallsFrom({ flying: false }), true);
  assert.equal(fallsFrom({ z: 1.4 }), true);
  assert.throws(() => scene.look({ flying: 1 }), /look: found flying 1, expected true or false/);
  scene.free();
  twin.free();
});

test('the old ways of drawing, by name, beside the exact picture', async () => {
  const scene = await load('first-walk');
  const size = { width: 96, height: 60 };
  const isSame = (a, b, [from, to]) => {
    for (let i = 0; i < a.data.length; ++i) {
      const x = (i >> 2) % size.width;
      if (x >= from && x < to && a.data[i] !== b.data[i]) return false;
    }
    return true;
  };
  assert.deepEqual(scene.leftOut, []);
  const exact = scene.pixels(size);
  const exactTrace = scene.trace(20, size);
  const fishEye = scene.oldWays.find(({ name }) => name === 'Fish eye');
  assert.deepEqual(fishEye.options, { 'classic.projection': 'equalAngles' });
  const named = new Set();
  for (const { name, description, options } of scene.oldWays) {
    assert.ok(name !== '' && description.endsWith('.'));
    for (const [option, value] of Object.entries(options)) {
      named.add(option);
      assert.notEqual(scene.get(option), value, `${option} is not so by default`);
    }
  }
  for (const { name } of scene.optionList)
    assert.ok(!name.startsWith('classic.') || named.has(name), name);

  for (const [option, value] of Object.entries(fishEye.options)) scene.set(option, value);
  scene.set('method', 'classic');
  assert.deepEqual(scene.leftOut, [], 'without such a way the picture is the exact one');
  scene.set('classic.oneLevel', 'on');
  assert.ok(scene.leftOut.length > 0 && scene.leftOut.every((sentence) => sentence.endsWith('.')));
  scene.set('classic.oneLevel', 'off');
  const old = scene.pixels(size);
  scene.set('method', 'exact');
  scene.set('compare', 0.5);
  const both = scene.pixels(size);
  assert.ok(isSame(both, old, [0, 44]) && !isSame(both, old, [52, 96]));
  assert.ok(isSame(both, exact, [52, 96]) && !isSame(both, exact, [0, 44]));
  // A trace describes the method that draws the column.
  assert.notDeepEqual(scene.trace(20, size).ray, exactTrace.ray);
  scene.set('compare', 0);
  assert.deepEqual(scene.trace(20, size).ray, exactTrace.ray);
  assert.ok(isSame(scene.pixels(size), exact, [0, 96]));
  scene.free();
});

// Trying moves nobody, and finds what the scene has.
test('views are tried for an old way of drawing', async () => {
  const scene = await load('first-walk');
  const before = scene.currentView;
  assert.equal(scene.tryOldWay(0).share, 0, 'without an old way there is nothing to see');
  assert.deepEqual(scene.tryOldWay(0).view, { ...before, flying: false });
  const most = (option, value) => {
    const standard = scene.get(option);
    scene.set(option, value);
    let best = { share: 0 };
    let tried;
    for (let number = 0; (tried = scene.tryOldWay(number)) !== null; ++number)
      if (tried.share > best.share) best = tried;
    scene.set(option, standard);
    return best;
  };
  assert.ok(most('classic.roofs', 'missing').share > 0.1);
  const drifting = most('classic.driftingHorizon', 'on');
  assert.ok(drifting.share > 0.1 && drifting.view.z > before.z, 'from higher than the start');
  assert.equal(most('classic.portalsOverdrawn', 'on').share, 0, 'it has no portal');
  assert.deepEqual(scene.currentView, before);
  assert.equal(scene.tryOldWay(-1), null);
  scene.free();
});

test('every call on a freed scene says so', async () => {
  const scene = await load('first-walk');
  scene.free();
  scene.free();
  const told = { name: 'Error', message: 'This scene has been freed.' };
  for (const property of [
    'warnings',
    'world',
    'currentView',
    'optionList',
    'oldWays',
    'leftOut',
    'memory',
  ])
    assert.throws(() => scene[property], told);
  for (const [method, ...words] of [
    ['set', 'fov', 70],
    ['get', 'fov'],
    ['look', null],
    ['step', 0],
    ['reset'],
    ['hits', 0],
    ['tryOldWay', 0],
    ['trace'],
    ['pixels', null],
    ['cast', null],
    ['pick', 0, 0],
    ['project', 1, 1, 1],
    ['cells', 'room'],
    ['blueprints'],
    ['setCell', 'room', 0, 1, 1, '.'],
    ['setCells', 'room', []],
    ['mark', []],
  ]) {
    assert.throws(() => scene[method](...words), told, method);
  }
  await assert.rejects(scene.png(), told);
});

test('warnings have places', async () => {
  const scene = await load(fileURLToPath(new URL('../scene/warnings.json', import.meta.url)));
  assert.ok(scene.warnings.length > 0);
  for (const { place } of scene.warnings) assert.match(place, /^warnings\.json:\d+:\d+$/);
  scene.free();
});

test('all faults are listed with their places, and the engine is freed', async (t) => {
  const stop = t.mock.method(Engine.prototype, 'stop');
  const error = await load({ title: 7, maps: 'none' }).catch((thrown) => thrown);
  assert.ok(error instanceof SceneError);
  assert.equal(stop.mock.callCount(), 1);
  assert.equal(error.code, 'scene');
  assert.ok(error.faults.length >= 2);
  for (const { place, found, expected } of error.faults)
    assert.ok(error.message.includes(`${place}: found ${found}, expected ${expected}`));
});

test('files that cannot be read are reported', async () => {
  await assert.rejects(load('nowhere/scene.json'), {
    name: 'SceneError',
    code: 'fetch',
    message: /nowhere\/scene\.json/,
  });
  await assert.rejects(load('http://localhost:9/100%.json'), {
    name: 'SceneError',
    code: 'fetch',
    message: /localhost:9/,
  });
  const error = await load(JSON.parse(roomScene()), { base: new URL('file:///nowhere/') }).catch(
    (thrown) => thrown,
  );
  assert.equal(error.code, 'scene');
  assert.match(
    error.faults[0].found,
    /^"brick\.png", .*: file:\/\/\/nowhere\/brick\.png: ENOENT: no such file or directory$/,
  );
  assert.ok(error.faults[0].message.includes(error.faults[0].found));
  await assert.rejects(load('nosuch'), {
    name: 'SceneError',
    code: 'fetch',
    message: /found "nosuch", .*castle, .* path, which \.\/nosuch would be/,
  });
  for (const scene of [7, null, undefined, '', 'http://'])
    await assert.rejects(load(scene), {
      name: 'TypeError',
      message: /^scene: found .*, expected a path/,
    });
  for (const options of [null, 7, { bass: '.' }, { engine: 'fast' }])
    await assert.rejects(load('castle', options), {
      name: 'TypeError',
      message: /: found .*, expected /,
    });
  const circle = {};
  circle.circle = circle;
  for (const scene of [circle, { title: 1n }])
    await assert.rejects(load(scene), { name: 'SceneError', code: 'scene', message: /JSON/ });
});

test(
  'many scenes at once need few open files',
  { skip: process.platform === 'win32' },
  async () => {
    const program = `import { load } from ${JSON.stringify(new URL('../../build/web/node/index.js', import.meta.url).href)};
    const scenes = await Promise.all(Array.from({ length: 4 }, () => load('castle')));
    console.log(scenes.length);`;
    const { stdout } = await run('sh', [
      '-c',
      'ulimit -n 72; exec "$0" --input-type=module --eval "$1"',
      process.execPath,
      program,
    ]).catch(crashToo);
    assert.equal(stdout.trim(), '4');
  },
);

test('without its files beside it the program says why, and tries again when it is asked again', async (t) => {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-'));
  t.after(() => rm(folder, { recursive: true }));
  const page = path.join(root, 'build/web');
  await cp(page, folder, {
    recursive: true,
    filter: (file) => file === page || /\.js(on)?$/.test(file) || /[\\/](node|engine)$/.test(file),
  });
  const moved = await import(pathToFileURL(path.join(folder, 'node/index.js')));
  await assert.rejects(moved.load('castle'), {
    name: 'SceneError',
    code: 'fetch',
    message: /slicecast-\w+\.wasm: ENOENT.*must leave external/,
  });
  for (const part of ['engine', 'scenes', 'textures', 'see-through', 'sheets', 'sprites'])
    await cp(path.join(page, part), path.join(folder, part), { recursive: true });
  const scene = await moved.load('first-walk');
  scene.free();
});

test('nothing is left among the names of a program', async () => {
  const before = Object.getOwnPropertyNames(globalThis);
  const scene = await load('first-walk');
  scene.free();
  assert.deepEqual(Object.getOwnPropertyNames(globalThis), before);
});

test('rows are a scene under Node too, with a legend, levels and colours', async () => {
  const scene = await load({
    rows: ['#####\n#>.x#\n#####', '##'],
    title: 'Rows',
    legend: { x: '#c03020', '#': 'brick' },
    colours: true,
  });
  assert.equal(scene.world.title, 'Rows');
  assert.equal(scene.world.maps[0].levels, 2);
  const { hits } = scene.hits(160, { width: 320, height: 200 });
  assert.equal(hits.find(({ filled }) => filled.length > 0).blueprint, 'block x');
  scene.free();
  await assert.rejects(load({ rows: '#>?', legend: { y: 7 } }), (error) => {
    assert.equal(error.name, 'SceneError');
    assert.equal(error.code, 'scene');
    assert.deepEqual(
      error.faults.map(({ place }) => place),
      ['rows:1:3', 'rows'],
    );
    return true;
  });
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-'));
  await copyFile(path.join(root, 'assets/textures/brick.png'), path.join(folder, 'wall.png'));
  const own = await load({ rows: '#>#', legend: { '#': 'wall.png' } }, { base: folder });
  own.free();
});

test('a scene that is a game tells its progress and its news', async () => {
  const hunt = await load('wayhouse-hunt');
  assert.equal(hunt.game.of, 4);
  assert.equal(hunt.game.begun, false);
  hunt.step(1);
  assert.equal(hunt.game.steps, 0);
  hunt.step(600, { forward: 1 });
  assert.equal(hunt.game.steps, 600);
  hunt.step(1, { use: true });
  const [refusal] = hunt.takeNews().slice(-1);
  assert.equal(refusal.kind, 'message');
  assert.match(refusal.text, /^The last gate is shut/);
  assert.deepEqual(hunt.takeNews(), []);
  hunt.free();
  const castleScene = await load('castle');
  assert.equal(castleScene.game, null);
  castleScene.free();
});

test('a scene may name shipped pictures, wherever it is', async (t) => {
  const scene = {
    title: 'Named',
    blueprints: { wall: { faces: { all: 'brick', top: 'lava' } } },
    legend: { '#': 'wall' },
    maps: [{ name: 'room', levels: [['####', '#..#', '####']], floor: 'grass' }],
    start: { x: 1.5, y: 1.5, heading: 0 },
  };
  const declared = {
    ...scene,
    textures: {
      brick: '../textures/brick.png',
      grass: '../textures/grass.png',
      lava: { file: '../sheets/lava.png', frames: 8, rate: 6 },
    },
  };
  const pictureOf = async (given, ...more) => {
    const loaded = await load(given, ...more);
    t.after(() => loaded.free());
    loaded.step(60);
    return loaded.pixels(kSize).data;
  };
  const wanted = await pictureOf(declared);
  assert.deepEqual(await pictureOf(scene, { base: tmpdir() }), wanted);
  assert.deepEqual(await pictureOf(declared, { base: tmpdir() }), wanted);
  await assert.rejects(
    load({ ...declared, textures: { grass: '../textures/gras.png' } }, { base: tmpdir() }),
    ({ faults: [{ found }] }) =>
      found.includes(`${new URL('../textures/', pathToFileURL(`${tmpdir()}/`))}`),
  );
  await assert.rejects(
    load({ ...scene, maps: [{ ...scene.maps[0], floor: 'gras' }] }),
    (error) => error instanceof SceneError && /did you mean "grass"/.test(error.message),
  );
});
