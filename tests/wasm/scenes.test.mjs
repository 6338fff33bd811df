// The shipped scenes, played by recorded inputs: the WebAssembly with SIMD, the one without, and
// the native program agree in every state and every byte.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { test } from 'node:test';

import { flavours, loadModule, root, Session, shippedScenes } from './load.mjs';

const kWidth = 203;
const kHeight = 131;
const kJump = 1;
const kFast = 2;
const kSlow = 4;
const kUse = 8;
const kOpen = 16;
const kClose = 32;

// Steps, then forward, strafe, turn, look, fly, turnDegrees, lookHeights, buttons.
const recording = [
  [0, 0, 0, 0, 0, 0, 0, 0, 0],
  [90, 1, 0, 0, 0, 0, 0, 0, 0],
  [60, 1, 0, 0.7, 0, 0, 0, 0, kFast],
  [1, 0, 0, 0, 0, 0, 33.3, 0.21, 0],
  [70, 1, -1, 0, 0, 0, 0.15, 0, kJump + kOpen],
  [50, 0, 1, -1, 1, 0, 0, 0, kSlow + kUse],
  [80, 1, 0, 0, -1, -1, 0, 0, kClose],
  [120, 1, 0, 0.3, 0, 0, 0, 0, kFast + kJump],
  [30, -1, 0.5, 0, 0, 0, -71.7, -0.05, 0],
  [90, 1, 0, -0.2, 0.1, 0, 0, 0, kFast],
];

function playNatively(scene) {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-'));
  try {
    const pictures = join(folder, 'pictures');
    const input = recording.map((line) => line.join(' ')).join('\n');
    const result = spawnSync(
      join(root, 'build/native/tests/slicecast-replay'),
      [scene, kWidth, kHeight, pictures].map(String),
      { input, encoding: 'utf8' },
    );
    assert.equal(result.status, 0, result.stderr ?? String(result.error));
    const bytes = readFileSync(pictures);
    const size = kWidth * kHeight * 4;
    return result.stdout
      .trim()
      .split('\n')
      .map((fingerprint, i) => ({
        fingerprint,
        picture: bytes.subarray(i * size, (i + 1) * size),
      }));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

async function play(flavour, scene) {
  const session = new Session(await loadModule(flavour));
  assert.deepEqual(session.load(scene), []);
  return recording.map(([count, ...input]) => {
    session.step(input, count);
    return { fingerprint: session.state().fingerprint, picture: session.draw(kWidth, kHeight) };
  });
}

test('there are scenes', () => assert.ok(shippedScenes.length > 0));

for (const scene of shippedScenes) {
  for (const flavour of flavours) {
    test(`${basename(scene)} plays the same natively and in WebAssembly (${flavour})`, async () => {
      const native = playNatively(scene);
      const ours = await play(flavour, scene);
      assert.equal(native.length, recording.length);
      assert.ok(
        new Set(native.map(({ fingerprint }) => fingerprint)).size === recording.length,
        'every stretch of the recording moves',
      );
      for (let i = 0; i < recording.length; ++i) {
        assert.equal(ours[i].fingerprint, native[i].fingerprint, `state ${i}`);
        assert.ok(ours[i].picture.equals(native[i].picture), `picture ${i}`);
      }
    });
  }
}

test('a picture between two steps is in between', async () => {
  const session = new Session(await loadModule('simd'));
  // Without objects, which are drawn at their place of the last step.
  session.load(shippedScenes.find((path) => path.endsWith('first-steps.json')));
  const before = session.draw(64, 40);
  session.step([0, 0, 0, 0, 0, 20, 0, 0]);
  assert.ok(session.draw(64, 40, 0).equals(before));
  const half = session.draw(64, 40, 0.5);
  const after = session.draw(64, 40, 1);
  assert.ok(!half.equals(before) && !half.equals(after) && !after.equals(before));
});

test('the state says where the player is, and an eye can be put elsewhere', async () => {
  const session = new Session(await loadModule('simd'));
  session.load(shippedScenes[0]);
  const { maps } = session.world();
  assert.ok(maps[0].width > 0 && maps[0].depth > 0 && maps[0].levels > 0);
  assert.equal(session.state().steps, 0);
  assert.ok(session.setEye({ x: 2.25, y: 3.5, z: 1.125, heading: 271.3, look: -0.4 }));
  const { map, x, y, z, heading, look, flying } = session.state();
  assert.deepEqual(
    { map, x, y, z, heading, look, flying },
    { map: 0, x: 2.25, y: 3.5, z: 1.125, heading: 271.3, look: -0.4, flying: true },
  );
  assert.equal(session.setEye({ x: 1, y: 1, z: 0 }), false, 'not at the floor');
  assert.equal(
    session.setEye({ map: maps.length, x: 1, y: 1, z: 1 }),
    false,
    'not in a map that is not there',
  );
  assert.equal(
    session.setEye({ x: NaN, y: 1, z: 1, heading: NaN }),
    false,
    'not with a heading that is no number',
  );
  assert.equal(session.state().x, 2.25);
  session.module._slicecast_reset(session.address);
  assert.equal(session.state().flying, false);
});

test('the same scene in two sessions of one module', async () => {
  const module = await loadModule('simd');
  const [one, other] = [new Session(module), new Session(module)];
  one.load(shippedScenes[0]);
  other.load(shippedScenes[0]);
  one.step([1, 0, 0, 0, 0, 0, 0, 0], 60);
  assert.notEqual(one.state().fingerprint, other.state().fingerprint);
  other.step([1, 0, 0, 0, 0, 0, 0, 0], 60);
  assert.equal(one.state().fingerprint, other.state().fingerprint);
  assert.ok(one.draw(80, 50).equals(other.draw(80, 50)));
});
