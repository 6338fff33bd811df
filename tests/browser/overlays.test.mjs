// The keys of the overlays, in the page.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import {
  frames,
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

test('T prints the hits of the inspected slice to the console', async (t) => {
  const { page } = await openScene(t, browser);
  await playAtOneSize(page);
  const told = page.waitForEvent('console', (message) => message.text().startsWith('slice '));
  await page.keyboard.press('KeyT');
  const { hits, column, map } = await (await told).args()[2].jsonValue();
  assert.equal(map, 'room');
  assert.equal(
    column,
    Math.floor(
      (await page.evaluate(() => window.slicecast.shadowRoot.querySelector('canvas').width)) / 2,
    ),
  );
  assert.equal(hits[0].face, 'west');
  assert.deepEqual(hits[0].tile, [6, 3]);
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
