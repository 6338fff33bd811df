// What refers to what, made in the editor by mouse, touch and keys, in the picture and on the plan,
// and then played.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { frames, launch } from './browser.mjs';
import { lookAt, openEditor as openTheEditor, pointOf, settle, told } from './editor-page.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const openEditor = (t, query, options) => openTheEditor(t, browser, query, options);
const valueOf = (page) => told(page, () => window.slicecastEditor.scene.value);
const pendingOf = (page) => told(page, () => window.slicecastEditor.editor.pending);

// Blocks of the first kind, on the ground.
async function build(page, ...places) {
  await told(
    page,
    (wanted) => {
      const { history, editor } = window.slicecastEditor;
      const cells = wanted.map(([x, y]) => ({ layer: 0, x, y, sign: editor.sign }));
      history.do('Build', [{ map: 0, cells }]);
    },
    places,
  );
  await settle(page);
}

async function click(page, place, options) {
  await page.mouse.move(...(await pointOf(page, ...place)));
  await frames(page);
  await page.mouse.click(...(await pointOf(page, ...place)), options);
  await settle(page);
}

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await frames(page);
  await page.mouse.down();
  await page.mouse.move(...to, { steps: 6 });
  await frames(page);
  await page.mouse.up();
  await settle(page);
}

// Where a point of the map is on the plan, which shows a map of 32 x 32 tiles as a whole.
async function planOf(page) {
  await page.click('[data-view=plan]');
  await frames(page);
  const box = await page.locator('#plan').boundingBox();
  const scale = Math.min(box.width, box.height) / 34;
  return (x, y) => [
    box.x + box.width / 2 + (x - 16) * scale,
    box.y + box.height / 2 + (y - 16) * scale,
  ];
}

// From a place on, straight ahead, until something is so.
async function walk(page, view, isThere, argument) {
  await page.click('[data-view=picture]');
  await lookAt(page, view);
  await page.click('#walk');
  await page.waitForFunction(() => window.slicecastEditor.caster.entered);
  await page.keyboard.down('KeyW');
  await page.waitForFunction(isThere, argument);
  await page.keyboard.up('KeyW');
  await page.keyboard.press('Tab');
  await page.waitForFunction(() => window.slicecastEditor.caster.state === 'paused');
  await settle(page);
}

test('a pair of portals is made in the picture, walked through, moved and removed', async (t) => {
  const { page } = await openEditor(t);
  await build(page, [14, 14], [19, 14]);
  await lookAt(page, { x: 16.5, y: 21.5, z: 1.4, heading: 270, look: -0.15 });
  await page.keyboard.press('KeyY');
  await click(page, [14.5, 15, 0.5]);
  assert.equal((await pendingOf(page)).kind, 'portal');
  await page.keyboard.press('Escape');
  assert.equal(await pendingOf(page), null);
  await click(page, [14.5, 15, 0.5]);
  await click(page, [19.5, 15, 0.5]);
  assert.deepEqual((await valueOf(page)).maps[0].portals, [
    {
      x: 14,
      y: 14,
      level: 0,
      face: 'south',
      to: { x: 19, y: 15, level: 0 },
      turn: 180,
      twoWay: true,
    },
  ]);
  assert.equal(await page.isHidden('#problems'), true);
  assert.equal(await page.isVisible('#part-thing [data-path$=",face"]'), true, 'its form');
  await walk(page, { x: 14.5, y: 17.5, z: 0.6, heading: 270, look: 0 }, () => {
    const { x, y } = window.slicecastEditor.caster.currentView;
    return x > 19 && x < 20 && y > 15.2;
  });
  await lookAt(page, { x: 16.5, y: 21.5, z: 1.4, heading: 270, look: -0.15 });
  await drag(page, await pointOf(page, 19.5, 15, 0.5), await pointOf(page, 16.5, 18.5, 0));
  const [{ to }] = (await valueOf(page)).maps[0].portals;
  assert.deepEqual(to, { x: 16, y: 18, level: 0 }, 'to the open: in one direction');
  await click(page, [14.5, 15, 0.5], { button: 'right' });
  assert.deepEqual((await valueOf(page)).maps[0].portals, []);
});

test('on the plan the nearest side of a block counts; an end is dragged there', async (t) => {
  const { page } = await openEditor(t);
  await build(page, [8, 8], [20, 14]);
  await page.keyboard.press('KeyY');
  const at = await planOf(page);
  await page.mouse.click(...at(8.9, 8.5));
  await page.mouse.click(...at(20.5, 14.1));
  await settle(page);
  const [portal] = (await valueOf(page)).maps[0].portals;
  assert.deepEqual([portal.face, portal.to], ['east', { x: 20, y: 13, level: 0 }]);
  assert.equal(portal.turn, 90);
  assert.equal(await page.isHidden('#problems'), true);
  assert.match(await page.textContent('.legend'), /Portal/);
  await drag(page, at(9, 8.5), at(8.5, 8.9));
  assert.equal((await valueOf(page)).maps[0].portals[0].face, 'south');
  await page.mouse.click(...at(8.5, 9), { button: 'right' });
  await settle(page);
  assert.deepEqual((await valueOf(page)).maps[0].portals, []);
});

test('on the plan a gate gets its find, messages are drawn, and blocks get a way', async (t) => {
  const { page } = await openEditor(t);
  await build(page, [8, 8], [20, 14]);
  const at = await planOf(page);
  await page.keyboard.press('KeyT');
  await page.click('#palette [data-key="find shell"]');
  await page.mouse.click(...at(12.5, 8.5));
  await settle(page);
  await page.keyboard.press('KeyY');
  await page.click('[data-way=gate]');
  await page.mouse.click(...at(8.5, 8.5));
  await page.mouse.click(...at(12.5, 8.5));
  await page.keyboard.press('Escape');
  await settle(page);
  const { blueprints } = await valueOf(page);
  const { gate } = Object.values(blueprints).find((one) => one.gate);
  assert.equal(gate.needs, 'shell');
  await page.click('[data-way=message]');
  await drag(page, at(4.5, 20.5), at(6.5, 21.5));
  assert.equal((await valueOf(page)).maps[0].messages[0].width, 3);
  await page.fill('#part-thing [data-path$=",text"]', 'Mind the step.');
  await page.keyboard.press('Tab');
  await page.click('[data-way=way]');
  await page.mouse.click(...at(20.5, 14.5));
  await page.mouse.click(...at(24.5, 14.5));
  await settle(page);
  const { maps, motions } = await valueOf(page);
  assert.equal(maps[0].messages[0].text, 'Mind the step.');
  assert.deepEqual(
    Object.values(motions).map(({ along = 'z', to }) => [along, to]),
    [
      ['z', -1],
      ['x', 4],
    ],
  );
  assert.equal(await page.isHidden('#problems'), true);
  assert.equal((await page.textContent('.legend')).trim(), 'GateMoving blockMessageFind');
});

test('find the key, open the gate, leave: a game made without a word of text', async (t) => {
  const { page } = await openEditor(t);
  await build(page, ...Array.from({ length: 32 }, (_, x) => [x, 15]));
  await lookAt(page, { x: 16.5, y: 23.5, z: 2.5, heading: 270, look: -0.4 });
  await page.keyboard.press('KeyT');
  await page.click('#palette [data-key="find crystal"]');
  await click(page, [16.5, 18, 0]);
  await page.keyboard.press('KeyY');
  await page.keyboard.press('KeyO');
  assert.equal(await page.getAttribute('[data-way=gate]', 'aria-pressed'), 'true');
  await click(page, [16.5, 16, 0.5]);
  assert.equal((await pendingOf(page)).kind, 'gate');
  await click(page, [16.5, 18, 0.15]);
  await page.keyboard.press('Escape');
  await page.click('[data-way=goal]');
  const at = await planOf(page);
  await drag(page, at(14.5, 10.5), at(18.5, 12.5));
  const { blueprints, game, maps } = await valueOf(page);
  const gates = Object.values(blueprints).filter(({ gate }) => gate);
  assert.deepEqual(
    gates.map(({ gate }) => gate.needs),
    ['crystal'],
  );
  assert.deepEqual(game.at, { x: 14, y: 10, width: 5, depth: 3 });
  assert.equal(maps[0].objects[0].find, 'crystal');
  assert.equal(await page.isHidden('#problems'), true);
  await told(page, () => {
    window.reached = [];
    for (const type of ['find', 'goal'])
      window.slicecastEditor.caster.addEventListener(type, () => window.reached.push(type));
  });
  await walk(
    page,
    { x: 16.5, y: 20.5, z: 0.6, heading: 270, look: 0 },
    () => String(window.reached) === 'find,goal',
  );
});

test('a way is clicked in the picture, and changed on the plan', async (t) => {
  const { page } = await openEditor(t);
  await told(page, () => {
    const { history } = window.slicecastEditor;
    history.do('Add', [
      { path: ['sprites', 'guard'], value: { file: '../sprites/guard.png', views: 4 } },
      {
        path: ['maps', 0, 'objects', 0],
        value: { sprite: 'guard', x: 14.5, y: 16.5, height: 0.8 },
      },
    ]);
  });
  await settle(page);
  await lookAt(page, { x: 16.5, y: 23.5, z: 3, heading: 270, look: -0.4 });
  await page.keyboard.press('KeyY');
  await page.click('[data-way=way]');
  await click(page, [14.5, 16.5, 0.4]);
  assert.equal((await pendingOf(page)).kind, 'way');
  await click(page, [18.5, 16.5, 0]);
  await click(page, [18.5, 18.5, 0]);
  await click(page, [14.5, 18.5, 0]);
  await page.keyboard.press('Enter');
  assert.equal(await pendingOf(page), null);
  const points = async () =>
    (await valueOf(page)).maps[0].objects[0].motion.path.map(({ x, y }) => [
      Math.round(x * 2) / 2,
      Math.round(y * 2) / 2,
    ]);
  assert.deepEqual(await points(), [
    [18.5, 16.5],
    [18.5, 18.5],
    [14.5, 18.5],
  ]);
  const at = await planOf(page);
  await page.mouse.click(...at(16.5, 18.5));
  await settle(page);
  assert.equal((await points()).length, 4);
  await drag(page, at(16.5, 18.5), at(16.5, 20));
  assert.deepEqual((await points())[2], [16.5, 20]);
  await page.mouse.click(...at(18.5, 18.5), { button: 'right' });
  await settle(page);
  assert.deepEqual(await points(), [
    [18.5, 16.5],
    [16.5, 20],
    [14.5, 18.5],
  ]);
  assert.equal(await page.isHidden('#problems'), true);
});

test('handles of the start and of lamps, a copy, and Delete', async (t) => {
  const { page } = await openEditor(t);
  await page.keyboard.press('KeyT');
  const at = await planOf(page);
  await page.mouse.click(...at(16.5, 20.5));
  assert.equal(await page.isVisible('#part-thing [data-path="start,heading"]'), true);
  await drag(page, at(16.5, 19.5), at(19.5, 20.5));
  assert.equal((await valueOf(page)).start.heading, 0);
  await page.mouse.move(...at(16.5, 20.5));
  await page.mouse.wheel(0, 100);
  await settle(page);
  assert.equal((await valueOf(page)).start.heading, 345);
  await page.click('#palette [data-key=lamp]');
  await page.mouse.click(...at(10.5, 10.5));
  await settle(page);
  await drag(page, at(15.5, 10.5), at(13.5, 10.5));
  const lamps = async () => (await valueOf(page)).maps[0].baked.lamps;
  assert.equal((await lamps())[0].radius, 3);
  await page.keyboard.press('Control+d');
  await settle(page);
  assert.equal((await lamps()).length, 2);
  assert.equal((await lamps())[1].x, (await lamps())[0].x + 1);
  await page.mouse.move(...at(2.5, 2.5));
  await frames(page);
  await page.keyboard.press('Delete');
  await settle(page);
  assert.equal((await lamps()).length, 1, 'what was chosen last');
  await page.click('[data-view=picture]');
  await lookAt(page, { x: 10.5, y: 14.5, z: 1.2, heading: 270, look: -0.1 });
  const [{ x, y, z }] = await lamps();
  await page.mouse.move(...(await pointOf(page, x, y, z)));
  await frames(page);
  await page.mouse.wheel(0, -100);
  await settle(page);
  const higher = (await lamps())[0].z;
  assert.ok(higher > z);
  await page.keyboard.down('Alt');
  await drag(page, await pointOf(page, x, y, higher), await pointOf(page, x, y, higher + 0.5));
  await page.keyboard.up('Alt');
  const [highest] = await lamps();
  assert.ok(Math.abs(highest.z - higher - 0.5) < 0.06, `${highest.z}`);
  assert.deepEqual([highest.x, highest.y], [x, y]);
});

test('a portal to another map, made on the plan, takes a new name of that map along', async (t) => {
  const { page } = await openEditor(t);
  await build(page, [8, 8]);
  await told(page, () => {
    const { history, scene } = window.slicecastEditor;
    const [first] = scene.value.maps;
    history.do('Add', [{ path: ['maps', 1], value: { ...first, name: 'cellar' } }]);
  });
  await settle(page);
  await page.keyboard.press('KeyY');
  const at = await planOf(page);
  await page.mouse.click(...at(8.5, 8.9));
  await page.selectOption('#map', '1');
  await frames(page);
  assert.equal((await pendingOf(page)).kind, 'portal', 'it is kept');
  await page.mouse.click(...at(8.9, 8.5));
  await settle(page);
  const portals = async () => (await valueOf(page)).maps[0].portals;
  assert.deepEqual((await portals())[0].to, { map: 'cellar', x: 9, y: 8, level: 0 });
  await page.click('#tab-map');
  const name = page.locator('#part-map [data-path="maps,1,name"]');
  await name.fill('world');
  await name.press('Tab');
  assert.match(await page.textContent('#toast'), /another map with the name "world"/);
  assert.equal(await name.inputValue(), 'cellar');
  await name.fill('crypt');
  await name.press('Tab');
  await settle(page);
  assert.equal((await portals())[0].to.map, 'crypt');
  assert.equal(await page.isHidden('#problems'), true);
  await page.click('#tab-kind');
  const kind = page.locator('#part-kind [data-path$=" rename"]');
  const before = await kind.inputValue();
  await kind.fill('rampart');
  await kind.press('Tab');
  await settle(page);
  assert.equal(await kind.inputValue(), 'rampart', 'the form stays');
  const { blueprints, legend } = await valueOf(page);
  assert.deepEqual(
    [before, 'rampart'].map((one) => Object.hasOwn(blueprints, one)),
    [false, true],
  );
  assert.ok(Object.values(legend).includes('rampart'));
  await page.click('#undo');
  await page.click('#tab-world');
  await page.click('#part-world summary:has-text("Sprites")');
  const oak = page.locator('#part-world [data-path="sprites,oak rename"]');
  await oak.fill('old oak');
  await oak.press('Tab');
  await settle(page);
  assert.deepEqual(Object.keys((await valueOf(page)).sprites)[0], 'old oak');
  await page.click('#undo');
  await page.click('#undo');
  assert.equal((await portals())[0].to.map, 'cellar');
});

test('by keys alone: a portal in the picture, and a way on the plan', async (t) => {
  const { page } = await openEditor(t);
  await build(page, [14, 14], [19, 14]);
  await told(page, () => {
    const { history } = window.slicecastEditor;
    const guard = { sprite: 'oak', x: 10.5, y: 10.5, height: 0.8 };
    history.do('Add', [{ path: ['maps', 0, 'objects', 0], value: guard }]);
  });
  await settle(page);
  await page.keyboard.press('KeyY');
  await lookAt(page, { x: 14.5, y: 16.5, z: 0.6, heading: 270, look: 0 });
  await page.keyboard.press('Enter');
  await lookAt(page, { x: 19.5, y: 16.5, z: 0.6, heading: 270, look: 0 });
  await page.keyboard.press('Enter');
  await settle(page);
  const [portal] = (await valueOf(page)).maps[0].portals;
  assert.deepEqual([portal.x, portal.face, portal.to.x], [14, 'south', 19]);
  await page.keyboard.press('KeyG');
  await page.keyboard.press('KeyO');
  await page.keyboard.press('KeyO');
  assert.equal(await page.getAttribute('[data-way=way]', 'aria-pressed'), 'true');
  for (const [x, y] of [
    [10.5, 10.5],
    [14.5, 10.5],
    [14.5, 12.5],
  ]) {
    await lookAt(page, { x, y, z: 2, heading: 0, look: 0 });
    await page.keyboard.press('Insert');
    await settle(page);
  }
  await page.keyboard.press('Enter');
  assert.equal(await pendingOf(page), null);
  const { path } = (await valueOf(page)).maps[0].objects[0].motion;
  assert.deepEqual(path, [
    { x: 14.5, y: 10.5 },
    { x: 14.5, y: 12.5 },
  ]);
});

test('by touch: taps make a portal, and buttons choose what is made', async (t) => {
  const { page } = await openEditor(t, '?template=meadow', {
    viewport: { width: 390, height: 844 },
    context: { hasTouch: true },
  });
  await build(page, [13, 14], [18, 14]);
  await lookAt(page, { x: 16, y: 20.5, z: 1.4, heading: 270, look: -0.15 });
  await page.tap('#tools [data-tool=link]');
  const tap = async (...place) => {
    await page.touchscreen.tap(...(await pointOf(page, ...place)));
    await settle(page);
  };
  await tap(13.5, 15, 0.5);
  await tap(18.5, 15, 0.5);
  assert.equal((await valueOf(page)).maps[0].portals.length, 1);
  await page.tap('[data-way=message]');
  await tap(16.5, 17.5, 0);
  assert.equal((await valueOf(page)).maps[0].messages.length, 1);
  await page.tap('#thing-remove');
  assert.deepEqual((await valueOf(page)).maps[0].messages, []);
  for (const button of await page.locator('#ways button:visible').all()) {
    const { width, height } = await button.boundingBox();
    assert.ok(width >= 44 && height >= 44, `${width} x ${height}`);
  }
  await page.tap('[data-view=plan]');
  await frames(page);
  await page.addScriptTag({ path: kAxe });
  const found = await told(page, async () =>
    (await window.axe.run(document, { resultTypes: ['violations'] })).violations.map(
      ({ id, nodes }) => [id, nodes[0].html],
    ),
  );
  assert.deepEqual(found, []);
});
