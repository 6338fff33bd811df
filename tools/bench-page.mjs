// How the page plays the views of shipped scenes in Chromium: the pictures that it draws a second,
// and their size, in two sizes of window. At a start somebody looks left and right; of a tour the
// seconds around its slowest moment are played. The page must have been built.
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
const kStepsPerMillisecond = 0.12;

// Resolves to {pictures: a second, width, height: their means}.
const count = (page) =>
  page.evaluate(
    ([settle, counted]) =>
      new Promise((resolve) => {
        const sizes = [];
        const note = () => sizes.push(globalThis.slicecast.picture);
        const mean = (side) => sizes.reduce((sum, size) => sum + size[side], 0) / sizes.length;
        setTimeout(() => {
          globalThis.slicecast.addEventListener('framechange', note);
          setTimeout(() => {
            globalThis.slicecast.removeEventListener('framechange', note);
            const pictures = (sizes.length * 1000) / counted;
            resolve({ pictures, width: mean('width'), height: mean('height') });
          }, counted);
        }, settle);
      }),
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
    const before = Math.round((kSettle + kCounted / 2) * kStepsPerMillisecond);
    const from = Math.max(0, moments[scene] - before);
    await page.evaluate((step) => globalThis.slicecast.seek(step), from);
    await page.waitForFunction(() => !globalThis.slicecast.replay.isSeeking);
  }
  await play(page);
  let isOver = false;
  const counting = count(page).finally(() => (isOver = true));
  if (!isTour) await lookAround(page, () => isOver);
  return counting;
}

export async function measurePage(views) {
  const server = await serve();
  const browser = await launch();
  const box = ({ width, height }) => `${Math.round(width)}x${Math.round(height)}`;
  console.log(`${''.padEnd(32)}${kWindows.map((size) => box(size).padEnd(30)).join('')}`);
  for (const view of views.filter(({ scene }) => scene !== undefined)) {
    process.stdout.write(view.title.padEnd(32));
    for (const viewport of kWindows) {
      const page = await browser.newPage({ viewport });
      const drawn = await measureView(page, server.address, view);
      const share = (drawn.width * drawn.height) / (viewport.width * viewport.height);
      const text = `${drawn.pictures.toFixed(0).padStart(3)} a second, ${box(drawn)}`;
      process.stdout.write(`${text} ${Math.round(share * 100)} %`.padEnd(30));
      await page.close();
    }
    process.stdout.write('\n');
  }
  await browser.close();
  await server.close();
}
