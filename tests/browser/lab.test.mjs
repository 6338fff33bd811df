// The Lab of the play page: overlays, light, old ways, photo mode, benchmark.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { launch, openScene, pictureHash, play } from './browser.mjs';

const axe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kWindow = { viewport: { width: 1000, height: 700 }, query: '?scene=room' };
const option = (page, name) => page.evaluate((which) => window.slicecast.get(which), name);

async function openLab(t, options = kWindow) {
  const opened = await openScene(t, browser, options);
  await opened.page.click('#open-lab');
  return opened;
}

test('every row of the Lab sets its option, and reflects changes by keys', async (t) => {
  const { page } = await openLab(t);
  for (const name of ['minimap', 'playerPanel', 'inspector', 'grid', 'slow']) {
    const before = await option(page, name);
    await page.click(`#lab-${name}`);
    assert.notEqual(await option(page, name), before, name);
    await page.click(`#lab-${name}`);
    assert.equal(await option(page, name), before, name);
  }
  await page.selectOption('#lab-lightPreset', 'night');
  assert.equal(await option(page, 'lightPreset'), 'night');
  await page.fill('#lab-drawnColumns', '100');
  assert.equal(await option(page, 'drawnColumns'), '100');
  await page.press('#lab-drawnColumns', 'End');
  assert.equal(await option(page, 'drawnColumns'), '-1');
  await page.evaluate(() => window.slicecast.set('minimap', 'on'));
  await page.waitForFunction(() => document.getElementById('lab-minimap').checked);
});

test('an old way is drawn left of the divider, which mouse and keys move', async (t) => {
  const { page } = await openLab(t);
  const exact = await pictureHash(page);
  assert.ok(!(await page.locator('#divider').isVisible()));
  await page.selectOption('#lab-way', 'Fish eye');
  assert.equal(await option(page, 'classic.projection'), 'equalAngles');
  assert.equal(await option(page, 'compare'), '0.5');
  await page.waitForFunction(() => !document.getElementById('divider').hidden);
  await page.waitForTimeout(200);
  assert.notEqual(await pictureHash(page), exact);
  const box = await page.locator('#divider').boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(136, box.y + box.height / 2, { steps: 4 }); // of 680 beside the Lab
  await page.mouse.up();
  assert.ok(Math.abs(Number(await option(page, 'compare')) - 0.2) < 0.01);
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs(Number(await option(page, 'compare')) - 0.21) < 0.01);
  await page.selectOption('#lab-way', '');
  assert.equal(await option(page, 'compare'), '0');
  assert.equal(await option(page, 'classic.projection'), 'plane');
  assert.ok(!(await page.locator('#divider').isVisible()));
});

const placeText = (page) => page.textContent('[data-lab="way-place"] [role="status"]');
const told = (page, text) =>
  page.waitForFunction(
    (wanted) =>
      document.querySelector('[data-lab="way-place"] [role="status"]').textContent === wanted,
    text,
  );

test('"Show me" goes where an old way matters, or says that it does nowhere', async (t) => {
  const { page } = await openLab(t);
  assert.ok(!(await page.locator('[data-lab="way-show"]').isVisible()), 'there is nothing to show');
  const view = () => page.evaluate(() => window.slicecast.currentView);
  const start = await view();

  await page.selectOption('#lab-way', 'Big pixels');
  await page.evaluate(() => window.slicecast.set('compare', 0.9));
  await page.click('[data-lab="way-show"]');
  await told(page, 'It shows in this view.');
  assert.deepEqual(await view(), start);
  assert.equal(await option(page, 'compare'), '0.5', 'the divider is in the middle');

  await page.selectOption('#lab-way', 'A drifting horizon');
  assert.equal(await placeText(page), '', 'that was of another way');
  await page.click('[data-lab="way-show"]');
  await told(page, 'You are where it shows.');
  const above = await view();
  assert.ok(above.z > start.z, 'it sinks only for who is higher than the start');
  assert.ok(await page.evaluate(() => window.slicecast.tryOldWay(0).share > 0.008));

  await page.selectOption('#lab-way', 'Portals drawn over');
  await page.click('[data-lab="way-show"]');
  await told(page, 'No place in this scene shows it.');
  assert.deepEqual(await view(), above);

  // Another choice ends a search
  await page.click('[data-lab="way-show"]');
  await page.selectOption('#lab-way', '');
  assert.ok(!(await page.locator('[data-lab="way-show"]').isVisible()));
  assert.equal(await placeText(page), '');
});

test('photo mode hides the controls, and saves the picture in the chosen size', async (t) => {
  const { page } = await openLab(t);
  await page.click('#lab-minimap');
  await page.click('[data-lab="photo"]');
  assert.equal(await option(page, 'minimap'), 'off');
  for (const selector of ['#bar', '#lab', '#pause'])
    assert.ok(!(await page.locator(selector).isVisible()), selector);
  await page.selectOption('#photo [name="size"]', '1280x720');
  const coming = page.waitForEvent('download');
  await page.click('[data-photo="save"]');
  const header = await readFile(await (await coming).path());
  assert.deepEqual([header.readUInt32BE(16), header.readUInt32BE(20)], [1280, 720]);
  await page.keyboard.press('Escape');
  assert.equal(await option(page, 'minimap'), 'on');
  assert.ok(await page.locator('#bar').isVisible());
});

test('photo mode gives back the time of day, the field of view and the focus', async (t) => {
  const { page } = await openLab(t);
  await page.selectOption('#lab-lightPreset', 'dusk');
  await page.click('[data-lab="photo"]');
  await page.selectOption('#photo [name="lightPreset"]', 'night');
  await page.fill('#photo [name="fov"]', '90');
  assert.deepEqual([await option(page, 'lightPreset'), await option(page, 'fov')], ['night', '90']);
  await page.click('[data-photo="done"]');
  assert.deepEqual([await option(page, 'lightPreset'), await option(page, 'fov')], ['dusk', '60']);
  const focused = () => page.evaluate(() => document.activeElement.textContent.trim());
  assert.equal(await focused(), 'Photo mode');
  await page.keyboard.press('Escape');
  assert.equal(await focused(), 'Lab');
});

test('the benchmark shows its figures, and restores the view', async (t) => {
  const { page } = await openLab(t);
  const view = () => page.evaluate(() => window.slicecast.currentView);
  const before = await view();
  await page.click('[data-lab="benchmark"]');
  await page.click('[data-benchmark="run"]');
  await page.waitForFunction(
    () => document.querySelectorAll('#benchmark tbody tr').length > 4,
    null,
    { timeout: 60000 },
  );
  const rows = await page.locator('#benchmark tbody tr').allTextContents();
  assert.ok(rows.some((row) => /Pictures drawn240/.test(row)));
  const nanoseconds = rows.map((row) => /Per pixel([\d.]+) ns/.exec(row)?.[1]).find(Boolean);
  assert.ok(Number(nanoseconds) > 0.05 && Number(nanoseconds) < 1000, nanoseconds);
  const limits = rows.map((row) => /Times the limit([\d.]+)/.exec(row)?.[1]).find(Boolean);
  assert.ok(Number(limits) > 0.5 && Number(limits) < 200, limits);
  const inPlay = rows
    .map((row) => /In play(\d+) a second, (\d+) × (\d+) \((\d+) %\)/.exec(row))
    .find(Boolean);
  const [pictures, width, height, share] = inPlay.slice(1).map(Number);
  assert.ok(pictures > 0 && pictures < 300, inPlay[0]);
  const { clientWidth, clientHeight } = await page.evaluate(() => ({
    clientWidth: window.slicecast.clientWidth,
    clientHeight: window.slicecast.clientHeight,
  }));
  assert.ok(Math.abs(width / clientWidth - share / 100) < 0.01, inPlay[0]);
  assert.ok(Math.abs(height / clientHeight - share / 100) < 0.01, inPlay[0]);
  assert.deepEqual(await view(), before);
  assert.ok(await page.locator('[data-benchmark="copy"]').isEnabled());
});

test('the Lab works by keys, stays open during play, and axe finds no violations in it', async (t) => {
  const { page } = await openLab(t);
  await page.addScriptTag({ path: axe });
  const { violations } = await page.evaluate(() => window.axe.run());
  assert.deepEqual(
    violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join('; ')}`),
    [],
  );
  await page.keyboard.press('Escape');
  assert.ok(!(await page.locator('#lab').isVisible()));
  await page.click('#open-lab');
  await play(page);
  assert.ok(await page.locator('#lab').isVisible());
});
