// What pages do to an element without meaning to: they are translated, printed, written with
// self-closed tags, bundled with small pictures as data:, opened as files; or have very many.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { kRoom, openGuest, ready, stateOf, until } from './guest-page.mjs';
import { roomFiles, roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kRows = `
##########
#........#
#>.......#
##########
`;
const kPlain = `<ray-caster style="width: 320px">${kRows}</ray-caster>`;

// As translators of browsers do it: each text in two elements.
const translate = () => {
  const texts = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) texts.push(walker.currentNode);
  for (const text of texts) {
    const [outer, inner] = ['font', 'font'].map((name) => document.createElement(name));
    text.replaceWith(outer);
    outer.append(inner);
    inner.append(text);
  }
};

test('rows stay a scene when the page is translated, before or after they have loaded', async (t) => {
  const { page } = await openGuest(t, browser, { body: kPlain });
  await ready(page);
  const before = await page.evaluate(() => document.querySelector('ray-caster').world);
  await page.evaluate(() => {
    window.states = [];
    document
      .querySelector('ray-caster')
      .addEventListener('statechange', ({ detail }) => window.states.push(detail.state));
  });
  await page.evaluate(translate);
  await ready(page);
  assert.deepEqual(await page.evaluate(() => window.states), []);
  // Another one that is translated first.
  const after = await page.evaluate(() => {
    const element = document.querySelector('ray-caster');
    const copy = element.cloneNode(true);
    element.replaceWith(copy);
    return copy.whenReady().then(() => copy.world);
  });
  assert.deepEqual(after, before);
});

const kNotes = '<h2>Next</h2><p>More about it.</p>';
const kFallback = '<p>A castle. <a href="castle.png">As an image</a></p>';
for (const [name, body, count] of [
  ['two self-closed tags', `<ray-caster scene="room" />Next<ray-caster scene="room" />`, 1],
  ['one, with the rest of the page in it', `<ray-caster scene="room" />${kNotes}`, 1],
  ['a closed tag before headings', `${kRoom}${kNotes}`, 0],
  ['other content in a closed tag', `<ray-caster scene="room">${kFallback}</ray-caster>`, 0],
  [
    'an article and another element at a place of the world',
    `<ray-caster scene="room"><article data-at="3,3,0.5"><h2>Here</h2>${kRoom}</article></ray-caster>`,
    0,
  ],
])
  test(`a warning tells of swallowed content: ${name}`, async (t) => {
    const { page } = await openGuest(t, browser, { body });
    await ready(page);
    const warnings = await page.evaluate(() =>
      [...document.querySelectorAll('ray-caster')].flatMap((element) => element.warnings),
    );
    assert.equal(warnings.length, count, JSON.stringify(warnings));
    for (const { attribute, message } of warnings) {
      assert.equal(attribute, 'content');
      assert.match(message, /write <ray-caster \.\.\.><\/ray-caster>, not <ray-caster \.\.\. \/>/);
    }
  });

test('an element that was never in sight prints a frame with its name, and loads', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<p style="height: 3000px">Read on.</p>
      <ray-caster scene="room" label="A room" style="width: 320px"></ray-caster>`,
  });
  await page.evaluate(() => customElements.whenDefined('ray-caster'));
  await until(page, () => document.querySelector('ray-caster').state === 'idle');
  await page.emulateMedia({ media: 'print' });
  const printed = await page.evaluate(() => {
    const box = document.querySelector('ray-caster').shadowRoot.querySelector('.box');
    return [getComputedStyle(box).outlineStyle, getComputedStyle(box, '::before').content];
  });
  assert.deepEqual(printed, ['solid', '"A room"']);
  await page.emulateMedia({ media: 'screen' });
  assert.equal(await stateOf(page), 'idle');
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
});

test("pictures as data: need no permission of the page's policy to connect", async (t) => {
  const scene = roomScene();
  for (const [name, file] of Object.entries(scene.textures)) {
    const bytes = roomFiles()[`scenes/${file}`];
    scene.textures[name] = `data:image/png;base64,${Buffer.from(bytes).toString('base64')}`;
  }
  const script = `
    await customElements.whenDefined('ray-caster');
    const scene = ${JSON.stringify(scene)};
    for (const [name, file] of Object.entries(scene.textures)) scene.textures[name] = new URL(file);
    document.querySelector('ray-caster').scene = scene;
    window.isSet = true;`;
  const { page } = await openGuest(t, browser, {
    body: '<ray-caster style="width: 320px"></ray-caster><script type="module" src="set.js"></script>',
    server: {
      files: { 'set.js': script },
      headers: {
        'Content-Security-Policy':
          "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; img-src 'self'; connect-src 'self'",
      },
    },
  });
  await until(page, () => window.isSet);
  await ready(page);
});

test('an element whose script runs in a page that was opened as a file says what to do', async (t) => {
  const { page } = await openGuest(t, browser, { expectErrors: true });
  await ready(page);
  const message = await page.evaluate(() => {
    const element = document.querySelector('ray-caster');
    element.scene = 'file:///somewhere/castle.json';
    return element.whenReady().catch((error) => error.message);
  });
  assert.match(message, /opened as a file may not read others; open it from a server/);
});

// ---- Many elements

const kMany = 150;
const kSmall = `<ray-caster loading="eager" style="width: 60px; height: 40px; display: inline-block">
####
#>.#
####
</ray-caster>`;

// Counts the engines' modules that were made at once, for one that wakes.
function countWakes() {
  window.wakes = 0;
  const { Instance } = WebAssembly;
  WebAssembly.Instance = function (program, imports) {
    if (imports.page !== undefined) window.wakes += 1;
    return new Instance(program, imports);
  };
}

// All that tells one game from another.
const everything = async () => {
  const element = document.getElementById('first');
  const { data } = element.pixels();
  const digest = await crypto.subtle.digest('SHA-256', data);
  return {
    player: element.player,
    view: element.currentView,
    options: element.optionList.map(({ name, value }) => `${name}=${value}`),
    cells: element.cells(),
    pixels: [...new Uint8Array(digest)].join(),
    picture: element.picture,
  };
};

test(`${kMany} elements have their pictures; those that rest are as they were`, async (t) => {
  const { page } = await openGuest(t, browser, {
    body: kPlain.replace('<ray-caster', '<ray-caster id="first"'),
    prepare: (newPage) => newPage.addInitScript(countWakes),
  });
  await ready(page);
  await page.evaluate(() => {
    const element = document.getElementById('first');
    element.record('rows');
    element.step(300, { forward: 1, turn: 0.3 });
    element.set('fov', 80);
    element.set('minimap', true);
    const [{ character }] = element.blueprints();
    element.setCell(null, 0, 3, 1, character);
    element.flying = true;
  });
  const before = await page.evaluate(everything);
  await page.evaluate(
    ([markup, count]) =>
      document.querySelector('main').insertAdjacentHTML('beforeend', markup.repeat(count)),
    [kSmall, kMany - 1],
  );
  await ready(page);
  const states = () => [...document.querySelectorAll('ray-caster')].map(({ state }) => state);
  assert.deepEqual(await page.evaluate(states), Array(kMany).fill('paused'));

  const canvas = "document.getElementById('first').shadowRoot.querySelector('canvas')";
  const isBlack = `${canvas}.getContext('2d').getImageData(0, 0, 320, 200).data.every((value, at) => at % 4 === 3 || value === 0)`;
  const wakes = await page.evaluate(() => window.wakes);
  assert.equal(await page.evaluate(isBlack), false);
  assert.equal(await page.evaluate(() => document.getElementById('first').memory > 0), true);
  assert.equal(await page.evaluate(() => window.wakes), wakes, 'it rests, with its picture');
  assert.deepEqual(await page.evaluate(everything), before);
  assert.equal(await page.evaluate(() => window.wakes), wakes + 1, 'it woke once');
  const recorded = await page.evaluate(() => document.getElementById('first').takeRecording());
  assert.match(recorded, /^end 300 /m);

  // All canvases come back after a restart of the graphics process.
  await page.evaluate(() => {
    for (const { shadowRoot } of document.querySelectorAll('ray-caster')) {
      const one = shadowRoot.querySelector('canvas');
      one.getContext('2d').reset();
      one.dispatchEvent(new Event('contextrestored'));
    }
  });
  await until(page, () =>
    [...document.querySelectorAll('ray-caster')].every(({ shadowRoot }) => {
      const one = shadowRoot.querySelector('canvas');
      const { data } = one.getContext('2d').getImageData(0, 0, one.width, one.height);
      return data.some((value, at) => at % 4 !== 3 && value > 0);
    }),
  );

  // One that rests plays when somebody wants it.
  await page.evaluate(() => {
    const last = [...document.querySelectorAll('ray-caster')].at(-1);
    last.scrollIntoView();
    last.play();
  });
  await until(page, () => [...document.querySelectorAll('ray-caster')].at(-1).player.steps > 20);
  assert.equal((await page.evaluate(states)).filter((state) => state === 'error').length, 0);
});
