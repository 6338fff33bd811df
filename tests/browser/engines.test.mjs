// The engine in the page: both builds, several side by side, and the messages if none can
// run.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { after, before, test } from 'node:test';
import {
  inState,
  launch,
  openPage,
  openScene,
  pictureHash,
  play,
  player,
  untilPlayer,
} from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kPages = new URL('pages/', import.meta.url);

async function trouble(page) {
  await page.waitForSelector('#trouble:not([hidden])');
  return `${await page.textContent('#trouble-title')}: ${await page.textContent('#trouble-text')}`;
}

test('the browser gets the engine with SIMD; without SIMD the other one, with the same picture', async (t) => {
  const simd = await openScene(t, browser);
  assert.ok(
    simd.server.asked.includes('engine/slicecast-simd.wasm') &&
      !simd.server.asked.includes('engine/slicecast-scalar.wasm'),
  );
  const scalar = await openScene(t, browser, { query: '?engine=scalar' });
  assert.ok(
    scalar.server.asked.includes('engine/slicecast-scalar.wasm') &&
      !scalar.server.asked.includes('engine/slicecast-simd.wasm'),
  );
  const old = await openScene(t, browser, {
    prepare: (page) =>
      page.addInitScript(() => {
        WebAssembly.validate = () => false;
      }),
  });
  assert.ok(
    old.server.asked.includes('engine/slicecast-scalar.wasm') &&
      !old.server.asked.includes('engine/slicecast-simd.wasm'),
  );
  const picture = await pictureHash(simd.page);
  assert.equal(await pictureHash(scalar.page), picture);
  assert.equal(await pictureHash(old.page), picture);
});

test('two canvases on one page draw their own pictures and get their own keys', async (t) => {
  const files = {};
  for (const name of ['two-canvases.html', 'two-canvases.js', 'scene-at.js'])
    files[name] = await readFile(new URL(name, kPages));
  const { page, server } = await openPage(t, browser, {
    query: 'two-canvases.html',
    server: { files },
  });
  await page.waitForFunction(() => window.engines?.every((engine) => engine.isReady));
  assert.equal(
    server.asked.filter((name) => name.endsWith('simd.wasm')).length,
    1,
    'one program serves both',
  );

  const states = () => page.evaluate(() => window.engines.map((engine) => engine.state));
  const middles = await page.evaluate(() =>
    window.engines.map(({ canvas }) =>
      [
        ...canvas.getContext('2d').getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data,
      ].join(),
    ),
  );
  assert.deepEqual(middles, ['40,180,60,255', '50,70,210,255']);

  // The keys go where the focus is: the second canvas is inside a shadow root.
  const moved = async (index) => {
    const before = await states();
    await page.keyboard.down('ArrowRight');
    await page.waitForFunction(
      ([which, heading]) => window.engines[which].state.heading > heading + 5,
      [index, before[index].heading],
    );
    await page.keyboard.up('ArrowRight');
    // Turning dies away.
    await page.waitForFunction(
      ([which, steps]) => window.engines[which].state.steps > steps + 120,
      [index, (await states())[index].steps],
    );
    const now = await states();
    assert.equal(now[1 - index].heading, before[1 - index].heading);
  };
  await page.evaluate(() => window.engines[0].canvas.focus());
  await moved(0);
  await page.evaluate(() => window.engines[1].canvas.focus());
  await moved(1);

  // Neither when a text box has it
  const before = await states();
  await page.click('#text');
  await page.keyboard.type('wasd');
  assert.equal(await page.inputValue('#text'), 'wasd');
  const now = await states();
  assert.deepEqual(
    now.map(({ x, y }) => [x, y]),
    before.map(({ x, y }) => [x, y]),
  );

  // One is stopped, the other goes on.
  await page.evaluate(() => window.engines[0].stop());
  const { steps } = now[1];
  await page.waitForFunction((last) => window.engines[1].state.steps > last + 10, steps);
});

test('without WebAssembly the page says what it needs', async (t) => {
  const { page, server } = await openPage(t, browser, {
    prepare: (newPage) =>
      newPage.addInitScript(() => {
        delete window.WebAssembly;
      }),
  });
  assert.match(await trouble(page), /This browser has no WebAssembly.*a current browser/);
  assert.ok(!server.asked.some((name) => name.startsWith('engine/')));
});

test('opened as a file, the page says what to do', async (t) => {
  const context = await browser.newContext();
  t.after(() => context.close());
  const page = await context.newPage();
  await page.goto(new URL('../../build/web/index.html', import.meta.url).href);
  assert.match(await trouble(page), /needs a web server.*tools\/play.*any static web server/);
  assert.equal(
    await page.evaluate(() => getComputedStyle(document.querySelector('.sheet')).backgroundColor),
    'rgb(34, 27, 32)',
    'the style sheet is there',
  );
});

test('without JavaScript the page says that it needs it', async (t) => {
  const { page } = await openPage(t, browser, { context: { javaScriptEnabled: false } });
  assert.ok((await page.locator('noscript').innerText()).includes('Slicecast needs JavaScript'));
  assert.equal(await page.locator('.trouble-without-script').isVisible(), true);
});

for (const [what, server, query, expected] of [
  [
    'an engine that is not there',
    { files: { 'engine/slicecast-simd.wasm': null } },
    '',
    /slicecast-simd\.wasm: the server answers 404/,
  ],
  [
    'a page in the place of the engine',
    { files: { 'engine/slicecast-simd.wasm': '<!doctype html><title>Welcome</title>' } },
    '',
    /found "<!doctype html>.*expected a WebAssembly program/,
  ],
  [
    'an engine cut short',
    {
      files: {
        'engine/slicecast-simd.wasm': () => Buffer.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 9]),
      },
    },
    '',
    /does not run here.*refuses/,
  ],
  [
    'a list of scenes that is not there',
    { files: { 'scenes/index.json': null } },
    '',
    /There is no scene to open/,
  ],
]) {
  test(`${what} is explained`, async (t) => {
    const { page } = await openPage(t, browser, { server, query, expectErrors: true });
    assert.match(await trouble(page), expected);
    assert.equal(await page.isVisible('#trouble-again'), true);
    assert.equal(await page.isVisible('#loading'), false);
  });
}

test('wasm with the wrong content type still works', async (t) => {
  const { page } = await openScene(t, browser, {
    server: { types: { 'engine/slicecast-simd.wasm': 'text/plain' } },
  });
  assert.equal((await player(page)).heading, 0);
});

test('if an engine crashes during play, an error is shown, and trying again starts a new one', async (t) => {
  const { page } = await openScene(t, browser, { expectErrors: true });
  await play(page);
  await page.evaluate(() => {
    const { requestAnimationFrame } = window;
    window.requestAnimationFrame = () => 0; // no picture comes any more
    setTimeout(() => {
      throw new WebAssembly.RuntimeError('unreachable');
    }, 100);
    window.mend = () => {
      window.requestAnimationFrame = requestAnimationFrame;
    };
  });
  assert.match(await trouble(page), /The engine has stopped.*unreachable/);
  await page.evaluate(() => window.mend());
  await page.click('#trouble-again');
  await inState(page, 'paused');
  await play(page);
  await untilPlayer(page, ({ steps }) => steps > 10);
});
