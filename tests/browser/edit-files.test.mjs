// The editor's files: the one that tools/play serves, those that pages may write, one HTML file
// that plays from a disk, own pictures, and two tabs with one world.

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { chmod, mkdir, mkdtemp, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { startServer } from '../../tools/serve.mjs';
import { frames, launch, openPage } from './browser.mjs';
import { openEditor as openTheEditor, settle, textOf, told } from './editor-page.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const { strFromU8, strToU8, unzipSync, zipSync } = createRequire(
  new URL('../../tools/package.json', import.meta.url),
)('fflate');
const kPage = fileURLToPath(new URL('../../build/web/', import.meta.url));
const kAssets = new URL('../../assets/', import.meta.url);
const kWait = 15000; // milliseconds

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const openEditor = (t, query, options) => openTheEditor(t, browser, query, options);
const isReady = (page) => page.waitForFunction(() => document.body.dataset.state === 'ready');
const rename = (page, title) =>
  told(
    page,
    (text) => {
      const { history } = window.slicecastEditor;
      history.do('Rename', [{ path: ['title'], value: text }]);
    },
    title,
  );
const saysToast = (page, text) =>
  page.waitForFunction(
    (wanted) => document.getElementById('toast').textContent.includes(wanted),
    text,
  );
const isKept = (page) =>
  page.waitForFunction(() => document.getElementById('kept').textContent.startsWith('Kept'));

async function folderFor(t) {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-files-'));
  t.after(() => rm(folder, { recursive: true }));
  return folder;
}

// A small world with six textures.
const kSix = [
  'stone-blocks-worn',
  'brick-weathered',
  'flagstones',
  'planks-wall',
  'rock',
  'grass-meadow',
];
function smallScene(title = 'Yard', folder = '../textures/') {
  const rows = Array.from({ length: 12 }, (_, y) =>
    Array.from({ length: 12 }, (__, x) =>
      x % 11 === 0 || y % 11 === 0 ? 'abcde'[(x + y) % 5] : '.',
    ).join(''),
  );
  return {
    title,
    textures: Object.fromEntries(kSix.map((name) => [name, `${folder}${name}.png`])),
    blueprints: Object.fromEntries([...'abcde'].map((sign, at) => [sign, { faces: kSix[at] }])),
    legend: Object.fromEntries([...'abcde'].map((sign) => [sign, sign])),
    maps: [{ name: 'yard', levels: [rows], floor: kSix[5] }],
    start: { x: 4.5, y: 5.5 },
  };
}

// ---- The scene of tools/play

async function served(t, { text, pictures = {}, viewport } = {}) {
  const root = await folderFor(t);
  const folder = path.join(root, 'scenes');
  await mkdir(folder);
  const file = path.join(folder, 'my yard.json');
  await writeFile(file, text);
  for (const [name, bytes] of Object.entries(pictures)) {
    await mkdir(path.dirname(path.join(folder, name)), { recursive: true });
    await writeFile(path.join(folder, name), bytes);
  }
  const server = await startServer({ folder: kPage, scene: file });
  const context = await browser.newContext({ viewport: viewport ?? { width: 1366, height: 768 } });
  const page = await context.newPage();
  page.setDefaultTimeout(kWait);
  const complaints = [];
  page.on('console', (said) => said.type() === 'error' && complaints.push(said.text()));
  t.after(async () => {
    await context.close();
    server.close();
    assert.deepEqual(complaints, [], 'the console of the browser stays empty');
  });
  const edit = `${server.address.split('?')[0]}edit.html?scene=-/scene/my%20yard.json`;
  return { page, context, server, file, edit };
}

const kWindows = `\uFEFF${JSON.stringify(smallScene('Yard', './'), null, 2).replaceAll('\n', '\r\n')}\r\n\r\n`;
const kBeside = Object.fromEntries(
  await Promise.all(
    kSix.map(async (name) => [
      `${name}.png`,
      await readFile(new URL(`textures/${name}.png`, kAssets)),
    ]),
  ),
);
const servedYard = (t, options) =>
  served(t, { text: kWindows.replaceAll('./', ''), pictures: kBeside, ...options });
const kYard = kWindows.replaceAll('./', '');

test('from tools/play one edits the very file: only what was changed differs in it', async (t) => {
  const { page, server, file } = await servedYard(t);
  await chmod(file, 0o640);
  await page.goto(server.address);
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  await page.click('#open-edit');
  await isReady(page);
  await page.waitForFunction(() => window.slicecastEditor?.caster.state === 'paused');
  assert.deepEqual(await told(page, () => window.slicecastEditor.caster.error), null);
  assert.equal(await page.title(), 'Yard · Build a world');
  assert.match(
    await told(page, () => document.getElementById('home').search),
    /scene=-%2Fscene%2Fmy\+yard\.json&live=1/,
  );
  await told(page, () => {
    const { history } = window.slicecastEditor;
    history.do('Place', [{ map: 0, cells: [{ layer: 0, x: 3, y: 3, sign: 'b' }] }]);
  });
  await page.waitForFunction(() => document.title.startsWith('● '));
  await page.keyboard.press('Control+s');
  await saysToast(page, 'Saved my yard.json');
  assert.equal(await page.title(), 'Yard · Build a world');
  const after = await readFile(file, 'utf8');
  assert.equal(after.length, kYard.length);
  assert.equal([...after].filter((letter, at) => letter !== kYard[at]).length, 1);
  assert.equal((await stat(file)).mode & 0o777, 0o640);

  await rename(page, 'Another');
  await page.click('#save');
  await page.waitForFunction(() => !document.title.startsWith('● '));
  assert.equal(await readFile(file, 'utf8'), after.replace('Yard', 'Another'));
});

test('a scene elsewhere shows shipped pictures, to play and to edit, without one try in vain', async (t) => {
  const { page, server, edit } = await served(t, { text: JSON.stringify(smallScene()) });
  await page.goto(server.address);
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  await page.goto(edit);
  await isReady(page);
  await page.waitForFunction(() => window.slicecastEditor?.caster.state === 'paused');
  assert.equal(await told(page, () => window.slicecastEditor.caster.error), null);
  await page.click('[data-tool=thing]');
  await page.click('#palette .add');
  await page.waitForSelector('#adding canvas');
  await page.waitForFunction(() =>
    [...document.querySelectorAll('#palette canvas, #adding canvas')].every((canvas) =>
      canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.some(Boolean),
    ),
  );
});

test('a file that has changed on the disk: both texts, and a choice', async (t) => {
  const { page, edit, file } = await servedYard(t);
  await page.goto(edit);
  await isReady(page);
  const theirs = kYard.replace('Yard', '<img src=x onerror=alert(1)>');
  await rename(page, 'Mine');
  await writeFile(file, theirs);
  await page.keyboard.press('Control+s');
  await page.waitForSelector('#conflict[open]');
  const places = await page.locator('[data-conflict=places] pre').allTextContents();
  assert.equal(places.length, 2);
  assert.match(places[0], /<img src=x/);
  assert.match(places[1], /"Mine"/);
  assert.match(await page.textContent('[data-conflict=about]'), /differs .* in one place/);
  await page.click('[data-conflict=whole] summary');
  assert.match(await page.textContent('[data-conflict=whole-theirs]'), /<img src=x/);
  assert.match(await page.textContent('[data-conflict=whole-mine]'), /"title": "Mine"/);
  await page.addScriptTag({ path: kAxe });
  const found = await told(page, async () =>
    (await window.axe.run('#conflict', { resultTypes: ['violations'] })).violations.map(
      ({ id, nodes }) => [id, nodes[0].html],
    ),
  );
  assert.deepEqual(found, []);
  const [copy] = await Promise.all([
    page.waitForEvent('download'),
    page.click('[data-conflict=copy]'),
  ]);
  assert.equal(JSON.parse(await readFile(await copy.path(), 'utf8')).title, 'Mine');
  assert.equal(await readFile(file, 'utf8'), theirs, 'nothing was written');

  await page.click('#conflict [value=""]');
  assert.match(await page.title(), /^● Mine/);
  await page.keyboard.press('Control+s');
  await page.click('[data-conflict=theirs]');
  await page.waitForFunction(() => !document.title.startsWith('● '));
  assert.equal(JSON.parse(await textOf(page)).title, '<img src=x onerror=alert(1)>');
  await page.click('#undo');
  await page.waitForFunction(() => document.title.startsWith('● Mine'));
  await writeFile(file, theirs.replace('yard', 'there'));
  await page.keyboard.press('Control+s');
  await page.click('[data-conflict=mine]');
  await saysToast(page, 'Saved my yard.json');
  assert.equal(await readFile(file, 'utf8'), kYard.replace('Yard', 'Mine'));
});

test('unsaved changes are there again, and leaving asks only while there are some', async (t) => {
  const { page, edit, file } = await servedYard(t);
  const asked = [];
  page.on('dialog', (dialog) => {
    asked.push(dialog.type());
    dialog.accept();
  });
  await page.goto(edit);
  await isReady(page);
  await page.mouse.click(5, 700); // browsers ask nobody who has done nothing
  await page.reload();
  await isReady(page);
  assert.deepEqual(asked, []);
  await rename(page, 'Mine');
  await isKept(page);
  await page.mouse.click(5, 700);
  await page.reload();
  await isReady(page);
  assert.deepEqual(asked, ['beforeunload']);
  assert.match(await page.title(), /^● Mine/);
  // It changes on the disk while the editor is closed.
  await page.goto('about:blank');
  await writeFile(file, kYard.replace('Yard', 'Theirs'));
  await page.goto(edit);
  await page.click('#outside button');
  assert.equal(await page.isVisible('[data-conflict=both]'), false, 'both have renamed it');
  await page.click('[data-conflict=theirs]');
  await page.waitForFunction(() => document.title.startsWith('Theirs'));
});

test('what others save is seen at once; changes of both become one text', async (t) => {
  const { page, edit, file } = await servedYard(t);
  await page.goto(edit);
  await isReady(page);
  await writeFile(file, kYard.replace('Yard', 'Theirs'));
  await page.waitForFunction(() => document.title.startsWith('Theirs'));
  await saysToast(page, 'This is my yard.json as it was changed outside');
  await told(page, () => {
    const { history } = window.slicecastEditor;
    history.do('Place', [{ map: 0, cells: [{ layer: 0, x: 3, y: 3, sign: 'b' }] }]);
  });
  await writeFile(file, kYard.replace('Yard', 'Gate'));
  await page.waitForSelector('#outside:not([hidden])');
  assert.equal(await page.locator('#conflict[open]').count(), 0, 'nobody is interrupted');
  await page.click('#outside button');
  await page.click('[data-conflict=both]');
  assert.equal(await page.isVisible('#outside'), false);
  assert.match(await page.title(), /^● Gate/);
  await page.keyboard.press('Control+s');
  await saysToast(page, 'Saved my yard.json');
  const after = await readFile(file, 'utf8');
  assert.equal([...after].filter((letter, at) => letter !== kYard[at]).length, 4);
});

test('a scene that tools/play does not serve is refused in words', async (t) => {
  const { page } = await openPage(t, browser, {
    query: 'edit.html?scene=-/scene/other.json',
    expectErrors: true,
  });
  await page.waitForFunction(() => document.body.dataset.state === 'failed');
  assert.match(await page.textContent('#about'), /opened by tools\/play, which does not serve it/);
});

// ---- Files that pages may write: the browser's own stand in for those of a disk

const withFiles = async (page) => {
  await page.addInitScript(() => {
    const handle = async (name) =>
      (await navigator.storage.getDirectory()).getFileHandle(name, { create: true });
    globalThis.showOpenFilePicker = async () => [await handle('mine.json')];
    globalThis.showSaveFilePicker = async ({ suggestedName }) => handle(suggestedName);
    globalThis.fileText = async (name) => (await (await handle(name)).getFile()).text();
    globalThis.fileWrite = async (name, text) => {
      const file = await (await handle(name)).createWritable();
      await file.write(text);
      await file.close();
    };
  });
};

test('a file that was opened is saved to, and not if it has changed outside', async (t) => {
  const { page } = await openEditor(t, '?template=cave', { prepare: withFiles });
  const text = JSON.stringify(smallScene('Mine'), null, 1).replaceAll('\n', '\r\n');
  await told(page, (content) => window.fileWrite('mine.json', content), text);
  await page.click('#open-files');
  await page.click('#open-file');
  await page.waitForURL(/\?file=mine$/);
  await isReady(page);
  const fileText = () => told(page, () => window.fileText('mine.json'));
  assert.equal(await page.isVisible('#save'), true);
  await rename(page, 'Changed');
  await page.keyboard.press('Control+s');
  await saysToast(page, 'Saved mine.json');
  assert.equal(await fileText(), text.replace('"Mine"', '"Changed"'));
  await isKept(page);
  await page.reload();
  await isReady(page);
  assert.equal(await page.title(), 'Changed · Build a world');

  await told(page, (content) => window.fileWrite('mine.json', content), text);
  await page.waitForFunction(() => document.title.startsWith('Mine'));
  await rename(page, 'Again');
  await told(
    page,
    (content) => window.fileWrite('mine.json', content),
    text.replace('"Mine"', '"Theirs"'),
  );
  await page.keyboard.press('Control+s');
  await page.click('[data-conflict=mine]');
  await saysToast(page, 'Saved mine.json');
  assert.equal(await fileText(), text.replace('"Mine"', '"Again"'));
});

test('a world without a file gets one by the first save', async (t) => {
  const { page } = await openEditor(t, '?template=cave', { prepare: withFiles });
  assert.equal(await page.isVisible('#save'), false);
  await rename(page, 'Deep');
  await page.keyboard.press('Control+s');
  await saysToast(page, 'Saved deep.json');
  assert.equal(await told(page, () => window.fileText('deep.json')), await textOf(page));
  await rename(page, 'Deeper');
  await page.waitForFunction(() => document.title.startsWith('● '));
  await page.click('#save');
  await page.waitForFunction(() => !document.title.startsWith('● '));
  assert.match(await told(page, () => window.fileText('deep.json')), /"Deeper"/);
  await isKept(page);
  await page.reload();
  await isReady(page);
  assert.equal(await page.isVisible('#save'), true, 'it is remembered');
});

test('where pages may write no files, a save is a download in the form of the file', async (t) => {
  const { page } = await openEditor(t, '?template=cave', {
    prepare: (one) =>
      one.addInitScript(() => {
        delete globalThis.showSaveFilePicker;
        delete globalThis.showOpenFilePicker;
      }),
  });
  const text = JSON.stringify(smallScene('Mine'), null, 1).replaceAll('\n', '\r\n');
  await page.click('#open-files');
  await page.setInputFiles('#files input[type=file]', [
    { name: 'mine.json', mimeType: 'application/json', buffer: Buffer.from(text) },
  ]);
  await page.waitForURL(/\?file=mine$/);
  await isReady(page);
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    page.keyboard.press('Control+s'),
  ]);
  assert.equal(file.suggestedFilename(), 'mine.json');
  assert.equal(await readFile(await file.path(), 'utf8'), text);
});

test('a file with the name of another world replaces nothing that is kept', async (t) => {
  const { page } = await openEditor(t, '?template=cave', {
    prepare: (one) => one.addInitScript(() => delete globalThis.showOpenFilePicker),
  });
  const open = async (title, query) => {
    await page.click('#open-files');
    const buffer = Buffer.from(JSON.stringify(smallScene(title)));
    await page.setInputFiles('#files input[type=file]', [
      { name: 'mine.json', mimeType: 'application/json', buffer },
    ]);
    await page.waitForURL((address) => address.search === query);
    await isReady(page);
  };
  await open('One', '?file=mine');
  await open('Two', '?file=mine%202');
  await page.goBack();
  await isReady(page);
  assert.equal(JSON.parse(await textOf(page)).title, 'One');
});

// ---- Edit from everywhere

test('each scene of the menu has an editor, and the bar’s button opens that of the scene', async (t) => {
  const { page } = await openPage(t, browser, { viewport: { width: 1366, height: 768 } });
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  await page.click('#open-scenes');
  const links = page.locator('#scene-list .edit');
  assert.equal(await links.count(), await page.locator('#scene-list .scene').count());
  const boxes = await links.evaluateAll((all) =>
    all.map((one) => one.getBoundingClientRect().height),
  );
  assert.ok(Math.min(...boxes) >= 44, `${Math.min(...boxes)}`);
  const [first] = await links.evaluateAll((all) => all.map((one) => one.href));
  assert.match(first, /edit\.html\?scene=[\w-]+$/);
  await links.first().click();
  await isReady(page);
});

test('a scene that was dropped onto the play page goes over to the editor', async (t) => {
  const { page } = await openPage(t, browser, { viewport: { width: 1366, height: 768 } });
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  const scene = smallScene('Dropped');
  scene.textures[kSix[0]] = 'own.png';
  const text = JSON.stringify(scene);
  await page.setInputFiles('#files', [
    { name: 'dropped.json', mimeType: 'application/json', buffer: Buffer.from(text) },
    { name: 'own.png', mimeType: 'image/png', buffer: kBeside[`${kSix[0]}.png`] },
  ]);
  await page.waitForFunction(() => window.slicecast.world?.title === 'Dropped');
  await page.click('#open-edit');
  await page.waitForURL(/edit\.html\?file=dropped$/);
  await isReady(page);
  assert.equal(await textOf(page), text);
  await page.click('#open-share');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('#save-zip')]);
  const zip = unzipSync(await readFile(await file.path()));
  assert.deepEqual(Object.keys(zip).sort(), ['dropped.json', 'own.png']);
});

// ---- One HTML file

async function htmlOf(t, page) {
  await page.click('#open-share');
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('#save-html')]);
  const place = path.join(await folderFor(t), file.suggestedFilename());
  await file.saveAs(place);
  return place;
}

test('one HTML file plays from a disk, by keys and by touch, without a request', async (t) => {
  const { page } = await openEditor(t, '?template=cave', {
    prepare: (one) => one.addInitScript(() => delete globalThis.showOpenFilePicker),
  });
  await page.click('#open-files');
  const title = 'Yard </title><script>document.title = "broken"</script>';
  await page.setInputFiles('#files input[type=file]', [
    {
      name: 'yard.json',
      mimeType: 'application/json',
      buffer: Buffer.from(JSON.stringify(smallScene(title))),
    },
  ]);
  await page.waitForURL(/\?file=yard$/);
  await isReady(page);
  const place = await htmlOf(t, page);
  const { size } = await stat(place);
  t.diagnostic(`${size} bytes with six textures`);
  assert.ok(size <= 450_000, `${size} bytes, at most 450,000`);

  const context = await browser.newContext({
    viewport: { width: 800, height: 500 },
    hasTouch: true,
    offline: true,
  });
  t.after(() => context.close());
  const player = await context.newPage();
  player.setDefaultTimeout(kWait);
  const complaints = [];
  const requests = [];
  player.on('console', (message) => complaints.push(message.text()));
  player.on('pageerror', (error) => complaints.push(String(error)));
  player.on('request', (request) => requests.push(request.url()));
  await player.goto(pathToFileURL(place).href);
  await player.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await player.title(), title);
  const isEntered = (value) =>
    player.waitForFunction(
      (wanted) => document.querySelector('ray-caster').entered === wanted,
      value,
    );
  const view = () => player.evaluate(() => document.querySelector('ray-caster').currentView);
  const moves = async () => {
    const before = await view();
    return player.waitForFunction(({ x, y }) => {
      const now = document.querySelector('ray-caster').currentView;
      return Math.hypot(now.x - x, now.y - y) > 0.3;
    }, before);
  };
  await player.waitForFunction(() => document.activeElement.localName === 'ray-caster');
  await player.keyboard.press('Enter');
  await isEntered(true);
  await player.keyboard.down('KeyW');
  await moves();
  await player.keyboard.up('KeyW');
  await player.keyboard.press('Escape');
  await isEntered(false);
  await player.touchscreen.tap(400, 250);
  await isEntered(true);
  await player.keyboard.press('Escape');
  await isEntered(false);

  // Servers often say that all pages are UTF-8.
  const kServed = 'https://worlds.example/yard.html';
  await player.route(kServed, (route) =>
    route.fulfill({ path: place, contentType: 'text/html; charset=utf-8' }),
  );
  await player.goto(kServed);
  await player.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await player.title(), title);

  await player.click('#open-about');
  await player.waitForFunction(() =>
    /RapidJSON[^]*Permission is hereby granted/.test(
      document.getElementById('licences').textContent,
    ),
  );
  await player.addScriptTag({ path: kAxe }).catch(() => {}); // its policy allows no file
  assert.deepEqual(
    requests.filter((address) => !address.startsWith('data:')),
    [pathToFileURL(place).href, kServed],
  );
  assert.deepEqual(
    complaints.filter((text) => !/axe|Content Security Policy/.test(text)),
    [],
  );
});

test('the shipped castle becomes one HTML file, too', async (t) => {
  const { page } = await openEditor(t, '?scene=castle');
  const place = await htmlOf(t, page);
  t.diagnostic(`${(await stat(place)).size} bytes for the castle`);
  const context = await browser.newContext({ viewport: { width: 640, height: 400 } });
  t.after(() => context.close());
  const player = await context.newPage();
  await player.goto(pathToFileURL(place).href);
  await player.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await player.title(), 'The castle in the lake');
});

// ---- Own pictures

const picture = (page, type, width, height) =>
  told(
    page,
    async ([wanted, ...sides]) => {
      const canvas = new OffscreenCanvas(...sides);
      const context = canvas.getContext('2d');
      context.fillStyle = '#c03020';
      context.fillRect(0, 0, ...sides);
      const blob = await canvas.convertToBlob({ type: wanted });
      return Array.from(new Uint8Array(await blob.arrayBuffer()));
    },
    [type, width, height],
  );

// Dispatched as a browser does it, since a test has no other program to drag from.
const drop = (page, event, name, type, bytes) =>
  told(
    page,
    ([kind, fileName, fileType, content]) => {
      const transfer = new DataTransfer();
      transfer.items.add(new File([new Uint8Array(content)], fileName, { type: fileType }));
      const how = { bubbles: true, cancelable: true };
      document.body.dispatchEvent(
        kind === 'drop'
          ? new DragEvent('drop', { ...how, dataTransfer: transfer })
          : new ClipboardEvent('paste', { ...how, clipboardData: transfer }),
      );
    },
    [event, name, type, bytes],
  );

test('a picture that is dropped becomes a block, scaled as one was told', async (t) => {
  const { page } = await openEditor(t);
  await drop(
    page,
    'drop',
    'my wall.jpg',
    'image/jpeg',
    await picture(page, 'image/jpeg', 300, 200),
  );
  await page.waitForSelector('#own-picture[open]');
  assert.equal(
    await page.textContent('[data-picture=about]'),
    'JPEG, 300 × 200 pixels, becomes a PNG of 128 × 128: its middle, as textures are square.',
  );
  await page.selectOption('[data-picture=side]', '64');
  assert.match(await page.textContent('[data-picture=about]'), /PNG of 64 × 64/);
  await page.press('[data-picture=name]', 'Enter');
  await settle(page);
  const scene = JSON.parse(await textOf(page));
  assert.equal(scene.textures['my wall'], 'my-wall.png');
  assert.deepEqual(scene.blueprints['my wall'], { faces: 'my wall' });
  assert.equal(await told(page, () => window.slicecastEditor.caster.error), null);
  await page.waitForSelector('#palette [aria-label="my wall"][aria-pressed=true]');

  await page.click('#open-share');
  assert.match(await page.textContent('#share-about'), /own pictures has no link/);
  const [file] = await Promise.all([page.waitForEvent('download'), page.click('#save-zip')]);
  const zip = unzipSync(await readFile(await file.path()));
  const [json] = Object.keys(zip).filter((name) => name.endsWith('.json'));
  assert.equal(strFromU8(zip[json]), await textOf(page));
  assert.equal(Buffer.from(zip['my-wall.png']).readUInt32BE(16), 64);
  await page.click('#share [data-close]');

  // The zip opens again, in a browser that knows nothing of it.
  const other = await openEditor(t, '?template=cave', {
    prepare: (one) => one.addInitScript(() => delete globalThis.showOpenFilePicker),
  });
  await other.page.click('#open-files');
  await other.page.setInputFiles('#files input[type=file]', [
    { name: 'again.zip', mimeType: 'application/zip', buffer: Buffer.from(zipSync(zip)) },
  ]);
  await other.page.waitForURL(/\?file=/);
  await isReady(other.page);
  await settle(other.page);
  assert.equal(await textOf(other.page), await textOf(page));
  assert.equal(await told(other.page, () => window.slicecastEditor.caster.error), null);

  // One undo takes it back as it came.
  await page.click('#undo');
  assert.equal(JSON.parse(await textOf(page)).textures['my wall'], undefined);
});

test('a picture that is pasted becomes a thing, and one that is not used can go', async (t) => {
  const { page } = await openEditor(t);
  const before = await textOf(page);
  await drop(page, 'paste', 'image.webp', 'image/webp', await picture(page, 'image/webp', 20, 50));
  await page.selectOption('[data-picture=what]', 'sprites');
  assert.match(
    await page.textContent('[data-picture=about]'),
    /20 × 50 pixels, becomes a PNG of 6 × 16\.$/,
  );
  await page.click('#own-picture .main');
  await settle(page);
  assert.equal(JSON.parse(await textOf(page)).sprites.image, 'image.png');
  await isKept(page);
  await page.reload();
  await isReady(page);
  await settle(page);
  assert.equal(await told(page, () => window.slicecastEditor.caster.error), null);
  await page.keyboard.press('KeyT');
  await page.click('#palette .add');
  await page.click('#adding .remove');
  assert.equal(await page.locator('#adding .remove').count(), 0);
  await page.click('#adding [data-close]');
  await settle(page);
  assert.equal(await textOf(page), before);
  await page.click('#undo');
  await settle(page);
  assert.equal(await told(page, () => window.slicecastEditor.caster.error), null);
});

test('a chosen picture is a texture at once; what is none is refused in words', async (t) => {
  const { page } = await openEditor(t);
  const [face] = await page.locator('#kind .faces button').all();
  await face.click();
  await page.setInputFiles('#adding input[type=file]', [
    {
      name: 'door.png',
      mimeType: 'image/png',
      buffer: Buffer.from(await picture(page, 'image/png', 32, 32)),
    },
  ]);
  await page.click('#own-picture .main');
  await settle(page);
  const scene = JSON.parse(await textOf(page));
  assert.equal(scene.textures.door, 'door.png');
  assert.match(JSON.stringify(scene.blueprints), /"north":"door"/);
  const svg = [...Buffer.from('<svg xmlns="http://www.w3.org/2000/svg"><script/></svg>')];
  await drop(page, 'drop', 'a.svg', 'image/svg+xml', svg);
  await saysToast(page, 'Found an SVG');
  await drop(page, 'drop', 'b.png', 'image/png', [...Buffer.from('no picture')]);
  await saysToast(page, 'Found another kind of file');
});

for (const width of [360, 820, 1366])
  test(`in a window of ${width} pixels the dialogs of files fit, and axe finds nothing`, async (t) => {
    const { page } = await openEditor(t, '?template=house', {
      viewport: { width, height: 800 },
      context: { hasTouch: width < 1000, isMobile: width < 1000 },
    });
    await page.addScriptTag({ path: kAxe });
    for (const id of ['share', 'own-picture', 'other-tab', 'conflict', 'adding']) {
      await told(page, (one) => document.getElementById(one).showModal(), id);
      const dialog = page.locator(`#${id}`);
      const box = await dialog.boundingBox();
      assert.ok(box.x >= 0 && box.x + box.width <= width, `${id}: ${JSON.stringify(box)}`);
      assert.ok(await dialog.evaluate((one) => one.scrollWidth <= one.clientWidth), id);
      if (width < 1000) {
        const low = await dialog.evaluate((one) =>
          [...one.querySelectorAll('button, select, input')]
            .filter((part) => part.checkVisibility() && part.offsetHeight < 44)
            .map((part) => part.outerHTML),
        );
        assert.deepEqual(low, [], 'too low for a finger');
      }
      const found = await told(
        page,
        async (one) =>
          (await window.axe.run(`#${one}`, { resultTypes: ['violations'] })).violations.map(
            ({ id: rule, nodes }) => [rule, nodes[0].html],
          ),
        id,
      );
      assert.deepEqual(found, [], id);
      await told(page, (one) => document.getElementById(one).close(), id);
    }
  });

test('each world to begin with, and each shipped scene, is shown with a picture', async (t) => {
  const { page } = await openEditor(t);
  await page.click('#open-files');
  const shown = (list) =>
    page.locator(`#${list} button`).evaluateAll((all) =>
      Promise.all(
        all.map(async (button) => {
          const image = button.querySelector('img');
          image.loading = 'eager';
          await image.decode();
          return [button.textContent, image.naturalWidth > 100];
        }),
      ),
    );
  await page.waitForSelector('#remixes button');
  const [worlds, scenes] = [await shown('templates'), await shown('remixes')];
  assert.equal(worlds.length, 6);
  assert.deepEqual(
    worlds.filter(([, isDrawn]) => !isDrawn),
    [],
  );
  assert.equal(scenes.length, 2, 'of the test server');
});

// ---- Hostile files

test('zips that lead elsewhere or unpack to too much are refused, and nothing changes', async (t) => {
  const { page } = await openEditor(t, '?template=cave');
  const before = await textOf(page);
  await page.click('#open-files');
  const open = async (files, message) => {
    const buffer = Buffer.from(zipSync(files));
    await page.setInputFiles('#files input[type=file]', [
      { name: 'evil.zip', mimeType: 'application/zip', buffer },
    ]);
    await page.waitForFunction(
      (wanted) => new RegExp(wanted).test(document.getElementById('open-told').textContent),
      message,
    );
  };
  const scene = strToU8(JSON.stringify(smallScene()));
  await open({ 'a.json': scene, '../b.png': scene }, 'expected one in its own folder');
  await open({ 'a.json': scene, 'b.png': new Uint8Array(100 << 20) }, 'more than 64 MB');
  assert.equal(await textOf(page), before);
});

test('a title of HTML is a title', async (t) => {
  const { page } = await openEditor(t, '?template=cave');
  const title =
    '<img src=x onerror="window.isBroken = true"><script>window.isBroken = true</script>';
  await rename(page, title);
  await page.click('#open-share');
  await frames(page);
  assert.equal(await told(page, () => window.isBroken), undefined);
  assert.ok((await page.title()).startsWith(title));
  const tag = await page.inputValue('#share-tag');
  const shown = await told(
    page,
    (html) => {
      const place = document.createElement('div');
      place.innerHTML = html;
      return [...place.children].map((one) => [one.localName, one.getAttribute('label')]);
    },
    tag,
  );
  assert.deepEqual(shown, [
    ['script', null],
    ['ray-caster', title],
  ]);
});

// ---- Two tabs

test('of two tabs with one world one has it: take over, or open a copy', async (t) => {
  const { page, context, server } = await openEditor(t, '?template=cave');
  await rename(page, 'First');
  const address = `${server.address}edit.html?template=cave`;
  const other = await context.newPage();
  other.setDefaultTimeout(kWait);
  await other.goto(address);
  await other.waitForSelector('#other-tab[open]');
  await other.keyboard.press('Escape');
  assert.equal(await other.isVisible('#other-tab'), true, 'one has to choose');
  // What was done a moment ago is not kept yet.
  await told(page, () => (window.setTimeout = () => 0));
  await rename(page, 'Second');
  await Promise.all([other.waitForEvent('load'), other.click('[data-take]')]);
  await isReady(other);
  assert.equal(await other.inputValue('#title'), 'Second', 'nothing is lost');
  assert.equal(await other.locator('#other-tab[open]').count(), 0);
  await page.waitForSelector('#other-tab[open]');
  assert.match(await page.textContent('#other-tab p'), /taken this world over/);
  await rename(other, 'Third');
  await isKept(other);
  await rename(page, 'Late'); // by a script: the dialog is in the way of everything else
  await told(page, () => dispatchEvent(new Event('pagehide')));
  await Promise.all([page.waitForEvent('load'), page.click('[data-take]')]);
  await isReady(page);
  assert.equal(await page.inputValue('#title'), 'Third');

  await other.click('[data-copy-world]');
  await other.waitForURL(/\?file=Third%20copy$/);
  await isReady(other);
  await rename(other, 'Copy');
  await isKept(other);
  await page.reload();
  await isReady(page);
  assert.equal(await page.inputValue('#title'), 'Third');
});
