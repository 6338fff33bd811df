// Every error code in web/element/faults.js, provoked for real: the element shows the error and
// sends the event with its code.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { openGuest, ready, until } from './guest-page.mjs';
import { roomFiles, roomPictures, roomScene } from './room.mjs';
import { serve } from './static-server.mjs';
import { errorCodes } from '../../web/element/faults.js';

let browser;
let other; // another host, which shares nothing
const provoked = new Set();
before(async () => {
  browser = await launch();
  other = await serve({ files: roomFiles() });
});
after(async () => {
  await browser.close();
  await other.close();
});

// The detail of the event `error` and what the element shows; both must agree.
async function troubleOf(page, selector = 'ray-caster') {
  const told = await until(
    page,
    (which) => window.told?.find(({ selector: at }) => document.querySelector(which).matches(at)),
    selector,
  );
  const shown = await page.evaluate((which) => {
    const element = document.querySelector(which);
    const message = element.shadowRoot.querySelector('[part~="message"]');
    return {
      text: message.innerText,
      isVisible: message.checkVisibility(),
      role: message.getAttribute('role'),
      state: element.state,
      error: element.error,
    };
  }, selector);
  provoked.add(told.detail.code);
  assert.equal(shown.isVisible, true);
  assert.equal(shown.role, 'alert');
  assert.equal(shown.state, 'error');
  assert.deepEqual(shown.error, told.detail);
  assert.ok(shown.text.includes(told.detail.message), shown.text);
  assert.ok(told.detail.message.endsWith(errorCodes[told.detail.code].remedy), told.detail.message);
  assert.equal(told.bubbles, false);
  return { ...told.detail, text: shown.text };
}

// Hears all errors, from the beginning on.
function listen() {
  window.told = [];
  document.addEventListener(
    'error',
    ({ target, detail, bubbles }) => {
      if (target.localName === 'ray-caster')
        window.told.push({
          selector: target.id === '' ? 'ray-caster' : `#${target.id}`,
          detail,
          bubbles,
        });
    },
    { capture: true },
  );
}

function openTroubled(t, options, inBrowser = browser) {
  return openGuest(t, inBrowser, {
    expectErrors: true,
    prepare: (page) => page.addInitScript(listen),
    ...options,
  });
}

const withPolicy = (policy) => ({ headers: { 'Content-Security-Policy': policy } });
const gone = 'http://localhost:9';

for (const [what, code, expected, options] of [
  [
    'a scene that is not there',
    'fetch',
    /scenes\/nowhere\.json: the server answers 404/,
    { body: '<ray-caster scene="nowhere"></ray-caster>' },
  ],
  [
    'a server that does not answer',
    'fetch',
    /does not answer/,
    { body: `<ray-caster scene="${gone}/room.json"></ray-caster>` },
  ],
  [
    'an engine that is not there',
    'fetch',
    /slicecast-simd\.wasm: the server answers 404/,
    { server: { files: { 'engine/slicecast-simd.wasm': null } } },
  ],
  [
    'a scene of a host that does not share',
    'cors',
    /does not allow pages of other origins/,
    () => ({ body: `<ray-caster scene="${other.address}scenes/room.json"></ray-caster>` }),
  ],
  [
    'a page in the place of the engine',
    'mime',
    /found "<!doctype html>/,
    {
      server: { files: { 'engine/slicecast-simd.wasm': '<!doctype html><title>Welcome</title>' } },
    },
  ],
  [
    'a page in the place of the scene',
    'mime',
    /room\.json: the server answers with a web page.*pictures and tours must be served in http/,
    { server: { files: { 'scenes/room.json': '\n<!DOCTYPE html><title>Welcome</title>' } } },
  ],
  [
    'a policy without WebAssembly',
    'csp',
    /does not allow WebAssembly.*'wasm-unsafe-eval'/s,
    { server: withPolicy("script-src 'self'") },
  ],
  [
    'a policy without fetches',
    'csp',
    /connect-src/,
    { server: withPolicy("script-src 'self' 'wasm-unsafe-eval'; connect-src 'none'") },
  ],
  [
    'a policy without that host',
    'csp',
    /connect-src/,
    () => ({
      body: `<ray-caster scene="${other.address}scenes/room.json"></ray-caster>`,
      server: withPolicy("connect-src 'self'"),
    }),
  ],
  [
    'an engine cut short',
    'engine',
    /refuses .*slicecast-simd\.wasm/,
    {
      server: {
        files: {
          'engine/slicecast-simd.wasm': () => Buffer.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 9]),
        },
      },
    },
  ],
  [
    'no scene at all',
    'address',
    /Found nothing, expected scene="castle"/,
    { body: '<ray-caster></ray-caster>' },
  ],
  [
    'a tour that is not there',
    'tour',
    /tours\/nowhere\.txt: the server answers 404/,
    { body: '<ray-caster tour="nowhere"></ray-caster>' },
  ],
  [
    'a tour that is none',
    'tour',
    /mine\.txt/,
    {
      body: '<ray-caster tour="./mine.txt"></ray-caster>',
      server: { files: { 'mine.txt': 'walk about\n' } },
    },
  ],
]) {
  test(`${what}: ${code}`, async (t) => {
    const { page } = await openTroubled(t, typeof options === 'function' ? options() : options);
    const { code: found, message } = await troubleOf(page);
    assert.equal(found, code, message);
    assert.match(message, expected);
  });
}

test('a bad scene: all of its faults, each with its place', async (t) => {
  const scene = roomScene();
  scene.maps[0].levels[0][2] = '#..?..#';
  scene.maps[0].floor = 'gras';
  const { page } = await openTroubled(t, {
    server: { files: { 'scenes/room.json': JSON.stringify(scene, null, 1) } },
  });
  const { code, title, faults, text } = await troubleOf(page);
  assert.equal(code, 'scene');
  assert.equal(title, '2 faults in room.json');
  const places = faults.map(({ pointer, row, character }) => [pointer, row, character]);
  assert.deepEqual(places.sort(), [
    ['/maps/0/floor', -1, -1],
    ['/maps/0/levels/0/2', 2, 3],
  ]);
  for (const { place, found, expected } of faults) {
    assert.match(place, /^room\.json:\d+:\d+$/);
    for (const part of [place, found, expected])
      assert.ok(text.includes(part), `${part} in ${text}`);
  }
});

test("a missing shipped scene suggests the nearest name; the error's message lists all faults", async (t) => {
  const scene = roomScene();
  scene.textures.red = 'pictures/none.png';
  const { page } = await openTroubled(t, {
    body: '<ray-caster id="a" scene="rom"></ray-caster><ray-caster id="b" scene="bad"></ray-caster>',
    server: { files: { 'scenes/bad.json': JSON.stringify({ ...scene, start: 3, maps: [] }) } },
  });
  const { code, message } = await troubleOf(page, '#a');
  assert.equal(code, 'fetch');
  assert.match(message, /rom\.json: the server answers 404.*Did you mean 'room'\?/);
  const { faults } = await troubleOf(page, '#b');
  assert.ok(faults.length > 1);
  const error = await page.evaluate(() =>
    document
      .getElementById('b')
      .whenReady()
      .catch(({ message: text }) => text),
  );
  for (const { place, found, expected } of faults)
    assert.ok(error.includes(`\n  ${place}: found ${found}, expected ${expected}`), error);
});

test('missing pictures, invalid JSON, and rows with faults: scene', async (t) => {
  const { page } = await openTroubled(t, {
    body: `<ray-caster id="one" loading="eager" scene="room"></ray-caster>
      <ray-caster id="two" loading="eager"><script type="application/json">{ "title": </script></ray-caster>
      <ray-caster id="three" loading="eager"><script type="text/plain" data-rows>
#?#
#>#</script></ray-caster>`,
    server: { files: { 'scenes/pictures/red.png': null } },
  });
  const one = await troubleOf(page, '#one');
  assert.match(one.faults[0].pointer, /textures\/red/);
  assert.match(
    one.faults[0].found,
    /"pictures\/red\.png", which could not be read: the server answers 404/,
  );
  assert.match((await troubleOf(page, '#two')).faults[0].found, /./);
  assert.equal((await troubleOf(page, '#three')).faults[0].place, 'rows:1:2');
});

test('shipped pictures that are not beside a scene come from the package; others are told', async (t) => {
  const scene = roomScene({ folder: '../textures/' });
  const files = { ...roomPictures('textures/'), 'my/worlds/far.json': JSON.stringify(scene) };
  scene.textures.red = '../textures/none.png';
  files['my/worlds/bad.json'] = JSON.stringify(scene);
  const { page } = await openTroubled(t, {
    body: `<ray-caster id="far" loading="eager" scene="my/worlds/far.json"></ray-caster>
      <ray-caster id="bad" loading="eager" scene="my/worlds/bad.json"></ray-caster>`,
    server: { files },
  });
  const { faults } = await troubleOf(page, '#bad');
  assert.equal(faults.length, 1);
  assert.match(faults[0].found, /none\.png", which could not be read: the server answers 404/);
  assert.equal(
    await page.evaluate(async () => (await document.getElementById('far').whenReady()).title),
    'The coloured room',
  );
});

test("pictures of a host that does not share: the scene's fault says so", async (t) => {
  const pictures = new URL('scenes/pictures/', other.address).href;
  const shared = await serve({
    files: { 'far.json': () => JSON.stringify(roomScene()) },
    headers: { 'Access-Control-Allow-Origin': '*' },
  });
  t.after(() => shared.close());
  const { page } = await openTroubled(t, {
    body: `<ray-caster scene="${shared.address}far.json"></ray-caster>`,
    prepare: async (opened) => {
      await opened.addInitScript(listen);
      await opened.route('**/pictures/*.png', (route) => {
        const elsewhere = pictures + route.request().url().split('/').pop();
        return route.fulfill({
          status: 302,
          headers: { Location: elsewhere, 'Access-Control-Allow-Origin': '*' },
        });
      });
    },
  });
  assert.match((await troubleOf(page)).faults[0].found, /does not allow pages of other origins/);
});

test('a host that only a redirect has named is not asked a second time', async (t) => {
  other.asked.length = 0;
  const { page } = await openTroubled(t, {
    body: '<ray-caster scene="scenes/moved.json"></ray-caster>',
    server: { redirects: { 'scenes/moved.json': `${other.address}scenes/room.json` } },
  });
  assert.match((await troubleOf(page)).message, /does not allow pages of other origins/);
  assert.equal(other.asked.length, 1);

  const half = await serve({
    files: roomFiles(),
    headersOf: (name) => (name.endsWith('.json') ? { 'Access-Control-Allow-Origin': '*' } : {}),
  });
  t.after(() => half.close());
  const { page: second } = await openTroubled(t, {
    body: '<ray-caster scene="scenes/moved.json"></ray-caster>',
    server: { redirects: { 'scenes/moved.json': `${half.address}scenes/room.json` } },
  });
  const { faults } = await troubleOf(second);
  assert.match(faults[0].found, /does not answer, or does not let this page read its answer/);
  const pictures = half.asked.filter((name) => name.endsWith('.png'));
  assert.ok(pictures.length > 1);
  assert.equal(new Set(pictures).size, pictures.length);
});

test('no memory for the engine: engine', async (t) => {
  const { page } = await openTroubled(t, {
    prepare: async (opened) => {
      await opened.addInitScript(listen);
      // More memory than there is.
      await opened.addInitScript(() => {
        const instantiate = WebAssembly.instantiate.bind(WebAssembly);
        WebAssembly.instantiate = () => {
          WebAssembly.instantiate = instantiate;
          return Promise.reject(
            new RangeError(
              'WebAssembly.instantiate(): Out of memory: Cannot allocate Wasm memory for new instance',
            ),
          );
        };
      });
    },
  });
  const { code, message } = await troubleOf(page);
  assert.equal(code, 'engine');
  assert.match(message, /memory/i);
  // Trying again may succeed.
  await page.getByRole('button', { name: 'Try again' }).click();
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
});

test('methods before there is a scene: not-ready', async (t) => {
  const { page } = await openTroubled(t, {
    body: '<p style="height: 4000px">Read on.</p><ray-caster scene="room"></ray-caster>',
  });
  const thrown = await page.evaluate(async () => {
    await customElements.whenDefined('ray-caster');
    const element = document.querySelector('ray-caster');
    const codes = [];
    for (const [name, ...values] of [
      ['reset'],
      ['step'],
      ['set', 'fov', 75],
      ['get', 'fov'],
      ['look', '1,1,1,0'],
      ['hits', 0],
      ['trace', 0],
      ['trace'],
    ]) {
      try {
        element[name](...values);
        codes.push(`${name} went well`);
      } catch (error) {
        codes.push(error.code);
      }
    }
    codes.push(await element.snapshot().catch((error) => error.code));
    return codes;
  });
  assert.deepEqual(new Set(thrown), new Set(['not-ready']));
  provoked.add('not-ready');
});

test('set() with a bad value: an Error with the code option, and the scene goes on', async (t) => {
  const { page } = await openTroubled(t, {});
  await ready(page);
  assert.deepEqual(
    await page.evaluate(() =>
      ['colour', 'fov'].map((name) => {
        try {
          return document.querySelector('ray-caster').set(name, 'wide');
        } catch (error) {
          return error.code;
        }
      }),
    ),
    ['option', 'option'],
  );
  assert.equal(await page.evaluate(() => document.querySelector('ray-caster').state), 'paused');
  provoked.add('option');
});

test('recovery from errors: trying again, another address', async (t) => {
  let isThere = false;
  const { page } = await openTroubled(t, {
    server: {
      files: {
        'scenes/room.json': () => (isThere ? JSON.stringify(roomScene()) : null),
        'engine/slicecast-simd.wasm': () =>
          isThere
            ? readFileSync(new URL('../../build/web/engine/slicecast-simd.wasm', import.meta.url))
            : null,
      },
    },
  });
  await troubleOf(page);
  isThere = true;
  await page.getByRole('button', { name: 'Try again' }).click();
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  assert.equal(await page.evaluate(() => document.querySelector('ray-caster').error), null);

  for (const [name, bad, good] of [
    ['scene', 'nowhere', 'other'],
    ['scene', 'http://[', 'room'],
  ]) {
    await page.evaluate(
      ([attribute, value]) => {
        window.told.length = 0;
        document.querySelector('ray-caster').setAttribute(attribute, value);
      },
      [name, bad],
    );
    await troubleOf(page);
    await page.evaluate(
      ([attribute, value]) => document.querySelector('ray-caster').setAttribute(attribute, value),
      [name, good],
    );
    await until(
      page,
      () =>
        document.querySelector('ray-caster').state === 'paused' &&
        document.querySelector('ray-caster').error === null,
    );
  }
});

test('steering.js fails to load: reported when somebody wants to play, not to passers-by', async (t) => {
  let isThere = false;
  const { page } = await openTroubled(t, {
    server: {
      files: {
        'ray-caster-steering.js': () =>
          isThere
            ? readFileSync(new URL('../../build/web/ray-caster-steering.js', import.meta.url))
            : null,
      },
    },
  });
  await ready(page);
  await page.hover('ray-caster');
  await page.waitForTimeout(300);
  assert.equal(await page.evaluate(() => document.querySelector('ray-caster').state), 'paused');
  await page.click('ray-caster');
  const { code, message } = await troubleOf(page);
  assert.equal(code, 'fetch', message);
  assert.match(message, /ray-caster-steering\.js: the server answers 404/);
  isThere = true;
  await page.getByRole('button', { name: 'Try again' }).click();
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  await page.click('ray-caster');
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
});

for (const [what, code, expected, server] of [
  [
    'not there',
    'fetch',
    /ray-caster-rows\.js: the server answers 404/,
    { files: { 'ray-caster-rows.js': null } },
  ],
  [
    'sent as something else',
    'mime',
    /ray-caster-rows\.js: the server sends it as text\/plain/,
    { types: { 'ray-caster-rows.js': 'text/plain' } },
  ],
]) {
  test(`the script for rows is ${what}: ${code}`, async (t) => {
    const { page } = await openTroubled(t, {
      body: '<ray-caster><script type="text/plain" data-rows>#>#</script></ray-caster>',
      server,
    });
    const { code: found, message } = await troubleOf(page);
    assert.equal(found, code, message);
    assert.match(message, expected);
  });
}

async function launchWith(t, flags) {
  const special = await launch([`--js-flags=${flags}`]);
  t.after(() => special.close());
  return special;
}

// As in browsers' strict modes.
test("no WebAssembly: no-webassembly, and the page's fallback", async (t) => {
  const body =
    '<ray-caster scene="room" style="width: 400px"><p id="text">A room with four walls</p></ray-caster>';
  const { page } = await openTroubled(t, { body }, await launchWith(t, '--jitless'));
  const { code } = await troubleOf(page);
  assert.equal(code, 'no-webassembly');
  assert.equal(await page.isVisible('#text'), true);
});

test('no SIMD: the other build, without a message', async (t) => {
  const { page, server } = await openTroubled(
    t,
    {},
    await launchWith(t, '--no-enable-sse4-1 --no-enable-ssse3'),
  );
  await ready(page);
  assert.deepEqual(await page.evaluate(() => window.told), []);
  assert.deepEqual(server.asked.filter((path) => path.startsWith('engine/')).sort(), [
    'engine/slicecast-scalar.wasm',
  ]);
});

test('every code has been provoked', () => {
  assert.deepEqual([...provoked].sort(), Object.keys(errorCodes).sort());
});
