// Gamepads, and steering by the mouse position. The gamepad is a fake one, provided
// through the browser's own interface.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import {
  frames,
  inState,
  launch,
  openPage,
  openScene,
  play,
  player,
  untilPlayer,
  withWindows,
} from './browser.mjs';
import { withPad } from './fake-pad.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const setPad = (page, ...state) => page.evaluate((given) => window.pad(...given), state);

async function stands(page) {
  const { steps } = await player(page);
  const before = await untilPlayer(page, (now, last) => now.steps > last + 60, steps);
  const now = await untilPlayer(page, (state, last) => state.steps > last + 20, before.steps);
  return ['x', 'y', 'z', 'heading', 'look'].every((key) => before[key] === now[key]);
}

test('a gamepad starts the game, walks, turns, jumps and flies', async (t) => {
  const { page } = await openScene(t, browser, { prepare: withPad });
  await setPad(page);
  await frames(page, 5);
  await inState(page, 'paused');
  await setPad(page, [0, 0, 0, 0], [0]);
  await inState(page, 'playing');
  assert.equal(await page.evaluate(() => document.activeElement.id), 'picture');

  // The button that starts the game also jumps.
  await setPad(page, [0.1, -0.1, 0.1, 0]);
  await frames(page, 10);
  await untilPlayer(page, (now) => now.onGround);
  assert.ok(await stands(page), 'within the dead zones');
  const begin = await player(page);
  await setPad(page, [0, -1, 0, 0]);
  await untilPlayer(page, (now, { x }) => now.x > x + 0.5, begin);
  await setPad(page, [1, 0, 0, 0]);
  await untilPlayer(page, (now, { y }) => now.y > y + 0.5, begin);
  await setPad(page, [0, 0, 1, -1]);
  await untilPlayer(page, (now) => now.heading > 10 && now.heading < 180 && now.look > 0.05);
  await setPad(page);
  assert.ok(await stands(page));
  await setPad(page, [0, 0, 0, 0], [0]);
  await untilPlayer(page, (now, { z }) => now.z > z + 0.1, begin);
  await setPad(page, [0, 0, 0, 0], [3]);
  await untilPlayer(page, (now) => now.flying);
  await setPad(page, [0, 0, 0, 0], [7]);
  await untilPlayer(page, (now) => now.z > 1.2);

  // Unplugged with the trigger down
  await page.evaluate(() => window.unplug());
  assert.ok(await stands(page));
  await setPad(page, [0, 0, 0, 0], [9]);
  await inState(page, 'paused');
});

test('a gamepad without the standard mapping is ignored', async (t) => {
  const { page } = await openScene(t, browser, { prepare: withPad });
  await play(page);
  await setPad(page, [1, 1, 1, 1], [0], '');
  assert.ok(await stands(page));
});

test('N steers by the mouse position, with a dead zone in the middle', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.mouse.move(320, 180);
  await page.keyboard.press('n');
  await page.waitForFunction(() => document.body.classList.contains('steering'));
  assert.equal(await page.textContent('#mode'), 'The mouse position steers; Escape ends it');

  // 640 x 360: the dead zone reaches from 256 to 384 and from 144 to 216
  await page.mouse.move(380, 148);
  assert.ok(await stands(page));
  await page.mouse.move(600, 180);
  await untilPlayer(page, (now) => now.heading > 10 && now.heading < 180);
  assert.equal((await player(page)).look, 0);
  await page.mouse.move(320, 60);
  await untilPlayer(page, (now) => now.look > 0.1);
  await page.mouse.move(320, 180);
  assert.ok(await stands(page));
  await page.keyboard.press('n');
  await page.waitForFunction(() => !document.body.classList.contains('steering'));
  await page.mouse.move(600, 180);
  assert.ok(await stands(page));
});

test('if the browser refuses the pointer lock, a click steers by the mouse position', async (t) => {
  // A sandbox without allow-pointer-lock
  const files = {
    'frame.html':
      '<!doctype html><body style="margin:0"><iframe sandbox="allow-scripts allow-same-origin" src="./" style="border:0;width:640px;height:360px">',
  };
  const { page } = await openPage(t, await withWindows(t), {
    server: { files },
    query: 'frame.html',
    expectErrors: true,
  });
  const frame = await (await page.waitForSelector('iframe')).contentFrame();
  await frame.waitForFunction(() => document.body.dataset.state === 'paused');
  const state = () => frame.evaluate(() => window.slicecast.player);
  await page.mouse.click(320, 100);
  await frame.waitForFunction(() => document.body.classList.contains('steering'));
  assert.equal(await frame.evaluate(() => document.pointerLockElement), null);
  await page.mouse.move(40, 180);
  await frame.waitForFunction(
    () => window.slicecast.player.heading > 180 && window.slicecast.player.heading < 350,
  );
  await page.mouse.move(320, 180);
  const { steps } = await state();
  await frame.waitForFunction((last) => window.slicecast.player.steps > last + 60, steps);
  const rested = await state();
  await frame.waitForFunction((last) => window.slicecast.player.steps > last + 20, rested.steps);
  assert.equal((await state()).heading, rested.heading);
});
