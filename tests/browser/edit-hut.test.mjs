// One hut, built on an empty meadow by mouse alone, by keys alone and by touch alone: the world is
// that of hut.json each time.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { frames, launch } from './browser.mjs';
import { openEditor, settle, textOf, told } from './editor-page.mjs';

const kHut = readFileSync(new URL('hut.json', import.meta.url), 'utf8');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Walls of brick round seven by five tiles, a door, a roof of planks, an oak before it.
const kSteps = [
  { tool: 'box', way: 'walls', block: 2, from: [12, 10], to: [18, 14] },
  { tool: 'place', removes: true, at: [15, 14] },
  { level: 1 },
  { tool: 'box', way: 'solid', block: 3, from: [12, 10], to: [18, 14] },
  { level: -1 },
  { tool: 'thing', thing: 'sprite oak', at: [20, 17] },
];

const isSame = async (page) => {
  await settle(page);
  assert.equal(await textOf(page), kHut);
  assert.equal(await page.isHidden('#problems'), true);
};
// Where a tile of the plan is in the window.
async function tilesOf(page) {
  const box = await page.locator('#plan').boundingBox();
  const scale = Math.min(box.width, box.height) / 34;
  return ([x, y]) => [
    box.x + box.width / 2 + (x - 15.5) * scale,
    box.y + box.height / 2 + (y - 15.5) * scale,
  ];
}
const numberOf = (page, key) =>
  told(
    page,
    (wanted) =>
      [...document.querySelectorAll('#palette [data-key]')].findIndex(
        ({ dataset }) => dataset.key === wanted,
      ) + 1,
    key,
  );

test('by mouse alone', async (t) => {
  const { page } = await openEditor(t, browser);
  await page.click('[data-view=plan]');
  await frames(page);
  const at = await tilesOf(page);
  for (const { tool, way, block, from, to, at: place, removes, level, thing } of kSteps) {
    if (level !== undefined) await page.click(level > 0 ? '#level-up' : '#level-down');
    if (tool !== undefined) await page.click(`[data-tool=${tool}]`);
    if (way !== undefined) await page.click(`[data-way=${way}]`);
    if (block !== undefined) await page.click(`#palette [data-digit="${block}"]`);
    if (thing !== undefined) await page.click(`#palette [data-key="${thing}"]`);
    if (place !== undefined)
      await page.mouse.click(...at(place), { button: removes ? 'right' : 'left' });
    if (from === undefined) continue;
    await page.mouse.move(...at(from));
    await page.mouse.down();
    await page.mouse.move(...at(to), { steps: 4 });
    await page.mouse.up();
  }
  await isSame(page);
});

test('by keys alone', async (t) => {
  const { page } = await openEditor(t, browser);
  const press = (key) => page.keyboard.press(key);
  await press('KeyG');
  let [x, y] = [16, 20]; // the eye, where arrows begin
  await press('ArrowUp');
  const go = async ([toX, toY]) => {
    for (; x < toX; ++x) await press('ArrowRight');
    for (; x > toX; --x) await press('ArrowLeft');
    for (; y < toY; ++y) await press('ArrowDown');
    for (; y > toY; --y) await press('ArrowUp');
  };
  const keys = { box: 'KeyX', place: 'KeyB', thing: 'KeyT' };
  for (const { tool, way, block, from, to, at, removes, level, thing } of kSteps) {
    if (level !== undefined) await press(level > 0 ? 'PageUp' : 'PageDown');
    if (tool !== undefined) await press(keys[tool]);
    while (way !== undefined && (await told(page, () => window.slicecastEditor.editor.way)) !== way)
      await press('KeyO');
    if (block !== undefined) await press(`Digit${block}`);
    if (thing !== undefined) await press(`Digit${await numberOf(page, thing)}`);
    if (at !== undefined) {
      await go(at);
      await press(removes ? 'Delete' : 'Enter');
    }
    if (from === undefined) continue;
    await go(from);
    await press('Enter');
    await go(to);
    await press('Enter');
  }
  await isSame(page);
});

test('by touch alone', async (t) => {
  const { page, context } = await openEditor(t, browser, '?template=meadow', {
    viewport: { width: 820, height: 1180 },
    context: { hasTouch: true },
  });
  await page.tap('[data-view=plan]');
  await frames(page);
  const at = await tilesOf(page);
  const client = await context.newCDPSession(page);
  const touch = (type, place) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: place === null ? [] : [{ x: at(place)[0], y: at(place)[1] }],
    });
  for (const { tool, way, block, from, to, at: place, removes, level, thing } of kSteps) {
    if (level !== undefined) await page.tap(level > 0 ? '#level-up' : '#level-down');
    if (tool !== undefined) await page.tap(`[data-tool=${tool}]`);
    if (way !== undefined) await page.tap(`[data-way=${way}]`);
    if (block !== undefined) await page.tap(`#palette [data-digit="${block}"]`);
    if (thing !== undefined) await page.tap(`#palette [data-key="${thing}"]`);
    // A finger has one button, and a switch.
    if (removes) await page.tap('#ways button:text-is("Remove")');
    if (place !== undefined) await page.touchscreen.tap(...at(place));
    if (from === undefined) continue;
    await touch('touchStart', from);
    await touch('touchMove', to);
    await touch('touchEnd', null);
    await page.tap('#where'); // Chromium makes no click of the first tap after such a drag
  }
  await isSame(page);
});
