// Pens, fingers beside a mouse, screens of other density, and a graphics process that restarts.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, openPage, openScene } from './browser.mjs';
import { openGuest, ready, until } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const isEntered = () => document.querySelector('ray-caster').entered;
const hasTurned = () => document.querySelector('ray-caster').currentView.heading !== 0;
const hasThumbs = (page) =>
  page.evaluate(
    () => document.querySelector('ray-caster').shadowRoot.querySelector('.touch') !== null,
  );

async function openTouched(t) {
  const { page, context } = await openGuest(t, browser, { context: { hasTouch: true } });
  await ready(page);
  const session = await context.newCDPSession(page);
  const { x, y } = await (await page.$('ray-caster')).boundingBox();
  const touch = (type, ...points) =>
    session.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([id, px, py]) => ({ id, x: x + px, y: y + py })),
    });
  // A pen, or the mouse.
  const press = (type, px, py, pointerType = 'pen') =>
    session.send('Input.dispatchMouseEvent', {
      type,
      x: x + px,
      y: y + py,
      button: 'left',
      buttons: type === 'mouseReleased' ? 0 : 1,
      clickCount: 1,
      pointerType,
    });
  return { page, touch, press };
}

test('a pen begins as a finger does, looks around and leaves', async (t) => {
  const { page, press } = await openTouched(t);
  await press('mousePressed', 160, 100);
  await press('mouseReleased', 160, 100);
  await until(page, isEntered);
  assert.equal(await hasThumbs(page), true);
  await press('mousePressed', 240, 60);
  await press('mouseMoved', 200, 60);
  await press('mouseReleased', 200, 60);
  await until(page, hasTurned);
  await press('mousePressed', 298, 22);
  await press('mouseReleased', 298, 22);
  await until(page, () => !document.querySelector('ray-caster').entered);
});

for (const [name, isPen] of [
  ['a finger', false],
  ['a pen', true],
])
  test(`${name} takes over from a mouse, with its first motion`, async (t) => {
    const { page, touch, press } = await openTouched(t);
    await press('mousePressed', 160, 100, 'mouse');
    await press('mouseReleased', 160, 100, 'mouse');
    await until(page, isEntered);
    assert.equal(await hasThumbs(page), false);
    await page.evaluate(() => {
      window.got = [];
      for (const type of ['touchstart', 'touchmove', 'touchend', 'pointerdown', 'pointermove'])
        document.addEventListener(type, () => window.got.push(type));
    });
    if (isPen) {
      await press('mousePressed', 240, 60);
      await press('mouseMoved', 200, 60);
      await press('mouseReleased', 200, 60);
    } else {
      await touch('touchStart', [1, 240, 60]);
      await touch('touchMove', [1, 200, 60]);
      await touch('touchEnd');
    }
    await until(page, hasTurned);
    assert.equal(await hasThumbs(page), true);
    assert.deepEqual(await page.evaluate(() => window.got), []);
    const leave = () =>
      document.querySelector('ray-caster').shadowRoot.querySelector('.leave').hidden;
    assert.equal(await page.evaluate(leave), false);
  });

const pictureIs = (page, width, height) =>
  until(
    page,
    ([wide, tall]) => {
      const { picture } = document.querySelector('ray-caster');
      return picture.width === wide && picture.height === tall;
    },
    [width, height],
  );

// Two screens, and a page that never hears "resize", as in browsers that keep the size of a window
// in CSS pixels.
for (const isExact of [true, false])
  test(`the picture follows the density of the screen${isExact ? '' : ', also in browsers that tell no screen pixels'}`, async (t) => {
    const screens = '--screen-info={1000x800}{1000x800 devicePixelRatio=2.0}';
    const twoScreens = await launch([screens, '--window-size=700,600']);
    t.after(() => twoScreens.close());
    const { page, context } = await openGuest(t, twoScreens, {
      viewport: null,
      prepare: (newPage) =>
        newPage.addInitScript((exact) => {
          window.addEventListener('resize', (event) => event.stopImmediatePropagation());
          if (!exact) delete ResizeObserverEntry.prototype.devicePixelContentBoxSize;
        }, isExact),
    });
    await ready(page);
    await pictureIs(page, 320, 200);
    const session = await context.newCDPSession(page);
    const { windowId } = await session.send('Browser.getWindowForTarget');
    for (const [left, density] of [
      [1100, 2],
      [0, 1],
      [1200, 2],
    ]) {
      await session.send('Browser.setWindowBounds', { windowId, bounds: { left } });
      await pictureIs(page, 320 * density, 200 * density);
    }
  });

test('the picture has the pixels of an enlarged ancestor, by zoom or by transform', async (t) => {
  const { page } = await openGuest(t, browser, {});
  await ready(page);
  const style = (text) =>
    page.evaluate((given) => document.querySelector('main').setAttribute('style', given), text);
  await style('zoom: 1.5');
  await pictureIs(page, 480, 300);
  await style('');
  await pictureIs(page, 320, 200);
  // No browser tells of a transform; slide shows lay out again when the window has another size.
  await style('transform: scale(1.25); transform-origin: 0 0');
  await page.evaluate(() => window.dispatchEvent(new Event('resize')));
  await pictureIs(page, 400, 250);
  // The canvas fills the box.
  const boxes = await page.evaluate(() => {
    const caster = document.querySelector('ray-caster');
    return [caster, caster.shadowRoot.querySelector('canvas')].map((one) => {
      const { left, top, width, height } = one.getBoundingClientRect();
      return [left, top, width, height].map(Math.round);
    });
  });
  assert.deepEqual(boxes[0], boxes[1]);
  // A card that is turned over is no reason for another size.
  await style('transform: rotateY(80deg)');
  await page.evaluate(() => window.dispatchEvent(new Event('resize')));
  await pictureIs(page, 320, 200);
});

// As the browser does when its graphics process restarts: the canvas is empty, then it says so.
const loseCanvas = (canvas) => {
  canvas.getContext('2d').reset();
  canvas.dispatchEvent(new Event('contextlost'));
  canvas.dispatchEvent(new Event('contextrestored'));
};
const isBlack = (canvas) =>
  canvas
    .getContext('2d')
    .getImageData(0, 0, canvas.width, canvas.height)
    .data.every((value, at) => at % 4 === 3 || value === 0);
const isPictured = (page, find) => until(page, `!(${isBlack})((${find})())`);

test('a still picture comes back after a restart of the graphics process', async (t) => {
  const { page } = await openGuest(t, browser, {});
  await ready(page);
  const find = () => document.querySelector('ray-caster').shadowRoot.querySelector('canvas');
  await page.evaluate(`(${loseCanvas})((${find})())`);
  await isPictured(page, find);
});

test('so does that of the play page while it is paused', async (t) => {
  const { page } = await openScene(t, browser);
  const find = () => window.slicecast.shadowRoot.querySelector('canvas');
  await page.evaluate(`(${loseCanvas})((${find})())`);
  await isPictured(page, find);
});

test('all canvases of a chapter come back', async (t) => {
  const { page } = await openPage(t, browser, { query: 'learn/two-fish-eyes.html' });
  await page.evaluate(() =>
    Promise.all(
      [...document.querySelectorAll('ray-caster')].map((caster) => {
        return caster.whenReady();
      }),
    ),
  );
  await until(page, () => document.querySelectorAll('.fig.live').length > 0);
  const canvases = () =>
    [
      ...document.querySelectorAll('canvas'),
      ...[...document.querySelectorAll('ray-caster')].map((caster) =>
        caster.shadowRoot.querySelector('canvas'),
      ),
    ].filter((canvas) => canvas !== null && canvas.width > 0);
  const drawn = await page.evaluate(
    `(${canvases})().map((canvas) => !(${isBlack})(canvas)).filter(Boolean).length`,
  );
  assert.ok(drawn > 2, `${drawn}`);
  await page.evaluate(
    `(${canvases})().forEach((canvas) => (${isBlack})(canvas) || (${loseCanvas})(canvas))`,
  );
  await until(
    page,
    `(${canvases})().filter((canvas) => !(${isBlack})(canvas)).length === ${drawn}`,
  );
});

test('without a context to draw with, the error says so; a later try finds it', async (t) => {
  const { page } = await openGuest(t, browser, {
    prepare: (newPage) =>
      newPage.addInitScript(() => {
        const real = HTMLCanvasElement.prototype.getContext;
        window.refuse = true;
        HTMLCanvasElement.prototype.getContext = function (...values) {
          return window.refuse ? null : real.apply(this, values);
        };
      }),
  });
  const error = await page.evaluate(async () => {
    await customElements.whenDefined('ray-caster');
    return document
      .querySelector('ray-caster')
      .whenReady()
      .catch(({ code, title, message }) => ({ code, title, message }));
  });
  assert.equal(error.code, 'engine');
  assert.match(`${error.title}. ${error.message}`, /no picture.*gives the page no canvas/);
  await page.evaluate(() => {
    window.refuse = false;
    document.querySelector('ray-caster').reload();
    return document.querySelector('ray-caster').whenReady();
  });
  await isPictured(page, () =>
    document.querySelector('ray-caster').shadowRoot.querySelector('canvas'),
  );
});
