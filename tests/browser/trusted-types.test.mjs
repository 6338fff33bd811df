// The pages under the strictest rule for scripts: no text becomes HTML or a script, and no policy
// may let it through.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, openPage, play } from './browser.mjs';

const kPolicy = "require-trusted-types-for 'script'; trusted-types 'none'";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Errors on the console, such as a browser's for each refusal, fail the test.
function openStrict(t, query) {
  return openPage(t, browser, {
    query,
    server: { headers: { 'Content-Security-Policy': kPolicy } },
  });
}

test('the policy is active in these pages', async (t) => {
  const { page, complaints } = await openPage(t, browser, {
    query: 'element.html',
    expectErrors: true,
    server: { headers: { 'Content-Security-Policy': kPolicy } },
  });
  const refusal = await page.evaluate(() => {
    try {
      document.body.innerHTML = '<p>';
    } catch (error) {
      return error.name;
    }
    return 'none';
  });
  assert.equal(refusal, 'TypeError');
  assert.match(complaints.join('\n'), /TrustedHTML/);
});

for (const chapter of ['one-ray', 'flying', 'portals']) {
  test(`a chapter draws its figures: ${chapter}`, async (t) => {
    const { page } = await openStrict(t, `learn/${chapter}.html`);
    const figures = await page.$$('[data-figure]');
    assert.ok(figures.length > 2);
    for (const figure of figures) {
      await figure.scrollIntoViewIfNeeded();
      await figure.waitForSelector('.fig.live');
    }
    await page.waitForFunction(() =>
      [...document.querySelectorAll('.fig-svg')].every((svg) => svg.childElementCount > 0),
    );
  });
}

test('the documentation of the element', async (t) => {
  const { page } = await openStrict(t, 'element.html');
  await page.waitForSelector('.snippet button');
  await page.evaluate(() => document.querySelector('ray-caster').whenReady());
});

test('a frame', async (t) => {
  const { page } = await openStrict(t, 'embed.html?scene=room&controls=all');
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  await page.click('ray-caster');
  await page.waitForFunction(() => document.body.dataset.state === 'playing');
});

test('the play page, its hints and everything that its bar opens', async (t) => {
  const { page } = await openStrict(t, '?scene=room');
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  for (const name of ['scenes', 'keys', 'settings', 'share']) {
    await page.click(`#open-${name}`);
    await page.click(`#${name} [data-close]`);
  }
  await page.click('#open-lab');
  await page.click('[data-lab=close]');
  await play(page); // by a key: a click captures the mouse
  await page.waitForSelector('#hint.shown kbd');
  assert.equal(await page.textContent('#hint'), 'WASD walk');
});
