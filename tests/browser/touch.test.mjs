// Thumbs on a touch screen, as real touches.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { frames, inState, launch, openScene, play, player, untilPlayer } from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const phone = {
  viewport: { width: 390, height: 844 },
  context: { isMobile: true, hasTouch: true },
};

// The page, played, and a function that sends touches: touch('touchMove', {id, x, y}, ...) names
// all fingers on the glass.
async function openTouched(t) {
  const { page, context } = await openScene(t, browser, phone);
  assert.equal(await page.isVisible('.touch'), false);
  await page.tap('#play');
  await inState(page, 'playing');
  const session = await context.newCDPSession(page);
  return {
    page,
    touch: (type, ...touchPoints) =>
      session.send('Input.dispatchTouchEvent', { type, touchPoints }),
  };
}

// Waits until the player no longer moves; returns the state.
async function atRest(page) {
  for (;;) {
    const { steps } = await player(page);
    const before = await untilPlayer(page, (now, last) => now.steps > last + 60, steps);
    const after = await untilPlayer(page, (now, last) => now.steps > last + 20, before.steps);
    if (['x', 'y', 'z', 'heading', 'look'].every((key) => before[key] === after[key])) return after;
  }
}

test('the left thumb walks and strafes, the right one looks, also both at once', async (t) => {
  const { page, touch } = await openTouched(t);
  const begin = await player(page);
  await touch('touchStart', { id: 1, x: 90, y: 600 });
  await touch('touchMove', { id: 1, x: 90, y: 530 });
  await untilPlayer(page, (now, { x }) => now.x > x + 0.3, begin);
  assert.equal((await player(page)).heading, 0);
  await touch('touchStart', { id: 1, x: 90, y: 530 }, { id: 2, x: 300, y: 400 });
  await touch('touchMove', { id: 1, x: 90, y: 530 }, { id: 2, x: 360, y: 400 });
  await untilPlayer(page, (now) => Math.abs(now.heading - 9) < 1e-6);
  await touch('touchMove', { id: 1, x: 90, y: 530 }, { id: 2, x: 360, y: 350 });
  await untilPlayer(page, (now) => now.look > 0.05);
  await touch('touchEnd');
  const rested = await atRest(page);

  // To the right, and no more than a stick's full way
  await touch('touchStart', { id: 1, x: 60, y: 500 });
  await touch('touchMove', { id: 1, x: 130, y: 500 });
  const { speed } = await untilPlayer(page, (now, { y }) => now.y > y + 0.5, rested);
  assert.ok(speed < 3.01, `${speed} units per second`);
  await touch('touchEnd');
  await atRest(page);
});

test('the stick rests in the middle, walks slowly half way, and runs far out', async (t) => {
  const { page, touch } = await openTouched(t);
  const begin = await player(page);
  await touch('touchStart', { id: 1, x: 100, y: 600 });
  await touch('touchMove', { id: 1, x: 104, y: 595 });
  assert.equal((await atRest(page)).x, begin.x);
  await touch('touchMove', { id: 1, x: 100, y: 568 });
  await untilPlayer(page, (now, { x }) => now.x > x + 0.3, begin);
  const { speed } = await player(page);
  assert.ok(speed > 0.8 && speed < 2.2, `${speed} units per second`);
  await touch('touchMove', { id: 1, x: 100, y: 695 });
  await untilPlayer(page, (now) => now.speed > 4);
  await touch('touchEnd');
  await atRest(page);
});

test('two taps on the right jump, one does not', async (t) => {
  const { page, touch } = await openTouched(t);
  const { z } = await player(page);
  const tap = async () => {
    await touch('touchStart', { id: 1, x: 290, y: 300 });
    await touch('touchEnd');
  };
  // The highest of the next 60 steps, asked in the page so that none is missed
  const highest = page.evaluate(async () => {
    const { slicecast } = window;
    const { steps } = slicecast.player;
    let most = 0;
    for (; slicecast.player.steps < steps + 60; await new Promise(requestAnimationFrame))
      most = Math.max(most, slicecast.player.z);
    return most;
  });
  await tap();
  assert.equal(await highest, z);
  await tap();
  await tap();
  await untilPlayer(page, (now, floor) => now.z > floor + 0.1, z);
  assert.equal((await atRest(page)).z, z);
});

test('the buttons jump, crouch and fly, and then rise and sink', async (t) => {
  const { page, touch } = await openTouched(t);
  const { z } = await player(page);
  const on = async (name) => {
    const box = await page.locator(`[data-thumb="${name}"]`).boundingBox();
    return { id: 3, x: box.x + box.width / 2, y: box.y + box.height / 2 };
  };
  await touch('touchStart', await on('jump'));
  await untilPlayer(page, (now, floor) => now.z > floor + 0.1, z);
  await touch('touchEnd');
  await atRest(page);
  await touch('touchStart', await on('crouch'));
  await untilPlayer(page, (now) => now.crouched);
  await touch('touchEnd');
  await untilPlayer(page, (now) => !now.crouched);
  await touch('touchStart', await on('fly'));
  await touch('touchEnd');
  await untilPlayer(page, (now) => now.flying);
  await page.waitForFunction(
    () =>
      window.slicecast.shadowRoot.querySelector('[data-thumb="jump"] span').textContent === 'Rise',
  );
  await touch('touchStart', await on('jump'));
  await untilPlayer(page, (now) => now.z > 1.2);
  await touch('touchEnd');
  await atRest(page);
  await touch('touchStart', await on('crouch'));
  await untilPlayer(page, (now) => now.z < 1);
  await touch('touchEnd');
  await touch('touchStart', await on('fly'));
  await touch('touchEnd');
  await untilPlayer(page, (now) => !now.flying);
});

test('the page scrolls under a finger until the game is played', async (t) => {
  const { page, context } = await openScene(t, browser, phone);
  await page.evaluate(() => {
    document.documentElement.style.overflow = document.body.style.overflow = 'auto';
    document.body.style.height = '5000px';
  });
  const session = await context.newCDPSession(page);
  const swipe = async () => {
    for (let y = 500; y >= 300; y -= 20) {
      await session.send('Input.dispatchTouchEvent', {
        type: y === 500 ? 'touchStart' : 'touchMove',
        touchPoints: [{ id: 1, x: 300, y }],
      });
    }
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    // A tap on a page that still glides would only stop it.
    for (
      let before = -1, now = 0;
      now !== before;
      before = now, now = await page.evaluate(() => scrollY)
    )
      await frames(page, 20);
  };
  await swipe();
  const scrolled = await page.evaluate(() => scrollY);
  assert.ok(scrolled > 50, `${scrolled}`);
  assert.equal(await page.evaluate(() => document.body.dataset.state), 'paused');
  await page.touchscreen.tap(200, 300);
  await inState(page, 'playing');
  await swipe();
  assert.equal(await page.evaluate(() => scrollY), scrolled);
});

test('the sheet of keys shows the touch controls, and the keys on demand', async (t) => {
  const { page } = await openScene(t, browser, phone);
  assert.equal(await page.innerText('#open-keys'), 'Touch');
  await page.tap('#open-keys');
  await page.waitForSelector('#keys[open]');
  assert.equal(await page.innerText('#keys-title'), 'Touch');
  const names = await page.$$eval('#fingers dt', (all) => all.map(({ innerText }) => innerText));
  for (const name of ['Left thumb', 'Right thumb', 'Jump', 'Crouch', 'Fly', 'Gate'])
    assert.ok(names.includes(name), name);
  // Each button is drawn as on the picture.
  const shapes = (selector) =>
    page.$$eval(selector, (all) => all.map((path) => path.getAttribute('d')));
  const shown = await shapes('#fingers path');
  await page.click('#keys [data-close]');
  await page.tap('#play');
  await inState(page, 'playing');
  for (const shape of await shapes('.thumb-button path')) assert.ok(shown.includes(shape));

  await page.tap('button.leave');
  await inState(page, 'paused');
  await page.tap('#open-keys');
  assert.equal(await page.isVisible('#key-tables'), false);
  assert.equal(await page.isVisible('[data-keys="change"]'), false);
  await page.tap('#key-part summary');
  await page.waitForSelector('#key-tables', { state: 'visible' });
  assert.ok(await page.isVisible('[data-keys="change"]'));
});

test('with a mouse the sheet of keys shows no touch controls', async (t) => {
  const { page } = await openScene(t, browser);
  assert.equal(await page.innerText('#open-keys'), 'Keys');
  await page.click('#open-keys');
  await page.waitForSelector('#key-tables', { state: 'visible' });
  for (const hidden of ['#fingers', '#key-part summary'])
    assert.equal(await page.isVisible(hidden), false);
  assert.equal(await page.innerText('#keys-title'), 'Keys');
});

test('with a mouse there are no touch controls', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  assert.equal(await page.isVisible('.touch'), false);
});
