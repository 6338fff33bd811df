// Scenes under Node, as the package offers them.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { load, SceneError } from '../../build/web/node/index.js';
import { flavours, loadModule, roomScene, root, Session } from '../wasm/load.mjs';

const castle = `${root}/assets/scenes/castle.json`;
const kSize = { width: 120, height: 75 };

test('a scene is found by name, path, address and as an object, and looks the same', async () => {
  const object = JSON.parse(await readFile(castle, 'utf8'));
  const pictures = [];
  for (const from of ['castle', castle, new URL(`file://${castle}`), `file://${castle}`, object]) {
    const scene = await load(from);
    pictures.push(Buffer.from(scene.picture(kSize).data));
    scene.free();
  }
  for (const picture of pictures) assert.ok(picture.equals(pictures[0]));
});

test('both builds draw what the bindings draw', async () => {
  for (const engine of flavours) {
    const scene = await load('castle', { engine });
    const session = new Session(await loadModule(engine));
    session.load(castle);
    scene.step(60, { forward: 1, turn: 0.5, jump: true });
    session.step([1, 0, 0.5, 0, 0, 0, 0, 1], 60);
    assert.ok(Buffer.from(scene.picture(kSize).data).equals(session.draw(kSize.width, kSize.height)), engine);
    scene.free();
  }
});

test('an object names its files from a base', async () => {
  const scene = await load(JSON.parse(roomScene()), { base: new URL(`file://${root}/assets/textures/`) });
  assert.deepEqual(scene.world, { title: 'A room', maps: [{ name: 'room', width: 8, depth: 6, levels: 1 }] });
  scene.free();
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
  assert.deepEqual(scene.currentView, { ...before, x: 3.5, y: 4.5, z: 0.75, heading: 180, look: 0 });
  assert.equal(scene.look({ map: 'nowhere' }), false);
  scene.reset();
  assert.deepEqual(scene.currentView, before);

  const { hits, size } = scene.hits(60, kSize);
  assert.deepEqual(size, [kSize.width, kSize.height]);
  assert.ok(hits.length > 0);
  assert.equal(scene.hits(120, kSize), null);
  assert.equal(scene.trace(60, kSize).hits.length, hits.length);
  assert.deepEqual(scene.trace(undefined, kSize).size, size);
  assert.throws(() => scene.picture({ width: 0, height: 10 }), RangeError);
  scene.free();
  assert.throws(() => scene.picture(), /stopped/);
});

test('warnings have places', async () => {
  const scene = await load(fileURLToPath(new URL('../scene/warnings.json', import.meta.url)));
  assert.ok(scene.warnings.length > 0);
  for (const { place } of scene.warnings) assert.match(place, /^warnings\.json:\d+:\d+$/);
  scene.free();
});

test('all faults are listed, with their places', async () => {
  const error = await load({ title: 7, maps: 'none' }).catch((thrown) => thrown);
  assert.ok(error instanceof SceneError);
  assert.equal(error.code, 'scene');
  assert.ok(error.faults.length >= 2);
  for (const { place, found, expected } of error.faults) assert.ok(error.message.includes(`${place}: found ${found}, expected ${expected}`));
});

test('what cannot be read is told', async () => {
  await assert.rejects(load('nowhere/scene.json'), { name: 'SceneError', code: 'fetch', message: /nowhere\/scene\.json/ });
  await assert.rejects(load('http://localhost:9/scene.json'), { name: 'SceneError', code: 'fetch', message: /localhost:9/ });
  await assert.rejects(load(JSON.parse(roomScene()), { base: new URL('file:///nowhere/') }), { code: 'scene', message: /brick\.png/ });
  await assert.rejects(load(7), TypeError);
  await assert.rejects(load('castle', { engine: 'fast' }), TypeError);
});

test('nothing is left among the names of a program', async () => {
  const before = Object.getOwnPropertyNames(globalThis);
  const scene = await load('first-walk');
  scene.free();
  assert.deepEqual(Object.getOwnPropertyNames(globalThis), before);
});
