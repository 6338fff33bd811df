// The documentation in Chromium: it fits phones and desks, axe finds nothing in it, a strict policy
// lets it work, and its pictures can be played.

import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { inState, launch, openPage } from './browser.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const kFolder = new URL('../../build/web/docs/', import.meta.url);
const kPages = readdirSync(kFolder).filter((name) => name.endsWith('.html'));
const kPhone = { width: 360, height: 740 };
const kDesktop = { width: 1200, height: 800 };
const kStrict =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self'; connect-src 'self'";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

for (const [device, viewport, colorScheme] of [
  ['phone', kPhone, 'dark'],
  ['desktop', kDesktop, 'light'],
]) {
  for (const name of kPages) {
    test(`${name} on a ${device}, ${colorScheme}: nothing overflows, axe finds nothing`, async (t) => {
      const { page } = await openPage(t, browser, {
        query: `docs/${name}`,
        viewport,
        context: { colorScheme, isMobile: viewport === kPhone },
      });
      const width = await page.evaluate(() => document.documentElement.scrollWidth);
      assert.ok(width <= viewport.width, `it is ${width} pixels wide`);
      // Nothing is cut off either: wide content scrolls.
      const cut = await page.evaluate(() =>
        [...document.querySelectorAll('main *')]
          .filter((node) => !node.closest('pre, .table, .strip, ray-caster, .reference thead'))
          .filter(
            (node) => node.getBoundingClientRect().right > document.documentElement.clientWidth + 1,
          )
          .map((node) => node.outerHTML.slice(0, 80)),
      );
      assert.deepEqual(cut, []);
      await page.addScriptTag({ path: kAxe });
      const { violations } = await page.evaluate(() =>
        window.axe.run(document, { resultTypes: ['violations'] }),
      );
      assert.deepEqual(
        violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`),
        [],
      );
    });
  }
}

test('a strict content security policy lets the pages work', async (t) => {
  const { page, server } = await openPage(t, browser, {
    query: 'docs/scenes.html',
    viewport: kDesktop,
    server: { headers: { 'Content-Security-Policy': kStrict } },
  });
  const live = page.locator('ray-caster').first();
  await live.scrollIntoViewIfNeeded();
  await live.evaluate((caster) => caster.whenReady());
  assert.ok((await page.locator('.snippet button').count()) > 10);
  for (const name of kPages) await page.goto(`${server.address}docs/${name}`);
});

test('every live picture is drawn', async (t) => {
  const { page } = await openPage(t, browser, { query: 'docs/scenes.html', viewport: kDesktop });
  const states = await page.evaluate(() =>
    Promise.all(
      [...document.querySelectorAll('ray-caster')].map((caster) => {
        caster.scrollIntoView();
        return caster.whenReady().then(
          () => 'ready',
          (error) => error.message,
        );
      }),
    ),
  );
  assert.ok(states.length >= 5);
  assert.deepEqual([...new Set(states)], ['ready']);
});

test('a picture opens in the player, where it was seen', async (t) => {
  const { page } = await openPage(t, browser, { query: 'docs/scenes.html', viewport: kDesktop });
  await page.click('a.open[href*="mirrors.json"]');
  await inState(page, 'paused');
  assert.equal(await page.textContent('#bar-title'), 'A yard');
  const { x, y } = await page.evaluate(() => window.slicecast.player);
  assert.ok(Math.abs(x - 3.4) < 0.1 && Math.abs(y - 8.9) < 0.1, `${x}, ${y}`);
});

test('the skip link and the folded list of pages work by keys', async (t) => {
  const { page } = await openPage(t, browser, { query: 'docs/play.html', viewport: kPhone });
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.textContent), 'Skip to the text');
  await page.keyboard.press('Enter');
  assert.equal(new URL(page.url()).hash, '#text');
  await page.click('.folded summary');
  await page.click('.folded a:has-text("Testing")');
  await page.waitForFunction(() => document.title.startsWith('Testing'));
});
