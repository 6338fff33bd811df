// A gamepad in the page's menus.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { frames, inState, launch, openScene } from './browser.mjs';
import { withPad } from './fake-pad.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kUp = 12;
const kDown = 13;
const kRight = 15;
const kStart = 9;

async function tap(page, button) {
  await page.evaluate((which) => window.pad([0, 0, 0, 0], [which]), button);
  await frames(page, 3);
  await page.evaluate(() => window.pad());
  await frames(page, 3);
}
const focused = (page) =>
  page.evaluate(() => document.activeElement.id || document.activeElement.className);

test('the D-pad moves between controls, the lower button presses, the right one closes', async (t) => {
  const { page } = await openScene(t, browser, { prepare: withPad, query: '?scene=room' });
  await page.evaluate(() => window.pad());
  await frames(page, 3);
  await tap(page, kDown);
  assert.equal(await focused(page), 'play');
  await tap(page, kDown);
  assert.equal(await focused(page), 'open-scenes');
  await tap(page, 0);
  assert.ok(await page.locator('#scenes').isVisible());
  await tap(page, 1);
  assert.ok(!(await page.locator('#scenes').isVisible()));
  await tap(page, kStart);
  assert.ok(await page.locator('#scenes').isVisible());
  await tap(page, 1);
});

test('it sets sliders, and Start pauses the game', async (t) => {
  const { page } = await openScene(t, browser, { prepare: withPad, query: '?scene=room' });
  await page.evaluate(() => window.pad());
  await page.click('#open-settings');
  await page.focus('#set-fov');
  const before = Number(await page.inputValue('#set-fov'));
  await tap(page, kRight);
  assert.equal(Number(await page.inputValue('#set-fov')), before + 5);
  assert.equal(await page.evaluate(() => window.slicecast.get('fov')), String(before + 5));
  await tap(page, kUp);
  assert.notEqual(await focused(page), 'set-fov');
  await tap(page, 1);
  assert.equal(await focused(page), 'open-settings');
  await page.focus('#play');
  await tap(page, 0);
  await inState(page, 'playing');
  await tap(page, kStart);
  await inState(page, 'paused');
});
