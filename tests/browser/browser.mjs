// Shared by the browser tests: Chromium, a page in it, and questions to the page.

import { accessSync, constants } from 'node:fs';
import path from 'node:path';
import { chromium } from 'playwright-core';
import { serve } from './static-server.mjs';
import { roomFiles } from './room.mjs';

const kArguments = [
  '--no-sandbox',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
const kWaitMilliseconds = 15000; // for anything; a slow machine is not a fault

function findChromium(names) {
  const places = [
    process.env.SLICECAST_CHROMIUM,
    ...names.flatMap((name) =>
      (process.env.PATH ?? '').split(path.delimiter).map((folder) => path.join(folder, name)),
    ),
    '/Applications/Chromium.app/Contents/MacOS/Chromium',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  ];
  const found = places.find((place) => {
    try {
      accessSync(place ?? '', constants.X_OK);
      return true;
    } catch {
      return false;
    }
  });
  if (found === undefined)
    throw new Error(
      'There is no Chromium; tools/setup installs it, or SLICECAST_CHROMIUM names it.',
    );
  return found;
}

const kWindowed = ['chromium', 'chromium-browser', 'google-chrome'];
// Without windows a test takes a third of the processor time.
const kWindowless = ['chromium-headless-shell', ...kWindowed];

// `more` are further arguments, as --js-flags.
export function launch(more = [], names = kWindowless) {
  return chromium.launch({
    executablePath: findChromium(names),
    args: [...kArguments, ...more],
  });
}

// For one test, a Chromium that has windows, though nobody sees them: only there the pointer can be
// locked, and a page is hidden by another one.
export async function withWindows(t) {
  const browser = await launch([], kWindowed);
  atEnd(t, async () => {
    await browser.close();
    return [];
  });
  return browser;
}

const closings = new WeakMap(); // by test: functions that close a page and return its complaints

// Closes all pages of a test, the last one first, and only then fails by what they complained
// about. A hook that throws keeps the later hooks from running, and a server that is left open
// keeps the tests from ending.
function atEnd(t, close) {
  if (!closings.has(t)) {
    const all = [];
    closings.set(t, all);
    t.after(async () => {
      const complaints = [];
      for (const one of all.reverse()) complaints.push(...(await one()));
      if (complaints.length > 0) throw new Error(`The page complained: ${complaints.join('\n')}`);
    });
  }
  closings.get(t).push(close);
}

// A page on a server of its own. Whatever the page complains about on the console fails the test at
// its end, unless the test expects complaints.
export async function openPage(
  t,
  browser,
  {
    server: serverOptions = {},
    query = '',
    viewport = { width: 640, height: 360 },
    context: contextOptions = {},
    expectErrors = false,
    prepare = async () => {},
  } = {},
) {
  const server = await serve({
    ...serverOptions,
    files: { ...roomFiles(), ...serverOptions.files },
  });
  const context = await browser.newContext({ viewport, ...contextOptions });
  const page = await context.newPage();
  page.setDefaultTimeout(kWaitMilliseconds);
  const complaints = [];
  let isClosing = false; // then what is still loading fails
  page.on('console', (message) => {
    const isOfClosing = isClosing && /Failed to load resource/.test(message.text());
    if (message.type() === 'error' && !isOfClosing) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  atEnd(t, async () => {
    isClosing = true;
    await context.close();
    await server.close();
    return expectErrors ? [] : complaints;
  });
  await prepare(page, context);
  await page.goto(server.address + query);
  return { page, context, server, complaints };
}

// The same, and waits until the scene can be played.
export async function openScene(t, browser, options) {
  const opened = await openPage(t, browser, options);
  await inState(opened.page, 'paused');
  return opened;
}

export function inState(page, state) {
  return page.waitForFunction((wanted) => document.body.dataset.state === wanted, state);
}

// By the key, as the mouse would be captured too.
export async function play(page) {
  await page.press('#play', 'Enter');
  await inState(page, 'playing');
}

// At one size, for pictures that are compared: with "auto" a busy machine draws smaller ones.
export async function playAtOneSize(page) {
  await page.evaluate(() => (window.slicecast.size = '640x360'));
  await play(page);
}

export function player(page) {
  return page.evaluate(() => window.slicecast.player);
}

// Waits until the function, which runs in the page, is true for the player's state.
export async function untilPlayer(page, condition, argument) {
  await page.waitForFunction(
    `(${condition})(window.slicecast.player, ${JSON.stringify(argument ?? null)})`,
  );
  return player(page);
}

export function pixel(page, shareX, shareY) {
  return page.evaluate(
    ([x, y]) => {
      const canvas = window.slicecast.shadowRoot.querySelector('canvas');
      return [
        ...canvas
          .getContext('2d')
          .getImageData(Math.floor(x * canvas.width), Math.floor(y * canvas.height), 1, 1)
          .data.subarray(0, 3),
      ];
    },
    [shareX, shareY],
  );
}

// A string of all pixels of the canvas, equal only for equal pictures.
export function pictureHash(page, selector = 'canvas') {
  return page.evaluate(async (which) => {
    const place = window.slicecast?.shadowRoot ?? document;
    const canvas = place.querySelector(which);
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const digest = await crypto.subtle.digest('SHA-256', data);
    return `${canvas.width}x${canvas.height} ${[...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join('')}`;
  }, selector);
}

// Lets time pass for a page whose clock is a test's, four pictures a second; `runFor` draws 60.
export async function letPass(page, seconds) {
  for (let quarter = 0; quarter < 4 * seconds; ++quarter) await page.clock.fastForward(250);
}

// Long enough for several frames.
export function frames(page, count = 3) {
  return page.evaluate(
    (left) =>
      new Promise((resolve) => {
        const next = () => (left-- > 0 ? requestAnimationFrame(next) : resolve());
        next();
      }),
    count,
  );
}
