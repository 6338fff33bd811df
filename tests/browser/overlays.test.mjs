// The keys of the overlays, in the page.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import {
  frames,
  inState,
  launch,
  openScene,
  pictureHash,
  playAtOneSize,
  player,
  untilPlayer,
} from './browser.mjs';
import { roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const option = (page, name) => page.evaluate((which) => window.slicecast.get(which), name);

async function untilOption(page, name, value) {
  await page.waitForFunction(
    ([which, wanted]) => window.slicecast.get(which) === wanted,
    [name, value],
  );
  await frames(page);
}

test('each overlay has a key that shows and hides it', async (t) => {
  const { page } = await openScene(t, browser);
  await playAtOneSize(page);
  await frames(page);
  const plain = await pictureHash(page);
  for (const [key, name] of [
    ['KeyM', 'minimap'],
    ['KeyJ', 'playerPanel'],
    ['KeyU', 'processPanel'],
    ['KeyG', 'inspector'],
    ['KeyK', 'grid'],
    ['KeyY', 'slow'],
  ]) {
    await page.keyboard.press(key);
    await untilOption(page, name, 'on');
    assert.notEqual(await pictureHash(page), plain, name);
    await page.keyboard.press(key);
    await untilOption(page, name, 'off');
    assert.equal(await pictureHash(page), plain, name);
  }
  await page.keyboard.press('KeyM');
  await untilOption(page, 'minimap', 'on');
  for (const [key, name] of [
    ['KeyB', 'minimapTurns'],
    ['KeyO', 'minimapRays'],
  ]) {
    const without = await pictureHash(page);
    await page.keyboard.press(key);
    await untilOption(page, name, 'on');
    assert.notEqual(await pictureHash(page), without, name);
  }
});

test("F1 to F4 are the game's, not the browser's", async (t) => {
  const { page, context } = await openScene(t, browser);
  await playAtOneSize(page);
  const { width } = await page.evaluate(() => ({
    width: window.slicecast.shadowRoot.querySelector('canvas').width,
  }));
  await page.keyboard.press('F2');
  await untilOption(page, 'inspectorColumn', String(Math.floor(width / 2) + 1));
  await page.keyboard.press('F1');
  await untilOption(page, 'inspectorColumn', String(Math.floor(width / 2)));
  await page.keyboard.press('F4');
  await untilOption(page, 'slowSlices', '2');
  await page.keyboard.press('F3');
  await untilOption(page, 'slowSlices', '1');
  assert.equal(context.pages().length, 1);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'picture');
});

test('T lists what the inspected slice meets', async (t) => {
  const { page } = await openScene(t, browser);
  await playAtOneSize(page);
  await page.keyboard.press('KeyT');
  await page.waitForSelector('#slice[open]');
  assert.equal(await page.innerText('#slice h2'), 'Slice 320 of 640');
  const lines = await page.$$eval('#slice tbody tr', (rows) =>
    rows.map(({ cells }) => [...cells].map(({ innerText }) => innerText)),
  );
  assert.deepEqual(
    lines.map(([, what]) => what),
    ['sky', 'wall, west side', 'floor'],
  );
  assert.deepEqual(lines[1].slice(2), ['tile 6, 3; level 0', '2.50', '0 to 1']);
  assert.match(lines[0][0], /^0 to \d+$/);
  assert.match(lines[2][0], /^\d+ to 359$/);
  await page.keyboard.press('Escape');
  await inState(page, 'playing');
});

test('the number row goes to maps, L cycles through the times of day', async (t) => {
  const scene = roomScene();
  scene.maps.push({ ...scene.maps[0], name: 'second room' });
  const { page } = await openScene(t, browser, {
    server: { files: { 'scenes/room.json': JSON.stringify(scene) } },
  });
  await playAtOneSize(page);
  await page.keyboard.press('Digit1');
  await untilPlayer(page, (now) => now.mapName === 'second room');
  await page.keyboard.press('Digit5');
  await frames(page);
  assert.equal((await player(page)).map, 1, 'there is no such map');
  await page.keyboard.press('Digit0');
  await untilPlayer(page, (now) => now.mapName === 'room');
  const seen = new Set();
  for (const preset of ['day', 'dusk', 'night', 'fog', 'map']) {
    await page.keyboard.press('KeyL');
    await untilOption(page, 'lightPreset', preset);
    seen.add(await pictureHash(page));
  }
  assert.equal(seen.size, 5);
  assert.equal(await option(page, 'lightPreset'), 'map');
});
