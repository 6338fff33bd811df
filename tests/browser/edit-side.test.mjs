// The side view of the editor: the section through the map, where heights are dragged and tools
// work as on the plan.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { frames, launch } from './browser.mjs';
import { openEditor as openTheEditor, rowsOf, settle, textOf, told } from './editor-page.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const openEditor = (t, query, options) => openTheEditor(t, browser, query, options);

// Where a place of the section is in the window, while the whole of it is in sight.
async function placeOf(page, along, z) {
  const box = await page.locator('#side').boundingBox();
  const { width, depth, levels, ceiling, axis } = await told(page, () => {
    const { scene, editor } = window.slicecastEditor;
    const map = scene.value.maps[editor.map];
    return {
      width: map.levels[0][0].length,
      depth: map.levels[0].length,
      levels: map.levels.length,
      ceiling: map.ceiling?.height ?? 0,
      axis: editor.section.axis,
    };
  });
  const length = axis === 'x' ? width : depth;
  const top = Math.max(levels, ceiling) + 1;
  const scale = Math.min(box.width / (length + 2), box.height / (top + 0.35 + 2));
  return [
    box.x + box.width / 2 + (along - length / 2) * scale,
    box.y + box.height / 2 + (-z - (0.35 - top) / 2) * scale,
  ];
}

async function openSide(page) {
  await page.keyboard.press('KeyV');
  await page.waitForSelector('#side');
  await frames(page);
  await page.keyboard.press('0');
  await frames(page);
}

async function drag(page, from, to, modifiers = []) {
  await page.mouse.move(...(await placeOf(page, ...from)));
  await page.mouse.down();
  for (const key of modifiers) await page.keyboard.down(key);
  await page.mouse.move(...(await placeOf(page, ...to)), { steps: 8 });
  await page.mouse.up();
  for (const key of modifiers) await page.keyboard.up(key);
  await settle(page);
}

const sectionOf = (page) => told(page, () => window.slicecastEditor.editor.section);
const kindAt = (page, x, y, level) =>
  told(
    page,
    (place) => {
      const { scene } = window.slicecastEditor;
      return scene.value.legend[scene.sign(0, place[2], place[0], place[1])] ?? null;
    },
    [x, y, level],
  );

test('blocks are placed and removed in the section, and it is turned and moved by keys', async (t) => {
  const { page } = await openEditor(t);
  const before = await textOf(page);
  await openSide(page);
  assert.deepEqual(await sectionOf(page), { axis: 'x', at: 20 }, 'where the eye is');
  await drag(page, [10.5, 0.5], [14.5, 0.5]);
  assert.match((await rowsOf(page, 0))[20].slice(9, 16), /^\.([^.])\1{4}\.$/);
  await page.mouse.click(...(await placeOf(page, 12.5, 1.5)));
  assert.notEqual((await rowsOf(page, 1))[20][12], '.');
  await page.mouse.click(...(await placeOf(page, 12.5, 0.5)), { button: 'right' });
  assert.equal((await rowsOf(page, 0))[20][12], '.');
  await page.mouse.move(...(await placeOf(page, 13.5, 0.5)));
  await page.keyboard.press('Delete');
  assert.equal((await rowsOf(page, 0))[20][13], '.');
  await page.keyboard.press('ArrowUp');
  assert.deepEqual(await sectionOf(page), { axis: 'x', at: 19 }, 'to the north');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  assert.equal(await page.textContent('#section'), 'y 21');
  await page.keyboard.press('KeyV');
  assert.deepEqual(await sectionOf(page), { axis: 'y', at: 16 }, 'through the middle');
  await page.keyboard.press('ArrowUp');
  assert.equal(await page.textContent('#section'), 'x 17');
  await page.click('#section-near');
  assert.equal(await page.textContent('#section'), 'x 16');
  await page.mouse.move(...(await placeOf(page, 8.5, 2.5)));
  await page.keyboard.down('Shift');
  await page.mouse.wheel(0, 100);
  await page.waitForFunction(() => document.getElementById('section').textContent === 'x 15');
  await page.keyboard.up('Shift');
  await page.keyboard.press('0');
  await page.mouse.click(...(await placeOf(page, 4.5, 2.5)));
  assert.notEqual((await rowsOf(page, 2))[4][15], '.');
  while ((await told(page, () => window.slicecastEditor.history.undo())) !== null);
  assert.equal(await textOf(page), before);
});

test('edges of blocks are dragged, in steps of a tenth, with Alt finely', async (t) => {
  const { page } = await openEditor(t, '?template=house');
  await openSide(page);
  for (let count = 0; count < 8; ++count) await page.keyboard.press('ArrowUp');
  assert.deepEqual(await sectionOf(page), { axis: 'x', at: 14 });
  const before = await textOf(page);
  assert.equal(await kindAt(page, 11, 14, 1), 'brick wall');
  // Place: from within the block, near its edge.
  await drag(page, [11.5, 1.9], [11.5, 1.41]);
  assert.equal(await kindAt(page, 11, 14, 1), 'brick wall up to 0.5');
  await page.keyboard.press('KeyH');
  await drag(page, [11.5, 1.45], [11.5, 1.18], ['Alt']);
  const [, height] = /up to ([\d.]+)$/.exec(await kindAt(page, 11, 14, 1));
  assert.ok(Math.abs(Number(height) - 0.23) < 0.04 && Number(height) !== 0.2, height);
  await drag(page, [12.5, 0.2], [12.5, 0.5]);
  assert.equal(await kindAt(page, 12, 14, 0), 'brick wall from 0.3');
  const kinds = await told(page, () => Object.keys(window.slicecastEditor.scene.value.blueprints));
  assert.equal(kinds.filter((name) => name.startsWith('brick wall ')).length, 3, 'no others');
  const inEngine = await told(page, () =>
    window.slicecastEditor.caster.blueprints().some(({ name }) => name === 'brick wall from 0.3'),
  );
  assert.equal(inEngine, true);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);
  // Escape leaves a drag as if it had not begun.
  await page.mouse.move(...(await placeOf(page, 12.5, 0.8)));
  await page.mouse.down();
  await page.mouse.move(...(await placeOf(page, 12.5, 0.4)), { steps: 4 });
  assert.notEqual(await textOf(page), before);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  assert.equal(await textOf(page), before);
});

test('slopes, the ceiling, lamps and the start are dragged', async (t) => {
  const { page } = await openEditor(t);
  await told(page, () => {
    const { history } = window.slicecastEditor;
    history.do('Prepare', [
      { map: 0, cells: [{ layer: 0, x: 10, y: 20, sign: '/' }] },
      { path: ['maps', 0, 'ceiling'], value: { height: 4, texture: 'planks' } },
      { path: ['maps', 0, 'baked', 'lamps'], value: [{ x: 20.5, y: 20.5, z: 2 }] },
    ]);
  });
  await openSide(page);
  await page.keyboard.press('KeyH');
  await drag(page, [10.9, 0.8], [10.9, 0.4]);
  const ramp = await kindAt(page, 10, 20, 0);
  const { top } = await told(
    page,
    (name) => window.slicecastEditor.scene.value.blueprints[name],
    ramp,
  );
  assert.deepEqual(top, [0, 0.6]);
  await drag(page, [5.5, 4], [5.5, 3]);
  const { ceiling } = await told(page, () => window.slicecastEditor.scene.value.maps[0]);
  assert.equal(ceiling.height, 3);
  await page.keyboard.press('KeyT');
  await page.keyboard.press('0');
  await frames(page);
  await drag(page, [20.5, 2], [21.5, 1]);
  const [lamp] = await told(page, () => window.slicecastEditor.scene.value.maps[0].baked.lamps);
  assert.ok(Math.abs(lamp.x - 21.5) < 0.1 && lamp.y === 20.5, JSON.stringify(lamp));
  assert.ok(Math.abs(lamp.z - 1) < 0.11, JSON.stringify(lamp));
  await drag(page, [16.5, 0.6], [18.5, 0.6]);
  const { start } = await told(page, () => window.slicecastEditor.scene.value);
  assert.ok(Math.abs(start.x - 18.5) < 0.1 && start.y === 20.5);
  // What is put stands where one clicks, a little above the ground on it.
  await page.click('#palette [data-key="sprite oak"]');
  await page.mouse.click(...(await placeOf(page, 25.5, 0.2)));
  await page.click('#palette [data-key="lamp"]');
  await page.mouse.click(...(await placeOf(page, 27.5, 2)));
  await settle(page);
  const map = await told(page, () => window.slicecastEditor.scene.value.maps[0]);
  assert.equal(map.objects[0].z ?? 0, 0);
  assert.ok(Math.abs(map.baked.lamps[1].z - 2) < 0.1);
  await page.mouse.click(...(await placeOf(page, 27.5, 2)), { button: 'right' });
  await settle(page);
  assert.equal(
    await told(page, () => window.slicecastEditor.scene.value.maps[0].baked.lamps.length),
    1,
  );
});

test('the other tools work in the section as on the plan', async (t) => {
  const { page } = await openEditor(t);
  await openSide(page);
  await page.keyboard.press('KeyX');
  await drag(page, [4.5, 0.5], [8.5, 3.5]);
  const sign = await told(page, () => window.slicecastEditor.editor.sign);
  for (let level = 0; level < 4; ++level)
    assert.equal((await rowsOf(page, level))[20].slice(3, 10), `.${sign.repeat(5)}.`);
  await page.keyboard.press('0'); // there are more levels now
  await frames(page);
  await page.keyboard.press('3');
  await page.keyboard.press('KeyR');
  await page.mouse.click(...(await placeOf(page, 5.5, 2.5)));
  const third = await told(page, () => window.slicecastEditor.editor.sign);
  assert.equal((await rowsOf(page, 1))[20].slice(3, 10), `.${third.repeat(5)}.`);
  await page.keyboard.press('KeyP');
  await page.click('#palette [data-key="sand"]');
  await page.mouse.click(...(await placeOf(page, 6.5, 3.85)));
  const painted = await kindAt(page, 6, 20, 3);
  const { faces } = await told(
    page,
    (name) => window.slicecastEditor.scene.value.blueprints[name],
    painted,
  );
  assert.equal(faces.top, 'sand');
  await page.keyboard.press('KeyB');
  await page.mouse.click(...(await placeOf(page, 4.5, 1.5)), { button: 'middle' });
  assert.equal(await told(page, () => window.slicecastEditor.editor.sign), third);
});

test('the plan shows the section until another view is used; a wide page keeps the picture', async (t) => {
  const { page } = await openEditor(t, '?template=house', {
    viewport: { width: 1600, height: 900 },
  });
  await page.click('[data-view=side]');
  assert.equal(await page.isVisible('#picture'), true);
  const [picture, side] = await Promise.all(
    ['#picture-view', '#side-view'].map((part) => page.locator(part).boundingBox()),
  );
  assert.ok(Math.abs(picture.width - side.width) < 4);
  await page.click('[data-view=plan]');
  assert.equal(await page.isVisible('#side'), false);
  assert.deepEqual(await sectionOf(page), { axis: 'x', at: 22 });
  const brightOf = () =>
    told(page, () => {
      const canvas = document.getElementById('plan');
      const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
      let count = 0;
      for (let at = 0; at < data.length; at += 4)
        if (data[at] === 0xf7 && data[at + 1] === 0xf1 && data[at + 2] === 0xe1) count += 1;
      return count;
    });
  await frames(page);
  assert.ok((await brightOf()) > 100);
  await page.click('[data-view=picture]');
  assert.equal(await sectionOf(page), null);
  await page.click('[data-view=plan]');
  await frames(page);
  assert.equal(await brightOf(), 0);
});

test('two fingers pan and zoom, one places', async (t) => {
  const { page, context } = await openEditor(t, '?template=meadow', {
    viewport: { width: 820, height: 1180 },
    context: { hasTouch: true, isMobile: true },
  });
  await page.tap('[data-view=side]');
  await frames(page);
  const [x, y] = await placeOf(page, 10.5, 0.5);
  await page.touchscreen.tap(x, y);
  assert.notEqual((await rowsOf(page, 0))[20][10], '.');
  const text = await textOf(page);
  const client = await context.newCDPSession(page);
  const touch = (type, points) =>
    client.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: points.map(([atX, atY], id) => ({ x: atX, y: atY, id })),
    });
  await touch('touchStart', [[x, y]]);
  await touch('touchStart', [
    [x, y],
    [x + 100, y],
  ]);
  await touch('touchMove', [
    [x, y],
    [x + 300, y],
  ]);
  await touch('touchEnd', []);
  await frames(page);
  assert.equal(await textOf(page), text, 'the first finger has put nothing');
  // The tile under the first finger has stayed, and all is larger.
  await page.touchscreen.tap(...(await placeOf(page, 20.5, 0.5)));
  const row = (await rowsOf(page, 0))[20];
  const columns = [...row].flatMap((sign, column) => (sign === '.' ? [] : column));
  assert.equal(columns.length, 2);
  assert.ok(columns[1] >= 12 && columns[1] <= 15, String(columns));
});

for (const [name, viewport] of Object.entries({
  'a small desk': { width: 1366, height: 768 },
  'a tablet': { width: 820, height: 1180 },
  'a phone': { width: 360, height: 740 },
})) {
  test(`on ${name} the side view fits, and axe finds nothing`, async (t) => {
    const hasTouch = viewport.width < 900;
    const { page } = await openEditor(t, '?scene=castle', {
      viewport,
      context: { hasTouch, isMobile: hasTouch },
    });
    await page.click('[data-view=side]');
    await frames(page);
    const { overflow, small } = await told(page, () => ({
      overflow: document.documentElement.scrollWidth - innerWidth,
      small: [...document.querySelectorAll('[data-of=side] button')].filter(
        (button) => button.getBoundingClientRect().height < (innerWidth < 900 ? 44 : 32),
      ).length,
    }));
    assert.deepEqual([overflow, small], [0, 0]);
    await page.addScriptTag({ path: kAxe });
    const found = await told(page, async () =>
      (await window.axe.run(document, { resultTypes: ['violations'] })).violations.map(
        ({ id, nodes }) => [id, nodes[0].html],
      ),
    );
    assert.deepEqual(found, []);
  });
}
