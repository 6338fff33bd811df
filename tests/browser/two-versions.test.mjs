// Two copies of the element's script in one page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { launch } from './browser.mjs';
import { openGuest } from './guest-page.mjs';

const script = readFileSync(new URL('../../build/web/ray-caster.js', import.meta.url), 'utf8');
const { version } = JSON.parse(
  readFileSync(new URL('../../build/web/package.json', import.meta.url), 'utf8'),
);
const other = script.replaceAll(`"${version}"`, '"99.0.0"');
let browser;
before(async () => (browser = await launch()));
after(() => browser?.close());

async function warningsWith(t, second) {
  const told = [];
  const { page } = await openGuest(t, browser, {
    body: '',
    script: ['ray-caster.js', 'second.js']
      .map((name) => `<script type="module" src="${name}"></script>`)
      .join(''),
    server: { files: { 'second.js': second } },
    prepare: (opened) =>
      opened.on('console', (message) => message.type() === 'warning' && told.push(message.text())),
  });
  // Both scripts have run: modules do so in order, before the page has loaded.
  assert.equal(await page.evaluate(() => customElements.get('ray-caster').version), version);
  return told;
}

test('the second of two versions says that it is not used', async (t) => {
  assert.notEqual(other, script);
  assert.deepEqual(await warningsWith(t, other), [
    `<ray-caster> stays version ${version}, whose script ran first, and version 99.0.0 is not used. Load only one of the two scripts.`,
  ]);
});

test('two copies of one version get along', async (t) => {
  assert.deepEqual(await warningsWith(t, script), []);
});
