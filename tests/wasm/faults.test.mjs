// Faults of scenes and options have the same texts as in the native programs, and
// the running game goes on.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { brokenScenes, brokenScenesFolder } from '../scene/broken-scenes.mjs';
import {
  loadModule,
  mistakesOf,
  roomScene,
  root,
  Session,
  shippedScenes,
  textureBytes,
} from './load.mjs';

const readTexture = () => textureBytes;

test('every broken scene has the same faults natively and in WebAssembly', async () => {
  const session = new Session(await loadModule('simd'));
  for (const { name, bytes, faults } of brokenScenes()) {
    const found = session.loadText(bytes, `${name}.json`, (image) =>
      readFileSync(join(brokenScenesFolder, image)),
    );
    assert.deepEqual(
      found.map(({ message }) => message),
      faults.map((fault) => `${name}.json:${fault}`),
    );
    assert.equal(session.draw(8, 8), null, name);
  }
});

test('warnings are the same natively and in WebAssembly, and the scene plays', async () => {
  const session = new Session(await loadModule('simd'));
  const scene = join(root, 'tests/scene/warnings.json');
  assert.deepEqual(session.load(scene), []);
  const native = spawnSync(join(root, 'build/native/bin/slicecast-check'), [scene], {
    encoding: 'utf8',
  });
  assert.deepEqual(
    session.warnings.map(({ message }) => `warning: ${message}`),
    native.stderr.trimEnd().split('\n'),
  );
  assert.notEqual(session.draw(8, 8), null);
});

test('mistakes that take long to find are the same natively and in WebAssembly', async () => {
  const scene = join(root, 'tests/scene/everything.json');
  const { warnings, spares } = await mistakesOf(scene);
  assert.ok(warnings.length > 1 && spares.length > 5);
  const native = spawnSync(join(root, 'build/native/bin/slicecast-check'), [scene], {
    encoding: 'utf8',
  });
  const withoutFile = (line) => line.replace(/^(warning: )?\S*everything\.json/, '');
  assert.deepEqual(
    [...warnings, ...spares].map(({ message }) => withoutFile(message)).sort(),
    native.stderr.trimEnd().split('\n').map(withoutFile).sort(),
  );
});

test('a fault names file, place, what was found and what was expected', async () => {
  const session = new Session(await loadModule('simd'));
  const { files, faults } = session.parse('{\n  "title": 7\n}', 'odd "name".json');
  assert.deepEqual(files, []);
  const fault = faults.find(({ pointer }) => pointer === '/title');
  assert.deepEqual(
    { file: fault.file, line: fault.line, column: fault.column },
    { file: 'odd "name".json', line: 2, column: 12 },
  );
  assert.match(fault.found, /7/);
  assert.ok(fault.expected.length > 0);
  assert.ok(fault.message.startsWith('odd "name".json:2:12'));
});

test('a file that is never supplied is a fault of the start', async () => {
  const session = new Session(await loadModule('simd'));
  assert.deepEqual(session.parse(roomScene(), 'room.json'), { files: ['brick.png'], faults: [] });
  const faults = session.start();
  assert.equal(faults.length, 1);
  assert.match(faults[0].message, /brick\.png/);
});

test('bytes that are no image are a fault', async () => {
  const session = new Session(await loadModule('simd'));
  const faults = session.loadText(roomScene(), 'room.json', () => Buffer.from('no image'));
  assert.equal(faults.length, 1);
  assert.match(faults[0].message, /PNG/);
});

test('a game goes on while the next scene has faults', async () => {
  const session = new Session(await loadModule('simd'));
  session.load(shippedScenes[0]);
  session.step([1, 0, 0, 0, 0, 0, 0, 0], 30);
  const { fingerprint } = session.state();
  assert.ok(session.loadText('{"title": ', 'half.json', readTexture).length > 0);
  assert.ok(session.start().length > 0, 'a start after a wrong text says what is wrong again');
  assert.ok(
    session.loadText(roomScene(), 'room.json', () => {
      throw new Error('not there');
    }).length > 0,
  );
  assert.equal(session.state().fingerprint, fingerprint);
  assert.deepEqual(session.loadText(roomScene(), 'room.json', readTexture), []);
  assert.equal(session.world().title, 'A room');
});

test('a wrong option changes nothing and says what is expected', async () => {
  const session = new Session(await loadModule('simd'));
  session.load(shippedScenes[0]);
  assert.equal(session.setOption('fov', '75'), '');
  assert.equal(session.option('fov'), '75');
  for (const [name, value, expected] of [
    ['fov', '1000', /10 to 150/],
    ['fov', 'wide', /a number/],
    ['light', 'yes', /'on' or 'off'/],
    ['colour', 'on', /colour/],
  ]) {
    assert.match(session.setOption(name, value), expected);
  }
  assert.equal(session.option('fov'), '75');
  assert.equal(session.option('light'), 'on');
  assert.equal(session.option('colour'), '');
});

test('options work, are listed, and can be set before a game and outlive it', async () => {
  const session = new Session(await loadModule('simd'));
  assert.equal(session.setOption('textures', 'off'), '');
  assert.match(session.setOption('textures', 'maybe'), /'on' or 'off'/);
  session.loadText(roomScene(), 'room.json', readTexture);
  assert.equal(session.option('textures'), 'off');
  const plain = session.draw(64, 40);
  session.setOption('textures', 'on');
  assert.ok(!session.draw(64, 40).equals(plain));

  session.setOption('minimap', 'on');
  session.loadText(roomScene({ width: 12 }), 'room.json', readTexture);
  assert.equal(session.option('minimap'), 'on');
  const listed = session.options();
  assert.deepEqual(listed.find(({ name }) => name === 'minimap').value, 'on');
  assert.deepEqual(listed.find(({ name }) => name === 'fov').least, 10);
});

test('pictures of impossible sizes are refused', async () => {
  const session = new Session(await loadModule('simd'));
  session.load(shippedScenes[0]);
  for (const [width, height] of [
    [0, 10],
    [10, 0],
    [-1, 10],
    [8193, 1],
    [1, 8193],
  ])
    assert.equal(session.draw(width, height), null, `${width}x${height}`);
  assert.equal(session.draw(1, 1).length, 4);
});
