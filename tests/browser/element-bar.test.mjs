// Controls of <ray-caster>: its bar, its cover, the sheet of keys, the pointer and full
// screen.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, withWindows } from './browser.mjs';
import {
  elementPixel,
  focusOf,
  inElementState,
  noteEvents,
  eventsOf,
  openElements,
  ready,
} from './element.mjs';
import { png } from './png.mjs';
import { kGreen } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kRoom = '<ray-caster id="a" scene="room" controls label="Four walls"></ray-caster>';

const names = (page) =>
  page.evaluate(() =>
    [...document.getElementById('a').shadowRoot.querySelectorAll('.controls button')]
      .filter((button) => button.checkVisibility())
      .map((button) => button.getAttribute('aria-label')),
  );
const button = (page, name) => page.locator('#a').getByRole('button', { name, exact: true });
const status = (page) => page.locator('#a').locator('.status');

test('the bar shows the requested buttons with their labels', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await button(page, 'Play').waitFor(); // it comes after the picture
  assert.deepEqual(await names(page), [
    'Play',
    'Back to the start',
    'Map and panels',
    'Save the picture',
    'Copy the tag',
    'Full screen',
  ]);
  await page.evaluate(() => {
    document.getElementById('a').controls = 'share play';
  });
  await ready(page, 'a');
  assert.deepEqual(await names(page), ['Play', 'Copy the tag']);
  await page.evaluate(() => {
    document.getElementById('a').controls = null;
  });
  await ready(page, 'a');
  assert.deepEqual(await names(page), []);
});

test('its buttons play, pause, go back, and switch overlays on and off', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await noteEvents(page, 'a', ['statechange']);
  await button(page, 'Play').click();
  await inElementState(page, 'a', 'playing');
  assert.equal(await focusOf(page), 'a canvas', 'who plays has the keys');
  await page.keyboard.down('KeyW');
  await page.waitForFunction(() => document.getElementById('a').currentView.x > 3.8);
  await page.keyboard.up('KeyW');
  await button(page, 'Map and panels').click();
  assert.equal(await button(page, 'Map and panels').getAttribute('aria-pressed'), 'true');
  assert.equal(await page.evaluate(() => document.getElementById('a').get('minimap')), 'on');
  assert.equal(
    await focusOf(page),
    'a canvas',
    'a press on the bar leaves the keys where they are',
  );
  await page.keyboard.press('m');
  await page.waitForFunction(() => document.getElementById('a').get('minimap') === 'off');
  // A key changes the bar too, with the next frame.
  await page
    .locator('#a')
    .getByRole('button', { name: 'Map and panels', pressed: false })
    .waitFor();
  await button(page, 'Pause').click();
  await inElementState(page, 'a', 'paused');
  assert.equal(await focusOf(page), 'a cover');
  await button(page, 'Back to the start').click();
  assert.equal(await page.evaluate(() => document.getElementById('a').currentView.x), 3.5);
  assert.deepEqual(
    (await eventsOf(page, 'a')).map(([, { state }]) => state),
    ['playing', 'paused'],
  );
});

test('it saves the picture, and copies the tag with the current view and options', async (t) => {
  const { page, server } = await openElements(t, browser, kRoom, {
    context: { permissions: ['clipboard-read', 'clipboard-write'], acceptDownloads: true },
  });
  await ready(page, 'a');
  await page.evaluate(() => {
    document.getElementById('a').look('3.5,3.5,0.5,90');
    document.getElementById('a').set('fov', 75);
    document.getElementById('a').set('grid', true);
  });
  const coming = page.waitForEvent('download');
  await button(page, 'Save the picture').click();
  assert.equal((await coming).suggestedFilename(), 'the-coloured-room.png');
  await button(page, 'Copy the tag').click();
  await page.waitForFunction(() =>
    document
      .getElementById('a')
      .shadowRoot.querySelector('.status')
      .textContent.startsWith('Copied'),
  );
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(
    copied,
    `<script type="module" src="${server.address}ray-caster.js"></script>\n` +
      `<ray-caster scene="${server.address}scenes/room.json" controls="" label="Four walls" view="walk,3.5,3.5,0.5,90,0,room" options="fov=75" overlay="grid"></ray-caster>`,
  );
});

test("the copied tag of a tour has its scene, the current view, and the poster's full address", async (t) => {
  const tour = 'slicecast recording 1\nscene room\n100 forward 256\nend 100 0123456789abcdef\n';
  const { page, server } = await openElements(
    t,
    browser,
    '<ray-caster id="a" tour="tours/mine.txt" poster="pictures/a.png" controls="share"></ray-caster>',
    {
      files: { 'tours/mine.txt': tour, 'pictures/a.png': png(8, () => kGreen) },
      context: { permissions: ['clipboard-read', 'clipboard-write'] },
    },
  );
  await ready(page, 'a');
  await page.evaluate(() => document.getElementById('a').look('2.5,4.5,0.5,90'));
  await button(page, 'Copy the tag').click();
  await page.waitForFunction(() =>
    document
      .getElementById('a')
      .shadowRoot.querySelector('.status')
      .textContent.startsWith('Copied'),
  );
  const [, tag] = (await page.evaluate(() => navigator.clipboard.readText())).split('\n');
  assert.equal(
    tag,
    `<ray-caster poster="${server.address}pictures/a.png" controls="share" view="walk,2.5,4.5,0.5,90,0,room" scene="${server.address}scenes/room.json"></ray-caster>`,
  );
});

test('full screen by the button and by F', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await button(page, 'Full screen').click();
  await page.waitForFunction(() => document.fullscreenElement?.id === 'a');
  await page.waitForFunction(() => document.getElementById('a').picture.width === innerWidth);
  await button(page, 'Leave full screen').click();
  await page.waitForFunction(() => document.fullscreenElement === null);
  await page.click('#a');
  await page.waitForFunction(() => document.getElementById('a').entered);
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.fullscreenElement?.id === 'a');
});

test('a press on the cover before the scene has loaded starts play later, unless the focus has moved', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    `${kRoom}<ray-caster id="b" scene="other"></ray-caster><button id="else">Else</button>`,
    {
      prepare: (opened) =>
        opened.route('**/*.png', async (route) => {
          await new Promise((resolve) => setTimeout(resolve, 500));
          await route.continue();
        }),
    },
  );
  await inElementState(page, 'b', 'loading');
  await page.click('#b');
  await page.click('#else');
  await page.click('#a');
  await Promise.all([ready(page, 'a'), ready(page, 'b')]);
  await page.waitForTimeout(200);
  assert.deepEqual(
    await page.evaluate(() => ['a', 'b'].map((id) => document.getElementById(id).state)),
    ['playing', 'paused'],
  );
  assert.equal(await focusOf(page), 'a canvas');
});

test('H shows the keys on a sheet; H and Escape close it and give the focus back', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  assert.equal(await status(page).textContent(), 'Escape leaves, H shows the keys');
  for (const key of ['h', 'Escape']) {
    await page.keyboard.press('h');
    await page.locator('#a').getByRole('dialog', { name: 'Keys' }).waitFor();
    assert.equal(await page.evaluate(() => document.getElementById('a').state), 'paused');
    assert.ok((await page.locator('#a').locator('.keys dt').count()) >= 12);
    await page.keyboard.press(key);
    await page.locator('#a').locator('.keys').waitFor({ state: 'hidden' });
    assert.equal(await focusOf(page), 'a cover');
    await page.keyboard.press('Enter');
    await inElementState(page, 'a', 'playing');
  }
});

test('the first click plays, the next one locks the pointer; then the wheel does not scroll', async (t) => {
  const { page } = await openElements(
    t,
    await withWindows(t),
    `${kRoom}<div style="height: 3000px"></div>`,
  );
  await ready(page, 'a');
  await page.mouse.click(160, 60);
  await inElementState(page, 'a', 'playing');
  const holder = () =>
    page.evaluate(
      () => document.getElementById('a').shadowRoot.pointerLockElement?.localName ?? null,
    );
  assert.equal(await holder(), null);
  await page.mouse.click(160, 60);
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.pointerLockElement !== null,
  );
  await page.mouse.move(240, 60, { steps: 4 });
  await page.waitForFunction(() => document.getElementById('a').currentView.heading > 5);
  await page.mouse.wheel(0, 200);
  await page.waitForTimeout(200);
  assert.equal(await page.evaluate(() => scrollY), 0);
  await page.evaluate(() => document.getElementById('a').pause());
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.pointerLockElement === null,
  );
  await page.mouse.wheel(0, 200);
  await page.waitForFunction(() => scrollY > 0);
});

test('if the pointer cannot be locked, the mouse position steers', async (t) => {
  const { page } = await openElements(t, browser, kRoom, {
    prepare: (opened) =>
      opened.addInitScript(() => {
        Element.prototype.requestPointerLock = () =>
          Promise.reject(new DOMException('not here', 'NotAllowedError'));
      }),
  });
  await ready(page, 'a');
  await page.mouse.click(160, 60);
  await inElementState(page, 'a', 'playing');
  await page.mouse.click(160, 60);
  await page.waitForFunction(() =>
    document
      .getElementById('a')
      .shadowRoot.querySelector('.status')
      .textContent.includes('mouse position steers'),
  );
  await page.mouse.move(310, 100);
  await page.waitForFunction(() => document.getElementById('a').currentView.heading > 5);
  await page.keyboard.press('Escape');
  await inElementState(page, 'a', 'paused');
  assert.equal(await status(page).textContent(), '');
});

test('P pauses, and play and pause of the page agree with it', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="room" autoplay></ray-caster>',
  );
  await inElementState(page, 'a', 'playing');
  assert.equal(await focusOf(page), 'body', 'autoplay takes no focus');
  await page.click('#a');
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.activeElement?.localName === 'canvas',
  );
  await page.keyboard.press('p');
  await inElementState(page, 'a', 'paused');
  assert.equal(await page.evaluate(() => document.getElementById('a').paused), true);
  await page.evaluate(() => document.getElementById('a').play());
  await inElementState(page, 'a', 'playing');
  await page.evaluate(() => document.getElementById('a').focus());
  assert.equal(await focusOf(page), 'a cover');
  await page.evaluate(() => document.getElementById('a').pause());
  await inElementState(page, 'a', 'paused');
});

test('a fixed size gives the element its shape, and a pixel covers a whole number of screen pixels', async (t) => {
  for (const ratio of [1, 1.5, 2]) {
    const { page } = await openElements(
      t,
      browser,
      '<ray-caster id="a" scene="room" size="100x80" style="width: 333.3px"></ray-caster>',
      { context: { deviceScaleFactor: ratio } },
    );
    await ready(page, 'a');
    assert.deepEqual(await elementPixel(page, 'a'), kGreen);
    const seen = await page.evaluate(() => {
      const a = document.getElementById('a');
      const box = a.shadowRoot.querySelector('canvas').getBoundingClientRect();
      return {
        width: box.width * devicePixelRatio,
        left: box.left * devicePixelRatio,
        shape: a.getBoundingClientRect().width / a.getBoundingClientRect().height,
      };
    });
    assert.ok(Math.abs(seen.shape - 1.25) < 0.01, `${seen.shape}`);
    assert.ok(
      Math.abs(seen.width / 100 - Math.round(seen.width / 100)) < 1e-3,
      `${seen.width} device pixels for 100`,
    );
    assert.ok(Math.abs(seen.left - Math.round(seen.left)) < 0.05, `from ${seen.left}`);
  }
});
