// The bar of recordings on the play page: recording by buttons, watching, moving along it, taking
// over and going back. What a jump leads to is what playing leads to, to the byte.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { inState, launch, openScene, pictureHash, play, player, untilPlayer } from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Ten seconds round the room, with a mark that the room does not keep to.
const tour =
  'slicecast recording 1\nscene room\n60 forward 256\n400 turn 128\n140 forward 128\n600 turn -90 forward 20\nend 1200 0123456789abcdef\n';

const bar = (name) => `#replay [data-replay="${name}"]`;

const state = (page) => page.evaluate(() => document.getElementById('replay').dataset.state);

const becomes = (page, wanted) =>
  page.waitForFunction((name) => document.getElementById('replay').dataset.state === name, wanted);

const openTour = (t, options = {}) =>
  openScene(t, browser, {
    query: '?tour=mine',
    server: { files: { 'tours/mine.txt': tour } },
    ...options,
  });

// Waits until the picture shows that step of the recording, and stands still.
const arrives = (page, step) =>
  page.waitForFunction((wanted) => {
    const { replay } = window.slicecast;
    return replay !== null && !replay.isSeeking && replay.stepsDone === wanted;
  }, step);

const setSlider = (page, step) =>
  page.$eval(
    bar('seek'),
    (slider, value) => {
      slider.value = String(value);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    },
    step,
  );

const timeShown = (page) => page.textContent(bar('time'));

test('a jump shows what playing through shows, byte for byte', async (t) => {
  const { page } = await openTour(t);
  await page.evaluate(() => {
    window.slicecast.size = '320x180';
  });
  await page.waitForFunction(() => window.slicecast.picture.width === 320);
  // Through, in leaps that a jump never takes: each from the one before
  const seen = new Map();
  const look = async (step) => {
    await setSlider(page, step);
    await arrives(page, step);
    return [await pictureHash(page), (await player(page)).fingerprint];
  };
  for (let step = 50; step <= 1200; step += 50) seen.set(step, await look(step));
  assert.ok(new Set([...seen.values()].map(String)).size > 15, 'the views differ');
  for (const step of [1150, 100, 650, 50, 1200, 250])
    assert.deepEqual(await look(step), seen.get(step), `step ${step}`);
});

test('a tour shows the bar; keys move along it and its button plays and pauses', async (t) => {
  const { page } = await openTour(t);
  assert.equal(await state(page), 'replay');
  assert.equal(await timeShown(page), '0:00 / 0:10');
  await page.focus(bar('seek'));
  await page.keyboard.press('ArrowRight');
  await arrives(page, 120);
  assert.equal(await timeShown(page), '0:01 / 0:10');
  assert.equal(await page.getAttribute(bar('seek'), 'aria-valuetext'), '0:01 of 0:10');
  await page.keyboard.press('Shift+ArrowRight');
  await arrives(page, 121);
  await page.keyboard.press('End');
  await arrives(page, 1200);
  await page.keyboard.press('Home');
  await arrives(page, 0);
  await page.keyboard.press('PageUp');
  await arrives(page, 1200);
  await setSlider(page, 600);
  await arrives(page, 600);

  await page.click(bar('play'));
  await page.waitForFunction(() => window.slicecast.replay.stepsDone > 660);
  assert.equal(await page.textContent(bar('play')), 'Pause');
  assert.equal(await page.isVisible('#pause'), false, 'the caption leaves the picture free');
  await page.click(bar('play'));
  await page.waitForFunction(() => window.slicecast.state === 'paused');
  const { stepsDone } = await page.evaluate(() => window.slicecast.replay);
  assert.ok(stepsDone < 1200);
});

test('at the end it pauses, and plays again', async (t) => {
  const { page } = await openTour(t);
  await setSlider(page, 1100);
  await arrives(page, 1100);
  await page.click(bar('play'));
  await becomes(page, 'left');
  await page.waitForFunction(() => window.slicecast.state === 'paused');
  assert.equal(await timeShown(page), '0:10 / 0:10');
  assert.equal(await page.textContent(bar('play')), 'Play again');
  await page.click(bar('play'));
  await becomes(page, 'replay');
  await page.waitForFunction(() => window.slicecast.replay.stepsDone < 600);
});

test('whoever takes over can go back to the recording', async (t) => {
  const { page } = await openTour(t);
  await play(page);
  await page.waitForFunction(() => window.slicecast.replay.stepsDone > 60);
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => window.slicecast.replay === null);
  assert.equal(await page.isVisible('#replay'), false, 'nothing is in the way while one plays');
  await page.keyboard.press('Escape');
  await inState(page, 'paused');
  await becomes(page, 'left');
  assert.equal(await page.textContent(bar('play')), 'Back to the recording');
  await setSlider(page, 300);
  await arrives(page, 300);
  assert.equal(await state(page), 'replay');
  await page.click(bar('close'));
  assert.equal(await page.isVisible('#replay'), false);
  assert.equal(await page.evaluate(() => window.slicecast.replay), null);
  const { steps } = await player(page);
  assert.ok(steps >= 300 && steps < 320, 'the player stays there');
});

test('buttons record, stop, watch and save', async (t) => {
  const { page } = await openScene(t, browser, { context: { acceptDownloads: true } });
  await page.click('#open-lab');
  await page.click('[data-lab="record"]');
  await becomes(page, 'recording');
  await inState(page, 'playing');
  assert.equal(await page.isVisible('#lab'), false);
  await page.keyboard.down('d');
  await untilPlayer(page, (now) => now.y > 4);
  await page.keyboard.up('d');
  await untilPlayer(page, (now) => now.steps > 130);
  await page.waitForFunction(
    (time) => document.querySelector(time).textContent === 'Recording 0:01',
    bar('time'),
  );
  const end = await player(page);
  await page.click(bar('stop'));
  assert.equal(await state(page), 'recorded');
  assert.match(await timeShown(page), /^Recorded 0:0\d$/);
  const downloading = page.waitForEvent('download');
  await page.click(bar('save'));
  const download = await downloading;
  assert.equal(download.suggestedFilename(), 'room-recording.txt');
  assert.match(readFileSync(await download.path(), 'utf8'), /^slicecast recording 1\nscene room\n/);

  await page.click(bar('watch'));
  await becomes(page, 'replay');
  await becomes(page, 'left');
  const watched = await player(page);
  assert.ok(Math.abs(watched.y - end.y) < 0.05, `${watched.y}, ${end.y}`);
  assert.ok(await page.isVisible(bar('save')), 'it can still be saved');
  // Another scene has nothing to do with it.
  await page.evaluate(() => {
    history.pushState(null, '', '?scene=other');
    window.dispatchEvent(new PopStateEvent('popstate'));
  });
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  await page.waitForFunction(() => document.getElementById('replay').hidden);
});

test('a drag along the bar holds the replay, and lets it go on from there', async (t) => {
  const { page } = await openTour(t);
  await page.click(bar('play'));
  await page.waitForFunction(() => window.slicecast.replay.stepsDone > 20);
  const box = await (await page.$(bar('seek'))).boundingBox();
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width * 0.3, y);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.5, y, { steps: 5 });
  await page.waitForFunction(() => {
    const { replay } = window.slicecast;
    return !replay.isSeeking && Math.abs(replay.stepsDone - 600) < 60;
  });
  const { stepsDone } = await page.evaluate(() => window.slicecast.replay);
  assert.equal(await page.evaluate(() => window.slicecast.state), 'paused');
  await page.mouse.up();
  await page.waitForFunction((at) => window.slicecast.replay.stepsDone > at + 30, stepsDone);
});

for (const [width, height, touch] of [
  [1366, 768, false],
  [390, 844, true],
  [844, 390, true],
]) {
  test(`the bar covers nothing at ${width}x${height}`, async (t) => {
    const { page } = await openTour(t, {
      viewport: { width, height },
      context: { hasTouch: touch, isMobile: touch },
    });
    const boxes = await page.evaluate(() => {
      const of = (selector) => document.querySelector(selector).getBoundingClientRect();
      return {
        stage: of('#stage').bottom,
        caption: of('#pause').bottom,
        bar: of('#replay').top,
        parts: [...document.querySelectorAll('#replay [data-replay]')]
          .filter((part) => part.offsetParent !== null)
          .map((part) => part.getBoundingClientRect())
          .map(({ left, right, top, bottom }) => ({ left, right, top, bottom })),
      };
    });
    assert.ok(
      boxes.stage <= boxes.bar + 1 && boxes.caption <= boxes.bar + 1,
      JSON.stringify(boxes),
    );
    for (const [index, a] of boxes.parts.entries()) {
      assert.ok(a.left >= 0 && a.right <= width && a.bottom <= height, JSON.stringify(a));
      for (const b of boxes.parts.slice(index + 1))
        assert.ok(
          a.right <= b.left + 1 ||
            b.right <= a.left + 1 ||
            a.bottom <= b.top + 1 ||
            b.bottom <= a.top + 1,
          JSON.stringify([a, b]),
        );
    }
  });
}
