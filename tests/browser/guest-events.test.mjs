// Other people's listeners around a <ray-caster>: they do not get what the picture takes, they get
// the rest, and a click that they keep is theirs.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { kRoom, openGuest, ready, until, wait } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const middle = { position: { x: 160, y: 100 } };
const headingOf = (page) =>
  page.evaluate(() => document.querySelector('ray-caster').currentView.heading);
const isEntered = () => document.querySelector('ray-caster').entered;

// Notes which events reach the page.
const listen = (page, types) =>
  page.evaluate((wanted) => {
    window.got = [];
    for (const type of wanted)
      document.addEventListener(type, (event) =>
        window.got.push(event.code === undefined ? type : `${type} ${event.code}`),
      );
  }, types);
const got = (page) => page.evaluate(() => window.got.splice(0));

test('the page gets the keys that the picture does not take, and no others', async (t) => {
  const { page } = await openGuest(t, browser, {});
  await ready(page);
  await listen(page, ['keydown', 'keyup']);
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual(await got(page), ['keydown ArrowLeft', 'keyup ArrowLeft']);
  await page.click('ray-caster', middle);
  await until(page, isEntered);
  await page.keyboard.down('ArrowLeft');
  await until(page, () => document.querySelector('ray-caster').currentView.heading !== 0);
  await page.keyboard.up('ArrowLeft');
  await page.keyboard.press('Space');
  assert.deepEqual(await got(page), []);
  await page.keyboard.press('Quote');
  assert.deepEqual(await got(page), ['keydown Quote', 'keyup Quote']);
});

test('thumbs do not swipe the page', async (t) => {
  const { page, context } = await openGuest(t, browser, {
    viewport: { width: 390, height: 700 },
    context: { isMobile: true, hasTouch: true },
  });
  await ready(page);
  const box = await (await page.$('ray-caster')).boundingBox();
  await page.touchscreen.tap(box.x + 160, box.y + 100);
  await until(page, isEntered);
  await listen(page, ['touchstart', 'touchmove', 'touchend', 'pointerdown', 'pointermove']);
  const session = await context.newCDPSession(page);
  const touch = (type, ...touchPoints) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await touch('touchStart', { id: 1, x: box.x + 280, y: box.y + 80 });
  await touch('touchMove', { id: 1, x: box.x + 200, y: box.y + 80 });
  await touch('touchEnd');
  await until(page, () => document.querySelector('ray-caster').currentView.heading !== 0);
  assert.deepEqual(await got(page), []);
  await touch('touchStart', { id: 1, x: 200, y: 650 });
  await touch('touchEnd');
  assert.deepEqual(await got(page), ['pointerdown', 'touchstart', 'touchend']);
});

for (const type of ['click', 'pointerdown'])
  test(`a page keeps a click by preventDefault() of ${type}`, async (t) => {
    const { page } = await openGuest(t, browser, {});
    await ready(page);
    await page.evaluate((kept) => {
      const element = document.querySelector('ray-caster');
      window.tiles = [];
      window.keep = (event) => {
        event.preventDefault();
        const tile = element.pick(event.clientX, event.clientY)?.tile;
        if (event.type === 'click') window.tiles.push(tile !== undefined);
      };
      element.addEventListener(kept, window.keep);
      if (kept !== 'click') element.addEventListener('click', window.keep);
    }, type);
    await page.click('ray-caster', middle);
    await until(page, () => window.tiles.length > 0);
    await wait(100);
    assert.equal(await page.evaluate(isEntered), false);
    assert.deepEqual(await page.evaluate(() => window.tiles), [true]);
    // The next one, which it does not keep, enters.
    await page.evaluate((kept) => {
      const element = document.querySelector('ray-caster');
      element.removeEventListener(kept, window.keep);
      element.removeEventListener('click', window.keep);
    }, type);
    await page.click('ray-caster', middle);
    await until(page, isEntered);
  });

test('one wild motion of the mouse does not turn the view; a fast hand does', async (t) => {
  const { page } = await openGuest(t, browser, {});
  await ready(page);
  await page.click('ray-caster', middle);
  await until(page, isEntered);
  // As if the picture held the pointer: Chromium without a window becomes very slow if one does.
  await page.evaluate(() => {
    const root = document.querySelector('ray-caster').shadowRoot;
    const canvas = root.querySelector('canvas');
    Object.defineProperty(root, 'pointerLockElement', { get: () => canvas });
    document.dispatchEvent(new Event('pointerlockchange'));
  });
  const move = (motions) =>
    page.evaluate((all) => {
      const canvas = document.querySelector('ray-caster').shadowRoot.querySelector('canvas');
      for (const movementX of all)
        canvas.dispatchEvent(new MouseEvent('mousemove', { movementX, bubbles: true }));
    }, motions);
  const turned = async (motions) => {
    const before = await headingOf(page);
    await move(motions);
    await wait(200);
    return (((((await headingOf(page)) - before) % 360) + 540) % 360) - 180;
  };
  const slow = await turned([12, 14, -720, 13, 12]);
  assert.ok(Math.abs(slow - 51 * 0.15) < 0.5, `${slow} degrees`);
  const fast = await turned([40, 90, 170, 260, 260, 170, 60]);
  assert.ok(Math.abs(fast - 1050 * 0.15) < 0.5, `${fast} degrees`);
});

test('a picture that gets out of sight is no longer steered', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `${kRoom}<p style="height: 3000px">Read on.</p>`,
  });
  await ready(page);
  await page.click('ray-caster', middle);
  await until(page, isEntered);
  await page.evaluate(() => window.scrollTo(0, 2000));
  await until(page, () => !document.querySelector('ray-caster').entered);
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.click('ray-caster', middle);
  await until(page, isEntered);
  // A slide show hides the slides that are not shown.
  await page.evaluate(() => {
    document.querySelector('ray-caster').style.display = 'none';
  });
  await until(page, () => !document.querySelector('ray-caster').entered);
});
