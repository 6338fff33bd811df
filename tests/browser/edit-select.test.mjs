// The editor in a page: parts are selected, moved, turned, copied and kept as stamps; floors are
// painted, lines drawn, and maps change their size.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { frames, launch } from './browser.mjs';
import { lookAt, openEditor, pointOf, rowsOf, settle, textOf, told } from './editor-page.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const count = (page) => told(page, () => window.slicecastEditor.editor.selection?.cells.size ?? 0);
const button = (page, label) => page.locator(`#select-bar button:text-is("${label}")`);
const noFaults = async (page) => {
  await settle(page);
  assert.equal(
    await page.textContent('#problems:not([hidden])', { timeout: 100 }).catch(() => ''),
    '',
  );
};

async function drag(page, from, to, { button: which = 'left', during = () => {} } = {}) {
  await page.mouse.move(...from);
  await page.mouse.down({ button: which });
  await page.mouse.move(...to, { steps: 6 });
  await frames(page);
  await during();
  await page.mouse.up({ button: which });
  await settle(page);
}

// Puts another scene into the page.
async function setScene(page, value) {
  await told(
    page,
    (text) => {
      const { scene } = window.slicecastEditor;
      scene.apply([{ offset: 0, length: scene.text.length, content: text }]);
    },
    JSON.stringify(value),
  );
  await settle(page);
}

async function openPlan(page) {
  await page.click('[data-view=plan]');
  await page.waitForSelector('#plan');
  await frames(page);
  const [width, depth] = await told(page, () => {
    const { scene, editor } = window.slicecastEditor;
    const [rows] = scene.value.maps[editor.map].levels.filter((level) => level.length > 0);
    return [rows[0].length, rows.length];
  });
  const box = await page.locator('#plan').boundingBox();
  const scale = Math.min(box.width / (width + 2), box.height / (depth + 2), 96);
  return (x, y) => [
    box.x + box.width / 2 + (x - width / 2) * scale,
    box.y + box.height / 2 + (y - depth / 2) * scale,
  ];
}

const kYard = {
  title: 'A yard',
  textures: { grass: '#3c7a3c', grey: '#808080', red: '#c03020', blue: '#3050c0', gold: '#d0a030' },
  blueprints: {
    wall: { faces: 'grey' },
    post: { faces: 'red' },
    ramp: { top: [0, 1], rise: 'north', faces: { all: 'gold', west: 'blue', top: 'red' } },
    half: { diagonal: 'north-west', faces: { all: 'blue', south: 'gold' } },
    pane: { plan: [0.6, 0, 1, 0.4], top: 0.7, faces: { all: 'grey', north: 'red', west: 'gold' } },
  },
  legend: { '#': 'wall', p: 'post', r: 'ramp', h: 'half', n: 'pane' },
  maps: [
    {
      name: 'yard',
      levels: [
        [
          '.........',
          '.........',
          '.........',
          '...#rp...',
          '...hn#...',
          '...prr...',
          '.........',
          '.........',
          '.........',
        ],
      ],
      floor: 'grass',
      light: { on: false },
    },
  ],
  start: { x: 1.5, y: 1.5 },
};

test('in the picture: a box is selected, moved, removed; kinds and what is joined', async (t) => {
  const { page } = await openEditor(t, browser);
  await setScene(page, kYard);
  const before = await textOf(page);
  await lookAt(page, { x: 4.5, y: 8.9, z: 2, heading: 270, look: -0.8 });
  await page.keyboard.press('KeyM');
  await drag(page, await pointOf(page, 3.5, 6.5, 0), await pointOf(page, 5.5, 6.5, 0));
  assert.equal(await count(page), 3);
  await page.keyboard.press('Escape');
  assert.equal(await count(page), 0);

  await button(page, 'Joined').click();
  await page.mouse.click(...(await pointOf(page, 4.8, 6, 0.2)));
  assert.equal(await count(page), 2, 'two ramps');
  await button(page, 'Kind').click();
  await page.mouse.click(...(await pointOf(page, 4.8, 6, 0.2)));
  assert.equal(await count(page), 3);
  await page.keyboard.down('Shift');
  await page.mouse.click(...(await pointOf(page, 3.5, 6, 0.8)));
  await page.keyboard.up('Shift');
  assert.equal(await count(page), 5, 'the posts, too');
  await page.keyboard.press('Delete');
  assert.deepEqual((await rowsOf(page, 0)).slice(3, 6), ['...#.....', '...hn#...', '.........']);
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);

  // Dragged by its top, a block stays at its height.
  await page.keyboard.press('Escape');
  await page.mouse.click(...(await pointOf(page, 3.5, 5.5, 1)));
  assert.equal(await count(page), 2);
  await drag(page, await pointOf(page, 3.5, 5.5, 1), await pointOf(page, 2.5, 6.5, 1));
  assert.equal((await rowsOf(page, 0))[6], '..p......');
  assert.equal((await rowsOf(page, 0))[4], '...hp#...');
  // Arrows lead away from the eye, Shift lifts.
  await page.keyboard.press('ArrowUp');
  assert.equal((await rowsOf(page, 0))[5], '..p.rr...');
  await page.keyboard.press('Shift+ArrowUp');
  assert.equal((await rowsOf(page, 1))[5], '..p......');
  for (let times = 0; times < 3; ++times) await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);
});

test('in the plan: levels by wheel and keys, copied, turned, pasted, cut and filled', async (t) => {
  const { page } = await openEditor(t, browser);
  await setScene(page, kYard);
  const tile = await openPlan(page);
  await page.keyboard.press('KeyM');
  await drag(page, tile(3.5, 3.5), tile(5.5, 4.5), {
    async during() {
      await page.mouse.wheel(0, -100);
      await page.keyboard.press('PageUp');
      await frames(page);
    },
  });
  assert.equal(await count(page), 6 * 3, 'three levels');
  await page.keyboard.press('Control+c');
  await page.waitForFunction(() =>
    document.getElementById('toast').textContent.startsWith('Copied'),
  );
  await page.keyboard.press('Control+v');
  await page.waitForFunction(() => window.slicecastEditor.editor.brush !== null);
  await page.keyboard.press('KeyU');
  await page.mouse.click(...tile(7.5, 7.5));
  await page.keyboard.press('Escape');
  const rows = await rowsOf(page, 0);
  const names = await told(page, () => {
    const { scene } = window.slicecastEditor;
    return Object.fromEntries(Object.entries(scene.value.legend));
  });
  assert.deepEqual(
    rows.slice(6).map((row) => [...row].slice(7).map((sign) => names[sign])),
    [
      ['half, turned', 'wall'],
      ['pane, turned', 'ramp, turned'],
      ['wall', 'post'],
    ],
  );
  await noFaults(page);
  await page.keyboard.press('Escape');
  await page.keyboard.press('KeyM');
  await drag(page, tile(3.5, 3.5), tile(5.5, 3.5));
  await page.keyboard.press('Control+x');
  assert.equal((await rowsOf(page, 0))[3], '.........');
  await page.keyboard.press('2');
  await page.keyboard.press('KeyN');
  assert.equal((await rowsOf(page, 0))[3], '...ppp...');
  await page.keyboard.press('ArrowLeft');
  assert.equal((await rowsOf(page, 0))[3], '..ppp....');
  await page.keyboard.press('Control+a');
  assert.equal(await count(page), 3 + 3 + 3 + 6 + 1, 'all blocks, and the start');
});

test('by touch: the bar has all that keys do', async (t) => {
  const { page } = await openEditor(t, browser, '?template=meadow', {
    viewport: { width: 390, height: 844 },
    context: { hasTouch: true },
  });
  await setScene(page, kYard);
  const tile = await openPlan(page);
  await page.locator('[data-tool=select]').tap();
  await page.touchscreen.tap(...tile(3.5, 3.5));
  assert.equal(await count(page), 1);
  await button(page, 'Add').tap();
  await page.touchscreen.tap(...tile(4.5, 3.5));
  assert.equal(await count(page), 2);
  await button(page, 'Turn').tap();
  await settle(page);
  const turned = await told(page, () => {
    const { legend } = window.slicecastEditor.scene.value;
    return [3, 4].map((y) => legend[window.slicecastEditor.scene.sign(0, 0, 3, y)]);
  });
  assert.deepEqual(turned, ['wall', 'ramp, turned'], 'from north to south');
  await page.tap('#undo');
  assert.equal((await rowsOf(page, 0))[3], kYard.maps[0].levels[0][3]);
  await button(page, 'Delete').tap();
  assert.equal((await rowsOf(page, 0))[3], '.....p...');
  const sizes = await told(page, () =>
    [...document.querySelectorAll('#select-bar button:not([hidden])')].map(
      (one) => one.getBoundingClientRect().height,
    ),
  );
  assert.ok(
    sizes.every((height) => height >= 44),
    `${sizes}`,
  );
});

test('a stamp is kept, shown in other worlds, and brings what it needs', async (t) => {
  const { page, server } = await openEditor(t, browser, '?template=house');
  await page.keyboard.press('Control+a');
  const blocks = await count(page);
  await page.keyboard.press('Shift+K');
  await page.fill('dialog.small input', 'my house');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() =>
    document.getElementById('toast').textContent.includes('my house'),
  );
  await page.goto(`${server.address}edit.html?template=cave`);
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  const before = await textOf(page);
  await page.keyboard.press('KeyK');
  await page.click('#palette [aria-label="my house"]');
  const tile = await openPlan(page);
  await page.mouse.click(...tile(12.5, 12.5));
  await noFaults(page);
  const kinds = await told(page, () => Object.keys(window.slicecastEditor.scene.value.blueprints));
  assert.ok(kinds.includes('brick wall') || kinds.length > 3, `${kinds}`);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+z');
  assert.equal(await textOf(page), before);
  await page.keyboard.press('KeyK');
  await page.click('#palette [aria-label="my house"]');
  await button(page, 'Forget').click();
  await page.keyboard.press('KeyK');
  await page.waitForFunction(() => document.querySelectorAll('#palette [data-key]').length === 0);
  assert.ok(blocks > 20);
});

test('what was copied in one tab is pasted in another', async (t) => {
  const { page, context, server } = await openEditor(t, browser);
  await setScene(page, kYard);
  await page.keyboard.press('Control+a');
  await page.keyboard.press('Control+c');
  await page.waitForFunction(() =>
    document.getElementById('toast').textContent.startsWith('Copied'),
  );
  const other = await context.newPage();
  await other.goto(`${server.address}edit.html?template=garden`);
  await other.waitForFunction(() => document.body.dataset.state === 'ready');
  await other.keyboard.press('Control+v');
  await other.waitForFunction(() => window.slicecastEditor.editor.brush !== null);
  const tile = await openPlan(other);
  await other.mouse.click(...tile(6.5, 6.5));
  await noFaults(other);
  assert.ok(
    await told(other, () => Object.hasOwn(window.slicecastEditor.scene.value.blueprints, 'pane')),
  );
  await other.close();
});

test('what is turned looks from the east as it looked from the north', async (t) => {
  const { page } = await openEditor(t, browser);
  await setScene(page, kYard);
  const before = await textOf(page);
  // From a side, a little above, towards the middle of the 9 x 9 tiles.
  const shotFrom = async (heading) => {
    const angle = (heading * Math.PI) / 180;
    await lookAt(page, {
      x: 4.5 - 4 * Math.cos(angle),
      y: 4.5 - 4 * Math.sin(angle),
      z: 1.8,
      heading,
      look: -0.3,
    });
    await frames(page);
    return (await page.locator('#picture').screenshot()).toString('base64');
  };
  const differing = (one, other) =>
    told(
      page,
      async (pictures) => {
        const [a, b] = await Promise.all(
          pictures.map(async (base64) => {
            const answer = await fetch(`data:image/png;base64,${base64}`);
            const bitmap = await createImageBitmap(await answer.blob());
            const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
            const drawing = canvas.getContext('2d');
            drawing.drawImage(bitmap, 0, 0);
            return drawing.getImageData(0, 0, bitmap.width, bitmap.height).data;
          }),
        );
        let differ = 0;
        for (let at = 0; at < a.length; at += 4)
          if ([0, 1, 2].some((part) => Math.abs(a[at + part] - b[at + part]) > 8)) differ += 1;
        return differ / (a.length / 4);
      },
      [one, other],
    );
  await page.addStyleTag({ content: '#stage > :is(div, p) { visibility: hidden; }' });
  // Nothing but the world: marks come back with each report of the engine.
  await told(page, () => {
    const { caster } = window.slicecastEditor;
    caster.mark([]);
    caster.mark = () => {};
  });
  const sides = [];
  for (const heading of [0, 90, 180, 270]) sides.push(await shotFrom(heading));
  assert.ok((await differing(sides[0], sides[1])) > 0.05, 'the sides differ');
  const tile = await openPlan(page);
  await page.keyboard.press('KeyM');
  await drag(page, tile(3.5, 3.5), tile(5.5, 5.5));
  await page.click('[data-view=picture]');
  await page.keyboard.press('KeyU');
  await noFaults(page);
  for (const [index, heading] of [90, 180, 270, 0].entries()) {
    const share = await differing(sides[index], await shotFrom(heading));
    assert.ok(share < 0.01, `from ${heading}: ${share}`);
  }
  for (let times = 0; times < 3; ++times) await page.keyboard.press('KeyU');
  await settle(page);
  assert.deepEqual(
    JSON.parse(await textOf(page)).maps,
    JSON.parse(before).maps,
    'four turns are none',
  );
});

test('floor tiles are painted in the picture and in the plan, ceilings too', async (t) => {
  const { page } = await openEditor(t, browser);
  await setScene(page, kYard);
  await lookAt(page, { x: 4.5, y: 8.9, z: 2, heading: 270, look: -0.8 });
  await page.keyboard.press('KeyP');
  await page.click('#palette [data-key=red]');
  await drag(page, await pointOf(page, 3.5, 6.5, 0), await pointOf(page, 5.5, 6.5, 0));
  const floor = () => told(page, () => window.slicecastEditor.scene.value.maps[0].floor);
  assert.deepEqual((await floor()).tiles[6], '...rrr...');
  await noFaults(page);
  const tile = await openPlan(page);
  await page.click('#palette [data-key=gold]');
  await drag(page, tile(0.5, 0.5), tile(2.5, 0.5));
  assert.deepEqual((await floor()).tiles[0], 'ggg......');
  // Shown in the plan: the pixel is golden.
  await page.mouse.move(5, 5);
  await frames(page);
  const [red, green, blue] = await told(
    page,
    ([x, y]) => {
      const canvas = document.getElementById('plan');
      const box = canvas.getBoundingClientRect();
      return [...canvas.getContext('2d').getImageData(x - box.left, y - box.top, 1, 1).data];
    },
    tile(1.5, 0.5),
  );
  assert.deepEqual([red, green, blue], [0xd0, 0xa0, 0x30]);
  await page.keyboard.press('KeyO');
  await page.keyboard.press('KeyO');
  await page.mouse.click(...tile(4.5, 1.5));
  const ceiling = await told(page, () => window.slicecastEditor.scene.value.maps[0].ceiling);
  assert.deepEqual([ceiling.texture, ceiling.tiles[1]], ['gold', '    .    ']);
  await noFaults(page);
});

test('a line is drawn in the picture, its end lifted by the wheel', async (t) => {
  const { page } = await openEditor(t, browser);
  await setScene(page, kYard);
  await lookAt(page, { x: 4.5, y: 8.9, z: 2, heading: 270, look: -0.8 });
  await page.keyboard.press('KeyL');
  await page.keyboard.press('2');
  await drag(page, await pointOf(page, 3.5, 6.5, 0), await pointOf(page, 5.5, 6.5, 0), {
    during: () => page.mouse.wheel(0, -100),
  });
  assert.equal((await rowsOf(page, 0))[6], '...p.....');
  assert.equal((await rowsOf(page, 1))[6], '....pp...');
});

test('maps grow, get levels, are renamed, added and removed', async (t) => {
  const { page } = await openEditor(t, browser);
  await setScene(page, kYard);
  const before = await textOf(page);
  const maps = () => told(page, () => window.slicecastEditor.scene.value.maps);
  await page.click('#tab-map');
  await page.click('#map-tools button:text-is("Size")');
  await page.fill('dialog.small label:has-text("Width") + input', '7');
  await page.fill('dialog.small label:has-text("Depth") + input', '11');
  await page.check('dialog.small [value=south-east]');
  assert.equal(await page.textContent('dialog.small [role=status]'), 'Nothing is lost.');
  await page.fill('dialog.small label:has-text("Width") + input', '4');
  assert.equal(await page.textContent('dialog.small [role=status]'), 'This removes 6 blocks.');
  await page.click('dialog.small button:text-is("Change")');
  await settle(page);
  let [yard] = await maps();
  assert.deepEqual(yard.levels[0].slice(0, 2), ['....', '....']);
  assert.equal(yard.levels[0][5], 'p...');
  assert.deepEqual(await told(page, () => window.slicecastEditor.scene.value.start), {
    x: 0.5,
    y: 3.5,
  });
  await page.keyboard.press('Escape');
  await page.click('#undo');
  assert.equal(await textOf(page), before);

  await page.click('#map-tools button:text-is("Insert level 0")');
  [yard] = await maps();
  assert.deepEqual(yard.levels, [[], kYard.maps[0].levels[0]]);
  await page.click('#map-tools button:text-is("Take out level 0")');
  assert.deepEqual((await maps())[0].levels, kYard.maps[0].levels);

  await page.fill('#part-map [data-path="maps,0,name"]', 'court');
  await page.press('#part-map [data-path="maps,0,name"]', 'Tab');
  assert.equal(await page.textContent('#map option'), 'court');
  await page.click('#map-tools button:text-is("New map")');
  await page.fill('dialog.small label:text-is("Name") + input', 'den');
  await page.fill('dialog.small label:has-text("Width") + input', '6');
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => window.slicecastEditor.caster.currentView.map === 'den');
  await noFaults(page);
  assert.equal((await rowsOf(page, 0))[0], '......');
  await page.click('#map-tools button:text-is("Remove")');
  assert.match(await page.textContent('dialog.small'), /The map is empty/);
  await page.click('dialog.small button:text-is("Remove")');
  await page.waitForFunction(() => window.slicecastEditor.caster.currentView.map === 'court');
  assert.equal((await maps()).length, 1);
  assert.equal(await page.isDisabled('#map-tools button:text-is("Remove")'), true);
  await noFaults(page);
});

for (const [name, viewport] of Object.entries({
  'a small desk': { width: 1366, height: 768 },
  'a tablet': { width: 820, height: 1180 },
  'a phone': { width: 360, height: 740 },
})) {
  test(`on ${name} the bar fits beside what else is there, and axe finds nothing`, async (t) => {
    const { page } = await openEditor(t, browser, '?template=house', { viewport });
    await page.keyboard.press('Control+a');
    await page.addScriptTag({ path: kAxe });
    for (const view of ['picture', 'plan']) {
      await page.click(`[data-view=${view}]`);
      const [bar, levels] = await told(page, () =>
        ['#select-bar', '[data-of=plan] .view-bar'].map((selector) => {
          const { left, right, top, bottom } = document
            .querySelector(selector)
            .getBoundingClientRect();
          return { left, right, top, bottom };
        }),
      );
      assert.ok(bar.right <= viewport.width && bar.bottom - bar.top < 64, JSON.stringify(bar));
      const isApart = bar.right <= levels.left || bar.bottom <= levels.top || levels.right === 0;
      assert.ok(isApart, `${view}: ${JSON.stringify([bar, levels])}`);
      const found = await told(page, async () =>
        (await window.axe.run(document, { resultTypes: ['violations'] })).violations.map(
          ({ id, nodes }) => [id, nodes[0].html],
        ),
      );
      assert.deepEqual(found, [], view);
    }
    await page.click('#tab-map');
    await page.click('#map-tools button:text-is("Size")');
    const inDialog = await told(page, async () =>
      (await window.axe.run('dialog.small', { resultTypes: ['violations'] })).violations.map(
        ({ id, nodes }) => [id, nodes[0].html],
      ),
    );
    assert.deepEqual(inDialog, []);
  });
}
