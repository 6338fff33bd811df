// An engine adopts the scene of another one as if it had loaded it.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Engine } from '../../build/web/engine/engine.js';
import { readEngine } from '../../build/web/node/engine-files.js';
import { openScene } from '../../build/web/node/scene-files.js';
import { flavours } from './load.mjs';

const kSize = [160, 100];

// One that draws into a canvas has its scene in the program's session; none of these begins to
// draw.
async function createEngine(flavour) {
  return Engine.create({ files: await readEngine(flavour), canvas: {} });
}

// The pictures of a walk, and the state at its end.
function walk(engine) {
  const seen = [0, 60, 120, 120].map((steps) => {
    engine.step({ forward: 1, turn: 0.3, use: steps === 60 }, steps);
    return Buffer.from(engine.drawPixels(...kSize)).toString('base64');
  });
  return {
    seen,
    state: engine.state,
    options: engine.options,
    world: engine.world,
    warnings: engine.warnings,
    view: engine.view,
  };
}

for (const flavour of flavours) {
  for (const name of ['castle', 'garden', 'glassworks', 'wayhouse']) {
    test(`${flavour}: ${name} is adopted from an engine that has played it for a while`, async () => {
      const fresh = await createEngine(flavour);
      assert.deepEqual(await fresh.loadScene(openScene(name)), []);
      const player = await createEngine(flavour);
      assert.deepEqual(await player.loadScene(openScene(name)), []);
      // Things move, gates open, and options change what is drawn and what maps keep of it.
      player.setOption('lightPreset', 'dusk');
      player.setOption('intensity', '0.3');
      player.setOption('fov', '90');
      player.setOption('minimap', true);
      player.flying = true;
      player.step({ forward: 1, fly: 0.2, open: true }, 400);
      player.paused = true;
      player.resize(300, 200);
      player.record(name);
      player.step({ turn: 1 }, 20);
      const before = player.state;

      const adopter = await createEngine(flavour);
      assert.equal(adopter.adopt(player), true);
      assert.equal(adopter.paused, false);
      assert.equal(adopter.takeRecording(), '');
      assert.deepEqual(walk(adopter), walk(fresh));
      assert.deepEqual(player.state, before);
      // And they stay equal.
      const third = await createEngine(flavour);
      assert.equal(third.adopt(adopter), true);
      assert.equal(third.state.fingerprint, (await reloaded(flavour, name)).state.fingerprint);
    });
  }

  test(`${flavour}: with grown memory, and with nothing to adopt`, async () => {
    const player = await createEngine(flavour);
    assert.equal((await createEngine(flavour)).adopt(player), false);
    await player.loadScene(openScene('first-steps'));
    // Into memory that is there, and then into some that has to be grown first.
    for (let pixels = 1 << 20; pixels <= 2 << 20; pixels *= 2) {
      player.drawPixels(1024, pixels / 1024);
      const adopter = await createEngine(flavour);
      assert.equal(adopter.adopt(player), true);
      assert.ok(adopter.memoryBytes >= player.memoryBytes);
      assert.deepEqual(walk(adopter), walk(await reloaded(flavour, 'first-steps')));
    }
    // Memory for a large picture is not part of the scene.
    player.drawPixels(4096, 4096);
    assert.ok(player.memoryBytes > 64e6);
    const adopter = await createEngine(flavour);
    assert.equal(adopter.adopt(player), false);
    assert.deepEqual(await adopter.loadScene(openScene('first-steps')), []);
    assert.ok(adopter.memoryBytes < 20e6);
    assert.deepEqual(walk(adopter), walk(await reloaded(flavour, 'first-steps')));
    player.stop();
    assert.equal((await createEngine(flavour)).adopt(player), false);
  });
}

async function reloaded(flavour, name) {
  const engine = await createEngine(flavour);
  await engine.loadScene(openScene(name));
  return engine;
}
