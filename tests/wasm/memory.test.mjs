// Memory grows when a picture needs it, is freed when a session ends, and belongs to one
// module alone.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { loadModule, roomScene, Session, shippedScenes, textureBytes } from './load.mjs';

const readTexture = () => textureBytes;

test('growing memory leaves the session and its pictures as they were', async () => {
  const session = new Session(await loadModule('simd'));
  session.load(shippedScenes[0]);
  const small = session.draw(160, 100);
  const bufferBefore = session.module.HEAPU8.buffer;
  const large = session.draw(4096, 4096);
  assert.notEqual(
    session.module.HEAPU8.buffer,
    bufferBefore,
    'a picture of 64 MB needs more memory',
  );
  assert.equal(large.length, 4096 * 4096 * 4);
  for (let at = 3; at < large.length; at += 4)
    if (large[at] !== 255) assert.fail(`alpha of byte ${at}`);
  assert.ok(session.draw(160, 100).equals(small));
});

// As an element does it: one module, one scene, one picture at a time.
test('a module holds little more memory than its scene and picture need', async (t) => {
  const kMiB = 2 ** 20;
  const held = async (load) => {
    const session = new Session(await loadModule('simd'));
    const program = session.module.HEAPU8.length;
    assert.ok(program < 1.5 * kMiB, `${program} bytes before any scene`);
    assert.deepEqual(load(session), []);
    assert.ok(session.draw(320, 200));
    return (session.module.HEAPU8.length - program) / kMiB;
  };
  const room = await held((session) => session.loadText(roomScene(), 'room.json', readTexture));
  const castleFile = shippedScenes.find((file) => file.endsWith('castle.json'));
  const castle = await held((session) => session.load(castleFile));
  t.diagnostic(`MiB beyond the program: a room ${room.toFixed(2)}, castle ${castle.toFixed(2)}`);
  assert.ok(room < 4);
  assert.ok(castle < 16);
});

test('ended sessions free their memory', async () => {
  const module = await loadModule('simd');
  const round = () => {
    const session = new Session(module);
    assert.deepEqual(session.load(shippedScenes[0]), []);
    session.step([1, 0, 0, 0, 0, 0, 0, 0], 10);
    assert.ok(session.draw(640, 400));
    session.free();
  };
  for (let i = 0; i < 3; ++i) round();
  const bytes = module.HEAPU8.length;
  for (let i = 0; i < 30; ++i) round();
  assert.equal(module.HEAPU8.length, bytes);
});

test('scene after scene in one session does not add up', async () => {
  const session = new Session(await loadModule('simd'));
  const round = () => assert.deepEqual(session.load(shippedScenes[0]), []);
  // Until the allocator's gaps no longer change.
  for (let i = 0; i < 30; ++i) round();
  const bytes = session.module.HEAPU8.length;
  for (let i = 0; i < 30; ++i) round();
  assert.equal(session.module.HEAPU8.length, bytes);
});

test('two modules do not see each other', async () => {
  const one = new Session(await loadModule('simd'));
  const other = new Session(await loadModule('simd'));
  assert.notEqual(one.module.HEAPU8.buffer, other.module.HEAPU8.buffer);
  one.loadText(roomScene(), 'room.json', readTexture);
  assert.equal(other.world(), null);
  other.loadText(roomScene({ title: 'Another room' }), 'room.json', readTexture);
  assert.equal(one.world().title, 'A room');
  assert.equal(other.world().title, 'Another room');
});
