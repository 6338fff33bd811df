// The engine comes in two parts: the first picture needs only the first one.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { root, shippedScenes } from '../wasm/load.mjs';
import { launch } from './browser.mjs';
import { openGuest, ready, until, wait } from './guest-page.mjs';

const kLater = 'engine/slicecast-simd-later.wasm';
const names = shippedScenes.map((path) => path.replace(/^.*\/|\.json$/g, ''));

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Whether the element has drawn: its canvas is not empty.
function isDrawn() {
  const canvas = document.querySelector('ray-caster').shadowRoot.querySelector('canvas');
  if (canvas === null || canvas.width === 0) return false;
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, 1);
  return data[3] === 255;
}

// A page with one element, and a server that keeps the later part until `release` is called.
async function openHeld(t, attributes, prepare) {
  let release;
  const held = new Promise((resolve) => {
    release = resolve;
  });
  const { page, server } = await openGuest(t, browser, {
    body: `<ray-caster loading="eager" ${attributes} style="width: 320px"></ray-caster>`,
    ...(prepare && { prepare }),
    server: { mayGo: (name) => (name === kLater ? held : undefined) },
  });
  t.signal.addEventListener('abort', release);
  return { page, server, release };
}

for (const name of names) {
  test(`the first picture of ${name} comes without the later part`, async (t) => {
    const { page, server, release } = await openHeld(t, `scene="${name}"`);
    await until(page, isDrawn);
    assert.equal(
      await page.evaluate(() => document.querySelector('ray-caster').state),
      'loading',
      'ready only when it is whole',
    );
    release();
    await ready(page);
    assert.equal(server.asked.filter((asked) => asked === kLater).length, 1, 'asked for once');
  });
}

test('a first picture that needs the later part waits for it', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: '<ray-caster scene="room" options="method=classic" style="width: 320px"></ray-caster>',
    prepare: (opened) =>
      opened.addInitScript(() => {
        const { open } = XMLHttpRequest.prototype;
        window.waitedFor = [];
        XMLHttpRequest.prototype.open = function (method, address, ...more) {
          window.waitedFor.push(address);
          return open.call(this, method, address, ...more);
        };
      }),
  });
  await ready(page);
  const waitedFor = await page.evaluate(() => window.waitedFor);
  assert.equal(waitedFor.length, 1, 'while the page stood still');
  assert.ok(waitedFor[0].endsWith(kLater), waitedFor[0]);
  assert.ok(await until(page, isDrawn));
});

// Its pictures are those of the element's package, wherever the page is.
test('a scene that names shipped pictures waits for their table and the later part', async (t) => {
  const scene = JSON.stringify({
    title: 'Named',
    blueprints: { wall: { faces: { all: 'brick', top: 'lava' } } },
    legend: { '#': 'wall' },
    maps: [{ name: 'room', levels: [['####', '#..#', '####']], floor: 'grass' }],
    start: { x: 1.5, y: 1.5 },
  });
  const { page, server } = await openGuest(t, browser, {
    body: `<ray-caster loading="eager" style="width: 320px"><script type="application/json">${scene}</script></ray-caster>`,
    prepare: (opened) =>
      opened.addInitScript(() => {
        window.XMLHttpRequest = class {
          constructor() {
            throw new Error('the page stood still');
          }
        };
      }),
  });
  await ready(page);
  assert.ok(await until(page, isDrawn));
  for (const file of [
    'pictures.json',
    'textures/brick.png',
    'textures/grass.png',
    'sheets/lava.png',
  ])
    assert.equal(server.asked.filter((asked) => asked === file).length, 1, file);
  const unlike = scene.replace('"lava"', '"lavva"');
  const { faults } = await page.evaluate(
    (text) => document.querySelector('ray-caster').update(text),
    unlike,
  );
  assert.match(faults[0].expected, /did you mean "lava"/);
  assert.equal(faults[0].pointer, '/blueprints/wall/faces/top');
});

test('two elements share both parts', async (t) => {
  const one = '<ray-caster scene="room" style="width: 320px"></ray-caster>';
  const { page, server } = await openGuest(t, browser, { body: one + one });
  await ready(page);
  assert.equal(server.asked.filter((asked) => asked === kLater).length, 1);
});

test('a browser that compiles only while the page goes on gets both parts first', async (t) => {
  const { page, server, release } = await openHeld(t, 'scene="room"', (opened) =>
    opened.addInitScript(() => {
      const { Module } = WebAssembly;
      WebAssembly.Module = class extends Module {
        constructor(bytes) {
          if (bytes.byteLength > 4096) throw new RangeError('Not on the main thread');
          super(bytes);
        }
      };
    }),
  );
  while (!server.asked.includes(kLater)) await wait(30);
  await wait(500);
  assert.equal(await page.evaluate(isDrawn), false, 'nothing before the later part');
  release();
  await ready(page);
  assert.equal(server.asked.filter((asked) => asked === kLater).length, 1);
});

test('a later part that is not there is explained', async (t) => {
  const { page } = await openGuest(t, browser, {
    server: { files: { [kLater]: null } },
    expectErrors: true,
  });
  const message = await page.evaluate(
    () =>
      new Promise((resolve) => {
        const element = document.querySelector('ray-caster');
        element.addEventListener('error', ({ detail }) => resolve(detail.message ?? `${detail}`));
        element.whenReady().catch(({ message }) => resolve(message));
      }),
  );
  assert.match(message, /slicecast-simd-later\.wasm: the server answers 404/);
});

test('a later part of another release is not put in', async (t) => {
  const other = readFileSync(join(root, 'build/web', kLater));
  other[other.length - 1] ^= 1; // of the section that both parts must have
  const { page } = await openGuest(t, browser, {
    server: { files: { [kLater]: other } },
    expectErrors: true,
  });
  const message = await page.evaluate(() =>
    document
      .querySelector('ray-caster')
      .whenReady()
      .catch(({ message }) => message),
  );
  assert.match(message, /two parts are of different releases\. Reload the page/);
});
