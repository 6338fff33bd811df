// Sharing: an address that carries a view, and the dialog that writes it.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import {
  inState,
  launch,
  openPage,
  openScene,
  pictureHash,
  play,
  player,
  untilPlayer,
} from './browser.mjs';
import { roomFiles, roomPictures, roomScene } from './room.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const option = (page, name) => page.evaluate((wanted) => window.slicecast.get(wanted), name);

async function openShare(page) {
  await page.click('#open-share');
  await page.waitForSelector('#share[open]');
}

test('an address with view, options and overlay shows exactly that', async (t) => {
  const { page } = await openScene(t, browser, {
    query:
      '?scene=other&view=2.5,4.25,0.75,200,0.125,room&options=fov=90+light=off&overlay=minimap+grid',
  });
  const { mapName, x, y, z, heading, look } = await player(page);
  assert.deepEqual(
    { mapName, x, y, z, heading, look },
    { mapName: 'room', x: 2.5, y: 4.25, z: 0.75, heading: 200, look: 0.125 },
  );
  for (const [name, value] of [
    ['fov', '90'],
    ['light', 'off'],
    ['minimap', 'on'],
    ['grid', 'on'],
    ['fog', 'on'],
    ['minimapRays', 'off'],
  ]) {
    assert.equal(await option(page, name), value, name);
  }
  assert.equal(await page.inputValue('#set-fov'), '90');
  assert.equal(await page.isChecked('#set-light'), false);
});

test("options that the address does not name are standard, and the visitor's settings return later", async (t) => {
  const stored = JSON.stringify({ fov: 80, fog: false });
  const { page } = await openScene(t, browser, {
    query: '?scene=room&options=light=off',
    prepare: (newPage) =>
      newPage.addInitScript((text) => localStorage.setItem('slicecast.settings', text), stored),
  });
  assert.deepEqual(
    [await option(page, 'fov'), await option(page, 'fog'), await option(page, 'light')],
    ['60', 'on', 'off'],
  );
  assert.equal(await page.evaluate(() => localStorage.getItem('slicecast.settings')), stored);
  await page.click('#open-scenes');
  await page.click('#scene-list a:has-text("The other room")');
  await page.waitForFunction(
    () => document.title.startsWith('The other room') && document.body.dataset.state === 'paused',
  );
  assert.deepEqual(
    [await option(page, 'fov'), await option(page, 'fog'), await option(page, 'light')],
    ['80', 'off', 'on'],
  );
});

test('a mistake in the address gives a warning, and the rest is shown', async (t) => {
  const cases = [
    ['view=1,2', /view/],
    ['options=fov=500', /Option 'fov' takes a number from 10 to 150, not '500'/],
    ['options=light=off+hat=1', /Unknown option 'hat'/],
    ['overlay=minmap', /Unknown overlay 'minmap'\. Did you mean 'minimap'\?/],
    ['view=2.5,2.5,0.5,0,0,cellar', /cellar/],
  ];
  const { page, server } = await openPage(t, browser, { query: `?scene=room&${cases[0][0]}` });
  for (const [query, expected] of cases) {
    await page.goto(`${server.address}?scene=room&${query}`);
    await inState(page, 'paused');
    const warnings = await page.evaluate(() => window.slicecast.warnings);
    assert.match(warnings.map(({ message }) => message).join(' '), expected, query);
    assert.equal(await option(page, 'light'), query.includes('light=off') ? 'off' : 'on', query);
  }
});

test('mistakes in the address are listed over the picture until closed', async (t) => {
  const { page, server } = await openScene(t, browser, { query: '?scene=room' });
  const lines = () =>
    page.$$eval('#address-problems li', (all) => all.map(({ innerText }) => innerText));
  assert.equal(await page.isVisible('#address-problems'), false);
  for (const [query, ...expected] of [
    ['options=nonsense:1,fog:off', /^options Unknown option 'nonsense'\. All options$/],
    ['options='],
    ['options=fov=500', /^options Option 'fov' takes a number from 10 to 150, not '500'\./],
    ['view=abc', /^view Found "abc", expected x,y,z,heading or /],
    ['view=2.5,2.5,0.5,0,0,cellar', /^view Unknown map 'cellar'\. Expected room\.$/],
    ['view=', /^view Found nothing, expected view=4\.5,2,0\.5,90/],
    ['overlay=minmap', /^overlay Unknown overlay 'minmap'\. Did you mean 'minimap'\?$/],
    ['engine=fast', /^engine .*'fast'\. Expected auto, simd or scalar\.$/],
    ['tour=', /^tour Found nothing, expected tour=/],
    ['opions=fov=90', /^opions Unknown name 'opions'\. Did you mean 'options'\?$/],
    ['utm_source=letter'],
    ['view=1,2&overlay=nothing', /^view Found "1,2"/, /^overlay Unknown overlay 'nothing'/],
  ]) {
    await page.goto(`${server.address}?scene=room&${query}`);
    await inState(page, 'paused');
    const said = await lines();
    assert.equal(said.length, expected.length, `${query}: ${said}`);
    expected.forEach((pattern) =>
      assert.ok(
        said.some((line) => pattern.test(line)),
        `${said}`,
      ),
    );
    assert.equal(await page.isVisible('#address-problems'), expected.length > 0, query);
    if (query.includes('fog:off')) assert.equal(await option(page, 'fog'), 'off');
  }
  await page.click('#address-problems button');
  assert.equal(await page.isVisible('#address-problems'), false);

  // Opening another scene, or playing, closes the list.
  await page.goto(`${server.address}?scene=room&view=abc`);
  await page.waitForSelector('#address-problems', { state: 'visible' });
  await page.click('#open-scenes');
  await page.click('#scene-list a:has-text("The other room")');
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  assert.equal(await page.isVisible('#address-problems'), false);
  await page.goBack();
  await page.waitForSelector('#address-problems', { state: 'visible' });
  await play(page);
  assert.equal(await page.isVisible('#address-problems'), false);
});

test('a misspelt scene or tour: the page suggests the right one', async (t) => {
  const { page, server } = await openPage(t, browser, {
    query: '?scene=othr&options=fov=80',
    expectErrors: true,
  });
  await inState(page, 'trouble');
  await page.waitForSelector('#trouble-near', { state: 'visible' });
  assert.equal(
    await page.innerText('#trouble-near'),
    "Unknown scene 'othr'. Did you mean 'other'? Open other",
  );
  await page.click('#trouble-near a');
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  await inState(page, 'paused');
  assert.equal(await option(page, 'fov'), '80');
  assert.equal(await page.isVisible('#trouble'), false);

  for (const query of ['?scene=nowhere', '?tour=othr']) {
    await page.goto(`${server.address}${query}`);
    await inState(page, 'trouble');
    await page.waitForSelector('#trouble-scenes', { state: 'visible' });
    assert.equal(await page.isVisible('#trouble-near'), false, query);
  }
});

test('the link leads somebody else to the very same picture', async (t) => {
  const { page, server } = await openScene(t, browser, { query: '?scene=other' });
  await page.evaluate(() => {
    const { slicecast } = window;
    slicecast.look({ x: 2.123, y: 4.7, heading: 33.25, look: -0.1 });
    slicecast.set('hazeColour', '#a0b4c8');
    slicecast.set('textures', 'off');
    slicecast.set('playerPanel', 'on');
  });
  await openShare(page);
  const link = await page.inputValue('#share-link');
  assert.match(
    link.slice(server.address.length),
    /^\?scene=other&view=walk,2\.123,4\.7,0\.5,33\.25,-0\.1,room&options=textures=off\+hazeColour=%23a0b4c8&overlay=playerPanel$/,
  );
  const other = await openPage(t, browser, {});
  await other.page.goto(link);
  await inState(other.page, 'paused');
  await page.click('#share [data-close]');
  assert.equal(await pictureHash(other.page), await pictureHash(page));

  await openShare(page);
  await page.uncheck('#share-from-view');
  assert.doesNotMatch(await page.inputValue('#share-link'), /view=/);
});

test('a view from the air stays in the air, one from the ground on the ground', async (t) => {
  const { page, server } = await openScene(t, browser, { query: '?scene=room&view=3.5,3.5,2.5,0' });
  await play(page);
  await untilPlayer(page, ({ steps }) => steps > 30);
  assert.deepEqual(
    await page.evaluate(() => [window.slicecast.player.z, window.slicecast.player.flying]),
    [2.5, true],
  );
  await page.goto(`${server.address}?scene=room&view=3.5,3.5,0.5,0`);
  await inState(page, 'paused');
  assert.equal((await player(page)).flying, false);
});

const steppedRoom = () => {
  const scene = roomScene({ title: 'A step and a pool' });
  scene.blueprints.step = { top: 0.5, faces: 'grey' };
  scene.blueprints.pool = { water: true, faces: 'blue' };
  Object.assign(scene.legend, { s: 'step', w: 'pool' });
  const wall = '#######';
  scene.maps[0].levels = [
    [wall, '#....s#', '#....s#', '#....s#', '#..www#', '#..www#', wall],
    ['.......', '.......', '.......', '.......', '...www.', '...www.', '.......'],
  ];
  return { 'scenes/stepped.json': JSON.stringify(scene) };
};
const settled = async (page) => {
  const { steps } = await player(page);
  return untilPlayer(page, (now, before) => now.steps > before + 120, steps);
};

test('a link gives the state that was shared: on a step, in water, in the air, and of today', async (t) => {
  const { page, server } = await openScene(t, browser, {
    query: '?scene=stepped',
    server: { files: steppedRoom() },
  });
  const open = async (view) => {
    await page.goto(`${server.address}?scene=stepped&view=${view}`);
    await inState(page, 'paused');
  };
  const link = async () => {
    await openShare(page);
    const view = new URL(await page.inputValue('#share-link')).searchParams.get('view');
    await page.click('#share [data-close]');
    return view;
  };
  for (const [view, shared, state] of [
    // While the eye still follows the body up a step, and down
    ['walk,5.5,2.5,0.60043,0', /^walk,5\.5,2\.5,0\.60043,/, { flying: false, z: 1 }],
    ['walk,2.5,2.5,0.7003,0', /^walk,2\.5,2\.5,0\.7003,/, { flying: false, z: 0.5 }],
    ['walk,4.5,4.8,2.12,0', /^walk,4\.5,4\.8,2\.12,/, { flying: false, swimming: true }],
    ['fly,2.5,2.5,0.9,0', /^fly,2\.5,2\.5,0\.9,/, { flying: true, z: 0.9 }],
    ['fly,2.5,2.5,2.5,0', /^fly,2\.5,2\.5,2\.5,/, { flying: true, z: 2.5 }],
    // Links that do not say it
    ['2.5,2.5,0.50043,0', /^walk,2\.5,2\.5,0\.50043,/, { flying: false, z: 0.5 }],
    ['2.5,2.5,2.5,0', /^fly,2\.5,2\.5,2\.5,/, { flying: true, z: 2.5 }],
  ]) {
    await open(view);
    assert.match(await link(), shared, view);
    assert.equal(await page.isVisible('#address-problems'), false, view);
    await play(page);
    const now = await settled(page);
    for (const [name, value] of Object.entries(state)) {
      const isSame = name === 'z' ? Math.abs(now.z - value) < 1e-4 : now[name] === value;
      assert.ok(isSame, `${view}: ${name} ${now[name]}, expected ${value}`);
    }
  }
});

test('a link into the void or into a wall lands on the nearest ground, and says so', async (t) => {
  const { page, server } = await openScene(t, browser, { query: '?scene=room' });
  for (const [view, x, y] of [
    ['fly,500,3.2,0.5,0', 6.5, 3.5],
    ['walk,0.4,3.2,0.5,0', 0.5, 3.5],
    ['3.4,3.4,-2,0', 3.5, 3.5],
    ['fly,3.4,3.4,900,0', 3.5, 3.5],
  ]) {
    await page.goto(`${server.address}?scene=room&view=${view}`);
    await inState(page, 'paused');
    await page.waitForSelector('#address-problems', { state: 'visible' });
    assert.match(
      await page.innerText('#address-problems'),
      /You stand on the nearest ground/,
      view,
    );
    await play(page);
    const now = await settled(page);
    assert.deepEqual([now.x, now.y, now.flying], [x, y, false], view);
    await page.keyboard.down('KeyW');
    const { steps } = now;
    const after = await untilPlayer(page, (state, before) => state.steps > before + 400, steps);
    await page.keyboard.up('KeyW');
    assert.ok(after.x <= 7 && after.y <= 7, 'still in the world');
  }
});

test('a link names only options that differ and are seen', async (t) => {
  const { page } = await openScene(t, browser, { query: '?scene=room' });
  const options = async (changes) => {
    await page.evaluate((all) => {
      for (const [name, value] of all) window.slicecast.set(name, value);
    }, changes);
    await openShare(page);
    const { searchParams } = new URL(await page.inputValue('#share-link'));
    await page.click('#share [data-close]');
    return [searchParams.get('options'), searchParams.get('overlay')];
  };
  assert.deepEqual(
    await options([
      ['speed', '2'],
      ['bob', 'off'],
      ['minimapReach', '5'],
      ['minimapRays', 'on'],
      ['inspectorColumn', '7'],
      ['classic.march', 'on'],
    ]),
    [null, null],
  );
  assert.deepEqual(
    await options([
      ['minimap', 'on'],
      ['compare', '0.5'],
      ['light', 'off'],
      ['intensity', '2'],
    ]),
    ['light=off minimapReach=5 compare=0.5 classic.march=on', 'minimap minimapRays'],
  );
});

test('the picture of a view has its full size, also while the automatic size is smaller', async (t) => {
  const { page } = await openScene(t, browser);
  await page.evaluate(() => {
    const { slicecast } = window;
    Object.defineProperty(slicecast, 'picture', { get: () => ({ width: 320, height: 180 }) });
  });
  await openShare(page);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#share-save')]);
  assert.equal(download.suggestedFilename(), 'room-640x360.png');
});

test('tag and frame work with any title', async (t) => {
  const title = 'Rooms "A" & <B>';
  const { page, server } = await openScene(t, browser, {
    query: '?scene=room&options=fov=75',
    server: { files: roomFiles({ title }) },
  });
  await openShare(page);
  const parsed = await page.evaluate(() => {
    const template = document.createElement('template');
    const attributesOf = (selector) =>
      Object.fromEntries(
        [...template.content.querySelector(selector).attributes].map(({ name, value }) => [
          name,
          value,
        ]),
      );
    template.innerHTML = document.getElementById('share-tag').value;
    const [script, tag] = [attributesOf('script'), attributesOf('ray-caster')];
    template.innerHTML = document.getElementById('share-frame').value;
    return { script, tag, frame: attributesOf('iframe') };
  });
  assert.deepEqual(parsed.script, { type: 'module', src: `${server.address}ray-caster.js` });
  assert.deepEqual(parsed.tag, {
    scene: `${server.address}scenes/room.json`,
    view: 'walk,3.5,3.5,0.5,0,0,room',
    options: 'fov=75',
    label: title,
    controls: '',
  });
  assert.equal(
    parsed.frame.src,
    `${server.address}embed.html?scene=room&view=walk,3.5,3.5,0.5,0,0,room&options=fov=75`,
  );
  assert.equal(parsed.frame.title, title);
});

test('copying by keys alone is confirmed', async (t) => {
  const { page, context, server } = await openScene(t, browser);
  await context.grantPermissions(['clipboard-read', 'clipboard-write'], {
    origin: new URL(server.address).origin,
  });
  await play(page);
  await page.keyboard.press('z');
  await page.waitForSelector('#share[open]');
  for (const what of ['link', 'tag', 'frame']) {
    await page.focus(`[data-copy=${what}]`);
    await page.keyboard.press('Enter');
    await page.waitForFunction(
      (name) => document.querySelector(`[data-copy=${name}]`).textContent === 'Copied',
      what,
    );
    assert.equal(
      await page.evaluate(() => navigator.clipboard.readText()),
      await page.inputValue(`#share-${what}`),
    );
    assert.equal(await page.innerText('#share-status'), `Copied: the ${what}`);
    assert.equal(await page.locator('.done').count(), 1);
    assert.equal(
      await page.evaluate((name) => document.activeElement.dataset.copy === name, what),
      true,
      'the focus stays',
    );
  }
  await page.keyboard.press('Escape');
  await page.waitForSelector('#share:not([open])', { state: 'attached' });
  await page.click('#open-keys');
  assert.match(await page.innerText('#keys'), /Z\s+share this view/);
});

test('if the clipboard is refused, the text is selected', async (t) => {
  const { page } = await openScene(t, browser, {
    prepare: (newPage) =>
      newPage.addInitScript(() =>
        Object.defineProperty(navigator, 'clipboard', { value: undefined }),
      ),
  });
  await openShare(page);
  await page.click('[data-copy=tag]');
  await page.waitForFunction(() =>
    document.getElementById('share-status').textContent.includes('selected'),
  );
  assert.equal(
    await page.evaluate(() => getSelection().toString()),
    await page.inputValue('#share-tag'),
  );
});

test('the view is saved as a picture of the chosen size', async (t) => {
  const { page } = await openScene(t, browser);
  await openShare(page);
  for (const [value, name, size] of [
    [null, 'room-640x360.png', [640, 360]],
    ['1920x1080', 'room-1920x1080.png', [1920, 1080]],
  ]) {
    if (value !== null) await page.selectOption('#share-size', value);
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.click('#share-save'),
    ]);
    assert.equal(download.suggestedFilename(), name);
    const bytes = await readFile(await download.path());
    assert.equal(bytes.subarray(1, 4).toString(), 'PNG');
    assert.deepEqual([bytes.readUInt32BE(16), bytes.readUInt32BE(20)], size);
    assert.equal(await page.innerText('#share-status'), `Saved: ${name}`);
  }
});

test('a scene of the visitor’s own files has no address, but its picture can be saved', async (t) => {
  const { page } = await openScene(t, browser);
  const pictures = Object.entries(roomPictures()).map(([name, buffer]) => ({
    name,
    mimeType: 'image/png',
    buffer,
  }));
  await page.setInputFiles('#files', [
    {
      name: 'mine.json',
      mimeType: 'application/json',
      buffer: Buffer.from(JSON.stringify(roomScene({ title: 'Mine', folder: '' }))),
    },
    ...pictures,
  ]);
  await page.waitForFunction(
    () => document.title.startsWith('Mine') && document.body.dataset.state === 'paused',
  );
  await openShare(page);
  assert.equal(await page.isVisible('#share-addresses'), false);
  assert.match(await page.innerText('#share-no-address'), /no address/);
  const [download] = await Promise.all([page.waitForEvent('download'), page.click('#share-save')]);
  assert.equal(download.suggestedFilename(), 'mine-640x360.png');
});

test('axe finds nothing wrong with the dialog', async (t) => {
  const { page } = await openScene(t, browser);
  await openShare(page);
  await page.addScriptTag({ path: kAxe });
  const { violations } = await page.evaluate(() =>
    window.axe.run(document.getElementById('share')),
  );
  assert.deepEqual(
    violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(' ')}`),
    [],
  );
});

test('the visible scene is shared, even if another could not be opened', async (t) => {
  const { page } = await openScene(t, browser, { expectErrors: true });
  await page.evaluate(() => {
    history.pushState(null, '', '?scene=gone');
    window.dispatchEvent(new PopStateEvent('popstate'));
  });
  await inState(page, 'trouble');
  await page.click('#trouble-back');
  await inState(page, 'paused');
  await openShare(page);
  assert.match(await page.inputValue('#share-link'), /\?scene=room&/);
  assert.match(await page.inputValue('#share-tag'), /scenes\/room\.json/);
  await page.click('#share [data-close]');
  await page.click('#open-scenes');
  assert.equal(await page.textContent('#scene-list a[aria-current] h3'), 'The coloured room');
});
