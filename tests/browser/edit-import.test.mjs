// Maps from elsewhere in the editor's page: the dialog shows what was found, a picture follows each
// choice, and nothing is dropped silently.

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { tilesPicture } from '../import/load.mjs';
import { launch } from './browser.mjs';
import { openEditor as openTheEditor, rowsOf, settle, told } from './editor-page.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const [kWidth, kDepth] = [9, 7];

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const openEditor = (t, options) => openTheEditor(t, browser, '?template=meadow', options);

const isRim = (x, y) => x === 0 || y === 0 || x === kWidth - 1 || y === kDepth - 1;
const cells = (gidAt) =>
  Array.from({ length: kWidth * kDepth }, (_, at) => gidAt(at % kWidth, Math.floor(at / kWidth)));
const layer = (name, data) => ({ name, type: 'tilelayer', width: kWidth, height: kDepth, data });
const object = (id, type, x, y) => ({ id, type, name: '', x, y, width: 16, height: 16 });
const kTileset = {
  name: 'town',
  tilewidth: 16,
  tileheight: 16,
  columns: 3,
  tilecount: 6,
  image: 'town.png',
  imagewidth: 48,
  imageheight: 32,
};
const mapOf = (tileset) => ({
  type: 'map',
  orientation: 'orthogonal',
  width: kWidth,
  height: kDepth,
  tilewidth: 16,
  tileheight: 16,
  tilesets: [{ firstgid: 1, ...tileset }],
  layers: [
    layer(
      'Ground',
      cells(() => 2),
    ),
    {
      name: 'House',
      type: 'group',
      layers: [
        layer(
          'Walls',
          cells((x, y) => (isRim(x, y) ? 1 : 0)),
        ),
        layer(
          'Upper',
          cells((x, y) => (isRim(x, y) ? 4 : 0)),
        ),
      ],
    },
    {
      name: 'Things',
      type: 'objectgroup',
      objects: [
        object(1, 'oak', 32, 32),
        object(2, 'tree', 64, 48),
        object(3, 'crate', 900, 48),
        object(4, 'player', 48, 80),
      ],
    },
  ],
});
const file = (name, content) => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(
    typeof content === 'object' && !ArrayBuffer.isView(content) ? JSON.stringify(content) : content,
  ),
});
const kMap = file('town.tmj', mapOf(kTileset));
const kPicture = file('town.png', tilesPicture());

async function choose(page, files) {
  if (!(await page.isVisible('#files'))) await page.click('#open-files');
  await page.setInputFiles('#files input[type=file]', files);
}
const shown = (page) =>
  page.waitForFunction(
    () =>
      document.querySelector('#import ray-caster')?.world &&
      document.querySelector('#import-open:enabled') !== null,
  );
// The maps of the picture in the dialog, as the engine has them, once they fulfil a condition.
const previewed = (page, condition) =>
  page.waitForFunction((source) => {
    const { world } = document.querySelector('#import ray-caster');
    return world !== null && new Function('maps', `return ${source}`)(world.maps);
  }, condition);
async function open(page, name) {
  await page.click('#import-open:enabled');
  await page.waitForURL((address) => address.searchParams.get('file') === name);
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
}
const sceneOf = (page) => told(page, () => window.slicecastEditor.scene.value);
const row = (page, name) => page.locator('#import-choices li', { hasText: name }).first();

test('a pasted matrix becomes a world to walk in, by keys alone', async (t) => {
  const { page } = await openEditor(t);
  await page.focus('#open-files');
  await page.keyboard.press('Enter');
  await page.focus('#open-text');
  await page.keyboard.insertText(
    'int map[4][5] = {{1,1,1,1,1},{1,0,0,2,1},{1,0,0,0,1},{1,1,1,1,1}};',
  );
  await page.keyboard.press('Tab');
  await page.keyboard.press('Enter');
  await shown(page);
  assert.equal(
    await page.textContent('#import-found'),
    'Text with numbers, 5 × 4 tiles, 1 layer, 3 kinds of tiles',
  );
  assert.match(await page.textContent('#import-not-taken'), /the start: there is none/);
  // The twos become low, and look like a hedge.
  await page.getByLabel('to of 2').focus();
  await page.keyboard.type('0.5');
  await page.keyboard.press('Shift+Tab');
  await page.getByLabel('What 2 looks like').focus();
  await page.keyboard.type('hedge');
  await page.waitForFunction(() => !document.getElementById('import-open').disabled);
  await page.focus('#import-open');
  await page.keyboard.press('Enter');
  await page.waitForURL(/file=pasted/);
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  assert.deepEqual(
    (await rowsOf(page, 0)).map((text) => text.length),
    [5, 5, 5, 5],
  );
  const { blueprints, legend, maps } = await sceneOf(page);
  const low = blueprints[legend[maps[0].levels[0][1][3]]];
  assert.equal(low.top, 0.5);
  assert.equal(low.faces.all, 'hedge');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => window.slicecastEditor.caster.entered);
  const { x } = await told(page, () => window.slicecastEditor.caster.currentView);
  await page.keyboard.down('KeyW');
  await page.waitForFunction(
    (before) => Math.abs(window.slicecastEditor.caster.currentView.x - before) > 0.2,
    x,
  );
  await page.keyboard.up('KeyW');
});

test('the picture and the list follow each choice, and the world is what they showed', async (t) => {
  const { page } = await openEditor(t);
  await choose(page, [kMap, kPicture]);
  await shown(page);
  await previewed(page, 'maps[0].levels === 2');
  assert.match(await page.textContent('#import-not-taken'), /object 2 "tree".*without a picture/);
  assert.match(await page.textContent('#import-not-taken'), /object 3 "crate".*moved to its edge/);
  await page.selectOption('select[aria-label="What House/Upper becomes"]', 'ceiling');
  await previewed(page, 'maps[0].levels === 1');
  await page.getByLabel('Height of House/Upper').fill('2');
  await page.getByLabel('Height of House/Upper').press('Tab');
  await page.selectOption('select[aria-label="What tree looks like"]', 'pine');
  await page.selectOption('select[aria-label="What crate looks like"]', 'standing-barrel');
  await page.selectOption('select[aria-label="Objects beside the map"]', 'leave out');
  await page.waitForFunction(() => {
    const { textContent } = document.getElementById('import-not-taken');
    const isLeftOut = /object 3 "crate".*outside the map, and so left out/.test(textContent);
    return isLeftOut && !textContent.includes('tree');
  });
  const before = await told(page, () => document.querySelector('#import ray-caster').currentView);
  await page.click('#import-start');
  const after = await told(page, () => document.querySelector('#import ray-caster').currentView);
  assert.ok(before.z > 2 && after.z < 1);
  assert.deepEqual([after.x, after.y], [3.5, 5.5]);
  await open(page, 'town');
  const { maps, sprites } = await sceneOf(page);
  assert.equal(maps[0].levels.length, 1);
  assert.equal(maps[0].ceiling.height, 2);
  assert.deepEqual(
    maps[0].objects.map(({ sprite }) => sprites[sprite]),
    ['../sprites/oak.png', '../sprites/pine.png'],
  );
  // Its own pictures have come with it.
  await settle(page);
  await page.click('#open-share');
  assert.match(await page.textContent('#share-about'), /own pictures/);
});

test('a group is chosen at once; what is impossible is told, and can be mended', async (t) => {
  const { page } = await openEditor(t);
  await choose(page, [kMap, kPicture]);
  await shown(page);
  await page.selectOption('select[aria-label="What all of House becomes"]', 'floor');
  await previewed(page, 'maps[0].levels === 1');
  assert.equal(await page.inputValue('select[aria-label="What House/Walls becomes"]'), 'floor');
  assert.equal(await page.isVisible('[aria-label="Level of House/Walls"]'), false);
  await page.selectOption('select[aria-label="What House/Walls becomes"]', 'level');
  assert.equal(await page.inputValue('select[aria-label="What all of House becomes"]'), '');
  await page.getByLabel('Level of House/Walls').fill('99');
  await page.getByLabel('Level of House/Walls').press('Tab');
  await previewed(page, 'maps[0].levels === 32');
  await page.getByLabel('Level of House/Walls').fill('0.5');
  await page.getByLabel('Level of House/Walls').press('Tab');
  await page.waitForFunction(() =>
    /found the level 0.5/.test(document.getElementById('import-told').textContent),
  );
  assert.equal(await page.isDisabled('#import-open'), true);
  await page.getByLabel('Level of House/Walls').fill('1');
  await page.getByLabel('Level of House/Walls').press('Tab');
  await previewed(page, 'maps[0].levels === 2');
  // Closed, it has done nothing.
  const text = await told(page, () => window.slicecastEditor.scene.text);
  await page.keyboard.press('Escape');
  await page.waitForSelector('#import', { state: 'hidden' });
  assert.equal(await page.locator('#import ray-caster').count(), 0);
  assert.equal(await told(page, () => window.slicecastEditor.scene.text), text);
  assert.equal(await page.isVisible('#files'), true);
});

test('files that are missing are asked for', async (t) => {
  const { page } = await openEditor(t);
  await choose(page, [kMap]);
  await shown(page);
  assert.match(await page.textContent('#import-not-taken'), /"town.png": it was not chosen/);
  await page.selectOption('select[aria-label="What House/Upper becomes"]', 'leave out');
  await page.setInputFiles('#import-files', [kPicture]);
  await page.waitForFunction(
    () => !document.getElementById('import-not-taken').textContent.includes('town.png'),
  );
  assert.equal(await page.isVisible('#import-add'), false);
  assert.equal(
    await page.inputValue('select[aria-label="What House/Upper becomes"]'),
    'leave out',
    'choices stay',
  );
  await page.keyboard.press('Escape');
  await page.waitForSelector('#import', { state: 'hidden' });

  const tsx = `<tileset name="town" tilewidth="16" tileheight="16" tilecount="6" columns="3">
    <image source="town.png" width="48" height="32"/></tileset>`;
  await choose(page, [file('far.tmj', mapOf({ source: 'tiles/town.tsx' }))]);
  await page.waitForFunction(() =>
    document
      .getElementById('open-told')
      .textContent.startsWith(
        'far.tmj needs "tiles/town.tsx": it was not chosen together with the map. Choose it now',
      ),
  );
  await choose(page, [file('town.tsx', tsx), kPicture]);
  await shown(page);
  assert.equal(await page.textContent('#import-title'), 'Open far');
  assert.doesNotMatch(await page.textContent('#import-not-taken'), /png|tsx/);
  await open(page, 'far');
  assert.equal((await rowsOf(page, 0)).length, kDepth);
  // The same map again is another world, once something was made of the first one; what is dropped
  // onto the dialog joins it.
  await told(page, () =>
    window.slicecastEditor.history.do('Rename', [{ path: ['title'], value: 'Mine' }]),
  );
  await page.waitForFunction(() => document.getElementById('kept').textContent.startsWith('Kept'));
  await choose(page, [file('far.tmj', mapOf(kTileset))]);
  await shown(page);
  await told(
    page,
    (bytes) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([new Uint8Array(bytes)], 'town.png'));
      const drop = new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true });
      document.getElementById('import-choices').dispatchEvent(drop);
    },
    [...kPicture.buffer],
  );
  await page.waitForFunction(
    () => !document.getElementById('import-not-taken').textContent.includes('town.png'),
  );
  await open(page, 'far 2');
});

for (const [name, viewport] of Object.entries({
  'a small desk': { width: 1366, height: 768 },
  'a tablet': { width: 820, height: 1180 },
  'a phone': { width: 390, height: 844 },
  'a small phone': { width: 360, height: 640 },
})) {
  test(`on ${name} the dialog fits, and axe finds nothing`, async (t) => {
    const hasTouch = viewport.width < 900;
    const { page } = await openEditor(t, { viewport, context: { hasTouch, isMobile: hasTouch } });
    await choose(page, [kMap, kPicture]);
    await shown(page);
    const found = await told(page, () => {
      const dialog = document.getElementById('import').getBoundingClientRect();
      const controls = [...document.querySelectorAll('#import :is(button, select, input)')].filter(
        (one) => one.checkVisibility(),
      );
      return controls
        .map((one) => [
          one.getAttribute('aria-label') ?? one.textContent,
          one.getBoundingClientRect(),
        ])
        .filter(
          ([, { left, right, height }]) =>
            left < dialog.left || right > dialog.right || (innerWidth < 900 && height < 43.5),
        )
        .map(([label]) => label);
    });
    assert.deepEqual(found, []);
    await page.addScriptTag({ path: kAxe });
    const violations = await told(page, async () =>
      (await window.axe.run('#import', { resultTypes: ['violations'] })).violations.map(
        ({ id, nodes }) => [id, nodes[0].html],
      ),
    );
    assert.deepEqual(violations, []);
    if (hasTouch) {
      await row(page, 'crate').scrollIntoViewIfNeeded();
      await page.tap('#import-open');
      await page.waitForURL(/file=town/);
    }
  });
}
