// Scenes: the menu, files that are dropped, faults, and reloading while somebody edits.

import assert from 'node:assert/strict';
import { mkdir, mkdtemp, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { after, before, test } from 'node:test';
import { startServer } from '../../tools/serve.mjs';
import {
  frames,
  inState,
  launch,
  openPage,
  openScene,
  pixel,
  play,
  player,
  untilPlayer,
} from './browser.mjs';
import { png } from './png.mjs';
import { kBlue, kGreen, roomFiles, roomPictures, roomScene } from './room.mjs';
import { serve } from './static-server.mjs';

const kOrange = [240, 130, 20];

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const faultRows = (page) =>
  page.$$eval('#trouble-faults tbody tr', (rows) =>
    rows.map((row) => ({
      place: row.querySelector('th').firstChild.textContent,
      inside: row.querySelector('.inside')?.textContent ?? '',
      found: row.querySelectorAll('td')[0].textContent,
      expected: row.querySelectorAll('td')[1].textContent,
    })),
  );

// Drops files on the page: name -> text or bytes.
function drop(page, files) {
  const list = Object.entries(files).map(([name, content]) => ({
    name,
    base64: Buffer.from(content).toString('base64'),
  }));
  return page.evaluate((all) => {
    const data = new DataTransfer();
    for (const { name, base64 } of all)
      data.items.add(
        new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name),
      );
    for (const type of ['dragenter', 'dragover', 'drop']) {
      window.dispatchEvent(
        new DragEvent(type, { dataTransfer: data, bubbles: true, cancelable: true }),
      );
    }
  }, list);
}

test('the menu shows a view of every scene, opens one, and Back leads back', async (t) => {
  const { page } = await openScene(t, browser);
  await page.click('#open-scenes');
  await page.waitForSelector('#scenes[open]');
  assert.deepEqual(
    await page.$$eval('#scene-list h3', (titles) => titles.map((title) => title.textContent)),
    ['The coloured room', 'The other room'],
  );
  assert.equal(await page.textContent('#scene-list a[aria-current] h3'), 'The coloured room');
  const middle = (index) =>
    page
      .waitForFunction((which) => {
        const view = document.querySelectorAll('#scene-list img')[which];
        if (!view.complete || view.naturalWidth === 0) return false;
        const copy = new OffscreenCanvas(1, 1).getContext('2d');
        copy.drawImage(view, -view.naturalWidth / 2, -view.naturalHeight / 2);
        return copy.getImageData(0, 0, 1, 1).data.subarray(0, 3).join();
      }, index)
      .then((handle) => handle.jsonValue());
  assert.equal(await middle(0), kGreen.join());
  assert.equal(await middle(1), kBlue.join());

  await page.evaluate(() => {
    window.isSamePage = true;
  });
  await page.click('#scene-list a:has-text("The other room")');
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kBlue);
  assert.match(page.url(), /\?scene=other$/);
  assert.equal(await page.evaluate(() => window.isSamePage), true, 'nothing is loaded twice');
  await page.goBack();
  await page.waitForFunction(() => document.title.startsWith('The coloured room'));
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kGreen);
});

test("the list of scenes has every scene's title, and each opens without faults", async (t) => {
  const folder = new URL('../../build/web/scenes/', import.meta.url);
  const read = async (name) => JSON.parse(await readFile(new URL(name, folder), 'utf8'));
  const list = await read('index.json');
  const there = (await readdir(folder)).filter(
    (name) => name.endsWith('.json') && name !== 'index.json',
  );
  assert.deepEqual(list.map(({ file }) => file).sort(), there.sort());
  const tours = (await readdir(new URL('../tours/', folder))).map((name) =>
    name.replace(/\.txt$/, '.json'),
  );
  assert.deepEqual(
    list
      .filter(({ tour }) => tour)
      .map(({ file }) => file)
      .sort(),
    tours.sort(),
  );
  const { page } = await openScene(t, browser, {
    server: { files: { 'scenes/index.json': JSON.stringify(list) } },
  });
  assert.equal(await page.textContent('#bar-title'), list[0].title);
  for (const { file, title, about } of list) {
    assert.equal((await read(file)).title, title);
    assert.ok(about.length > 10, `${file} says what it is about`);
    await page.click('#open-scenes');
    await page.click(
      `#scene-list a[href="?scene=${encodeURIComponent(file.replace(/\.json$/, ''))}"]`,
    );
    await page.waitForFunction((wanted) => document.title.startsWith(wanted), title);
    await inState(page, 'paused');
  }
});

test('the menu fetches only pictures that the list names', async (t) => {
  const list = [
    { file: 'room.json', title: 'First', about: 'A room.', poster: 'posters/room.png' },
    { file: 'other.json', title: 'Other', about: 'A room without a picture.' },
  ];
  const { page, server } = await openScene(t, browser, {
    server: {
      files: { 'scenes/index.json': JSON.stringify(list), 'scenes/posters/other.png': null },
    },
  });
  await page.click('#open-scenes');
  await page.waitForFunction(() => document.querySelector('#scene-list img').naturalWidth > 0);
  await frames(page);
  assert.deepEqual(
    server.asked.filter((name) => name.includes('posters/')),
    ['scenes/posters/room.png'],
  );
  // Its space is reserved anyway.
  const heights = await page.$$eval('#scene-list img', (all) => all.map((one) => one.clientHeight));
  assert.ok(heights[1] > 50 && Math.abs(heights[1] - heights[0]) <= 1, `${heights}`);
});

test('the built page names a picture of each scene', async () => {
  const folder = new URL('../../build/web/scenes/', import.meta.url);
  for (const { poster } of JSON.parse(await readFile(new URL('index.json', folder), 'utf8')))
    assert.ok((await readFile(new URL(poster, folder))).length > 1000, poster);
});

test('the menu sets the teaching rooms apart', async (t) => {
  const { page } = await openScene(t, browser, {
    server: {
      files: {
        'scenes/index.json': JSON.stringify([
          { file: 'room.json', title: 'First', about: 'The opening scene.' },
          { file: 'other.json', title: 'Other', about: 'A room.', group: 'Teaching rooms' },
        ]),
      },
    },
  });
  await page.click('#open-scenes');
  assert.deepEqual(
    await page.$$eval('#scene-list > li', (items) =>
      items.map((item) => item.querySelector('h3')?.textContent ?? `[${item.textContent}]`),
    ),
    ['First', '[Teaching rooms]', 'Other'],
  );
});

test('the address names a scene, with or without its ending', async (t) => {
  for (const query of ['?scene=other', '?scene=other.json', '?scene=scenes/other.json']) {
    const { page, context } = await openScene(t, browser, { query });
    assert.deepEqual(await pixel(page, 0.5, 0.5), kBlue, query);
    await context.close();
  }
});

test('a scene dropped with its pictures opens', async (t) => {
  const { page } = await openScene(t, browser);
  const scene = roomScene({ title: 'Dropped', folder: 'own/' });
  await drop(page, {
    ...roomPictures(),
    'dropped.json': JSON.stringify(scene),
    'green.png': png(8, () => kOrange),
  });
  await page.waitForFunction(() => document.title.startsWith('Dropped'));
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kOrange);
});

test('a scene that is dropped while the engine loads opens first', async (t) => {
  let arrive;
  let isAsked = false;
  const arrival = new Promise((resolve) => {
    arrive = resolve;
  });
  const { page } = await openPage(t, browser, {
    query: '?scene=other&options=fov=90',
    prepare: (newPage) =>
      newPage.route('**/*.wasm', async (route) => {
        isAsked = true;
        await arrival; // both parts of the program
        await route.continue();
      }),
  });
  while (!isAsked) await page.waitForTimeout(20);
  await drop(page, {
    ...roomPictures(),
    'dropped.json': JSON.stringify(roomScene({ title: 'Dropped', folder: 'own/' })),
  });
  arrive();
  await inState(page, 'paused');
  assert.equal(await page.title(), 'Dropped · Slicecast');
  assert.equal(
    await page.evaluate(() => window.slicecast.get('fov')),
    '90',
    'as the address wants it',
  );
});

test('a picture that cannot be read: the sheet says why, and trying again fetches it again', async (t) => {
  let picture = null;
  const { page } = await openPage(t, browser, {
    expectErrors: true,
    server: { files: { 'scenes/pictures/green.png': () => picture } },
  });
  await inState(page, 'trouble');
  assert.match((await faultRows(page))[0].found, /pictures\/green\.png.*the server answers 404/);
  picture = png(8, () => kOrange);
  await page.click('#trouble-again');
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kOrange);
});

test("after a redirect, pictures are relative to the scene's final address", async (t) => {
  const files = {
    'far/off/room.json': JSON.stringify(roomScene()),
    ...roomPictures('far/off/pictures/'),
    'far/off/pictures/green.png': png(8, () => kOrange),
  };
  const { page } = await openScene(t, browser, {
    query: '?scene=moved',
    server: { files, redirects: { 'scenes/moved.json': '/far/off/room.json' } },
  });
  assert.deepEqual(await pixel(page, 0.5, 0.5), kOrange);
});

test('a redirect that is gone: trying again looks for the pictures at the current address', async (t) => {
  const redirects = { 'scenes/moved.json': '/far/off/room.json' };
  const files = {
    'far/off/room.json': JSON.stringify(roomScene()),
    'scenes/moved.json': JSON.stringify(roomScene()),
  };
  const { page } = await openPage(t, browser, {
    query: '?scene=moved',
    expectErrors: true,
    server: { files, redirects },
  });
  await inState(page, 'trouble');
  delete redirects['scenes/moved.json'];
  await page.click('#trouble-again');
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kGreen);
});

test('nothing is asked for that the checked scene does not name', async (t) => {
  const other = await serve({ files: {}, headers: { 'Access-Control-Allow-Origin': '*' } });
  t.after(() => other.close());
  const { host } = new URL(other.address);
  const kNames = [
    ...[`http://${host}/a.png`, `//${host}/b.png`, ` //${host}/c.png`, `http://${host}/d?.png`],
    ...[`\t//${host}/e.png`, `\\\\${host}\\f.png`, '/root.png', '../api/logout?.png', 'g.png#.png'],
  ];
  const scene = roomScene();
  const files = {};
  kNames.forEach((name, index) => {
    files[`scenes/odd-${index}.json`] = JSON.stringify({
      ...scene,
      textures: { ...scene.textures, odd: name },
    });
    files[`scenes/said-${index}.json`] = JSON.stringify({ ...scene, title: name });
  });
  const { page, server } = await openPage(t, browser, {
    server: { files },
    query: '?scene=room',
    expectErrors: true,
  });
  await inState(page, 'paused');
  const wanted = [];
  page.on('request', (request) => wanted.push(request.url()));
  for (const where of ['', 'embed.html'])
    for (const [kind, state] of [
      ['odd', /trouble|error/],
      ['said', /paused/],
    ])
      for (const index of kNames.keys()) {
        await page.goto(`${server.address}${where}?scene=${kind}-${index}`);
        await page.waitForFunction(
          (text) => new RegExp(text).test(document.body.dataset.state),
          state.source,
        );
      }
  await page.waitForTimeout(300);
  const pictures = wanted.filter((url) => /\.png|^(?!http:\/\/localhost)/.test(url));
  const known = new RegExp(`^${server.address}scenes/(pictures|posters)/[\\w-]+\\.png$`);
  assert.ok(pictures.length > 50);
  assert.deepEqual(
    pictures.filter((url) => !known.test(url)),
    [],
  );
  assert.deepEqual(other.asked, []);
});

test('pictures of another host are asked for when its scene has been checked', async (t) => {
  const scene = roomScene();
  const other = await serve({
    files: {
      ...roomFiles(),
      'scenes/broken.json': JSON.stringify(scene).slice(0, -1),
      'scenes/whole.json': JSON.stringify(scene),
    },
    headers: { 'Access-Control-Allow-Origin': '*' },
  });
  t.after(() => other.close());
  const { page } = await openPage(t, browser, { query: '?scene=room', expectErrors: true });
  await inState(page, 'paused');
  for (const [file, state] of [
    ['scenes/broken.json', 'error'],
    ['scenes/whole.json', 'ready'],
  ]) {
    other.asked.length = 0;
    await page.evaluate((address) => {
      window.one?.remove();
      window.one = Object.assign(document.createElement('ray-caster'), {
        scene: address,
        loading: 'eager',
      });
      window.one.addEventListener('ready', () => (window.one.dataset.is = 'ready'));
      window.one.addEventListener('error', () => (window.one.dataset.is = 'error'));
      document.body.append(window.one);
    }, other.address + file);
    await page.waitForFunction((is) => window.one.dataset.is === is, state);
    const pictures = other.asked.filter((name) => name.endsWith('.png'));
    assert.equal(pictures.length > 0, state === 'ready', pictures.join());
  }
});

test('without a list of scenes the menu says why', async (t) => {
  const { page } = await openScene(t, browser, {
    query: '?scene=room',
    expectErrors: true,
    server: { files: { 'scenes/index.json': null } },
  });
  await page.click('#open-scenes');
  assert.match(
    await page.textContent('#scenes .missing'),
    /list of scenes could not be loaded.*scenes\/index\.json: the server answers 404/,
  );
});

test('pictures that were not dropped come from the page', async (t) => {
  const { page } = await openScene(t, browser);
  await page.click('#open-scenes');
  await page.setInputFiles('#files', [
    {
      name: 'alone.json',
      mimeType: 'application/json',
      buffer: Buffer.from(
        JSON.stringify({
          ...roomScene({ title: 'Alone' }),
          start: { x: 3.5, y: 3.5, heading: 90 },
        }),
      ),
    },
  ]);
  await page.waitForFunction(() => document.title.startsWith('Alone'));
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kBlue);
});

test('files without a scene among them are refused, and the picture is kept', async (t) => {
  const { page } = await openScene(t, browser);
  await drop(page, roomPictures());
  await inState(page, 'trouble');
  assert.match(await page.textContent('#trouble-text'), /red\.png.*expected a \.json file/);
  await page.click('#trouble-back');
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kGreen);
});

test('after a broken scene was dropped, the button and Escape lead back to the picture', async (t) => {
  const { page } = await openScene(t, browser, { query: '?scene=room', expectErrors: true });
  for (const goBack of [() => page.click('#trouble-back'), () => page.keyboard.press('Escape')]) {
    await drop(page, { 'broken.json': '{ "maps": [' });
    await inState(page, 'trouble');
    await goBack();
    await inState(page, 'paused');
    assert.equal(await page.isVisible('#trouble'), false);
    assert.equal(await page.title(), 'The coloured room · Slicecast');
    assert.deepEqual(await pixel(page, 0.5, 0.5), kGreen);
    await page.keyboard.press('Enter');
    await inState(page, 'playing');
    await page.keyboard.press('Escape');
    await inState(page, 'paused');
  }
});

test('all faults of a scene are shown, with place, found and expected; corrected, it opens', async (t) => {
  const scene = roomScene({ title: 'Mended' });
  const good = JSON.stringify(scene, null, 1);
  const bad = good
    .replace('"top": "grey"', '"top": "gray"')
    .replace('"#.....#"', '"#..Q..#"')
    .replace('"sky": "#88a0b8"', '"sky": "#88a0b"')
    .replace('"floor"', '"flor"');
  let text = bad;
  const { page } = await openPage(t, browser, {
    query: '?scene=broken',
    server: { files: { 'scenes/broken.json': () => text } },
  });
  await inState(page, 'trouble');
  const rows = await faultRows(page);
  const lineOf = (part) => bad.split('\n').findIndex((line) => line.includes(part)) + 1;
  assert.ok(rows.length >= 4, JSON.stringify(rows));
  assert.equal(await page.textContent('#trouble-title'), `${rows.length} faults in broken.json`);
  for (const [part, pointer, found] of [
    ['"gray"', '/blueprints/wall/faces/top', /gray/],
    ['Q', '/maps/0/levels/0', /Q/],
    ['#88a0b', '/maps/0/sky', /#88a0b/],
    ['flor', '/maps/0', /flor/],
  ]) {
    const row = rows.find(({ place }) => place.startsWith(`broken.json:${lineOf(part)}:`));
    assert.ok(row !== undefined, `${part} in line ${lineOf(part)}: ${JSON.stringify(rows)}`);
    assert.match(row.place, /^broken\.json:\d+:\d+$/);
    assert.ok(row.inside.startsWith(pointer), row.inside);
    assert.match(row.found, found);
    assert.ok(row.expected.length > 5);
  }
  assert.equal(await page.isVisible('#trouble-back'), false);
  text = good;
  await page.click('#trouble-again');
  await inState(page, 'paused');
  assert.equal(await page.title(), 'Mended · Slicecast');
});

test('a missing picture is a fault at the place that names it', async (t) => {
  const { page } = await openPage(t, browser, {
    query: '?scene=room',
    expectErrors: true,
    server: { files: { 'scenes/pictures/red.png': null, 'scenes/pictures/blue.png': 'no PNG' } },
  });
  await inState(page, 'trouble');
  const rows = await faultRows(page);
  assert.equal(rows.length, 2);
  assert.deepEqual(rows.map(({ inside }) => inside).sort(), ['/textures/blue', '/textures/red']);
});

test('a missing scene is reported, and others can be chosen', async (t) => {
  const { page } = await openPage(t, browser, { query: '?scene=nowhere', expectErrors: true });
  await inState(page, 'trouble');
  assert.match(
    await page.textContent('#trouble-text'),
    /scenes\/nowhere\.json: the server answers 404/,
  );
  await page.click('#trouble-scenes');
  await page.click('#scene-list a:has-text("The other room")');
  await inState(page, 'paused');
  assert.deepEqual(await pixel(page, 0.5, 0.5), kBlue);
});

test('a scene saved under tools/play is reloaded, and the eye stays where it is', async (t) => {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-live-'));
  await mkdir(path.join(folder, 'pictures'));
  const save = (scene) =>
    writeFile(
      path.join(folder, 'edited.json'),
      typeof scene === 'string' ? scene : JSON.stringify(scene),
    );
  await save(roomScene({ title: 'First' }));
  for (const [name, bytes] of Object.entries(roomPictures()))
    await writeFile(path.join(folder, 'pictures', name), bytes);
  const server = await startServer({
    folder: fileURLToPath(new URL('../../build/web', import.meta.url)),
    scene: path.join(folder, 'edited.json'),
  });
  const context = await browser.newContext({ viewport: { width: 640, height: 360 } });
  t.after(async () => {
    await context.close();
    server.close();
    await rm(folder, { recursive: true });
  });
  const page = await context.newPage();
  await page.goto(server.address);
  await inState(page, 'paused');
  await play(page);
  await page.keyboard.down('w');
  await untilPlayer(page, (now) => now.x > 4.3);
  await page.keyboard.up('w');
  await untilPlayer(page, (now, steps) => now.steps > steps + 60, (await player(page)).steps);
  const before = await player(page);

  // Changed
  const changed = roomScene({ title: 'Second' });
  changed.blueprints.wall.faces.west = 'blue';
  await save(changed);
  await page.waitForFunction(() => document.title.startsWith('Second'));
  await inState(page, 'playing');
  const now = await player(page);
  assert.deepEqual(
    [now.x, now.y, now.z, now.heading, now.flying],
    [before.x, before.y, before.z, before.heading, before.flying],
  );
  await page.waitForFunction(() => {
    const canvas = window.slicecast.shadowRoot.querySelector('canvas');
    return (
      canvas.getContext('2d').getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data[2] ===
      210
    );
  });

  // Broken, then corrected
  await save('{"title": "Third",}');
  await inState(page, 'trouble');
  assert.equal((await faultRows(page)).length, 1);
  assert.match(await page.textContent('#trouble-text'), /Fix these faults and save the file/);
  await save(roomScene({ title: 'Fourth' }));
  await page.waitForFunction(() => document.title.startsWith('Fourth'));
  await inState(page, 'playing');
  assert.equal((await player(page)).x, before.x);
});
