// The forms of the editor: each key of the schema can be set by them and unset again, and the text
// is the same afterwards.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { openEditor, settle, textOf } from './editor-page.mjs';

const kSchema = JSON.parse(
  readFileSync(new URL('../../assets/scene.schema.json', import.meta.url), 'utf8'),
);
// Drawn, or shown by other parts of the page; `comment` stands everywhere.
const kElsewhere = new Set([
  ...['$schema', 'levels', 'tiles', 'title', 'maps', 'objects', 'comment'],
  ...['fill', 'character', 'repeat'], // of levels
  // Textures, sprites and skies as objects: their second forms are typed.
  ...['file', 'frames', 'rate', 'material', 'variants', 'views', 'panorama'],
]);

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Names of keys that a value of the schema may have, at any depth.
function keysOf(node, found = new Set(), seen = new Set()) {
  if (typeof node !== 'object' || node === null || seen.has(node)) return found;
  seen.add(node);
  if (typeof node.$ref === 'string')
    keysOf(kSchema.definitions[node.$ref.split('/').at(-1)], found, seen);
  if (typeof node.properties === 'object')
    for (const key of Object.keys(node.properties)) found.add(key);
  for (const part of Object.values(node)) keysOf(part, found, seen);
  return found;
}

// In the page: uses each control of a form, opens each part, and goes back. Gives the keys that it
// has met, and what went wrong.
async function useForm(tab) {
  const { scene, history } = window.slicecastEditor;
  document.getElementById(`tab-${tab}`).click();
  const form = document.querySelector(`#part-${tab} .form`);
  const faults = [];
  const keys = new Set();
  const seen = new Set();
  const added = []; // {path, text} of parts, to be removed again
  const valueAt = (path) => path.split(',').reduce((node, key) => node?.[key], scene.value);
  const find = (path) => form.querySelector(`[data-path="${CSS.escape(path)}"]`);
  // What a name or a number stands for is the same for each.
  const kNamed = /^(textures|sprites|motions|blueprints|legend),[^,]+/;
  const alike = (path) => path.replace(kNamed, '$1,*').replaceAll(/\b\d+\b/g, '#');
  const isNew = (element) => !seen.has(alike(element.dataset.path));
  const texts = ['4, 4', '#123456', 'picture.png', 'something', 'a'];
  function valuesFor(input) {
    if (input.type === 'number') {
      const [least, most] = [input.min, input.max].map((end) => (end === '' ? NaN : Number(end)));
      const near = Number.isNaN(least) ? most : least;
      return [near + 1, near + 0.5, most - 1, most, least, 1, 2]
        .filter(Number.isFinite)
        .map(String);
    }
    const listed = document.getElementById(input.getAttribute('list'))?.options ?? [];
    return [...[...listed].map(({ value }) => value), ...texts];
  }
  function change(element, set) {
    set(element);
    element.dispatchEvent(new Event('change', { bubbles: true }));
  }
  function useField(path, element) {
    const text = scene.text;
    if (element.type === 'checkbox') {
      change(element, (box) => (box.checked = !box.checked));
      if (scene.text === text) faults.push(`${path}: not set`);
      change(find(path), (box) => (box.checked = !box.checked));
    } else if (element.tagName === 'SELECT') {
      const old = element.value;
      const other = [...element.options].map(({ value }) => value).find((one) => one !== old);
      change(element, (select) => (select.value = other));
      if (scene.text === text) faults.push(`${path}: not set`);
      change(find(path), (select) => (select.value = old));
    } else {
      const old = element.value;
      const fits = valuesFor(element).find((one) => {
        element.value = one;
        return one !== old && element.checkValidity();
      });
      change(element, (input) => (input.value = fits ?? 'none fits'));
      if (scene.text === text) faults.push(`${path}: not set, ${fits}`);
      change(find(path), (input) => (input.value = old));
    }
    if (scene.text !== text) faults.push(`${path}: not as before`);
    // Its richer form: what was there before comes back by Undo.
    const more = find(path)?.closest('.field')?.querySelector('button.small');
    if (!more) return;
    more.click();
    added.push({ path, text, isRicher: true });
  }
  function use(element) {
    const { path } = element.dataset;
    seen.add(alike(path));
    const [plain, what] = /^(.*?)(?: (name|another|remove|rename))?$/.exec(path).slice(1);
    if (what === undefined) keys.add(plain.split(',').at(-1));
    const { text } = scene;
    if (what === 'remove' || what === 'rename') return; // below; edit-links.test.mjs
    if (element.tagName === 'SUMMARY') {
      element.parentElement.open = true;
      element.parentElement.dispatchEvent(new Event('toggle'));
      return;
    }
    if (what === 'name') change(element, (input) => (input.value = 'something new'));
    else if (element.tagName === 'BUTTON') element.click();
    else {
      useField(plain, element);
      return;
    }
    const now =
      what === 'name'
        ? `${plain},something new`
        : what === 'another'
          ? `${plain},${valueAt(plain).length - 1}`
          : plain;
    if (scene.text === text || valueAt(now) === undefined) faults.push(`${path}: not added`);
    added.push({ path: now, text });
  }
  // Each part is removed when all in it was used, so that the form stays small.
  for (;;) {
    const last = added.at(-1);
    const scope = last === undefined ? form : find(last.path)?.closest('details');
    const element = [...(scope?.querySelectorAll('[data-path]') ?? [])].find(
      (one) => isNew(one) && one.checkVisibility(),
    );
    if (element !== undefined) {
      use(element);
      continue;
    }
    if (last === undefined) break;
    added.pop();
    if (last.isRicher) {
      while (scene.text !== last.text && history.undo() !== null);
      continue;
    }
    const remover = find(`${last.path} remove`);
    if (remover !== null) remover.click();
    else change(find(last.path), (input) => (input.value = ''));
    if (scene.text === last.text) continue;
    faults.push(`${last.path}: not as before it was added`);
    break;
  }
  return { keys: [...keys], faults };
}

test('each key of the schema is set and unset by forms, and the text stays the same', async (t) => {
  const { page } = await openEditor(t, browser, '?template=garden');
  const met = new Set();
  await page.evaluate(() => {
    const { history, editor } = window.slicecastEditor;
    const object = { sprite: 'oak', x: 14.5, y: 20.5, height: 2 };
    history.do('Put', [{ path: ['maps', 0, 'objects', 0], value: object }]);
    editor.choose({ edited: ['maps', 0, 'objects', 0] });
  });
  const text = await textOf(page);
  for (const tab of ['kind', 'thing', 'map', 'world']) {
    const { keys, faults } = await page.evaluate(useForm, tab);
    assert.deepEqual(faults, [], tab);
    assert.equal(await textOf(page), text, tab);
    for (const key of keys) met.add(key);
  }
  await settle(page);
  const missing = [...keysOf(kSchema)].filter((key) => !met.has(key) && !kElsewhere.has(key));
  assert.deepEqual(missing, []);
});

test('a message keeps its lines, a colour has a swatch, and the panel says what a key means', async (t) => {
  const { page } = await openEditor(t, browser);
  await page.evaluate(() => {
    const { history, editor } = window.slicecastEditor;
    const message = { text: 'One line.', x: 3, y: 4 };
    history.do('Put', [
      { path: ['maps', 0, 'messages'], value: [message] },
      { path: ['maps', 0, 'baked', 'lamps'], value: [{ x: 2, y: 2, z: 1 }] },
    ]);
    editor.choose({ edited: ['maps', 0, 'messages', 0] });
  });
  const thing = page.locator('#part-thing');
  await thing.getByLabel('Message').fill('One line.\nAnother.');
  await thing.getByLabel('West edge').focus();
  assert.match(await thing.locator('.meaning').textContent(), /from 0 at the west/);
  const text = () =>
    page.evaluate(() => window.slicecastEditor.scene.value.maps[0].messages[0].text);
  assert.equal(await text(), 'One line.\nAnother.');
  await page.evaluate(() =>
    window.slicecastEditor.editor.choose({ edited: ['maps', 0, 'baked', 'lamps', 0] }),
  );
  await thing.locator('input[type=color]').fill('#ff8040');
  assert.equal(await thing.getByLabel('Colour', { exact: true }).inputValue(), '#ff8040');
});

test('the panel follows what is chosen: a tool, a block that is picked, a thing', async (t) => {
  const { page } = await openEditor(t, browser, '?template=house');
  const tab = () => page.textContent('#tabs [aria-selected=true]');
  const choose = (choice) =>
    page.evaluate((one) => window.slicecastEditor.editor.choose(one), choice);
  await page.click('[data-tool=thing]');
  assert.equal(await tab(), 'Thing');
  await page.evaluate(() => {
    const { editor } = window.slicecastEditor;
    editor.pick({ map: 0, cell: { level: 0, x: 9, y: 7 } });
  });
  assert.equal(await tab(), 'Block');
  await page.click('#tab-map');
  await choose({ level: 1 });
  assert.equal(await tab(), 'Map');
  await choose({ edited: ['start'] });
  assert.equal(await tab(), 'Thing');
});
