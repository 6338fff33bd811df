// <ray-caster> in shadow trees, iframes, under strict policies, on high-resolution and zoomed
// screens, and without scripts.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { hashHeadless } from './headless.mjs';
import { guestPage, kRoom, openGuest, ready, until, wait } from './guest-page.mjs';
import { serve } from './static-server.mjs';
import { roomFiles, roomPictures, roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kSized = '<ray-caster scene="room" size="320x200" style="width: 320px"></ray-caster>';
let expectedHash = null;
async function roomHash() {
  expectedHash ??= await hashHeadless('room.json', roomFiles(), 320, 200);
  return expectedHash;
}

// The element's picture, as pictureHash gives it.
const hashIn = (frame, selector = 'ray-caster') =>
  frame.evaluate(async (which) => {
    const canvas = document.querySelector(which).shadowRoot.querySelector('canvas');
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const digest = await crypto.subtle.digest('SHA-256', data);
    return `${canvas.width}x${canvas.height} ${[...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join('')}`;
  }, selector);

async function frameOf(page, name) {
  for (let tries = 0; tries < 200; ++tries) {
    const frame = page.frame(name);
    if (frame !== null) return frame;
    await wait(30);
  }
  throw new Error(`There is no frame ${name}.`);
}

// Another host, which allows others to read its files or not.
async function otherHost(t, files, isShared) {
  const other = await serve({
    files: { ...roomFiles(), ...files },
    headers: isShared ? { 'Access-Control-Allow-Origin': '*' } : {},
  });
  t.after(() => other.close());
  return other;
}

test('the picture is the same as elsewhere', async (t) => {
  const { page } = await openGuest(t, browser, { body: kSized });
  await ready(page);
  assert.equal(await hashIn(page), await roomHash());
});

test('in a shadow tree it can be played and left by keys', async (t) => {
  const { page } = await openGuest(t, browser, { body: '<div id="host"></div>' });
  await page.evaluate(async (markup) => {
    await customElements.whenDefined('ray-caster');
    const root = document.querySelector('#host').attachShadow({ mode: 'open' });
    root.innerHTML = markup;
    await root.querySelector('ray-caster').whenReady();
  }, kSized);
  await page.click('ray-caster', { position: { x: 160, y: 100 } });
  const state = () => document.querySelector('#host').shadowRoot.querySelector('ray-caster').state;
  await until(page, `(${state})() === 'playing'`);
  await page.keyboard.down('ArrowRight');
  await until(
    page,
    () =>
      document.querySelector('#host').shadowRoot.querySelector('ray-caster').currentView.heading >
      5,
  );
  await page.keyboard.up('ArrowRight');
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape');
  await until(page, `(${state})() === 'paused'`);
});

test('in an iframe of the same origin, and of another one', async (t) => {
  const inner = { 'inner.html': guestPage(kSized) };
  const other = await otherHost(t, inner, false);
  const { page } = await openGuest(t, browser, {
    script: '',
    body: `<iframe name="same" src="inner.html" title="one"></iframe><iframe name="other" src="${other.address}inner.html" title="another"></iframe>`,
    server: { files: inner },
  });
  for (const name of ['same', 'other']) {
    const frame = await frameOf(page, name);
    await ready(frame);
    assert.equal(await hashIn(frame), await roomHash());
    await frame.click('ray-caster', { position: { x: 100, y: 60 } });
    await until(frame, () => document.querySelector('ray-caster').state === 'playing');
    await page.keyboard.down('ArrowRight');
    await until(frame, () => document.querySelector('ray-caster').currentView.heading > 5);
    await page.keyboard.up('ArrowRight');
  }
});

test('in a sandboxed iframe, if the host shares its files', async (t) => {
  const other = await otherHost(t, { 'inner.html': guestPage(kSized) }, true);
  const { page } = await openGuest(t, browser, {
    script: '',
    body: `<iframe name="box" sandbox="allow-scripts" src="${other.address}inner.html" title="box"></iframe>`,
  });
  const frame = await frameOf(page, 'box');
  await ready(frame);
  assert.equal(await frame.evaluate(() => self.origin), 'null');
  assert.equal(await hashIn(frame), await roomHash());
  await frame.click('ray-caster', { position: { x: 100, y: 60 } });
  await until(frame, () => document.querySelector('ray-caster').state === 'playing');
});

test('in a sandboxed iframe, scenes of a host that does not share: the code cors', async (t) => {
  const closed = await otherHost(t, {}, false);
  const open = await otherHost(
    t,
    {
      'inner.html': guestPage(
        kSized.replace('scene="room"', `scene="${closed.address}scenes/room.json"`),
      ),
    },
    true,
  );
  const { page } = await openGuest(t, browser, {
    script: '',
    expectErrors: true,
    body: `<iframe name="box" sandbox="allow-scripts" src="${open.address}inner.html" title="box" width="500" height="400"></iframe>`,
  });
  const frame = await frameOf(page, 'box');
  await until(frame, () => document.querySelector('ray-caster').error?.code === 'cors');
  assert.match(await frame.textContent('.message'), /Access-Control-Allow-Origin/);
});

test("in a sandboxed iframe of a host that does not share, the script is refused, and the page's fallback stays", async (t) => {
  const closed = await otherHost(
    t,
    { 'inner.html': guestPage('<ray-caster scene="room">A room with four walls</ray-caster>') },
    false,
  );
  const { page } = await openGuest(t, browser, {
    script: '',
    expectErrors: true,
    body: `<iframe name="box" sandbox="allow-scripts" src="${closed.address}inner.html" title="box"></iframe>`,
  });
  const frame = await frameOf(page, 'box');
  await frame.waitForLoadState('load');
  await wait(200);
  assert.equal(await frame.isVisible('text=A room with four walls'), true);
  assert.equal(await frame.evaluate(() => customElements.get('ray-caster') === undefined), true);
});

const kStrict =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self'; connect-src 'self'; " +
  "require-trusted-types-for 'script'";
const kHearViolations = `window.violations = [];
document.addEventListener('securitypolicyviolation', (event) => {
  violations.push([event.effectiveDirective, event.blockedURI, event.sourceFile, event.lineNumber].join(' '));
});`;

test('under a strict policy nothing is refused', async (t) => {
  const { page, complaints } = await openGuest(t, browser, {
    body: '<ray-caster scene="room" controls poster="poster.png"></ray-caster><ray-caster id="bad" scene="broken" controls></ray-caster>',
    head: '<link rel="stylesheet" href="guest.css"><script src="violations.js"></script>',
    server: {
      headers: { 'Content-Security-Policy': kStrict },
      files: {
        'guest.css': 'ray-caster { width: 320px }',
        'violations.js': kHearViolations,
        'scenes/broken.json': '{"title": 3}',
        'poster.png': roomPictures()['red.png'],
      },
    },
  });
  await ready(page, 'ray-caster:not([id])');
  await page.click('ray-caster', { position: { x: 160, y: 100 } });
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
  await page.keyboard.down('KeyW');
  await wait(100);
  await page.keyboard.up('KeyW');
  await page.evaluate(() =>
    document.querySelector('ray-caster').snapshot({ width: 64, height: 40 }),
  );
  await until(page, () => document.querySelector('#bad').error?.code === 'scene');
  await wait(100);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  assert.deepEqual(complaints, []);
});

test("on a high-resolution screen the picture has the screen's pixels, unless a size is given", async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `${kRoom}${kSized.replace('<ray-caster', '<ray-caster id="sized"')}`,
    context: { deviceScaleFactor: 2 },
  });
  await ready(page);
  const sizes = await page.evaluate(() =>
    [...document.querySelectorAll('ray-caster')].map(({ picture }) => [
      picture.width,
      picture.height,
    ]),
  );
  assert.deepEqual(sizes[1], [320, 200]);
  const [width, height] = sizes[0];
  const [boxWidth, boxHeight] = await page.evaluate(() => {
    const { clientWidth, clientHeight } = document.querySelector('ray-caster');
    return [clientWidth, clientHeight];
  });
  assert.deepEqual([width, height], [2 * boxWidth, 2 * boxHeight]);
  const box = await page.evaluate(() => {
    const { width: w, height: h } = document
      .querySelector('#sized')
      .shadowRoot.querySelector('canvas')
      .getBoundingClientRect();
    return [w, h];
  });
  assert.deepEqual(box, [320, 200]);
});

test('zoomed in, it keeps its shape and its place, and can be played', async (t) => {
  const { page, context } = await openGuest(t, browser, {
    body: `<ray-caster scene="room" controls></ray-caster>`,
  });
  await ready(page);
  const session = await context.newCDPSession(page);
  for (const scale of [1.5, 3]) {
    // What the browser's zoom does: fewer and larger CSS pixels.
    await session.send('Emulation.setDeviceMetricsOverride', {
      width: Math.round(800 / scale),
      height: Math.round(600 / scale),
      deviceScaleFactor: scale,
      mobile: false,
    });
    await until(
      page,
      (wanted) => {
        const element = document.querySelector('ray-caster');
        const box = element.getBoundingClientRect();
        const canvas = element.shadowRoot.querySelector('canvas').getBoundingClientRect();
        return (
          window.devicePixelRatio === wanted &&
          box.right <= window.innerWidth &&
          Math.abs(canvas.width / canvas.height - 1.6) < 0.02 &&
          Math.abs(element.picture.width / element.picture.height - 1.6) < 0.03 &&
          document.documentElement.scrollWidth <= window.innerWidth
        );
      },
      scale,
    );
    await page.click('ray-caster', { position: { x: 100, y: 60 } });
    await until(page, () => document.querySelector('ray-caster').state === 'playing');
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    await until(page, () => document.querySelector('ray-caster').state === 'paused');
  }
});

const kFallback =
  '<ray-caster scene="room"><img id="poster" src="poster.png" alt="A red wall" width="64" height="64"><p id="text">A room with four walls</p></ray-caster>';
const kFallbackFiles = { files: { 'poster.png': roomPictures()['red.png'] } };

test("without JavaScript the poster and the page's text are shown", async (t) => {
  const { page } = await openGuest(t, browser, {
    body: kFallback,
    server: kFallbackFiles,
    context: { javaScriptEnabled: false },
  });
  assert.equal(await page.isVisible('#text'), true);
  assert.equal(await page.isVisible('#poster'), true);
});

test('with a scene they are not shown', async (t) => {
  const { page } = await openGuest(t, browser, { body: kFallback, server: kFallbackFiles });
  await ready(page);
  assert.equal(await page.isVisible('#text'), false);
});

test('an inline scene and rows of characters', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<ray-caster id="inline" size="320x200"><script type="application/json">${JSON.stringify(roomScene())}</script></ray-caster>
      <ray-caster id="rows"><script type="text/plain" data-rows>
        #####
        #>.b#
        #####
      </script></ray-caster>`,
  });
  await ready(page);
  assert.equal(await hashIn(page, '#inline'), await roomHash());
  assert.deepEqual(
    await page.evaluate(() => [
      document.querySelector('#rows').world.maps[0].width,
      document.querySelector('#rows').hits(0).hits[0].blueprint,
    ]),
    [5, 'stone wall'],
  );
});

test("after a redirect, pictures are relative to the scene's final address", async (t) => {
  const files = {
    'far/off/room.json': JSON.stringify(roomScene()),
    ...roomPictures('far/off/pictures/'),
  };
  const { page } = await openGuest(t, browser, {
    body: kSized.replace('scene="room"', 'scene="moved.json"'),
    server: { files, redirects: { 'moved.json': '/far/off/room.json' } },
  });
  await ready(page);
  assert.equal(await hashIn(page), await roomHash());
});

test('moved to another document and back, it works again', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `${kSized}<iframe id="inner" srcdoc="<p>empty</p>" title="inner"></iframe>`,
  });
  await ready(page);
  await page.evaluate(async () => {
    const element = document.querySelector('ray-caster');
    document.querySelector('#inner').contentDocument.body.append(element);
    await new Promise((resolve) => setTimeout(resolve, 100));
    document.querySelector('main').append(element);
    await element.whenReady();
  });
  assert.equal(await hashIn(page), await roomHash());
});

test('in a container as wide as its content, it has a default width, and shrinks', async (t) => {
  const room = (attributes = '') =>
    `<ray-caster scene="room" loading="eager" ${attributes}></ray-caster>`;
  const { page } = await openGuest(t, browser, {
    viewport: { width: 800, height: 600 },
    body: `
    <div style="display: flex"><p>Text</p>${room()}</div>
    <div style="float: left">${room('size="320x100"')}</div><div style="clear: both"></div>
    <div style="display: flex; width: 300px">${room('style="flex: 1"').repeat(2)}</div>
    <div style="display: grid; grid-template-columns: 114px 114px">${room('style="height: 150px"').repeat(2)}</div>`,
  });
  await ready(page);
  const boxes = await page.evaluate(() =>
    Array.from(document.querySelectorAll('ray-caster'), (element) =>
      element.getBoundingClientRect(),
    ).map(({ width, height }) => `${width}x${height}`),
  );
  assert.deepEqual(boxes, ['640x400', '320x100', '150x93.75', '150x93.75', '114x150', '114x150']);
});

test('in small boxes the bar keeps the main buttons, and is hidden in tiny ones', async (t) => {
  const widths = [300, 260, 180, 130, 90];
  const { page } = await openGuest(t, browser, {
    body: widths
      .map(
        (width) =>
          `<ray-caster scene="room" loading="eager" controls style="width: ${width}px; height: 140px"></ray-caster>`,
      )
      .join(''),
  });
  await ready(page);
  await until(page, () =>
    [...document.querySelectorAll('ray-caster')].every(
      ({ shadowRoot }) => shadowRoot.querySelector('.controls') !== null,
    ),
  );
  const shown = await page.evaluate(() =>
    Array.from(document.querySelectorAll('ray-caster'), ({ shadowRoot }) =>
      Array.from(shadowRoot.querySelectorAll('.controls button'))
        .filter((button) => button.checkVisibility())
        .map(({ dataset }) => dataset.name)
        .join(' '),
    ),
  );
  assert.deepEqual(shown, [
    'play reset overlay save share fullscreen',
    'play reset overlay fullscreen',
    'play reset fullscreen',
    'play fullscreen',
    '',
  ]);
});
