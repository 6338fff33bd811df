// The tutorial's pages: each chapter can be read on a phone, its figures are drawn under the strict
// policy that the pages promise, it is light, and its numbers follow its figures.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { frames, launch, openPage } from './browser.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const kSite = fileURLToPath(new URL('../../build/web/', import.meta.url));
const kChapters = readdirSync(new URL('../../web/learn/', import.meta.url))
  .flatMap((folder) => /^\d\d-([a-z-]+)$/.exec(folder)?.[1] ?? [])
  .sort();
const kPolicy =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:";
const kPhone = { width: 360, height: 740 };
const kDesktop = { width: 1280, height: 900 };
// Gzipped, of a first load; 224 KB of them are the engine and the element.
const kMostBytes = 350_000;
const kAfterFirstPicture = /(-later\.wasm|ray-caster-more\.js)$/;
const kSmallestText = 12; // CSS pixels, on a phone

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// The pages' policy; the frame of the reader's programs has its own.
const strict = (name) => (name.endsWith('run.html') ? {} : { 'Content-Security-Policy': kPolicy });

function openChapter(t, name, options = {}) {
  return openPage(t, browser, {
    query: `learn/${name}.html`,
    server: { headersOf: strict },
    viewport: kDesktop,
    ...options,
  });
}

// Scrolls to each figure in turn, as a reader does, until all are drawn.
async function seeAll(page) {
  const count = await page.locator('ray-caster').count();
  for (let index = 0; index < count; ++index) {
    const caster = page.locator('ray-caster').nth(index);
    if (!(await caster.isVisible())) continue;
    await caster.scrollIntoViewIfNeeded();
    await caster.evaluate((element) => element.whenReady());
  }
  await frames(page);
}

// Answers each exercise wrongly, then rightly.
async function answerAll(page) {
  assert.ok((await page.locator('.exercise').count()) > 1, 'exercises');
  for (const form of await page.locator('form.reply').all()) {
    const right = Number(await form.getAttribute('data-answer'));
    const tolerance = Number(await form.getAttribute('data-tolerance'));
    await form.locator('input').fill(String(right + 2 * tolerance + 1));
    await form.locator('button').click();
    assert.match(await form.locator('output').textContent(), /too large/);
    await form.locator('input').fill(String(right));
    await form.locator('button').click();
    assert.match(await form.locator('output').textContent(), /Right/);
  }
}

test('there are 25 chapters, and the map leads to all', async (t) => {
  assert.equal(kChapters.length, 25);
  const { page } = await openPage(t, browser, {
    query: 'learn/index.html',
    server: { headersOf: strict },
    viewport: kPhone,
  });
  const links = await page.$$eval('main a', (all) => all.map((link) => link.getAttribute('href')));
  for (const name of kChapters) assert.ok(links.includes(`${name}.html`), name);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), kPhone.width);
});

for (const name of kChapters) {
  test(`${name}: light, drawn, readable on a phone, checks answers, and axe finds nothing`, async (t) => {
    const { page, server } = await openChapter(t, name, {
      viewport: kPhone,
      context: { colorScheme: 'dark', isMobile: true, hasTouch: true },
    });
    await page.waitForLoadState('networkidle');
    const files = [...new Set(server.asked)].filter((file) => !kAfterFirstPicture.test(file));
    const bytes = files.reduce((sum, file) => sum + gzipped(file), 0);
    t.diagnostic(`${name}: ${bytes} bytes, ${files.length} files`);
    assert.ok(bytes <= kMostBytes, `${bytes} bytes: ${files.join(', ')}`);

    await seeAll(page);
    // A phone widens the window for a page that is too wide.
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    assert.equal(wide, kPhone.width, 'it scrolls sideways');
    assert.deepEqual(await page.evaluate(flatPictures), []);
    assert.deepEqual(await page.evaluate(smallTexts, kSmallestText), []);
    await answerAll(page);
    await page.evaluate(readFileSync(kAxe, 'utf8'));
    const { violations } = await page.evaluate(() =>
      window.axe.run(document, { resultTypes: ['violations'] }),
    );
    assert.deepEqual(
      violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join('; ')}`),
      [],
    );
  });
}

test('without JavaScript a chapter is text with its pictures', async (t) => {
  for (const name of [kChapters[0], 'mirrors']) {
    const { page } = await openChapter(t, name, { context: { javaScriptEnabled: false } });
    const pictures = await page.locator('.figure img').all();
    assert.ok(pictures.length > 0, name);
    for (const picture of pictures) {
      await picture.scrollIntoViewIfNeeded();
      assert.ok((await picture.boundingBox()).width > 200, name);
    }
    assert.ok((await page.locator('.figure svg').count()) > 0, 'drawings');
    assert.equal(await page.locator('[data-needs-script]:visible').count(), 0);
  }
});

test('the search finds a section by keys alone', async (t) => {
  const { page } = await openChapter(t, kChapters[0]);
  await page.focus('#search');
  await page.keyboard.type('portal');
  await page.waitForSelector('#found a');
  assert.equal(await page.getAttribute('#search', 'aria-expanded'), 'true');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  await page.waitForURL(/portals\.html/);
});

test('old addresses of lessons lead to chapters', async (t) => {
  for (const [from, to] of [
    ['index', 'index'],
    ['one-ray', 'one-ray'],
    ['walls-and-floor', 'from-depth-to-height'],
    ['heights-and-hits', 'heights'],
  ]) {
    const { page } = await openPage(t, browser, { query: `examples/${from}.html` });
    await page.waitForURL(new RegExp(`/learn/${to}\\.html`));
  }
});

function gzipped(file) {
  return gzipSync(readFileSync(path.join(kSite, file)), { level: 9 }).length;
}

// In the page: visible pictures of fewer than 3 colours, as when nothing or only sky was drawn.
function flatPictures() {
  return [...document.querySelectorAll('ray-caster')]
    .filter((caster) => {
      const canvas = caster.shadowRoot.querySelector('canvas');
      if (!caster.checkVisibility() || canvas === null || canvas.width === 0) return false;
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size < 3;
    })
    .map((caster) => caster.closest('figure')?.id ?? 'outside');
}

// In the page: visible texts that are smaller than that, as they appear on the screen.
function smallTexts(smallest) {
  const found = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const element = walker.currentNode.parentElement;
    const words = walker.currentNode.data.trim();
    if (words === '' || !element.checkVisibility({ visibilityProperty: true })) continue;
    if (element.closest('math, noscript, .skip')) continue;
    let size = parseFloat(getComputedStyle(element).fontSize);
    const svg = element.closest('svg');
    if (svg !== null) size *= svg.getScreenCTM().a;
    if (size > 0 && size < smallest - 0.01)
      found.push(`${size.toFixed(1)} px: ${words.slice(0, 40)}`);
  }
  return found;
}
