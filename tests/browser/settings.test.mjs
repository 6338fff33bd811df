// The settings dialog: what each setting does, and that it is remembered.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import {
  frames,
  inState,
  launch,
  openScene,
  pictureHash,
  play,
  player,
  untilPlayer,
  withWindows,
} from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const canvasSize = (page) =>
  page.evaluate(
    () =>
      `${window.slicecast.shadowRoot.querySelector('canvas').width}x${window.slicecast.shadowRoot.querySelector('canvas').height}`,
  );
const untilSize = (page, size) =>
  page.waitForFunction((wanted) => {
    const canvas = window.slicecast.shadowRoot.querySelector('canvas');
    return `${canvas.width}x${canvas.height}` === wanted;
  }, size);
const shownSize = (page) =>
  page.evaluate(() => {
    const { width, height } = window.slicecast.shadowRoot
      .querySelector('canvas')
      .getBoundingClientRect();
    return `${width}x${height}`;
  });

async function openSettings(page) {
  await page.click('#open-settings');
  await page.waitForSelector('#settings[open]');
}

async function slide(page, selector, value) {
  await page.evaluate(
    ([which, wanted]) => {
      const field = document.querySelector(which);
      field.value = wanted;
      field.dispatchEvent(new Event('input', { bubbles: true }));
    },
    [selector, String(value)],
  );
}

test("the picture has the window's own pixels, or a share of them", async (t) => {
  const { page } = await openScene(t, browser);
  assert.equal(await canvasSize(page), '640x360');
  for (const [width, height] of [
    [1280, 720],
    [800, 601],
    [1920, 1080],
    [1367, 767],
  ]) {
    await page.setViewportSize({ width, height });
    await untilSize(page, `${width}x${height}`);
    assert.equal(await shownSize(page), `${width}x${height}`);
  }
  const filtering = () =>
    page.evaluate(
      () => getComputedStyle(window.slicecast.shadowRoot.querySelector('canvas')).imageRendering,
    );
  assert.equal(await filtering(), 'pixelated');
  await openSettings(page);
  assert.equal(await page.textContent('#size-now'), '1367 × 767 (100 %)');
  await page.selectOption('#set-size', '75%');
  await untilSize(page, '1025x575');
  assert.equal(await shownSize(page), '1367x767');
  assert.equal(await filtering(), 'auto');
  assert.equal(await page.textContent('#size-now'), '1025 × 575 (75 %)');
  // Pixels are even and cover the window; an odd row or column extends beyond its edge.
  await page.selectOption('#set-size', '50%');
  await untilSize(page, '684x384');
  assert.equal(await shownSize(page), '1368x768');
  assert.equal(await filtering(), 'pixelated');
  // A screen beyond what the engine draws.
  await page.selectOption('#set-size', 'auto');
  await page.setViewportSize({ width: 4800, height: 600 });
  await untilSize(page, '4096x512');
  assert.equal(await shownSize(page), '4800x600');
});

for (const ratio of [1, 1.25])
  test(`a chosen size is scaled by a whole number, without blur, where a CSS pixel is ${ratio} of the screen's`, async (t) => {
    const { page } = await openScene(t, browser, {
      viewport: { width: 1280, height: 720 },
      context: { deviceScaleFactor: ratio },
    });
    await openSettings(page);
    await page.selectOption('#set-size', '320x180');
    await untilSize(page, '320x180');
    assert.equal(await shownSize(page), '1280x720');
    await page.click('#settings button[type=submit]');
    await play(page);
    await page.keyboard.press('Numpad9'); // a corner of the room: slanted edges
    await page.waitForFunction(
      () => getComputedStyle(document.getElementById('bar')).opacity === '0',
    );
    await frames(page);
    const png = await page.screenshot({ animations: 'disabled' });
    const shot = `data:image/png;base64,${png.toString('base64')}`;
    const different = await page.evaluate(async (address) => {
      const image = await createImageBitmap(await (await fetch(address)).blob());
      const copy = new OffscreenCanvas(image.width, image.height).getContext('2d');
      copy.drawImage(image, 0, 0);
      const scale = image.width / 320;
      const screen = new Uint32Array(
        copy.getImageData(0, 0, image.width, image.height).data.buffer,
      );
      const picture = new Uint32Array(
        window.slicecast.shadowRoot
          .querySelector('canvas')
          .getContext('2d')
          .getImageData(0, 0, 320, 180).data.buffer,
      );
      return screen.reduce((sum, colour, index) => {
        const x = index % image.width;
        const y = (index - x) / image.width;
        return (
          sum + (colour === picture[Math.floor(y / scale) * 320 + Math.floor(x / scale)] ? 0 : 1)
        );
      }, 0);
    }, shot);
    assert.equal(different, 0);
  });

test('other shapes are centred between margins', async (t) => {
  const { page } = await openScene(t, browser, { viewport: { width: 1000, height: 800 } });
  await openSettings(page);
  await page.selectOption('#set-size', '960x540');
  await untilSize(page, '960x540');
  const box = await page.evaluate(() => {
    const { left, top, width, height } = window.slicecast.shadowRoot
      .querySelector('canvas')
      .getBoundingClientRect();
    return [left, top, width, height];
  });
  assert.deepEqual(box, [20, 130, 960, 540]);
});

test('settings are remembered after a reload', async (t) => {
  const { page } = await openScene(t, browser);
  const before = await pictureHash(page);
  await openSettings(page);
  await page.selectOption('#set-size', '320x180');
  await slide(page, '#set-fov', 90);
  assert.equal(await page.textContent('output[for=set-fov]'), '90°');
  await page.check('#set-rate');
  await page.check('#set-invert');
  await page.uncheck('#set-fog');
  await page.reload();
  await inState(page, 'paused');
  assert.equal(await canvasSize(page), '320x180');
  assert.equal(await page.evaluate(() => window.slicecast.get('fov')), '90');
  assert.equal(await page.evaluate(() => window.slicecast.get('fog')), 'off');
  assert.equal(await page.isVisible('#rate'), true);
  await openSettings(page);
  assert.equal(await page.isChecked('#set-invert'), true);
  await page.click('#standard-settings');
  await untilSize(page, '640x360');
  await frames(page);
  assert.equal(await pictureHash(page), before);
});

test('time of day and mirrors can be set there, and reflect changes by keys', async (t) => {
  const { page } = await openScene(t, browser);
  const option = (name) => page.evaluate((wanted) => window.slicecast.get(wanted), name);
  const before = await pictureHash(page);
  await openSettings(page);
  await page.selectOption('#set-light-preset', 'night');
  await slide(page, '#set-mirrors', 2.5);
  assert.equal(await page.textContent('output[for=set-mirrors]'), '2.5 ×');
  assert.deepEqual([await option('lightPreset'), await option('mirrors')], ['night', '2.5']);
  await frames(page);
  assert.notEqual(await pictureHash(page), before);
  await page.click('#settings button[type=submit]');
  await play(page);
  await page.keyboard.press('KeyL');
  await page.keyboard.press('NumpadSubtract');
  await page.waitForFunction(() => window.slicecast.get('mirrors') === '2.4');
  await openSettings(page);
  assert.equal(await page.inputValue('#set-light-preset'), 'fog');
  assert.equal(await page.inputValue('#set-mirrors'), '2.4');
  await page.click('#standard-settings');
  assert.deepEqual([await option('lightPreset'), await option('mirrors')], ['map', '1']);
});

test("sliders have the engine's ranges", async (t) => {
  const { page } = await openScene(t, browser);
  const options = await page.evaluate(() => window.slicecast.optionList);
  const sliders = await page.$$eval('input[type="range"][name]', (all) =>
    all
      .filter(({ form }) => form?.parentElement.id === 'settings')
      .map(({ name, min, max, step, disabled }) => ({
        name,
        min: Number(min),
        max: Number(max),
        step: Number(step),
        disabled,
      })),
  );
  for (const [name, step] of [
    ['fov', 1],
    ['mirrors', 0.1],
  ]) {
    const { least: min, greatest: max } = options.find((option) => option.name === name);
    assert.deepEqual(
      sliders.find((one) => one.name === name),
      { name, min, max, step, disabled: false },
    );
  }
});

test('the field of view changes the picture at once', async (t) => {
  const { page } = await openScene(t, browser);
  const before = await pictureHash(page);
  await openSettings(page);
  await slide(page, '#set-fov', 75);
  await frames(page);
  assert.notEqual(await pictureHash(page), before);
});

test('the mouse follows the chosen sensitivity and direction', async (t) => {
  const { page } = await openScene(t, await withWindows(t));
  const turnBy = async (pixels) => {
    await page.mouse.move(300, 100);
    await page.mouse.click(300, 100);
    await page.waitForFunction(() => document.pointerLockElement !== null);
    await frames(page, 5);
    const before = await player(page);
    await page.mouse.move(300 + pixels, 100 - pixels / 2, { steps: 4 });
    const now = await untilPlayer(
      page,
      (state, { heading, look }) => state.heading !== heading && state.look !== look,
      before,
    );
    await frames(page, 10);
    const end = await player(page);
    await page.keyboard.press('Escape');
    await inState(page, 'paused');
    assert.ok(now.steps > before.steps);
    return { turned: end.heading - before.heading, looked: end.look - before.look };
  };
  const usual = await turnBy(40);
  assert.ok(Math.abs(usual.turned - 40 * 0.15) < 0.01, `turned by ${usual.turned}`);
  assert.ok(usual.looked > 0);
  await openSettings(page);
  await slide(page, '#set-mouse', 2);
  await page.check('#set-invert');
  await page.click('#settings button[type=submit]');
  const fast = await turnBy(40);
  assert.ok(Math.abs(fast.turned - 2 * usual.turned) < 0.01, `turned by ${fast.turned}`);
  assert.ok(fast.looked < 0);
});

test('without a storage the page works on', async (t) => {
  const { page } = await openScene(t, browser, {
    prepare: (newPage) =>
      newPage.addInitScript(() => {
        Object.defineProperty(window, 'localStorage', {
          get() {
            throw new DOMException('The operation is insecure.', 'SecurityError');
          },
        });
      }),
  });
  await openSettings(page);
  await page.selectOption('#set-size', '320x180');
  await untilSize(page, '320x180');
});

test('nonsense in the storage is ignored', async (t) => {
  for (const nonsense of [
    '{"fov": 4000, "size": "9x9", "light": "maybe", "mouse": null, "other": 1}',
    'no JSON',
    '"text"',
    '{"__proto__": {}, "constructor": {}, "toString": "x"}',
  ]) {
    const { page } = await openScene(t, browser, {
      prepare: (newPage) =>
        newPage.addInitScript((text) => localStorage.setItem('slicecast.settings', text), nonsense),
    });
    assert.equal(await canvasSize(page), '640x360');
    assert.equal(await page.evaluate(() => window.slicecast.get('fov')), '60');
    await page.context().close();
  }
});

test("back to standard also removes the address's options", async (t) => {
  const { page } = await openScene(t, browser, {
    query: '?scene=room&options=fov=60',
    prepare: (newPage) =>
      newPage.addInitScript(
        (text) => localStorage.setItem('slicecast.settings', text),
        JSON.stringify({ fov: 90 }),
      ),
  });
  await openSettings(page);
  await page.click('#standard-settings');
  assert.equal(await page.inputValue('#set-fov'), '60');
  assert.equal(
    await page.evaluate(() => JSON.parse(localStorage.getItem('slicecast.settings')).fov),
    60,
  );
  await page.keyboard.press('Escape');
  await page.evaluate(() => {
    history.pushState(null, '', '?scene=other');
    window.dispatchEvent(new PopStateEvent('popstate'));
  });
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  assert.equal(await page.evaluate(() => window.slicecast.get('fov')), '60');
});
