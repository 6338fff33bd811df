// The page itself: loading, its picture, and different hosts.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import {
  inState,
  launch,
  openPage,
  openScene,
  pictureHash,
  pixel,
  play,
  playAtOneSize,
} from './browser.mjs';
import { hashHeadless } from './headless.mjs';
import { kBlue, kGreen, kGrey, kRed, kSky, kYellow, roomFiles } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

test('the loading bar shows real progress and goes', async (t) => {
  // The program's pieces and the pictures arrive one after another, each once the bar has shown
  // the one before. So none is missed, however slow the machine.
  let opened = null;
  let picturesSent = 0;
  const tells = (condition, argument) =>
    opened.waitForFunction(`(${condition})(window.seen, ${argument})`);
  async function mayGo(name, sent) {
    if (name.endsWith('.wasm') && sent > 0)
      await tells(
        (seen, kilobytes) => seen.some(({ bytes }) => parseInt(bytes.slice(2), 10) >= kilobytes),
        Math.floor(sent / 1024),
      );
    if (name.endsWith('.png') && sent === 0) {
      const before = picturesSent++;
      await tells(
        (seen, count) =>
          new Set(
            seen
              .filter(({ step, value }) => step.startsWith('Opening') && value > 0.5)
              .map(({ value }) => value),
          ).size >= count,
        before,
      );
    }
  }
  const { page } = await openPage(t, browser, {
    server: { mayGo },
    async prepare(newPage) {
      opened = newPage;
      await newPage.addInitScript(() => {
        window.seen = [];
        // Each change, however short.
        new MutationObserver(() => {
          const bar = document.getElementById('loading-bar');
          if (bar === null || !bar.checkVisibility()) return;
          window.seen.push({
            value: bar.value,
            step: document.getElementById('loading-step').textContent,
            bytes: document.getElementById('loading-bytes').textContent,
          });
        }).observe(document, {
          subtree: true,
          childList: true,
          attributes: true,
          characterData: true,
        });
      });
    },
  });
  await inState(page, 'paused');
  assert.equal(await page.isVisible('#loading'), false);
  const seen = await page.evaluate(() => window.seen);
  const values = seen.map(({ value }) => value);
  t.diagnostic(`${[...new Set(values)].map((value) => value.toFixed(2)).join(' ')}`);
  assert.ok(new Set(values).size >= 10, `only the values ${[...new Set(values)]}`);
  assert.deepEqual(
    values,
    [...values].sort((a, b) => a - b),
    'it never goes back',
  );
  assert.ok(
    values.some((value) => value > 0.05 && value < 0.45) &&
      values.some((value) => value > 0.55 && value < 0.95),
  );
  assert.ok(
    seen.some(({ step, bytes }) => step === 'Fetching the engine' && /^· [1-9]\d* KB$/.test(bytes)),
  );
  assert.ok(seen.some(({ step }) => step === 'Opening room.json'));
});

test('every wall of the room has its colour, and so have floor and sky', async (t) => {
  const { page } = await openScene(t, browser);
  assert.deepEqual(await pixel(page, 0.5, 0.05), kSky);
  assert.deepEqual(await pixel(page, 0.5, 0.95), kGrey);
  await play(page);
  for (const [key, colour] of [
    ['Numpad8', kRed],
    ['Numpad6', kGreen],
    ['Numpad2', kBlue],
    ['Numpad4', kYellow],
  ]) {
    await page.keyboard.press(key);
    await page.waitForFunction(([r, g, b]) => {
      const canvas = window.slicecast.shadowRoot.querySelector('canvas');
      const [red, green, blue] = canvas
        .getContext('2d')
        .getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data;
      return red === r && green === g && blue === b;
    }, colour);
  }
});

test('the canvas has the same picture as the engine draws without a page', async (t) => {
  const { page } = await openScene(t, browser, { viewport: { width: 640, height: 400 } });
  assert.equal(await pictureHash(page), await hashHeadless('room.json', roomFiles(), 640, 400));
});

test('the screen shows the canvas pixel by pixel', async (t) => {
  const { page } = await openScene(t, browser, {
    // A hint would cover the picture after some seconds.
    prepare: (newPage) =>
      newPage.addInitScript(() =>
        localStorage.setItem('slicecast.hints', '["walk","look","jump","fly"]'),
      ),
  });
  await playAtOneSize(page);
  await page.waitForFunction(
    () => getComputedStyle(document.getElementById('bar')).opacity === '0',
  );
  const png = await page.screenshot({ animations: 'disabled' }); // the bar may still be seen fading
  const shot = `data:image/png;base64,${png.toString('base64')}`;
  const rowsThatDiffer = await page.evaluate(async (address) => {
    const image = await createImageBitmap(await (await fetch(address)).blob());
    const copy = new OffscreenCanvas(image.width, image.height).getContext('2d');
    copy.drawImage(image, 0, 0);
    const canvas = window.slicecast.shadowRoot.querySelector('canvas');
    const screen = copy.getImageData(0, 0, canvas.width, canvas.height).data;
    const picture = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    const rows = [];
    for (let y = 0, at = 0; y < canvas.height; ++y, at += 4 * canvas.width) {
      const row = picture.subarray(at, at + 4 * canvas.width);
      if (row.some((byte, index) => byte !== screen[at + index])) rows.push(y);
    }
    return rows;
  }, shot);
  assert.deepEqual(rowsThatDiffer, []);
});

test('the page has its own title, description and icon', async (t) => {
  const { page, server } = await openScene(t, browser);
  assert.equal(await page.title(), 'The coloured room · Slicecast');
  assert.equal(await page.textContent('#bar-title'), 'The coloured room');
  assert.equal(await page.textContent('#pause-about'), 'Four walls.');
  assert.ok((await page.getAttribute('meta[name=description]', 'content')).length > 40);
  assert.match(await page.getAttribute('meta[name=theme-color]', 'content'), /^#[0-9a-f]{6}$/);
  const icon = await page.request.get(
    server.address + (await page.getAttribute('link[rel=icon]', 'href')),
  );
  assert.equal(icon.headers()['content-type'], 'image/svg+xml');
});

test('it plays under a strict content security policy', async (t) => {
  const policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self'; connect-src 'self'";
  const { page, complaints } = await openScene(t, browser, {
    server: { headers: { 'Content-Security-Policy': policy } },
  });
  assert.deepEqual(await pixel(page, 0.5, 0.5), kGreen);
  await page.click('#open-settings');
  await page.selectOption('#set-size', '320x180');
  await page.waitForFunction(
    () => window.slicecast.shadowRoot.querySelector('canvas').width === 320,
  );
  assert.deepEqual(complaints, []);
});

test('it works from a subfolder and fetches nothing outside of it', async (t) => {
  const { page } = await openScene(t, browser, { server: { prefix: '/some/deep/folder/' } });
  assert.deepEqual(await pixel(page, 0.5, 0.5), kGreen);
  await page.click('#open-scenes');
  await page.click('#scene-list a:has-text("The other room")');
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  assert.match(page.url(), /\/some\/deep\/folder\/\?scene=other$/);
});

test('a phone shows everything without overflow', async (t) => {
  const { page } = await openScene(t, browser, {
    viewport: { width: 390, height: 844 },
    context: { isMobile: true, hasTouch: true, deviceScaleFactor: 2 },
  });
  const outside = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('button, h1, h2, h3, p, kbd, select, input, textarea, td, th')]
        .filter((element) => element.checkVisibility() && element.getClientRects().length > 0)
        .filter((element) => {
          const box = element.getBoundingClientRect();
          return (
            box.width > 1 &&
            (box.left < 0 || box.right > document.documentElement.clientWidth + 0.5)
          );
        })
        .map((element) => element.outerHTML),
    );
  assert.deepEqual(await outside(), []);
  assert.equal(
    await page.evaluate(
      () => document.documentElement.scrollWidth <= document.documentElement.clientWidth,
    ),
    true,
  );
  assert.match(await page.innerText('#play-hint'), /Tap/);
  for (const name of ['scenes', 'keys', 'settings', 'share']) {
    await page.tap(`#open-${name}`);
    await page.waitForSelector(`#${name}[open]`);
    assert.deepEqual(await outside(), [], name);
    assert.ok(
      await page.evaluate(
        (id) => document.getElementById(id).scrollWidth <= document.getElementById(id).clientWidth,
        name,
      ),
      `${name} scrolls sideways`,
    );
    await page.tap(`#${name} [data-close]`);
  }
});
