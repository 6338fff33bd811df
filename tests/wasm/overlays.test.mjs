// Questions of inspectors: the hits of a column, the overlays by their options, the maps
// of a scene.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';

import { flavours, loadModule, root, Session } from './load.mjs';

const scene = join(root, 'assets/scenes/castle.json');
const kWidth = 640;
const kHeight = 400;

async function open(flavour, path = scene) {
  const session = new Session(await loadModule(flavour));
  assert.deepEqual(session.load(path), []);
  return session;
}

function renderNatively(theArguments) {
  const program = join(root, 'build/native/bin/slicecast-render');
  const result = spawnSync(program, theArguments, { encoding: 'utf8' });
  assert.equal(result.status, 0, result.stderr ?? String(result.error));
  return result.stdout;
}

function nativeHits(column) {
  return JSON.parse(
    renderNatively([scene, '--size', `${kWidth}x${kHeight}`, '--hits', `${column}`]),
  );
}

for (const flavour of flavours) {
  test(`the hits of a column are the same as slicecast-render's (${flavour})`, async () => {
    const session = await open(flavour);
    for (const column of [0, 200, kWidth - 1]) {
      const { scene: path, ...native } = nativeHits(column);
      const { scene: title, ...hits } = session.hits(kWidth, kHeight, column);
      assert.equal(path, scene);
      assert.equal(title, session.world().title);
      assert.deepEqual(hits, native);
      assert.ok(hits.hits.length > 0 && hits.tiles.length > 5);
    }
    for (const column of [-1, kWidth]) assert.equal(session.hits(kWidth, kHeight, column), null);
    assert.equal(session.hits(0, 0, 0), null);
  });
}

for (const flavour of flavours) {
  test(`so are the hits of portals, mirrors and objects (${flavour})`, async () => {
    const path = join(root, 'tests/scene/everything.json');
    const session = await open(flavour, path);
    const { maps } = session.world();
    for (const [map, eye, key, count] of [
      ['gallery', [2.5, 1.4, 0.5, 90, 0], 'portals', 2],
      ['hall', [2.5, 1.5, 0.625, 140, -0.2], 'mirrors', 2],
      ['hall', [2.5, 1.5, 0.625, 140, -0.2], 'objects', 3],
    ]) {
      const [x, y, z, heading, look] = eye;
      assert.ok(
        session.setEye({ map: maps.findIndex(({ name }) => name === map), x, y, z, heading, look }),
      );
      const view = ['--map', map, '--eye', eye.join(','), '--size', `${kWidth}x${kHeight}`];
      const { scene: title, ...hits } = session.hits(kWidth, kHeight, 320);
      const { scene: file, ...native } = JSON.parse(
        renderNatively([path, ...view, '--hits', '320']),
      );
      assert.equal(file, path);
      assert.equal(title, session.world().title);
      assert.deepEqual(hits, native);
      assert.ok(hits[key].length >= count, `${hits[key].length} ${key}`);
    }
  });
}

test('without a game there are neither hits nor maps', async () => {
  const session = new Session(await loadModule('simd'));
  assert.equal(session.hits(kWidth, kHeight, 0), null);
  assert.equal(session.goToMap(0), false);
});

test('every overlay is switched on by its option, and is the same in both flavours', async () => {
  const sessions = await Promise.all(flavours.map((flavour) => open(flavour)));
  const plain = sessions[0].draw(kWidth, kHeight);
  for (const [name, on] of [
    ['minimap', {}],
    ['minimapRays', { minimap: 'on' }],
    ['minimapTurns', { minimap: 'on' }],
    ['minimapLevel', { minimap: 'on' }],
    ['playerPanel', {}],
    ['processPanel', {}],
    ['inspector', {}],
    ['grid', {}],
    ['slow', {}],
  ]) {
    for (const session of sessions)
      for (const [also, value] of Object.entries(on))
        assert.equal(session.setOption(also, value), '');
    const before = sessions[0].draw(kWidth, kHeight);
    const pictures = sessions.map((session) => {
      assert.equal(session.setOption(name, name === 'minimapLevel' ? '3' : 'on'), '');
      return session.draw(kWidth, kHeight);
    });
    assert.ok(!pictures[0].equals(before), name);
    assert.ok(pictures[0].equals(pictures[1]), name);
    for (const session of sessions)
      for (const each of [name, ...Object.keys(on)])
        session.setOption(each, each === 'minimapLevel' ? '-1' : 'off');
    assert.ok(sessions[0].draw(kWidth, kHeight).equals(plain), `${name} leaves nothing behind`);
  }
});

test('times of day change the picture and can be undone', async () => {
  const session = await open('simd');
  const seen = new Set();
  for (const preset of ['map', 'day', 'dusk', 'night', 'fog']) {
    assert.equal(session.setOption('lightPreset', preset), '');
    seen.add(session.draw(64, 40).toString('latin1'));
  }
  assert.equal(seen.size, 5);
  session.setOption('lightPreset', 'map');
  assert.equal(session.draw(64, 40).toString('latin1'), [...seen][0]);
});

test('a map is entered by its number', async () => {
  const session = await open('simd');
  const { x, y } = session.state();
  session.step([1, 0, 0, 0, 0, 0, 0, 0], 100);
  assert.notEqual(session.state().x, x);
  assert.equal(session.goToMap(session.world().maps.length), false);
  assert.equal(session.goToMap(session.state().map), true);
  assert.deepEqual([session.state().x, session.state().y], [x, y], "to the scene's start");
});
