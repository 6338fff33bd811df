// Walks the whole site in Chromium, at the width of a phone, a laptop and a wide screen. No page is
// wider than its window, and none complains on the console. A picture of each is kept in
// build/site, for people to judge.

import assert from 'node:assert/strict';
import { mkdirSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { launch, openPage } from '../browser/browser.mjs';

const kRoot = new URL('../..', import.meta.url).pathname;
const kSite = join(kRoot, 'build/web');
const kPictures = join(kRoot, 'build/site');
const kWidths = [360, 1280, 2560];

// What a package or another page loads is no page of the site; learn/write/export.html is what
// the reader's download is made from.
const kNoPages = /^(bundlers|node|embed\.html|learn\/write\/export\.html)/;

const pages = readdirSync(kSite, { recursive: true })
  .filter((name) => name.endsWith('.html') && !kNoPages.test(name))
  .sort();

let browser;
before(async () => {
  mkdirSync(kPictures, { recursive: true });
  browser = await launch();
});
after(() => browser.close());

test('the site has its pages', () => {
  for (const name of ['index.html', 'element.html', 'docs/index.html', 'learn/index.html'])
    assert.ok(pages.includes(name), name);
});

for (const name of pages) {
  for (const width of kWidths) {
    test(`${name}, ${width} pixels wide`, async (t) => {
      const { page } = await openPage(t, browser, {
        query: name,
        viewport: { width, height: width === 360 ? 740 : 900 },
      });
      await page.waitForLoadState('networkidle');
      const file = `${name.replaceAll('/', '-').replace(/\.html$/, '')}-${width}.png`;
      await page.screenshot({ path: join(kPictures, file) });
      const wide = await page.evaluate('document.documentElement.scrollWidth');
      assert.ok(wide <= width, `${wide} pixels wide`);
    });
  }
}
