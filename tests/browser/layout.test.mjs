// Nothing covers anything: panels of the page, what the engine draws over the picture, messages and
// thumbs, from a small phone to a large screen and with pages magnified.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { frames, inState, launch, openScene } from './browser.mjs';
import { roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const phone = (width, height) => ({
  viewport: { width, height },
  context: { isMobile: true, hasTouch: true, deviceScaleFactor: 2 },
});
const desk = (width, height, deviceScaleFactor = 1) => ({
  viewport: { width, height },
  context: { deviceScaleFactor },
});
const kWindows = {
  '360 x 640 by touch': phone(360, 640),
  '390 x 844 by touch': phone(390, 844),
  '844 x 390 by touch': phone(844, 390),
  '768 x 1024': desk(768, 1024),
  '1366 x 768': desk(1366, 768),
  '1920 x 1080': desk(1920, 1080),
  '2560 x 1440': desk(2560, 1440),
  '1366 x 768 at 200 %': desk(683, 384, 2),
};

const kOverlays = ['minimap', 'playerPanel', 'processPanel', 'inspector'];
const kOfPage = [
  '#bar',
  '#address-problems',
  '#game',
  '#mode',
  '#rate',
  '#message',
  '#hint',
  '#toast',
  '#pause-title',
  '#pause-about',
  '#pause .row',
  '#lab',
  '#photo',
  '#divider',
];
const kOfElement = ['.leave', '.stick', '.buttons'];

function hunt() {
  const scene = roomScene({ title: 'A hunt in a coloured room' });
  scene.game = { aim: 'Find the lamp, the shell and the feather, then come back to the gate.' };
  return { 'scenes/room.json': JSON.stringify(scene) };
}

// The rectangles of all that can be seen, by name. Those of the engine are found in the picture:
// what differs with the overlay alone.
function rectangles(page) {
  return page.evaluate(
    ([overlays, ofPage, ofElement]) => {
      const { slicecast } = window;
      const found = {};
      const add = (name, { left, top, right, bottom }) => {
        found[name] = { left, top, right, bottom };
      };
      const take = (root, names) => {
        for (const name of names) {
          const element = root.querySelector(name);
          const box = element?.getBoundingClientRect();
          const isSeen = element?.checkVisibility({
            opacityProperty: true,
            visibilityProperty: true,
          });
          if (isSeen && box.height > 0) add(name, box);
        }
      };
      take(document, ofPage);
      take(slicecast.shadowRoot, ofElement);

      const picture = slicecast.shadowRoot.querySelector('canvas');
      const box = picture.getBoundingClientRect();
      const size = { width: picture.width, height: picture.height };
      const was = overlays.map((name) => slicecast.get(name));
      const column = slicecast.get('inspectorColumn');
      const show = (name, value) => slicecast.set(name, value);
      const pixels = () => new Uint32Array(slicecast.pixels(size).data.buffer);
      show('inspectorColumn', size.width - 1);
      for (const name of overlays) show(name, 'off');
      const plain = pixels();
      overlays.forEach((name, index) => {
        if (was[index] === 'off') return;
        show(name, 'on');
        const shown = pixels();
        show(name, 'off');
        // The inspector also marks its column.
        const width = name === 'inspector' ? size.width - 24 : size.width;
        let [left, top, right, bottom] = [Infinity, Infinity, -1, -1];
        for (let y = 0; y < size.height; ++y)
          for (let x = 0; x < width; ++x) {
            const at = y * size.width + x;
            if (plain[at] === shown[at]) continue;
            left = Math.min(left, x);
            right = Math.max(right, x + 1);
            top = Math.min(top, y);
            bottom = Math.max(bottom, y + 1);
          }
        if (right < 0) return;
        const scale = box.width / size.width;
        add(name, {
          left: box.left + left * scale,
          right: box.left + right * scale,
          top: box.top + top * scale,
          bottom: box.top + bottom * scale,
        });
      });
      overlays.forEach((name, index) => show(name, was[index]));
      show('inspectorColumn', column);
      return found;
    },
    [kOverlays, kOfPage, kOfElement],
  );
}

const kAlmost = 0.6; // CSS pixels: pictures and boxes end between them

function overlapsOf(found) {
  const names = Object.keys(found);
  return names.flatMap((a, index) =>
    names.slice(index + 1).flatMap((b) => {
      const [one, other] = [found[a], found[b]];
      const width = Math.min(one.right, other.right) - Math.max(one.left, other.left);
      const height = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
      return width > kAlmost && height > kAlmost ? [`${a} and ${b}`] : [];
    }),
  );
}

// `begin` shows what hides itself after a while: again, if a busy machine came too late to see it.
async function nothingCovers(page, { viewport }, state, expected, begin = () => {}) {
  let found;
  let tries = 0;
  do {
    await begin();
    await frames(page);
    found = await rectangles(page);
  } while (++tries < 5 && expected.some((name) => found[name] === undefined));
  for (const name of expected) assert.ok(found[name] !== undefined, `${state}: ${name} is shown`);
  assert.deepEqual(overlapsOf(found), [], `${state}: ${JSON.stringify(found)}`);
  for (const [name, { left, top, right, bottom }] of Object.entries(found))
    assert.ok(
      left > -kAlmost &&
        top > -kAlmost &&
        right < viewport.width + kAlmost &&
        bottom < viewport.height + kAlmost,
      `${state}: ${name} is in the window`,
    );
}

const kMessage =
  'The lamp hangs in the keeper’s house, behind the third door, and whoever takes it must be quick.';

const say = (page) =>
  page.evaluate((text) => {
    const tell = (name, detail) =>
      window.slicecast.dispatchEvent(new CustomEvent(name, { detail }));
    tell('message', { text });
    tell('modechange', { mode: 'fly', on: true });
  }, kMessage);

// Opens the room with everything shown at once.
async function openCrowd(t, shape, query = '') {
  const { page } = await openScene(t, browser, {
    ...shape,
    query: `?scene=room&overlay=minimap+playerPanel+processPanel+inspector${query}`,
    server: { files: hunt() },
  });
  await page.evaluate(() => {
    window.slicecast.dispatchEvent(
      new CustomEvent('modechange', { detail: { mode: 'recording', on: true } }),
    );
    document.getElementById('rate').hidden = false;
    document.getElementById('rate').textContent = '60 fps · 12.3 ms · 2560 × 1440';
  });
  return page;
}

for (const [name, shape] of Object.entries(kWindows)) {
  const isTouch = shape.context.hasTouch === true;
  test(`nothing covers anything in a window of ${name}`, async (t) => {
    const page = await openCrowd(t, shape);
    await nothingCovers(page, shape, 'paused', ['#bar', '#game', '#pause .row']);

    if (isTouch) await page.tap('#play');
    else await page.press('#play', 'Enter');
    await inState(page, 'playing');
    const thumbs = isTouch ? kOfElement : [];
    await nothingCovers(page, shape, 'playing', ['minimap', '#game', '#mode', '#rate', ...thumbs]);
    await page.waitForSelector('#hint.shown');
    await nothingCovers(page, shape, 'with a hint', ['#hint', ...thumbs]);
    await nothingCovers(
      page,
      shape,
      'with messages',
      ['#message', '#toast', ...thumbs],
      async () => {
        await say(page);
        await page.waitForSelector('#hint:not(.shown)', { state: 'attached' });
      },
    );

    await page.evaluate(() => window.slicecast.pause());
    await inState(page, 'paused');
    await page.click('#open-lab');
    await page.selectOption('#lab-way', 'Big pixels'); // others take a third of a second a picture
    await nothingCovers(page, shape, 'with the Lab', ['#lab', '#divider', '#bar']);
    await page.evaluate(() => window.slicecast.enter());
    await inState(page, 'playing');
    const expected = ['#lab', '#divider', '#message'];
    await nothingCovers(page, shape, 'playing beside the Lab', expected, () => say(page));
  });
}

test('mistakes in the address leave room for the game and the caption', async (t) => {
  for (const shape of [kWindows['360 x 640 by touch'], kWindows['844 x 390 by touch']]) {
    const page = await openCrowd(t, shape, '&view=1,2&options=hat=1+fov=900&opions=1&tour=');
    await nothingCovers(page, shape, 'mistakes', ['#address-problems', '#game', '#pause .row']);
  }
});

test('the settings are whole in a window of 1366 x 768', async (t) => {
  const { page } = await openScene(t, browser, { viewport: { width: 1366, height: 768 } });
  await page.click('#open-settings');
  const box = await page.evaluate(() => {
    const { scrollHeight, clientHeight } = document.getElementById('settings');
    return { scrollHeight, clientHeight };
  });
  assert.equal(box.scrollHeight, box.clientHeight);
  assert.ok(box.clientHeight < 700);
});
