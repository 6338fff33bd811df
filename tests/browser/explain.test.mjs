// "Explain a pixel": what the panel says is what the engine answers, and a mark is on the pixel,
// by mouse, touch and keyboard, in windows of any shape.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { inState, launch, openScene, player } from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const facts = (page) =>
  page.evaluate(() => {
    const panel = document.getElementById('explain');
    const names = [...panel.querySelectorAll('dt')].map((name) => name.textContent);
    const texts = [...panel.querySelectorAll('dd')].map((text) => text.textContent);
    return {
      summary: panel.querySelector('[data-explain="summary"]').textContent,
      layers: [...panel.querySelectorAll('li')].map((layer) => layer.textContent),
      ...Object.fromEntries(names.map((name, index) => [name, texts[index]])),
    };
  });

async function begin(page) {
  await page.click('#open-lab');
  await page.click('[data-lab="explain"]');
  await page.waitForFunction(() => document.activeElement.id === 'explain-cover');
  // The picture has made room.
  await page.waitForFunction(() => {
    const { width, height } = window.slicecast.picture;
    const box = window.slicecast.getBoundingClientRect();
    return Math.abs(width / height - box.width / box.height) < 0.02;
  });
}

// The place of the mark's middle, and the chosen pixel.
const chosen = (page) =>
  page.evaluate(() => {
    const { left, top, width, height } = document
      .querySelector('#explain-cover > div')
      .getBoundingClientRect();
    const [, column, row] = /column (\d+), row (\d+)/.exec(
      document.querySelector('#explain dd').textContent,
    );
    return {
      x: left + width / 2,
      y: top + height / 2,
      column: Number(column),
      row: Number(row),
    };
  });

test('it says what the pixel in the middle shows, and what is clicked', async (t) => {
  const { page } = await openScene(t, browser, { viewport: { width: 1000, height: 600 } });
  await begin(page);
  assert.equal(await page.isVisible('#lab'), false);
  assert.equal(await page.isVisible('#pause'), false);
  const ahead = await facts(page);
  assert.equal(ahead.summary, 'The side of a block: wall, facing west');
  assert.match(ahead.Pixel, /, #28b43c$/);
  assert.match(ahead.Ray, /^heading (0\.\d|359\.\d)°, 4 tiles walked$/);
  assert.match(ahead.Tile, /^6, 3, level 0, map room$/);
  assert.match(ahead.Point, /^6\.00, 3\.5\d, 0\.\d\d; depth 2\.50$/);
  assert.match(ahead.Texel, /^\d, \d of 8 × 8 in green, detail 0$/);
  assert.match(ahead.Light, /^100\u00a0%$/);
  assert.deepEqual(ahead.layers, ['the side of a block, green']);

  const { left, width, top, height } = await page.evaluate(() => {
    const { left, width, top, height } = window.slicecast.getBoundingClientRect();
    return { left, width, top, height };
  });
  await page.mouse.click(left + width * 0.7, top + height * 0.95);
  const below = await facts(page);
  assert.equal(below.summary, 'The floor');
  assert.match(below.Pixel, /, #787878$/);
  assert.match(below.Tile, /^\d, \d, map room$/);
  const mark = await chosen(page);
  assert.ok(Math.abs(mark.x - (left + width * 0.7)) <= 1, `${mark.x}`);
  assert.ok(Math.abs(mark.y - (top + height * 0.95)) <= 1, `${mark.y}`);
  await page.mouse.click(left + width * 0.5, top + height * 0.05);
  const above = await facts(page);
  assert.equal(above.summary, 'The sky');
  assert.equal(above.Texel, undefined);
  // The engine's own answer for the same place
  const picked = await page.evaluate(
    ({ x, y }) => window.slicecast.pick(x, y).what,
    await chosen(page),
  );
  assert.equal(picked, 'sky');
});

test('arrow keys move the pixel, and Escape gives the picture back', async (t) => {
  const { page } = await openScene(t, browser, { viewport: { width: 1000, height: 600 } });
  const before = await player(page);
  await begin(page);
  const first = await chosen(page);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowUp');
  const next = await chosen(page);
  assert.deepEqual([next.column - first.column, next.row - first.row], [2, -1]);
  await page.keyboard.press('Shift+ArrowLeft');
  await page.keyboard.press('Shift+ArrowDown');
  const far = await chosen(page);
  assert.deepEqual([far.column - next.column, far.row - next.row], [-10, 10]);
  for (let i = 0; i < 60; ++i) await page.keyboard.press('Shift+ArrowUp');
  assert.equal((await chosen(page)).row, 0, 'it stays in the picture');
  assert.deepEqual(await player(page), before, 'nobody has moved');
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#explain'), false);
  assert.equal(await page.isVisible('#explain-cover'), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), 'picture');
  await page.keyboard.press('Enter');
  await inState(page, 'playing');
});

test('it follows a replay to other moments', async (t) => {
  const tour = 'slicecast recording 1\nscene room\n480 turn 128\nend 480 0123456789abcdef\n';
  const { page } = await openScene(t, browser, {
    viewport: { width: 1000, height: 600 },
    query: '?tour=mine',
    server: { files: { 'tours/mine.txt': tour } },
  });
  await begin(page);
  const summaries = new Set();
  await page.focus('#replay [data-replay="seek"]');
  for (const key of ['ArrowRight', 'ArrowRight', 'ArrowRight']) {
    const last = (await facts(page)).Ray;
    await page.keyboard.press(key);
    await page.waitForFunction(
      (text) => document.querySelectorAll('#explain dd')[1].textContent !== text,
      last,
    );
    summaries.add((await facts(page)).summary);
  }
  assert.ok(summaries.size > 1, [...summaries].join());
});

for (const [width, height] of [
  [390, 844],
  [844, 390],
]) {
  test(`by touch at ${width}x${height} the panel leaves the picture free`, async (t) => {
    const { page } = await openScene(t, browser, {
      viewport: { width, height },
      context: { hasTouch: true, isMobile: true },
    });
    await begin(page);
    const { stage, panel, cover } = await page.evaluate(() => {
      const of = (id) => document.getElementById(id).getBoundingClientRect().toJSON();
      return { stage: of('stage'), panel: of('explain'), cover: of('explain-cover') };
    });
    assert.ok(
      stage.right <= panel.left + 1 || stage.bottom <= panel.top + 1,
      JSON.stringify({ stage, panel }),
    );
    assert.deepEqual(
      [stage.left, stage.top, stage.right, stage.bottom].map(Math.round),
      [cover.left, cover.top, cover.right, cover.bottom].map(Math.round),
    );
    const x = cover.left + cover.width * 0.3;
    const y = cover.top + cover.height * 0.9;
    await page.touchscreen.tap(x, y);
    const mark = await chosen(page);
    assert.ok(Math.hypot(mark.x - x, mark.y - y) <= 2, JSON.stringify({ mark, x, y }));
    assert.equal((await facts(page)).summary, 'The floor');
    assert.equal(await page.evaluate(() => window.slicecast.entered), false);
    await page.click('[data-explain="close"]');
    assert.equal(await page.isVisible('#explain'), false);
  });
}
