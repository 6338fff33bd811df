// How many pixels the picture has while it moves: fewer if the machine cannot keep up, all of
// them again at rest. The classic method is slow, and the browser's processor is throttled to a
// sixth of its speed, because some machines are fast enough for all pixels.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { frames, inState, launch, openScene, play } from './browser.mjs';
import { openGuest, ready, until } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kViewport = { width: 800, height: 600 };
const sizes = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('ray-caster')].map(
      ({ picture: { width, height } }) => `${width}x${height}`,
    ),
  );
const untilSmaller = (page, share) =>
  until(
    page,
    (wanted) => {
      const { picture, clientWidth } = document.querySelector('ray-caster');
      return picture.width < wanted * clientWidth;
    },
    share,
  );
async function drawSlowly(page, options = 'method=classic') {
  const browserTools = await page.context().newCDPSession(page);
  await browserTools.send('Emulation.setCPUThrottlingRate', { rate: 6 });
  await page.evaluate((wanted) => {
    document.querySelector('ray-caster').options = wanted;
  }, options);
}

test('a slow picture has fewer pixels while it moves, and all at rest', async (t) => {
  const { page } = await openScene(t, browser, { viewport: kViewport });
  assert.deepEqual(await sizes(page), ['800x600']);
  await drawSlowly(page);
  const before = await page.evaluate(() => window.slicecast.currentView);
  await play(page);
  await untilSmaller(page, 0.7);
  const [{ width, height }, box] = await page.evaluate(() => {
    const canvas = window.slicecast.shadowRoot.querySelector('canvas');
    const rect = canvas.getBoundingClientRect();
    return [window.slicecast.picture, [rect.width, rect.height]];
  });
  assert.ok(Math.abs(width / height - 4 / 3) < 0.01, `${width} x ${height}`);
  assert.deepEqual(box, [800, 600]); // it covers the same box
  assert.deepEqual(await page.evaluate(() => window.slicecast.currentView), before);
  await page.evaluate(() => window.slicecast.pause());
  await inState(page, 'paused');
  await frames(page);
  assert.deepEqual(await sizes(page), ['800x600']);
  assert.match(
    await page.textContent('#size-now'),
    /^800 × 600 \(100 %\); in motion \d+ × \d+ \(\d+ %\)$/,
  );
});

test('the size stays while columns are counted, and a fixed size always', async (t) => {
  const { page } = await openScene(t, browser, { viewport: kViewport });
  await drawSlowly(page, 'method=classic inspector=on');
  await play(page);
  await page.waitForTimeout(1500);
  assert.deepEqual(await sizes(page), ['800x600']);
  await page.evaluate(() => {
    window.slicecast.size = '100%';
    window.slicecast.options = 'method=classic';
  });
  await page.waitForTimeout(1500);
  assert.deepEqual(await sizes(page), ['800x600']);
  await page.evaluate(() => {
    window.slicecast.size = 'auto';
  });
  await untilSmaller(page, 0.9);
});

test('elements of a page share one budget', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<ray-caster scene="room" style="width: 600px"></ray-caster>
      <ray-caster scene="room" style="width: 400px"></ray-caster>
      <ray-caster scene="room" size="200x125"></ray-caster>`,
    viewport: { width: 800, height: 1200 },
  });
  await ready(page);
  const still = ['600x375', '400x250', '200x125'];
  assert.deepEqual(await sizes(page), still);
  await drawSlowly(page); // the first one takes all the time
  await page.evaluate(() => {
    for (const element of document.querySelectorAll('ray-caster')) element.play();
  });
  await untilSmaller(page, 0.8);
  const [first, second, third] = (await sizes(page)).map((size) => size.split('x').map(Number));
  assert.ok(second[0] < 400, `${second}`);
  assert.ok(Math.abs(first[0] / 600 - Math.max(second[0] / 400, 0.8)) < 0.3);
  assert.deepEqual(third, [200, 125]);
  await page.evaluate(() => {
    for (const element of document.querySelectorAll('ray-caster')) element.pause();
  });
  await until(page, () =>
    [...document.querySelectorAll('ray-caster')].every(({ state }) => state === 'paused'),
  );
  await frames(page);
  assert.deepEqual(await sizes(page), still);
});

test('a paused view that the page moves keeps the frame rate too', async (t) => {
  const { page } = await openScene(t, browser, { viewport: kViewport });
  await drawSlowly(page);
  await page.evaluate(() => {
    const turn = () => {
      const view = window.slicecast.currentView;
      window.slicecast.look({ ...view, heading: (view.heading + 1) % 360 });
      window.turning = requestAnimationFrame(turn);
    };
    turn();
  });
  await untilSmaller(page, 0.8);
  await page.evaluate(() => cancelAnimationFrame(window.turning));
  await until(page, () => window.slicecast.picture.width === 800);
});
