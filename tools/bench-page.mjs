// How the page plays the views of shipped scenes in Chromium, in two sizes of window: the pictures
// that it draws a second, their size, and the time that drawing one takes. At a start somebody
// looks left and right; of a tour the seconds around its slowest moment are played. The page must
// have been built.
//
//     await measurePage(views);      prints a line for each view; see bench-views.mjs

import { inState, launch, play } from '../tests/browser/browser.mjs';
import { serve } from '../tests/browser/static-server.mjs';
import { moments } from './bench-views.mjs';

const kWindows = [
  { width: 1366, height: 768 },
  { width: 1920, height: 1080 },
];
const kSettle = 1500; // milliseconds, in which the page finds the size that it can draw
const kCounted = 2000;
const kLook = 200; // milliseconds to the left, and as many to the right
const stepsIn = (milliseconds) => Math.round(milliseconds * 0.12);

// Resolves to the means of the page's own figures, which the event "pace" brings twice a second.
const meansOf = (page) =>
  page.evaluate(
    async ([settle, counted]) => {
      const wait = (time) => new Promise((resolve) => setTimeout(resolve, time));
      const told = [];
      await wait(settle);
      globalThis.slicecast.addEventListener('pace', ({ detail }) => told.push(detail));
      await wait(counted);
      const mean = (name) => told.reduce((sum, { [name]: one }) => sum + one, 0) / told.length;
      const names = ['framesPerSecond', 'drawMilliseconds', 'width', 'height'];
      return Object.fromEntries(names.map((name) => [name, mean(name)]));
    },
    [kSettle, kCounted],
  );

async function lookAround(page, isOver) {
  for (let turn = 0; !isOver(); ++turn) {
    const key = turn % 2 === 0 ? 'ArrowLeft' : 'ArrowRight';
    await page.keyboard.press(key, { delay: kLook });
  }
}

async function measureView(page, address, { scene, isTour }) {
  await page.goto(`${address}?${isTour ? 'tour' : 'scene'}=${scene}`);
  await inState(page, 'paused');
  if (isTour) {
    // Not beyond the end of the tour, where nothing moves any more.
    const begin = ([step, half, all]) => {
      const { replay } = globalThis.slicecast;
      globalThis.slicecast.seek(Math.max(0, Math.min(step - all + half, replay.steps - all)));
    };
    await page.evaluate(begin, [
      moments[scene],
      stepsIn(kCounted / 2),
      stepsIn(kSettle + kCounted),
    ]);
    await page.waitForFunction(() => !globalThis.slicecast.replay.isSeeking);
  }
  await play(page);
  let isOver = false;
  const counting = meansOf(page).finally(() => (isOver = true));
  if (!isTour) await lookAround(page, () => isOver);
  return counting;
}

export async function measurePage(views) {
  const server = await serve();
  const browser = await launch();
  const box = ({ width, height }) => `${Math.round(width)}x${Math.round(height)}`;
  console.log(`${''.padEnd(32)}${kWindows.map((size) => box(size).padEnd(36)).join('')}`);
  for (const view of views.filter(({ scene }) => scene !== undefined)) {
    process.stdout.write(view.title.padEnd(32));
    for (const viewport of kWindows) {
      const page = await browser.newPage({ viewport });
      const drawn = await measureView(page, server.address, view);
      const share = (drawn.width * drawn.height) / (viewport.width * viewport.height);
      const text =
        `${drawn.framesPerSecond.toFixed(0).padStart(3)} of ${box(drawn).padEnd(9)}` +
        `${Math.round(share * 100)} %`.padStart(6) +
        `${drawn.drawMilliseconds.toFixed(1)} ms`.padStart(9);
      process.stdout.write(text.padEnd(36));
      await page.close();
    }
    process.stdout.write('\n');
  }
  await browser.close();
  await server.close();
}
