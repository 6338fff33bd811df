// axe-core finds no violations in any state of <ray-caster>.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { openGuest, ready, until } from './guest-page.mjs';
import { roomPictures } from './room.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const kPhone = {
  viewport: { width: 390, height: 844 },
  context: { isMobile: true, hasTouch: true },
};

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// One line for each violation of any of axe's rules, best practices included.
async function complaintsOf(page) {
  await page.addScriptTag({ path: kAxe });
  return page.evaluate(async () => {
    const { violations, passes } = await window.axe.run(document);
    if (!passes.some(({ nodes }) => nodes.some(({ target }) => Array.isArray(target[0]))))
      return ['axe has not looked into the element'];
    return violations.flatMap(({ id, nodes }) =>
      nodes.map(
        ({ target, failureSummary }) => `${id}: ${target.flat().join(' > ')}: ${failureSummary}`,
      ),
    );
  });
}

const element = (attributes = '', content = '') =>
  `<ray-caster scene="room" controls ${attributes} style="width: 480px">${content}</ray-caster>`;
const hasBar = (page) =>
  until(
    page,
    () =>
      document.querySelector('ray-caster').shadowRoot.querySelector('.controls button') !== null,
  );
const inState = (page, state) =>
  until(page, (wanted) => document.querySelector('ray-caster').state === wanted, state);

async function play(page) {
  await ready(page);
  await page.click('ray-caster', { position: { x: 200, y: 100 } });
  await inState(page, 'playing');
}

for (const [what, options, arrive] of [
  [
    'idle, out of view',
    { body: `<p style="height: 4000px">Read on.</p>${element()}` },
    (page) => inState(page, 'idle'),
  ],
  [
    'idle, with a poster',
    {
      body: `<p style="height: 4000px">Read on.</p>${element('poster="poster.png" label="A room"')}`,
      server: { files: { 'poster.png': roomPictures()['red.png'] } },
    },
    (page) => inState(page, 'idle'),
  ],
  [
    'loading',
    { body: element(), prepare: (page) => page.route('**/*.wasm', () => {}) },
    (page) => inState(page, 'loading'),
  ],
  [
    'paused',
    { body: element() },
    async (page) => {
      await ready(page);
      await hasBar(page);
    },
  ],
  [
    'paused, three with names of their own',
    { body: element() + element('label="The same room"') + element('label="And again"') },
    ready,
  ],
  ['without controls', { body: element().replace('controls', '') }, ready],
  ['played', { body: element() }, play],
  ['played without keys', { body: element('keys="none"') }, play],
  ['asked to play', { body: element('autoplay') }, (page) => inState(page, 'playing')],
  [
    'left again',
    { body: element() },
    async (page) => {
      await play(page);
      await page.keyboard.press('Escape');
      await page.keyboard.press('Escape');
      await inState(page, 'paused');
    },
  ],
  [
    'played by a finger',
    { body: element(), ...kPhone },
    async (page) => {
      await ready(page);
      await page.tap('ray-caster');
      await inState(page, 'playing');
    },
  ],
  [
    'the sheet of keys',
    { body: element() },
    async (page) => {
      await play(page);
      await page.keyboard.press('h');
      await inState(page, 'paused');
    },
  ],
  [
    'an error to try again',
    { body: element().replace('"room"', '"nowhere"'), expectErrors: true },
    (page) => inState(page, 'error'),
  ],
  [
    'a scene with many faults',
    {
      body: element().replace('"room"', '"broken"'),
      server: {
        files: {
          'scenes/broken.json': JSON.stringify({ title: 3, maps: [1, 2, 3, 4, 5], textures: 4 }),
        },
      },
    },
    (page) => inState(page, 'error'),
  ],
  [
    'a policy that allows no engine',
    {
      body: element('', 'A room with <a href="#x">four walls</a>'),
      expectErrors: true,
      server: { headers: { 'Content-Security-Policy': "script-src 'self' 'unsafe-inline'" } },
    },
    (page) => inState(page, 'error'),
  ],
]) {
  test(what, async (t) => {
    const { page } = await openGuest(t, browser, options);
    await page.evaluate(() => customElements.whenDefined('ray-caster'));
    await arrive(page);
    assert.deepEqual(await complaintsOf(page), []);
  });
}

test('axe does find violations where there are some', async (t) => {
  const { page } = await openGuest(t, browser, { body: element() });
  await ready(page);
  await hasBar(page);
  await page.evaluate(() =>
    document
      .querySelector('ray-caster')
      .shadowRoot.querySelector('button')
      .removeAttribute('aria-label'),
  );
  assert.match((await complaintsOf(page)).join(), /button-name/);
});
