// The editor in a page: worlds are built in the picture, on the plan and as text, walked in, kept,
// and shared by a link.

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { frames, launch, openPage } from './browser.mjs';
import {
  lookAt,
  openEditor as openTheEditor,
  pointOf,
  rowsOf,
  settle,
  textOf,
  told,
} from './editor-page.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const { deflateSync, strToU8, zipSync } = createRequire(
  new URL('../../tools/package.json', import.meta.url),
)('fflate');
const kCastle = readFileSync(new URL('../../assets/scenes/castle.json', import.meta.url), 'utf8');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const hashOf = (scene) =>
  `#world=${Buffer.from(deflateSync(strToU8(JSON.stringify(scene)))).toString('base64url')}`;
const openEditor = (t, query, options) => openTheEditor(t, browser, query, options);

test('a first block is placed with one click, removed with another, and undone', async (t) => {
  const { page } = await openEditor(t);
  const before = await textOf(page);
  await lookAt(page, { x: 16.5, y: 20.5, z: 1.6, heading: 270, look: -0.5 });
  const [x, y] = await pointOf(page, 16.5, 17.5, 0);
  await page.mouse.move(x, y);
  await page.waitForFunction(
    () => document.getElementById('where').textContent === 'x 16, y 17, level 0',
  );
  await page.mouse.click(x, y);
  const sign = await told(page, () => window.slicecastEditor.editor.sign);
  assert.equal((await rowsOf(page, 0))[17][16], sign);
  // Against its south, then onto its top.
  await page.mouse.click(...(await pointOf(page, 16.5, 18, 0.5)));
  assert.equal((await rowsOf(page, 0))[18][16], sign);
  await page.mouse.click(...(await pointOf(page, 16.5, 18.5, 1)));
  assert.equal((await rowsOf(page, 1))[18][16], sign);
  await page.mouse.click(...(await pointOf(page, 16.5, 19, 1.5)), { button: 'right' });
  assert.equal((await rowsOf(page, 1))[18][16], '.');
  for (let count = 0; count < 4; ++count) await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);
  await page.keyboard.press('Control+y');
  assert.equal((await rowsOf(page, 0))[17][16], sign);
});

test('a drag puts a row, the other tools do as they say, and the picture follows', async (t) => {
  const { page } = await openEditor(t);
  await lookAt(page, { x: 16.5, y: 21.5, z: 3, heading: 270, look: -0.7 });
  const drag = async (from, to, button = 'left') => {
    await page.mouse.move(...(await pointOf(page, ...from)));
    await page.mouse.down({ button });
    await page.mouse.move(...(await pointOf(page, ...to)), { steps: 8 });
    await frames(page);
    await page.mouse.up({ button });
  };
  await drag([14.5, 17.5, 0], [18.5, 17.5, 0]);
  assert.match((await rowsOf(page, 0))[17].slice(13, 20), /^\.([^.])\1{4}\.$/);
  await page.keyboard.press('KeyX');
  await page.keyboard.press('3');
  const third = await told(page, () => window.slicecastEditor.editor.sign);
  await drag([15.5, 14.5, 0], [17.5, 16.5, 0]);
  assert.equal((await rowsOf(page, 0))[15].slice(14, 19), `.${third.repeat(3)}.`);
  await page.keyboard.press('KeyH');
  await page.mouse.move(...(await pointOf(page, 16.5, 15.5, 1)));
  await frames(page);
  for (let notch = 0; notch < 5; ++notch) {
    await page.mouse.wheel(0, 100);
    await settle(page);
  }
  const half = (await rowsOf(page, 0))[15][16];
  assert.notEqual(half, third);
  const [name, top] = await told(
    page,
    (sign) => {
      const { scene, caster } = window.slicecastEditor;
      const { name: shown, top: height } = caster
        .blueprints()
        .find((one) => one.character === sign);
      return [shown, height, scene.value.blueprints[shown].top];
    },
    half,
  );
  assert.match(name, /up to 0.5$/);
  assert.equal(top, 0.5);
});

test('the plan edits the same world, level by level', async (t) => {
  const { page } = await openEditor(t);
  await page.keyboard.press('KeyG');
  await page.waitForSelector('#plan');
  await frames(page);
  const box = await page.locator('#plan').boundingBox();
  const tile = (column, row) => [
    box.x + box.width / 2 + (column - 16) * (box.height / 34),
    box.y + box.height / 2 + (row - 16) * (box.height / 34),
  ];
  // Of one tile, as drawn.
  const colourAt = async (column, row) => {
    await page.mouse.move(...tile(2.5, 2.5));
    await frames(page);
    const [left, top] = tile(column, row);
    return told(
      page,
      ([x, y]) =>
        String(document.querySelector('#plan').getContext('2d').getImageData(x, y, 1, 1).data),
      [left - box.x, top - box.y],
    );
  };
  const grass = await colourAt(12.7, 10.7);
  await page.mouse.move(...tile(10.5, 10.5));
  await page.mouse.down();
  await page.mouse.move(...tile(14.5, 10.5), { steps: 6 });
  await page.mouse.up();
  assert.match((await rowsOf(page, 0))[10].slice(9, 16), /^\.([^.])\1{4}\.$/);
  await page.keyboard.press('PageUp');
  await page.mouse.click(...tile(10.5, 10.5));
  assert.notEqual((await rowsOf(page, 1))[10][10], '.');
  await page.mouse.click(...tile(12.5, 10.5), { button: 'right' });
  await page.keyboard.press('PageDown');
  await page.mouse.click(...tile(12.5, 10.5), { button: 'right' });
  assert.equal((await rowsOf(page, 0))[10][12], '.');
  assert.equal(await colourAt(12.7, 10.7), grass);
  const wall = await colourAt(13.7, 10.7);
  assert.notEqual(wall, grass);
  await page.keyboard.press('Control+z');
  assert.equal(await colourAt(12.7, 10.7), wall);
});

// A find on a wall, a barrel in a walker's way, and a sheet that is not called so.
const kMistaken = {
  title: 'Mistakes',
  textures: { spare: '../textures/rock.png' },
  sprites: { lava: '../sheets/lava.png' },
  blueprints: { wall: { faces: 'brick-weathered' }, unused: { faces: 'brick-weathered' } },
  legend: { '#': 'wall' },
  maps: [
    {
      name: 'hall',
      levels: [['########', '#......#', '#......#', '########']],
      floor: 'grass-meadow',
      objects: [
        { sprite: 'standing-barrel', x: 4.5, y: 1.5, height: 0.5 },
        {
          sprite: 'standing-barrel',
          x: 2.5,
          y: 1.5,
          height: 0.6,
          motion: {
            kind: 'patrol',
            speed: 1,
            path: [
              { x: 3, y: 1.5 },
              { x: 6, y: 1.5 },
            ],
          },
        },
        { sprite: 'lava', x: 3.5, y: 2.5, height: 0.5 },
        { sprite: 'standing-barrel', x: 5.5, y: 2.5, z: 3, height: 0.4, find: { kind: 'crown' } },
      ],
    },
  ],
  start: { x: 1.5, y: 2.5, heading: 0 },
};

test('mistakes that take long to find are listed soon after a change', async (t) => {
  const { page } = await openEditor(t);
  const write = (content) =>
    told(
      page,
      (text) => {
        const { scene } = window.slicecastEditor;
        scene.apply([{ offset: 0, length: scene.text.length, content: text }]);
      },
      content,
    );
  await write(JSON.stringify(kMistaken, null, 2));
  await page.waitForSelector('#problems:not([hidden])');
  const lines = await page.locator('#problems li').allTextContents();
  assert.equal(lines.length, 3, lines.join(' '));
  assert.match(lines[0], /^sprites, lava: found a picture so wide that it may be a sheet/);
  assert.match(lines[1], /a way to this point through the object at x 4.50/);
  assert.match(lines[2], /a find "crown" that nobody can reach on foot/);
  await write((await textOf(page)).replace('"z": 3', '"z": 0'));
  await page.waitForFunction(() => document.querySelectorAll('#problems li').length === 2);
});

test('the text is the same document: typing changes the world, faults leave it', async (t) => {
  const { page } = await openEditor(t);
  await page.keyboard.press('KeyJ');
  await page.waitForSelector('.cm-content');
  const replaceText = async (from, to) => {
    await told(
      page,
      ([what, by]) => {
        const { scene } = window.slicecastEditor;
        const offset = scene.text.indexOf(what);
        scene.apply([{ offset, length: what.length, content: by }]);
      },
      [from, to],
    );
    await settle(page);
  };
  await page.click('.cm-content');
  await page.keyboard.press('Control+Home');
  await page.keyboard.type(' ');
  assert.equal((await textOf(page)).slice(0, 2), ' {');
  await page.keyboard.press('Control+z');
  assert.equal((await textOf(page))[0], '{');
  await page.keyboard.press('Control+y');
  await replaceText('"floor": "grass-meadow"', '"floor": "gras"');
  await page.waitForSelector('#problems:not([hidden])');
  assert.match(await page.textContent('#problems li'), /found the name "gras"/);
  await page.click('#problems li button');
  assert.match(await page.textContent('.cm-activeLine'), /"floor": "gras"/);
  assert.equal(await page.locator('.cm-lint-marker-error').count(), 1);
  await replaceText('"floor": "gras"', '"floor": "sand"');
  await page.waitForSelector('#problems', { state: 'hidden' });
  while ((await told(page, () => window.slicecastEditor.history.undo())) !== null);
  await page.click('.cm-content');
  await page.keyboard.press('Control+Home');
  assert.match(await page.textContent('.cm-activeLine'), /^\{/);
  // What the other views do arrives in the text.
  await told(page, () => {
    const { history, editor } = window.slicecastEditor;
    const cells = [3, 5, 9].map((x) => ({ layer: 0, x, y: 0, sign: editor.sign }));
    history.do('Place', [
      { path: ['title'], value: 'Other' },
      { map: 0, cells },
    ]);
  });
  const row = (await rowsOf(page, 0))[0];
  await page.click('[data-view=text]');
  const shown = await page.textContent('.cm-content');
  assert.match(shown, /"title": "Other"/);
  assert.match(row, /^\.{3}([^.])\.\1\.{3}\1/);
});

test('one walks where one stands, and goes on building', async (t) => {
  const { page } = await openEditor(t, '?template=garden');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => window.slicecastEditor.caster.entered);
  const start = await told(page, () => window.slicecastEditor.caster.currentView);
  await page.keyboard.down('KeyW');
  await page.waitForFunction((y) => window.slicecastEditor.caster.currentView.y < y - 0.5, start.y);
  await page.keyboard.up('KeyW');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => window.slicecastEditor.caster.state === 'paused');
  await settle(page);
  assert.ok((await told(page, () => window.slicecastEditor.caster.currentView)).y < start.y - 0.4);
  await page.keyboard.press('KeyW');
  assert.equal(await told(page, () => window.slicecastEditor.caster.entered), false);
});

test('after a button was clicked Space rises; by keys alone it presses the button', async (t) => {
  const { page } = await openEditor(t);
  const height = () => told(page, () => window.slicecastEditor.caster.currentView.z);
  const rises = async () => {
    const before = await height();
    await page.keyboard.down('Space');
    await page.waitForFunction(
      (z) => window.slicecastEditor.caster.currentView.z > z + 0.05,
      before,
    );
    await page.keyboard.up('Space');
  };
  const tool = () => told(page, () => window.slicecastEditor.editor.tool.name);
  for (const button of ['tool=box', 'way=walls', 'key="w"', 'view=picture']) {
    await page.click(`[data-${button}]`);
    await rises();
  }
  // From a dialog, and from a field of the panel by a press on the picture
  await page.click('#open-keys');
  await page.click('#keys [data-close]:text-is("Close")');
  await rises();
  await page.click('#title');
  await page.mouse.click(...(await pointOf(page, 16.5, 17.5, 0)));
  await rises();
  assert.equal(await page.inputValue('#title'), 'A meadow');
  await page.focus('[data-tool=paint]');
  const before = await height();
  await page.keyboard.press('Space');
  assert.equal(await tool(), 'paint');
  await page.keyboard.press('Shift+Tab');
  await page.keyboard.press('Enter');
  assert.equal(await tool(), 'replace');
  assert.equal(await height(), before);
  assert.equal(await told(page, () => document.activeElement.dataset.tool), 'replace');
  // The mouse over the picture takes the keys again.
  await page.mouse.move(700, 20);
  await page.mouse.move(700, 400);
  await rises();
});

test('before the scene has loaded, Walk waits and nothing fails', async (t) => {
  let release;
  const mayGo = new Promise((resolve) => (release = resolve));
  const { page } = await openPage(t, browser, {
    query: 'edit.html?template=meadow',
    viewport: { width: 1366, height: 768 },
    prepare: (opened) =>
      opened.route('**/*.wasm', async (route) => {
        await mayGo;
        await route.continue();
      }),
  });
  await page.waitForFunction(() => document.querySelector('#tools button') !== null);
  assert.equal(await page.isDisabled('#walk'), true);
  for (const key of ['Tab', 'Enter', 'Delete', 'KeyW', 'Escape']) await page.keyboard.press(key);
  await page.mouse.click(500, 500);
  await page.mouse.wheel(0, 100);
  await page.keyboard.press('Tab');
  assert.equal(await page.locator('body[data-walking]').count(), 0);
  release();
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  await page.click('#walk');
  await page.waitForFunction(() => window.slicecastEditor.caster.entered);
});

for (const way of ['Escape', 'Tab', 'the button'])
  test(`one walks on the ground, looks ahead, sees no tool, and ${way} leads back`, async (t) => {
    const { page } = await openEditor(t, '?template=house');
    await lookAt(page, { x: 14, y: 22.5, z: 9, heading: 270, look: -1.2 });
    await page.click('#walk');
    await page.waitForFunction(() => window.slicecastEditor.caster.entered);
    const { player } = await told(page, () => ({ player: window.slicecastEditor.caster.player }));
    assert.deepEqual([player.x, player.y, player.feet, player.onGround], [14, 22.5, 0, true]);
    assert.equal(player.look, 0);
    for (const part of ['#tools', '#panel', '#blocks', '#about', '#views'])
      assert.equal(await page.isVisible(part), false, part);
    const { width, height } = await page.locator('#picture').boundingBox();
    assert.deepEqual([width, height], [1366, 720]);
    // Escape closes the list of keys first.
    if (way === 'Escape') {
      await page.keyboard.press('KeyH');
      await page.waitForFunction(() => !window.slicecastEditor.caster.entered);
      await page.keyboard.press('Escape');
      assert.equal(await page.isVisible('#tools'), false);
      await page.keyboard.press('Enter');
      await page.waitForFunction(() => window.slicecastEditor.caster.entered);
    }
    if (way === 'the button') await page.click('button:text-is("Back to editing")');
    else await page.keyboard.press(way);
    await page.waitForFunction(() => window.slicecastEditor.caster.state === 'paused');
    await settle(page);
    assert.equal(await page.isVisible('#tools'), true);
    assert.equal(await page.textContent('#walk'), 'Walk');
    assert.equal(await told(page, () => window.slicecastEditor.caster.flying), true);
  });

test('by touch the thumbs are there at once, and one button leads back', async (t) => {
  const { page } = await openEditor(t, '?template=house', {
    viewport: { width: 820, height: 1180 },
    context: { hasTouch: true, isMobile: true },
  });
  await page.tap('#walk');
  await page.waitForSelector('#picture .stick');
  assert.equal(await page.isVisible('#picture .leave'), false);
  await page.tap('button:text-is("Back to editing")');
  await page.waitForSelector('#picture .stick', { state: 'detached' });
  assert.equal(await page.isVisible('#tools'), true);
});

test('what was built is there again, and a link brings it to others', async (t) => {
  const { page, context, server } = await openEditor(t);
  await lookAt(page, { x: 16.5, y: 20.5, z: 1.6, heading: 270, look: -0.5 });
  await page.mouse.click(...(await pointOf(page, 16.5, 17.5, 0)));
  const text = await textOf(page);
  await page.click('#open-share');
  const link = await page.inputValue('#share-link');
  assert.match(link, /#world=/);
  assert.ok(link.length < 8000);
  await page.waitForFunction(() => document.getElementById('kept').textContent.startsWith('Kept'));
  await page.reload();
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  assert.equal(await textOf(page), text);

  // Somebody else sees the world itself, and no editor.
  const other = await context.newPage();
  await other.goto(link);
  await other.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await other.title(), 'From a link: “A meadow” · Slicecast');
  assert.equal(await other.textContent('#pause-title'), '“A meadow”');
  assert.ok((await other.locator('#play').boundingBox()).height >= 48);
  assert.equal(await told(other, () => window.slicecast.game), null);
  await other.click('#open-share');
  assert.equal(await other.inputValue('#share-link'), link);
  assert.deepEqual(await other.locator('#share-addresses textarea:visible').count(), 1);
  await other.click('#share [data-close]');
  await other.click('#play');
  await other.waitForFunction(() => window.slicecast.entered);
  await other.close();
  // So do those who have a link of earlier.
  const old = await context.newPage();
  await old.goto(`${server.address}edit.html${new URL(link).hash}`);
  await old.waitForURL(link);
  await old.waitForFunction(() => document.body.dataset.state === 'paused');
  await old.click('#edit-copy');
  await old.waitForFunction(() => document.body.dataset.state === 'ready');
  assert.deepEqual(JSON.parse(await textOf(old)), JSON.parse(text));
  assert.match(await old.textContent('#toast'), /A copy of a world from a link/);
  await old.goto(`${server.address}#world=damaged`);
  await old.waitForFunction(() => document.body.dataset.state === 'trouble');
  assert.match(await old.textContent('#trouble-text'), /The link is damaged/);
  await old.close();
});

test('the link comes first, takes a new name, and warns only where it is long', async (t) => {
  const { page, server } = await openEditor(t);
  await page.click('#open-share');
  const first = await page.evaluate(() => document.activeElement.dataset.copy);
  assert.equal(first, 'share-link', 'Enter copies it');
  const tops = await page
    .locator('#share :is(#share-link, #share-tag, #share-frame, #save-html, #save-zip)')
    .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().top));
  assert.deepEqual(
    tops,
    tops.toSorted((one, other) => one - other),
  );
  const before = await page.inputValue('#share-link');
  await page.fill('#share-name', 'A yard');
  await page.press('#share-name', 'Tab');
  assert.notEqual(await page.inputValue('#share-link'), before);
  assert.match(await page.inputValue('#share-tag'), /scene="a-yard" .* label="A yard"/);
  assert.equal(await page.inputValue('#title'), 'A yard');
  assert.equal(await page.locator('#share .warning').count(), 0);
  await page.click('#share [data-close]');

  await page.goto(`${server.address}edit.html?scene=hill-abbey`);
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  await page.click('#open-share');
  assert.match(await page.textContent('#share .warning'), /Send the HTML file instead/);
});

test('a link keeps the order of the palette, which shows something of each block', async (t) => {
  const { page } = await openEditor(t, '?scene=castle');
  const palette = () =>
    page.locator('#palette [data-key]').evaluateAll((all) => all.map((one) => one.title));
  const isPainted = () =>
    page.waitForFunction(() =>
      [...document.querySelectorAll('#palette canvas')].every((icon) => {
        const { data } = icon.getContext('2d').getImageData(0, 0, icon.width, icon.height);
        return data.some((value) => value > 0);
      }),
    );
  await isPainted();
  const kinds = await palette();
  await page.keyboard.press('KeyP');
  await isPainted();
  const textures = await palette();
  await page.click('#open-share');
  await page.goto(await page.inputValue('#share-link'));
  await page.click('#edit-copy');
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  assert.deepEqual(await palette(), kinds);
  await page.keyboard.press('KeyP');
  assert.deepEqual(await palette(), textures);
});

test('a world in a link cannot pose as a shipped one, and reaches nothing else', async (t) => {
  const { page, server } = await openEditor(t, '?template=meadow', { expectErrors: true });
  const asked = [];
  const hostile = {
    title: 'Castle” \u202e Your session has ended',
    textures: {
      a: '../textures/rock.png',
      b: '../../secret.png',
      c: '../textures/../../secret.png',
      d: 'https://elsewhere.example/a.png',
    },
    maps: [{ name: 'hall', levels: [['aab', 'c d']], floor: 'rock' }],
    blueprints: { a: { faces: 'a' }, b: { faces: 'b' }, c: { faces: 'c' }, d: { faces: 'd' } },
    legend: { a: 'a', b: 'b', c: 'c', d: 'd' },
    start: { x: 1.5, y: 1.5 },
  };
  const address = server.address + hashOf(hostile);
  page.on('request', (request) => asked.push(request.url()));
  await page.goto(address);
  await page.waitForFunction(() => document.body.dataset.state === 'trouble');
  assert.match(await page.textContent('#trouble-faults'), /elsewhere/);
  assert.deepEqual(
    asked.filter((url) => /secret|elsewhere/.test(url)),
    [],
  );
  hostile.textures = { a: '../textures/rock.png' };
  hostile.blueprints = { a: { faces: 'a' } };
  hostile.legend = { a: 'a' };
  hostile.maps[0].levels = [['aaa', 'a a']];
  await page.goto(server.address + hashOf(hostile));
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(
    await page.textContent('#bar-title'),
    'From a link: “Castle Your session has ended”',
  );
  assert.equal(await page.textContent('#pause-title'), '“Castle Your session has ended”');
  assert.match(await page.textContent('#pause-about'), /Somebody has built this world/);
  // Another scene is the page's own again, and back one is the guest.
  await page.click('#open-scenes');
  await page.click('#scene-list a:has-text("The other room")');
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  assert.equal(await page.isVisible('#edit-copy'), false);
  await page.goBack();
  await page.waitForFunction(() => document.title.startsWith('From a link'));
});

test('what was made of a link stays in the browser, and can be begun anew', async (t) => {
  const { page } = await openEditor(t);
  await page.click('#open-share');
  const link = await page.inputValue('#share-link');
  const text = await textOf(page);
  const editCopy = async () => {
    await page.goto(link);
    await page.waitForFunction(() => document.body.dataset.state === 'paused');
    await page.click('#edit-copy');
    await page.waitForFunction(() => document.body.dataset.state === 'ready');
  };
  await editCopy();
  await told(page, () => {
    const { history } = window.slicecastEditor;
    history.do('Rename', [{ path: ['title'], value: 'Mine' }]);
  });
  await page.waitForFunction(() => document.getElementById('kept').textContent.startsWith('Kept'));
  await editCopy();
  assert.equal(await page.inputValue('#title'), 'Mine');
  await page.click('#open-files');
  await Promise.all([page.waitForEvent('load'), page.click('#anew')]);
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  assert.deepEqual(JSON.parse(await textOf(page)), JSON.parse(text));
});

test('a scene, a zip and a map of Tiled open from files', async (t) => {
  const { page } = await openEditor(t);
  const open = async (files) => {
    if (!(await page.isVisible('#files'))) await page.click('#open-files');
    await page.setInputFiles('#files input[type=file]', files);
  };
  const arrived = async (query) => {
    await page.waitForURL((address) => address.search === query);
    await page.waitForFunction(() => document.body.dataset.state === 'ready');
  };
  const scene = JSON.parse(await textOf(page));
  scene.textures.mine = 'mine.png';
  scene.blueprints['my wall'] = { faces: 'mine' };
  scene.legend.m = 'my wall';
  const picture = readFileSync(new URL('../../assets/textures/brick.png', import.meta.url));
  const text = JSON.stringify(scene);
  const zip = Buffer.from(zipSync({ 'yard.json': strToU8(text), 'mine.png': picture }));
  await open([{ name: 'yard.zip', mimeType: 'application/zip', buffer: zip }]);
  await arrived('?file=yard');
  assert.equal(await textOf(page), text);
  await page.waitForFunction(() => window.slicecastEditor.caster.state === 'paused');
  await page.click('#open-share');
  assert.match(await page.textContent('#share-about'), /own pictures has no link/);
  await page.click('#share [data-close]');

  const rows = Array.from({ length: 8 }, (_, y) =>
    Array.from({ length: 8 }, (__, x) => (x % 7 === 0 || y % 7 === 0 ? 1 : 0)),
  );
  const tmx = `<map orientation="orthogonal" width="8" height="8" tilewidth="16" tileheight="16">
    <layer name="walls" width="8" height="8"><data encoding="csv">${rows}</data></layer></map>`;
  const csv = { name: 'room.csv', mimeType: 'text/csv', buffer: Buffer.from(rows.join('\n')) };
  await open([csv]);
  await page.click('#import-open:enabled');
  await arrived('?file=room');
  assert.equal((await rowsOf(page, 0)).length, 8);
  await open([{ name: 'broken.tmx', mimeType: 'text/xml', buffer: Buffer.from(tmx.slice(0, 90)) }]);
  await page.waitForFunction(() =>
    document.getElementById('open-told').textContent.startsWith('This cannot'),
  );
  await open([{ name: 'nothing.gif', mimeType: 'image/gif', buffer: Buffer.from('GIF') }]);
  await page.waitForFunction(() =>
    document.getElementById('open-told').textContent.includes('expected a scene'),
  );
});

test('an author changes one block of the castle, and the text differs there alone', async (t) => {
  const { page } = await openEditor(t, '?scene=castle');
  await lookAt(page, { x: 40.5, y: 20.5, z: 5, heading: 180, look: -0.3 });
  await page.mouse.click(
    ...(await told(page, () => {
      const box = window.slicecastEditor.caster.getBoundingClientRect();
      return [box.left + box.width / 2, box.top + box.height * 0.7];
    })),
  );
  await settle(page);
  const after = await textOf(page);
  assert.equal(after.length, kCastle.length);
  const differing = [...after].filter((letter, index) => letter !== kCastle[index]);
  assert.equal(differing.length, 1);
});

test('a form sets a value, and clearing it removes the key', async (t) => {
  const { page } = await openEditor(t);
  const before = await textOf(page);
  await page.click('#tab-map');
  await page.click('#part-map summary:has-text("Fog")');
  const field = page.locator('#part-map .field:has(label:text-is("End")) input');
  await field.fill('90');
  await field.press('Tab');
  await settle(page);
  assert.equal(await told(page, () => window.slicecastEditor.scene.value.maps[0].fog.end), 90);
  await page.click('#part-map button:has-text("Remove Fog")');
  await settle(page);
  assert.equal(await told(page, () => window.slicecastEditor.scene.value.maps[0].fog), undefined);
  await page.click('#undo');
  await page.click('#undo');
  assert.equal(await textOf(page), before);
});

test('things are put, moved and removed in the picture', async (t) => {
  const { page } = await openEditor(t);
  await lookAt(page, { x: 16.5, y: 21.5, z: 2, heading: 270, look: -0.5 });
  await page.keyboard.press('KeyT');
  await page.click('#palette [data-key="sprite oak"]');
  await page.mouse.click(...(await pointOf(page, 16.5, 17.5, 0)));
  await settle(page);
  const objects = () => told(page, () => window.slicecastEditor.scene.value.maps[0].objects);
  const [oak] = await objects();
  assert.equal(oak.sprite, 'oak');
  assert.ok(oak.height > 2, 'as tall as oaks are');
  assert.ok(Math.abs(oak.x - 16.5) < 0.1 && Math.abs(oak.y - 17.5) < 0.1);
  await page.mouse.move(...(await pointOf(page, oak.x, oak.y, 0.4)));
  await frames(page);
  await page.mouse.down();
  await page.mouse.move(...(await pointOf(page, 15.7, 17.9, 0)), { steps: 5 });
  await frames(page);
  await page.mouse.up();
  await settle(page);
  const [moved] = await objects();
  assert.ok(moved.x < 16, `${moved.x}`);
  assert.equal(await page.isVisible('#part-thing .field'), true);
  await page.mouse.click(...(await pointOf(page, moved.x, moved.y, 0.4)), { button: 'right' });
  await settle(page);
  assert.deepEqual(await objects(), []);
});

test('by keys alone a block is placed where the pointer is, and by touch too', async (t) => {
  const { page } = await openEditor(t, '?template=meadow', { context: { hasTouch: true } });
  await lookAt(page, { x: 16.5, y: 20.5, z: 1.6, heading: 270, look: -0.5 });
  await page.touchscreen.tap(...(await pointOf(page, 16.5, 17.5, 0)));
  assert.notEqual((await rowsOf(page, 0))[17][16], '.');
});

for (const [name, viewport] of Object.entries({
  'a small desk': { width: 1366, height: 768 },
  'a large one': { width: 1920, height: 1080 },
  'a tablet': { width: 820, height: 1180 },
  'a phone': { width: 390, height: 844 },
})) {
  test(`on ${name} all fits, and axe finds nothing`, async (t) => {
    const { page } = await openEditor(t, '?template=house', { viewport });
    const overflow = await told(page, () => {
      const { scrollWidth, scrollHeight } = document.documentElement;
      return [scrollWidth - innerWidth, scrollHeight - innerHeight];
    });
    assert.deepEqual(overflow, [0, 0]);
    const picture = await page.locator('#picture').boundingBox();
    assert.ok(picture.width * picture.height > 0.25 * viewport.width * viewport.height);
    await page.addScriptTag({ path: kAxe });
    for (const view of ['picture', 'plan', 'text']) {
      await page.click(`[data-view=${view}]`);
      if (view === 'text') await page.waitForSelector('.cm-content');
      const found = await told(page, async () =>
        (await window.axe.run(document, { resultTypes: ['violations'] })).violations.map(
          ({ id, nodes }) => [id, nodes[0].html],
        ),
      );
      assert.deepEqual(found, [], view);
    }
  });
}

// What lies over the views, and over the picture while somebody walks
const kOver = ['#select-bar', '#ways', '#tour', '.view-bar', '.legend', '#about', '#toast'];
const kOfWalker = ['.status', '.stick', '.buttons', '.leave'];

// Nothing of these covers another or leaves the views. The names of what is seen.
const apart = (page, at) =>
  told(
    page,
    ([over, ofWalker]) => {
      const { shadowRoot } = document.getElementById('picture');
      const all = [
        ...over.flatMap((name) => [...document.querySelectorAll(name)].map((one) => [name, one])),
        ...ofWalker.map((name) => [name, shadowRoot.querySelector(name)]),
      ]
        .filter(([, one]) => one?.checkVisibility({ visibilityProperty: true }))
        .map(([name, one]) => [name, one.getBoundingClientRect()])
        .filter(([, { width, height }]) => width > 1 && height > 1);
      const meet = (one, other) =>
        one.left < other.right &&
        other.left < one.right &&
        one.top < other.bottom &&
        other.top < one.bottom;
      const stage = document.getElementById('stage').getBoundingClientRect();
      const wrong = all.flatMap(([name, box], index) =>
        [
          ...all.slice(index + 1).filter(([, other]) => meet(box, other)),
          ...(box.left >= stage.left && box.right <= stage.right ? [] : [['#stage']]),
          ...(box.top >= stage.top && box.bottom <= stage.bottom ? [] : [['#stage']]),
        ].map(([other]) => `${name} and ${other}`),
      );
      return { seen: all.map(([name]) => name), wrong };
    },
    [kOver, kOfWalker],
  ).then(({ seen, wrong }) => {
    assert.deepEqual(wrong, [], at);
    return seen;
  });

for (const [width, height, isTouch] of [
  [360, 640, true],
  [390, 844, true],
  [820, 1180, true],
  [844, 390, true],
  [683, 384, false], // 1366 x 768 at 200 %
  [960, 540, false], // 1920 x 1080 at 200 %
  [1366, 768, false],
  [2560, 1440, false],
])
  test(`nothing covers anything in a window of ${width} x ${height}`, async (t) => {
    const { page } = await openEditor(t, '?template=garden&tour', {
      viewport: { width, height },
      context: { hasTouch: isTouch, isMobile: isTouch },
    });
    const press = (what) => (isTouch ? page.tap(what) : page.click(what));
    const cut = await told(page, () => {
      const bar = document.getElementById('bar').getBoundingClientRect();
      return [...document.querySelectorAll('#bar button:not([hidden])')]
        .filter((button) => {
          const { right, bottom } = button.getBoundingClientRect();
          return right > bar.right || bottom > bar.bottom;
        })
        .map(({ id }) => id);
    });
    assert.deepEqual(cut, [], 'all of the bar is seen');
    const seen = new Set();
    const look = async (at) => {
      await frames(page, 1);
      for (const name of await apart(page, at)) seen.add(name);
    };
    for (const hasTour of [true, false]) {
      if (!hasTour) await press('#tour [data-skip]');
      for (const view of ['picture', 'plan', 'side']) {
        await press(`[data-view=${view}]`);
        for (const tool of ['place', 'box', 'paint', 'link', 'select']) {
          await press(`[data-tool=${tool}]`);
          if (tool === 'select') await page.keyboard.press('Control+a');
          await told(
            page,
            (words) => window.slicecastEditor.editor.say(words),
            'Copied. '.repeat(6),
          );
          await look(`${view}, ${tool}, ${hasTour}`);
        }
      }
    }
    await press('#walk');
    await page.waitForFunction(() => window.slicecastEditor.caster.entered);
    await told(page, () => window.slicecastEditor.editor.say('Saved in this browser.'));
    await look('walking');
    for (const name of [
      '#select-bar',
      '#ways',
      '#tour',
      '.view-bar',
      '#toast',
      isTouch ? '.stick' : '.status',
    ])
      assert.ok(seen.has(name), `${name} was seen: ${[...seen]}`);
  });

test('a finger removes by the switch, and no words speak of mouse or keys to it', async (t) => {
  const { page } = await openEditor(t, '?template=meadow&tour', {
    viewport: { width: 390, height: 844 },
    context: { hasTouch: true, isMobile: true },
  });
  const words = () =>
    told(page, () =>
      ['about', 'tour', 'toast', 'open-keys'].map((id) => document.getElementById(id).innerText),
    );
  const kOfOthers =
    /click|wheel|button|\b(Keys|Shift|Escape|Enter|Delete|Tab|Ctrl|Alt|[A-Z]:)|\b[WSDOUI] /;
  const speaksOfFingers = async () => assert.doesNotMatch((await words()).join('\n'), kOfOthers);
  for (let step = 0; step < 4; ++step) {
    await speaksOfFingers();
    await page.tap('#tour [data-next]');
  }
  for (const tool of await page.locator('#tools button').all()) {
    await tool.tap();
    await speaksOfFingers();
    for (const way of await page.locator('#ways [data-way]:visible').all()) {
      await way.tap();
      await speaksOfFingers();
    }
  }
  await told(page, () =>
    window.slicecastEditor.editor.say('Right click removes, a double click ends.'),
  );
  await speaksOfFingers();
  await page.tap('#open-keys');
  assert.equal(await page.isVisible('[data-keys=tables]'), false);
  assert.match(await page.innerText('[data-keys=fingers]'), /Remove/);
  await page.tap('#keys [data-close]:text-is("Close")');

  await page.tap('[data-tool=place]');
  await lookAt(page, { x: 16.5, y: 20.5, z: 1.6, heading: 270, look: -0.5 });
  const tap = async (...place) => {
    await page.touchscreen.tap(...(await pointOf(page, ...place)));
    return (await rowsOf(page, 0))[17][16];
  };
  assert.match(await page.textContent('#about'), /Remove/);
  assert.notEqual(await tap(16.5, 17.5, 0), '.');
  await page.tap('#ways button:text-is("Remove")');
  assert.equal(await tap(16.5, 18, 0.5), '.');
  assert.equal(await tap(16.5, 17.5, 0), '.'); // there is nothing
  await page.tap('#palette [data-digit="2"]');
  assert.notEqual(await tap(16.5, 17.5, 0), '.');
  await page.tap('#ways button:text-is("Remove")');
  await page.tap('[data-view=plan]');
  await frames(page);
  const box = await page.locator('#plan').boundingBox();
  await page.touchscreen.tap(
    box.x + box.width * (0.5 + 0.5 / 34),
    box.y + box.height / 2 + box.width * (1.5 / 34),
  );
  assert.equal((await rowsOf(page, 0))[17][16], '.');

  // With a mouse the words are the others, and nothing needs the switch.
  await page.mouse.click(200, 20);
  assert.match((await words()).join('\n'), /Right click[^]*Keys/);
  await page.tap('[data-tool=box]');
  await page.mouse.click(200, 20);
  assert.equal(await page.isVisible('#ways button:text-is("Remove")'), false);
});

test('four steps begin the first visit, each done by doing it, and never come again', async (t) => {
  const { page } = await openEditor(t, '?template=meadow', { prepare: async () => {} });
  const at = (count, title) =>
    page.waitForFunction(
      ([number, words]) => {
        const card = document.getElementById('tour');
        const shown = (name) => card.querySelector(`[data-${name}]`).textContent;
        return !card.hidden && shown('count') === `${number} of 4` && shown('title') === words;
      },
      [count, title],
    );
  await at(1, 'Put a block');
  assert.equal(await page.locator('[data-told]').count(), 0, 'only buttons get a ring');
  const middle = async () => {
    const box = await page.locator('#picture').boundingBox();
    return [box.x + box.width / 2, box.y + box.height * 0.8];
  };
  await page.mouse.click(...(await middle()));
  await at(2, 'Look around');
  await page.keyboard.down('KeyW');
  await at(3, 'Walk in it');
  await page.keyboard.up('KeyW');
  await page.keyboard.press('Tab');
  await at(4, 'Show it to somebody');
  await page.keyboard.press('Tab');
  await page.click('#open-share');
  await page.waitForSelector('#tour', { state: 'hidden' });
  await page.waitForFunction(() => document.getElementById('kept').textContent.startsWith('Kept'));
  await page.reload();
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  assert.equal(await page.isVisible('#tour'), false);
  await page.click('#open-keys');
  await page.click('#begin-tour');
  await at(1, 'Put a block');
  await page.click('#tour [data-next]');
  await at(2, 'Look around');
  await page.click('#tour [data-skip]');
  assert.equal(await page.isVisible('#tour'), false);
  assert.equal(await page.locator('[data-told]').count(), 0);
});
