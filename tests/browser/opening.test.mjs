// The opening of the play page, and the hints of the first walk.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { inState, launch, letPass, openPage, openScene, play, untilPlayer } from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kFlight = {
  seconds: 20,
  points: [
    [1.5, 1.5, 1, 45, 0],
    [3.5, 1.5, 1.2, 90, 0],
    [3.5, 3.5, 1, 180, 0],
    [1.5, 3.5, 1.2, 270, 0],
  ],
};
const kList = JSON.stringify([
  { file: 'room.json', title: 'The coloured room', about: 'Four walls.', flight: kFlight },
]);
const withFlight = { server: { files: { 'scenes/index.json': kList } } };
const still = { context: { reducedMotion: 'reduce' } };

const isShown = (page, selector) => page.locator(selector).isVisible();
const view = (page) => page.evaluate(() => window.slicecast.currentView);

test('the page opens on a flight behind its title; Play begins at the start of the scene', async (t) => {
  const { page } = await openScene(t, browser, withFlight);
  assert.ok(await isShown(page, '#opening h2'));
  assert.ok(await isShown(page, '.three-keys'));
  assert.ok(!(await isShown(page, '#pause-title')));
  const first = await view(page);
  await page.waitForFunction(({ x, y }) => {
    const now = window.slicecast.currentView;
    return Math.hypot(now.x - x, now.y - y) > 0.3;
  }, first);
  await play(page);
  const { x, y, flying } = await page.evaluate(() => window.slicecast.player);
  assert.equal(flying, false);
  const start = await page.evaluate(() => {
    window.slicecast.reset();
    return window.slicecast.currentView;
  });
  assert.ok(Math.hypot(start.x - x, start.y - y) < 0.2, `${x}, ${y}`);
  assert.ok(!(await isShown(page, '#opening h2')));
});

test('with reduced motion a still picture is behind the title', async (t) => {
  const { page } = await openScene(t, browser, { ...withFlight, ...still });
  assert.ok(await isShown(page, '#opening h2'));
  const before = await view(page);
  await page.waitForTimeout(600);
  assert.deepEqual(await view(page), before);
  assert.equal(await page.evaluate(() => window.slicecast.state), 'paused');
});

test('an address that names a scene shows it, with its title', async (t) => {
  const { page } = await openScene(t, browser, { ...withFlight, query: '?scene=room' });
  assert.ok(!(await isShown(page, '#opening h2')));
  assert.ok(await isShown(page, '#pause-title'));
});

test('hints appear when needed, disappear when followed, and do not return', async (t) => {
  const { page, context, server } = await openScene(t, browser, { query: '?scene=room' });
  await play(page);
  await page.waitForFunction(() =>
    /walk/.test(document.querySelector('#hint.shown')?.textContent ?? ''),
  );
  const begin = await page.evaluate(() => window.slicecast.player);
  await page.keyboard.down('KeyS');
  await page.keyboard.down('KeyA');
  await untilPlayer(page, (now, from) => Math.hypot(now.x - from.x, now.y - from.y) > 1.2, begin);
  await page.keyboard.up('KeyS');
  await page.keyboard.up('KeyA');
  await page.waitForFunction(
    () => !/walk/.test(document.querySelector('#hint.shown')?.textContent ?? ''),
  );
  const kept = await page.evaluate(() => JSON.parse(localStorage.getItem('slicecast.hints')));
  assert.ok(kept.includes('walk'));
  const again = await context.newPage();
  await again.goto(`${server.address}?scene=room`);
  await inState(again, 'paused');
  await play(again);
  await again.waitForTimeout(2500);
  assert.ok(!/walk/.test(await again.locator('#hint').textContent()));
});

test('a hint that nobody follows ends by itself', async (t) => {
  const { page } = await openScene(t, browser, { query: '?scene=room' });
  await page.clock.install();
  await play(page);
  await letPass(page, 3);
  assert.match(await page.textContent('#hint.shown'), /walk/);
  await letPass(page, 12);
  assert.equal(await page.locator('#hint.shown').count(), 0);
  assert.equal(await page.evaluate(() => localStorage.getItem('slicecast.hints')), null);
});

test('after the opening, Escape pauses the world and leaves no label over it', async (t) => {
  const { page } = await openScene(t, browser, withFlight);
  await play(page);
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => window.slicecast.state === 'paused');
  await page.waitForFunction(() =>
    [...document.querySelectorAll('#notices > *')].every(
      (one) => !one.checkVisibility({ opacityProperty: true }),
    ),
  );
  assert.equal(
    await page.evaluate(
      () => getComputedStyle(window.slicecast.shadowRoot.querySelector('.hint')).display,
    ),
    'none',
  );
});

test('keys with effects that are hard to see show a message', async (t) => {
  const { page } = await openScene(t, browser, { query: '?scene=room' });
  await play(page);
  const says = (text) =>
    page.waitForFunction(
      (wanted) => document.querySelector('#toast.shown')?.textContent.includes(wanted),
      text,
    );
  await page.keyboard.press('KeyL');
  await says('Time of day: day');
  await page.keyboard.press('KeyX');
  await says('No gate within reach');
  await page.keyboard.press('KeyV');
  await says('Flying');
  await page.keyboard.press('KeyV');
  await says('Walking');
});

test('the opening at four sizes fits its window', async (t) => {
  for (const [width, height] of [
    [1366, 768],
    [1920, 1080],
    [390, 844],
    [844, 390],
  ]) {
    const { page } = await openPage(t, browser, { ...withFlight, viewport: { width, height } });
    await inState(page, 'paused');
    const boxes = await page.evaluate(() =>
      ['#opening', '#play', '.three-keys', '#bar nav'].map((selector) => {
        const { left, top, right, bottom } = document
          .querySelector(selector)
          .getBoundingClientRect();
        return { selector, left, top, right, bottom };
      }),
    );
    for (const { selector, left, top, right, bottom } of boxes)
      assert.ok(
        left >= 0 && top >= 0 && right <= width && bottom <= height,
        `${selector} at ${width}x${height}: ${left} ${top} ${right} ${bottom}`,
      );
  }
});
