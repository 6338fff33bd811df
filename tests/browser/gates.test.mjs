// A gate in the page: opened by a key, and by the button under the thumb, which only scenes with
// gates have.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { inState, launch, letPass, openScene, play, player, untilPlayer } from './browser.mjs';
import { png } from './png.mjs';
import { roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// The room with a gate across it, right before the player, who looks at it.
function files(needs = {}) {
  const scene = roomScene({ title: 'A room with a gate' });
  scene.textures.gate = { file: 'pictures/gate.png', frames: 2 };
  scene.blueprints.gate = { faces: 'gate', gate: { seconds: 0.25, reach: 1, ...needs } };
  scene.legend.g = 'gate';
  scene.maps[0].levels[0] = scene.maps[0].levels[0].map((row) =>
    row === '#######' ? row : '#...g.#',
  );
  return {
    'scenes/room.json': JSON.stringify(scene),
    'scenes/pictures/gate.png': png(16, (x) => (x < 8 ? [90, 60, 30] : [30, 90, 60]), 8),
  };
}

const halts = async (page) => {
  await page.keyboard.down('w');
  const { steps } = await player(page);
  const now = await untilPlayer(page, (state, before) => state.steps > before + 90, steps);
  await page.keyboard.up('w');
  return now.x < 4;
};

// Longer than it takes to open or to close
async function gateMoves(page) {
  const { steps } = await player(page);
  await untilPlayer(page, (state, before) => state.steps > before + 60, steps);
}

test('X opens the gate and closes it again', async (t) => {
  const { page } = await openScene(t, browser, { server: { files: files() } });
  await play(page);
  assert.ok(await halts(page), 'it is closed');
  await page.keyboard.press('x');
  await gateMoves(page);
  await page.keyboard.press('x');
  await gateMoves(page);
  assert.ok(await halts(page), 'it is closed again');
  await page.keyboard.press('Period');
  await page.keyboard.down('w');
  await untilPlayer(page, (state) => state.x > 5.2);
  await page.keyboard.up('w');
});

test('a thumb opens the gate; without gates there is no such button', async (t) => {
  const phone = {
    viewport: { width: 390, height: 844 },
    context: { isMobile: true, hasTouch: true },
  };
  const open = async (options) => {
    const { page, context } = await openScene(t, browser, { ...phone, ...options });
    await page.tap('#play');
    await inState(page, 'playing');
    return { page, touches: await context.newCDPSession(page) };
  };
  const { page: plain } = await open({});
  assert.equal(await plain.isVisible('[data-thumb="use"]'), false);
  assert.equal(await plain.isVisible('[data-thumb="fly"]'), true);
  const { page, touches } = await open({ server: { files: files() } });
  await page.tap('[data-thumb="use"]');
  await gateMoves(page);
  const touch = (type, ...touchPoints) =>
    touches.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', { id: 1, x: 90, y: 600 });
  await touch('touchMove', { id: 1, x: 90, y: 530 });
  await untilPlayer(page, (state) => state.x > 5.2);
  await touch('touchEnd');
});

test('a locked gate says what is missing, and no key; hints at gates end by themselves', async (t) => {
  const locked = files({ needs: 'brass key' });
  const scene = JSON.parse(locked['scenes/room.json']);
  scene.sprites = { key: 'pictures/red.png' };
  scene.maps[0].objects = [
    { sprite: 'key', x: 1.5, y: 1.5, height: 0.4, find: { kind: 'brass key' } },
  ];
  const open = async (all) => {
    const { page } = await openScene(t, browser, { server: { files: all } });
    await page.clock.install();
    await play(page);
    await page.waitForSelector('#hint.shown kbd, #hint.shown:not(:has(kbd))');
    return page;
  };
  const page = await open({ ...locked, 'scenes/room.json': JSON.stringify(scene) });
  assert.equal(await page.innerText('#hint'), 'Still missing: brass key.');
  assert.equal((await player(page)).gate, '');
  await page.keyboard.press('x');
  await page.waitForSelector('#message.shown');
  assert.equal(await page.innerText('#message'), 'Still missing: brass key.');
  await letPass(page, 26); // of this hint, and of the one about walking
  await page.waitForSelector('#hint:not(.shown)', { state: 'attached' });
  await page.close();

  const free = await open(files());
  assert.equal(await free.innerText('#hint'), 'X opens the gate');
  await letPass(free, 26);
  assert.equal(await free.locator('#hint.shown').count(), 0);
});
