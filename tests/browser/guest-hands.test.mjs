// Playing a <ray-caster> by keys and fingers: when the window gets the focus back, when something
// is removed under a finger, and what is left to the page.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, withWindows } from './browser.mjs';
import { focusOf, inElementState, openElements, ready } from './element.mjs';
import { wait } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kRoom = '<ray-caster id="a" scene="room" controls></ray-caster>';
const phone = {
  viewport: { width: 390, height: 844 },
  context: { isMobile: true, hasTouch: true },
};

const button = (page, name) => page.locator('#a').getByRole('button', { name, exact: true });
const whereIs = (page) => page.evaluate(() => document.getElementById('a').currentView);

test('after another tab, touch controls and the leave button are back', async (t) => {
  const { page, context } = await openElements(
    t,
    await withWindows(t),
    '<ray-caster id="a" scene="room"></ray-caster>',
    phone,
  );
  // Pages under test always count as focused, unless told otherwise.
  const session = await context.newCDPSession(page);
  await session.send('Emulation.setFocusEmulationEnabled', { enabled: false });
  await page.bringToFront();
  await ready(page, 'a');
  await page.tap('#a');
  await inElementState(page, 'a', 'playing');
  const other = await context.newPage();
  await other.bringToFront();
  await inElementState(page, 'a', 'paused');
  await page.bringToFront();
  await inElementState(page, 'a', 'playing');
  await page.locator('#a [data-thumb="walk"]').waitFor();
  await button(page, 'Leave the picture').tap();
  await inElementState(page, 'a', 'paused');
});

test('touch controls that are removed under a finger work again afterwards', async (t) => {
  const { page, context } = await openElements(
    t,
    browser,
    kRoom.replace('controls', 'style="height: 400px"'),
    phone,
  );
  await ready(page, 'a');
  const session = await context.newCDPSession(page);
  const touch = (type, ...touchPoints) =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints });
  await page.tap('#a');
  await inElementState(page, 'a', 'playing');
  await touch('touchStart', { id: 1, x: 80, y: 250 });
  await touch('touchMove', { id: 1, x: 80, y: 220 });
  await page.waitForFunction(() => document.getElementById('a').currentView.x > 3.6);
  await page.evaluate(() => document.getElementById('a').pause());
  await touch('touchEnd');
  await page.evaluate(() => document.getElementById('a').reset());
  await page.tap('#a');
  await inElementState(page, 'a', 'playing');
  assert.equal(await page.locator('#a .stick.held').count(), 0);
  await wait(300);
  assert.equal((await whereIs(page)).x, 3.5, 'nothing is held any more');
  await touch('touchStart', { id: 2, x: 80, y: 250 });
  await touch('touchMove', { id: 2, x: 80, y: 190 });
  await page.waitForFunction(() => document.getElementById('a').currentView.x > 3.6);
  await touch('touchEnd');
});

test('keys="none": put back into the page, Tab still skips the picture', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<button id="x">Before</button><ray-caster id="a" scene="room" keys="none"></ray-caster><button id="y">After</button>',
  );
  await ready(page, 'a');
  await page.hover('#a'); // loads steering.js
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.querySelector('.leave') !== null,
  );
  await page.evaluate(async () => {
    const element = document.getElementById('a');
    const next = element.nextSibling;
    element.remove();
    await Promise.resolve();
    next.before(element);
  });
  await ready(page, 'a');
  const seen = [];
  await page.focus('#x');
  for (let i = 0; i < 2; ++i) {
    await page.keyboard.press('Tab');
    seen.push(await focusOf(page));
  }
  assert.deepEqual(seen, ['a cover', 'y']);
});

test('the attribute keys changes during play: play goes on', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  for (const [keys, place] of [
    ['none', 'a stage'],
    ['move', 'a canvas'],
  ]) {
    await page.evaluate((wanted) => {
      document.getElementById('a').keys = wanted;
    }, keys);
    await page.waitForFunction(
      ([wanted]) =>
        document
          .getElementById('a')
          .shadowRoot.activeElement?.matches(wanted === 'none' ? '.stage' : 'canvas'),
      [keys],
    );
    assert.equal(await focusOf(page), place);
    assert.equal(await page.evaluate(() => document.getElementById('a').state), 'playing');
  }
  // The bar does not take the focus.
  await page.keyboard.press('Tab');
  assert.equal(await focusOf(page), 'a play');
  await page.evaluate(() => {
    document.getElementById('a').keys = 'all';
  });
  await wait(100);
  assert.equal(await focusOf(page), 'a play');
  await page.keyboard.press('Escape');
  await inElementState(page, 'a', 'paused');
});

test('an error closes the sheet of keys; once it is fixed the cover has the focus', async (t) => {
  const { page } = await openElements(t, browser, kRoom, { expectErrors: true });
  await ready(page, 'a');
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  await page.keyboard.press('h');
  await page.locator('#a').getByRole('dialog', { name: 'Keys' }).waitFor();
  await page.evaluate(() => {
    document.getElementById('a').scene = 'nowhere';
  });
  await inElementState(page, 'a', 'error');
  assert.equal(await focusOf(page), 'a sheet');
  assert.equal(await page.locator('#a .keys').isVisible(), false);
  await page.evaluate(() => {
    document.getElementById('a').scene = 'room';
  });
  await inElementState(page, 'a', 'paused');
  assert.equal(await focusOf(page), 'a cover');
});

test("under the sheet of keys nothing can be reached; it lists the element's keys", async (t) => {
  const { page } = await openElements(t, browser, `${kRoom}<button id="y">After</button>`);
  await ready(page, 'a');
  await button(page, 'Play').waitFor();
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  await page.keyboard.press('h');
  const sheet = page.locator('#a').getByRole('dialog', { name: 'Keys' });
  await sheet.waitFor();
  const listed = await sheet.locator('dt').allTextContents();
  assert.ok(listed.includes('MBO'), listed.join('; '));
  for (const key of ['I', 'T', 'F9']) assert.ok(!listed.includes(key), key);
  assert.match(await sheet.textContent(), /Escape\s*release the mouse, then leave/);
  const seen = [];
  for (const step of ['Shift+Tab', 'Tab', 'Tab']) {
    await page.keyboard.press(step);
    seen.push(await focusOf(page));
  }
  assert.ok(
    seen.every((place) => ['a again', 'y', 'body'].includes(place)),
    seen.join('; '),
  );
  await page.evaluate(() => document.getElementById('a').focus());
  assert.equal(await focusOf(page), 'a again');
  await page.keyboard.press('Escape');
  assert.equal(await focusOf(page), 'a cover');
  await button(page, 'Play').click();
  await inElementState(page, 'a', 'playing');
});

test("keys that are not the element's go to the page", async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await page.evaluate(() => {
    window.heard = [];
    document.addEventListener('keydown', ({ code, defaultPrevented }) =>
      window.heard.push([code, defaultPrevented]),
    );
  });
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  for (const key of ['i', 't', 'F9', 'k']) await page.keyboard.press(key);
  await page.evaluate(() => {
    document.getElementById('a').keys = 'move';
  });
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.activeElement?.localName === 'canvas',
  );
  for (const key of ['k', 'w']) await page.keyboard.press(key);
  assert.deepEqual(await page.evaluate(() => window.heard), [
    ['KeyI', false],
    ['KeyT', false],
    ['F9', false],
    ['KeyK', false], // only with keys="move"
  ]);
});

test('the button for overlays reflects each overlay, whichever key changed it', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await button(page, 'Play').waitFor();
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  for (const isOn of [true, false]) {
    await page.keyboard.press('k');
    await page
      .locator('#a')
      .getByRole('button', { name: 'Map and panels', pressed: isOn })
      .waitFor();
  }
});

test('an error message can have the focus', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="nowhere"></ray-caster>',
    { expectErrors: true },
  );
  await ready(page, 'a');
  await page.evaluate(() => document.getElementById('a').focus());
  assert.equal(await focusOf(page), 'a sheet');
});
