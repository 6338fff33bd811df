// Figures in a real page: they are dragged, typed at, scrubbed, painted and reset; their numbers
// are those of the element's trace, and their state is in the address.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { drawStatic } from '../../web/learn/figures/draw.js';
import * as kit from '../../web/learn/figures/kit.js';
import { nodeSource } from '../../web/learn/figures/source.js';
import { frames, launch, openPage } from './browser.mjs';
import { png } from './png.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const kLearn = new URL('../../web/learn/', import.meta.url);
const kShipped = new URL('../../assets/scenes/here/', import.meta.url); // ../../textures from here
const kPolicy =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' data: blob:";
const kPhone = { isMobile: true, hasTouch: true, deviceScaleFactor: 2 };

// The figures of the test page. The text of the function goes into the page.
function figures({
  button,
  choice,
  codeView,
  divider,
  mapView,
  numberTable,
  picture,
  plot,
  rulers,
  scrub,
  sideView,
  slider,
  sliceStrip,
  textureView,
  toggle,
  why,
}) {
  const view = '1.6,6.7,0.5,345';
  const scene = 'yard-1.json';
  return {
    walk: {
      scene,
      view,
      state: { column: 300 },
      controls: [
        slider({ label: 'Turn', eye: 'heading', from: -180, to: 180, unit: '°' }),
        scrub(),
      ],
      rows: [
        [
          picture({ title: 'The picture', handles: ['column', 'turn'] }),
          mapView({ title: 'The map' }),
        ],
        [
          rulers(),
          codeView({
            title: 'Code',
            code: 'start\nx\ny\nside',
            lines: { start: 1, x: 2, y: 3, side: 4 },
          }),
        ],
        [sideView({ title: 'The side' }), sliceStrip({ title: 'The rows' })],
        [numberTable({ title: 'Numbers' })],
      ],
      numbers: { depth: (now) => now.slice.hits[0].depth },
      says: (now) =>
        `Depth ${now.strong(now.fixed(now.slice.hits[0].depth, 4))}, heading ${now.scrubbed('eye.heading', now.degrees(now.eye.heading))}.`,
    },
    paint: {
      scene,
      view,
      state: { column: 240, at: 2, old: 'Fish eye' },
      controls: [
        toggle({ label: 'Light', option: 'light' }),
        choice({ label: 'Old way', field: 'old', oldWays: ['Fish eye', 'Big pixels'] }),
        slider({
          label: 'Field of view',
          option: 'fov',
          from: 30,
          to: 120,
          opening: 60,
          unit: '°',
        }),
        button({ label: 'North', change: () => ({ eye: { heading: 270 } }) }),
      ],
      rows: [
        [
          divider({ title: 'Two ways', right: { oldWay: ({ old }) => old } }),
          mapView({ title: 'Paint', paint: true, handles: ['eye'] }),
        ],
        [
          textureView({ title: 'Texture' }),
          why({ title: 'Why?' }),
          plot({
            title: 'Plot',
            x: { label: 'depth', from: 0, to: 10, field: 'at' },
            y: { label: 'light', from: 0, to: 1 },
            lines: [{ label: 'light', of: (x) => 1 / (1 + x) }],
          }),
        ],
      ],
      says: (now) => `The ray meets ${now.slice.hits.map(({ tile }) => tile.join(',')).join(' ')}.`,
    },
    blind: {
      scene,
      view,
      state: {},
      rows: [[rulers({ title: 'Only rulers' })]],
      says: (now) => `${now.slice.walk.length} tiles`,
    },
  };
}
const ours = figures(kit);

// What the build would put into the page, and the modules of the kit as they are.
const built = {};
const files = {};
const posters = {};
let browser;
before(async () => {
  browser = await launch();
  const read = (folder) => {
    for (const entry of readdirSync(new URL(folder, kLearn), { withFileTypes: true })) {
      if (entry.isDirectory()) read(`${folder}${entry.name}/`);
      else if (/\.(js|css|json)$/.test(entry.name))
        files[`learn/${folder}${entry.name}`] = readFileSync(new URL(folder + entry.name, kLearn));
    }
  };
  read('figures/');
  read('scenes/');
  files['learn/page.css'] =
    '* { box-sizing: border-box } body { margin: 0 16px; background: var(--paper); color: var(--ink); font: 16px sans-serif } .space { height: 700px }';
  files['learn/page.js'] = `import * as kit from './figures/kit.js';
    import { mount } from './figures/mount.js';
    window.live = {}; window.told = {};
    const all = (${figures})(kit);
    for (const node of document.querySelectorAll('[data-figure]')) {
      const name = node.dataset.figure;
      window.live[name] = mount(node, all[name], { name, scenes: new URL('scenes/', location.href), onNow: (now, numbers) => { window.told[name] = numbers; } });
    }`;
  for (const [name, figure] of Object.entries(ours)) {
    const scene = JSON.parse(readFileSync(new URL(`scenes/${figure.scene}`, kLearn), 'utf8'));
    const running = await load(scene, { base: kShipped });
    const source = nodeSource(running, { scene, size: figure.size });
    built[name] = drawStatic(figure, source, {
      name,
      wide: true,
      poster: (part) => `../${part}.png`,
    });
    running.free();
    for (const { name: part } of built[name].posters)
      posters[`${part}.png`] = png(480, () => [90, 120, 90], 300);
  }
});
after(() => browser.close());

async function open(
  t,
  names,
  { isBuilt = true, query = '', width = 1280, height = 900, context = {}, ...more } = {},
) {
  const bodies = names.map(
    (name) =>
      `<figure id="${name}" data-figure="${name}">${isBuilt ? built[name].html : ''}<figcaption>About ${name}</figcaption></figure>`,
  );
  const html = `<!doctype html><html lang="en"><meta charset="utf-8"><title>Figures</title><meta name="viewport" content="width=device-width"><link rel="icon" href="../favicon.svg"><link rel="stylesheet" href="figures/figures.css"><link rel="stylesheet" href="page.css"><script type="module" src="../ray-caster.js"></script><script type="module" src="page.js"></script><body><main><h1>Figures</h1>${bodies.join('')}<div class="space"></div></main></body></html>`;
  const { page, complaints } = await openPage(t, browser, {
    query: `learn/host.html${query}`,
    viewport: { width, height },
    context,
    server: {
      files: { ...files, 'learn/host.html': html, ...posters },
      headers: { 'Content-Security-Policy': kPolicy },
    },
    ...more,
  });
  if (context.javaScriptEnabled === false) return { page };
  for (const name of names) {
    await page.locator(`#${name}`).scrollIntoViewIfNeeded();
    await page.waitForSelector(`#${name} .fig.live`);
  }
  await page.evaluate(() => window.scrollTo(0, 0));
  await frames(page);
  return { page, complaints };
}

const stateOf = (page, name) => page.evaluate((which) => window.live[which].state, name);
const handle = (page, name, id) => page.locator(`#${name} [data-handle="${id}"]`);

// What the figure says, and the same from the element's own trace.
async function agree(page) {
  await frames(page);
  const told = await page.evaluate(() => {
    const caster = document.querySelector('#walk ray-caster');
    const { state } = window.live.walk;
    const slice = caster.trace(state.column);
    return {
      says: document.querySelector('#walk .fig-says').textContent,
      depth: slice.hits[0].depth,
      number: window.told.walk.depth,
      heading: caster.currentView.heading,
      cells: [...document.querySelectorAll('#walk .fig-table td:last-child')].map(
        (cell) => cell.textContent,
      ),
      depths: slice.walk.slice(1).map(({ depth }) => depth),
      steps: [state.step, slice.walk.length, slice.runs.length],
    };
  });
  assert.equal(
    told.says,
    `Depth ${kit.fixed(told.depth, 4)}, heading ${kit.degrees(told.heading)}.`,
  );
  assert.equal(told.number, kit.fixed(told.depth));
  const [step, tiles] = told.steps;
  const shown = step === null ? tiles : Math.min(step + 1, tiles);
  assert.deepEqual(
    told.cells.map((cell) => cell.replace('= ', '')),
    told.depths.slice(0, shown - 1).map((depth) => kit.fixed(depth, 6)),
  );
  return told;
}

async function middleOf(locator) {
  await locator.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await locator.boundingBox();
  return [x + width / 2, y + height / 2];
}

async function drag(page, locator, dx, dy) {
  const [x, y] = await middleOf(locator);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + dx / 2, y + dy / 2, { steps: 3 });
  await page.mouse.move(x + dx, y + dy, { steps: 3 });
  await page.mouse.up();
}

test('what the build has drawn is what the page draws', async (t) => {
  const { page } = await open(t, ['walk']);
  await agree(page);
  const live = await page.evaluate(() => window.told.walk);
  assert.deepEqual(live, built.walk.numbers);
  const says = await page.evaluate(() => document.querySelector('#walk .fig-says').innerHTML);
  assert.equal(says.replace(/<[^>]*>/g, ''), built.walk.says.replace(/<[^>]*>/g, ''));
  assert.equal(await page.locator('#walk ray-caster').count(), 1);
  // Without what the build has drawn the same appears.
  const { page: bare } = await open(t, ['walk'], { isBuilt: false });
  const textOf = (on) => on.evaluate(() => document.querySelector('#walk .fig').innerText);
  assert.equal(await textOf(bare), await textOf(page));
});

test('the mouse drags handles, and all views follow', async (t) => {
  const { page } = await open(t, ['walk']);
  const before = await agree(page);
  const unit = await page.evaluate(() => {
    const { width } = document
      .querySelector('#walk [data-panel="0.1"] svg')
      .getBoundingClientRect();
    return (width - 20) / 16;
  });
  await drag(page, handle(page, 'walk', 'eye'), 2 * unit, -unit);
  const { eye } = await stateOf(page, 'walk');
  assert.ok(Math.abs(eye.x - 3.6) < 0.05 && Math.abs(eye.y - 5.7) < 0.05, JSON.stringify(eye));
  const moved = await agree(page);
  assert.notEqual(moved.depth, before.depth);
  await drag(page, handle(page, 'walk', 'heading'), 0, 30);
  const turned = await agree(page);
  assert.notEqual(turned.heading, before.heading);
  await drag(page, handle(page, 'walk', 'column'), -100, 0);
  assert.ok(Math.abs((await stateOf(page, 'walk')).column - 200) <= 1);
  await agree(page);
  await drag(page, handle(page, 'walk', 'height'), 0, -40);
  assert.ok((await stateOf(page, 'walk')).eye.z > 0.55);
  await agree(page);
  // A press on the picture chooses the slice, and one on the rows a row.
  const frame = page.locator('#walk .fig-frame');
  await frame.scrollIntoViewIfNeeded();
  const box = await frame.boundingBox();
  await page.mouse.click(box.x + box.width * 0.25 + 0.5, box.y + box.height / 3);
  assert.equal((await stateOf(page, 'walk')).column, 120);
  await agree(page);
  // A handle that is taken at its side does not jump.
  const { eye: still } = await stateOf(page, 'walk');
  const [sideX, sideY] = await middleOf(handle(page, 'walk', 'eye'));
  await page.mouse.move(sideX + 14, sideY - 10);
  await page.mouse.down();
  await page.mouse.move(sideX + 15, sideY - 10);
  await page.mouse.up();
  const { eye: nudged } = await stateOf(page, 'walk');
  assert.ok(Math.abs(nudged.x - still.x - 1 / unit) < 0.02, `${nudged.x} ${still.x}`);
  assert.ok(Math.abs(nudged.y - still.y) < 0.02, `${nudged.y} ${still.y}`);
  // Escape takes a drag back.
  const [x, y] = await middleOf(handle(page, 'walk', 'eye'));
  const kept = await stateOf(page, 'walk');
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 60, y, { steps: 4 });
  assert.notDeepEqual(await stateOf(page, 'walk'), kept);
  await page.keyboard.press('Escape');
  await page.mouse.move(x + 90, y);
  await page.mouse.up();
  assert.deepEqual(await stateOf(page, 'walk'), kept);
});

test('keys move handles, tell where they are, and undo', async (t) => {
  const { page } = await open(t, ['walk']);
  const eye = handle(page, 'walk', 'eye');
  await eye.focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Shift+ArrowUp');
  await agree(page);
  let state = await stateOf(page, 'walk');
  assert.deepEqual(
    [state.eye.x, state.eye.y].map((n) => Number(n.toFixed(2))),
    [1.65, 6.2],
  );
  assert.equal(await eye.getAttribute('aria-valuetext'), 'x 1.65, y 6.20');
  assert.equal(await eye.getAttribute('role'), 'slider');
  await page.keyboard.press('Escape');
  state = await stateOf(page, 'walk');
  assert.deepEqual(
    [state.eye.x, state.eye.y].map((n) => Number(n.toFixed(2))),
    [1.6, 6.7],
  );
  const heading = handle(page, 'walk', 'heading');
  await heading.focus();
  await page.keyboard.press('PageUp');
  await frames(page);
  assert.equal(await heading.getAttribute('aria-valuetext'), '355 degrees, east');
  // A number in the text.
  await page.locator('#walk .fig-scrubbed').focus();
  await page.keyboard.press('Shift+ArrowRight');
  await frames(page);
  assert.equal((await stateOf(page, 'walk')).eye.heading, 5);
  const focused = await page.evaluate(() => document.activeElement.className);
  assert.equal(focused, 'fig-scrubbed');
  await drag(page, page.locator('#walk .fig-scrubbed'), 30, 0);
  assert.equal((await stateOf(page, 'walk')).eye.heading, 15);
  await agree(page);
  const turn = page.locator('#walk input[type=range]').first();
  await turn.focus();
  await page.keyboard.press('ArrowLeft');
  assert.equal((await stateOf(page, 'walk')).eye.heading, 14);
});

test('the walk is scrubbed forwards and back, with the line of code', async (t) => {
  const { page } = await open(t, ['walk']);
  const { steps } = await agree(page);
  const [, tiles, runs] = steps;
  const scrub = page.locator('#walk .fig-scrub');
  const range = scrub.locator('input');
  const shown = () =>
    page.evaluate(() => ({
      lit: document.querySelectorAll('#walk [data-panel="0.1"] .fig-lit').length,
      runs: document.querySelectorAll('#walk [data-panel="2.1"] .fig-run:not(.newest)').length,
      line: document.querySelector('#walk .fig-line.now')?.textContent ?? null,
      says: document.querySelector('#walk .fig-scrub output').textContent,
    }));
  assert.deepEqual(await shown(), {
    lit: tiles,
    runs,
    line: null,
    says: `all ${tiles + runs} steps`,
  });
  await range.focus();
  await page.keyboard.press('Home');
  await agree(page);
  const first = await shown();
  assert.deepEqual([first.lit, first.runs, first.line], [1, 0, '1start']);
  await scrub.getByRole('button', { name: /one step on/ }).click();
  await agree(page);
  const second = await shown();
  assert.deepEqual([second.lit, second.runs, second.line], [2, 0, '2x']);
  assert.match(second.says, /^2 of \d+: x = 2 at depth 0\.\d\d$/);
  for (let i = 0; i < tiles; ++i) await page.keyboard.press('Enter');
  await agree(page);
  assert.deepEqual([(await shown()).lit, (await shown()).runs], [tiles, 2]);
  await scrub.getByRole('button', { name: /one step back/ }).click();
  await frames(page);
  assert.equal((await shown()).runs, 1);
});

test('touch drags handles, and scrolls the page from anywhere else', async (t) => {
  const { page } = await open(t, ['walk'], { width: 360, height: 740, context: kPhone });
  const client = await page.context().newCDPSession(page);
  const swipe = async ([x, y], dx, dy) => {
    await client.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
    for (let i = 1; i <= 10; ++i)
      await client.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: [{ x: x + (dx * i) / 10, y: y + (dy * i) / 10 }],
      });
    await client.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await frames(page, 6);
  };
  const scrolled = () => page.evaluate(() => window.scrollY);
  const eye = await middleOf(handle(page, 'walk', 'eye'));
  const at = await scrolled();
  await swipe(eye, 40, -50);
  const { eye: moved } = await stateOf(page, 'walk');
  assert.ok(moved.x > 2.5 && moved.y < 6, JSON.stringify(moved));
  assert.equal(await scrolled(), at);
  await agree(page);
  const kept = await stateOf(page, 'walk');
  for (const part of [
    '.fig-frame',
    '[data-panel="0.1"] svg',
    '[data-panel="2.1"] svg',
    '.fig-scroll',
  ]) {
    const locator = page.locator(`#walk ${part}`).first();
    await page.evaluate(() => window.scrollTo(0, 0));
    const top = await locator.evaluate((node) => node.getBoundingClientRect().top);
    await page.evaluate((to) => window.scrollTo(0, to), top - 250);
    await frames(page);
    const from = await scrolled();
    const { x, y, width, height } = await locator.boundingBox();
    // Beside the handles.
    await swipe([x + width * 0.72, y + height * 0.4], 0, -160);
    assert.ok((await scrolled()) > from + 50, `${part}: ${from} ${await scrolled()}`);
    assert.deepEqual(await stateOf(page, 'walk'), kept, part);
  }
  // A tap chooses.
  const frame = page.locator('#walk .fig-frame');
  await frame.scrollIntoViewIfNeeded();
  const box = await frame.boundingBox();
  await page.touchscreen.tap(box.x + box.width / 2 + 40, box.y + box.height * 0.4);
  assert.notEqual((await stateOf(page, 'walk')).column, kept.column);
  await agree(page);
});

test('on a phone everything is large enough, and nothing is cut off', async (t) => {
  const { page } = await open(t, ['walk', 'paint'], { width: 360, height: 740, context: kPhone });
  const told = await page.evaluate(() => {
    const small = [...document.querySelectorAll('.fig-handle, .fig button, .fig input[type=range]')]
      .filter((node) => node.getBoundingClientRect().width > 0)
      .filter((node) => node.getBoundingClientRect().height < 44)
      .map((node) => node.outerHTML.slice(0, 80));
    const texts = [...document.querySelectorAll('.fig-svg text')].filter((node) => {
      const scale =
        node.ownerSVGElement.getBoundingClientRect().width /
        node.ownerSVGElement.viewBox.baseVal.width;
      return parseFloat(getComputedStyle(node).fontSize) * scale < 13;
    });
    const overlaps = [];
    const panels = [
      ...document.querySelectorAll('.fig-panel, .fig-controls, .fig-says, .fig-tools'),
    ].map((node) => [node.className, node.getBoundingClientRect()]);
    for (const [a, x] of panels)
      for (const [b, y] of panels)
        if (
          x !== y &&
          x.left < y.right - 1 &&
          y.left < x.right - 1 &&
          x.top < y.bottom - 1 &&
          y.top < x.bottom - 1
        )
          overlaps.push(`${a} ${b}`);
    const cut = [...document.querySelectorAll('.fig-svg text')]
      .filter((node) => {
        const inner = node.getBoundingClientRect();
        const outer = node.ownerSVGElement.getBoundingClientRect();
        return inner.left < outer.left - 2 || inner.right > outer.right + 2;
      })
      .map((node) => node.textContent);
    return {
      small,
      texts: texts.length,
      overlaps,
      cut,
      wide: document.documentElement.scrollWidth,
    };
  });
  assert.deepEqual(told, { small: [], texts: 0, overlaps: [], cut: [], wide: 360 });
});

test('cells are painted by pointer and by typing; reset takes all back', async (t) => {
  const { page } = await open(t, ['paint']);
  const cells = () =>
    page.evaluate(() => document.querySelector('#paint ray-caster').cells('yard', 0));
  const opening = await cells();
  const says = () => page.evaluate(() => document.querySelector('#paint .fig-says').textContent);
  const before = await says();
  const map = page.locator('#paint [data-panel="0.1"] .fig-svg');
  await map.scrollIntoViewIfNeeded();
  const { x, y, width } = await map.boundingBox();
  const unit = (width - 20) / 16;
  const place = (cellX, cellY) => [x + 10 + unit * (cellX + 0.5), y + 10 + unit * (cellY + 0.5)];
  await page.getByRole('button', { name: /pillar/ }).click();
  await frames(page);
  assert.equal(
    await page.getByRole('button', { name: /pillar/ }).getAttribute('aria-pressed'),
    'true',
  );
  // A stroke.
  await page.mouse.move(...place(3, 5));
  await page.mouse.down();
  await page.mouse.move(...place(3, 6), { steps: 4 });
  await page.mouse.up();
  await frames(page);
  let now = await cells();
  assert.deepEqual([now[5][3], now[6][3]], ['o', 'o']);
  assert.notEqual(await says(), before);
  assert.match(await says(), /meets 3,6/);
  // Both pictures show it.
  const other = await page.evaluate(() =>
    [...document.querySelectorAll('#paint ray-caster')].map((each) => each.cells('yard', 0)[6][3]),
  );
  assert.deepEqual(other, ['o', 'o']);
  // On the same block it erases.
  await page.mouse.click(...place(3, 6));
  assert.equal((await cells())[6][3], '.');
  // By keys.
  const cursor = handle(page, 'paint', 'cell');
  await cursor.focus();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('#');
  await frames(page);
  now = await cells();
  assert.equal(now[6][4], '#');
  assert.equal(await cursor.getAttribute('aria-valuetext'), '4, 6: wall');
  await page.keyboard.press('Backspace');
  assert.equal((await cells())[6][4], '.');
  await page.keyboard.press('Enter');
  assert.equal((await cells())[6][4], 'o');
  await page.getByRole('button', { name: 'Reset' }).click();
  await frames(page);
  assert.deepEqual(await cells(), opening);
  assert.equal(await says(), before);
});

test('the state is in the address, and comes back from it', async (t) => {
  const { page } = await open(t, ['walk', 'paint'], { query: '?other=1#walk' });
  await handle(page, 'walk', 'heading').focus();
  await page.keyboard.press('Shift+ArrowRight');
  await page.locator('#walk .fig-scrub button').first().click();
  await page.locator('#paint .fig-toggle input').click();
  await page.getByRole('radio', { name: 'Big pixels' }).check();
  await handle(page, 'paint', 'split').focus();
  await page.keyboard.press('ArrowRight');
  await handle(page, 'paint', 'x-at').focus();
  await page.keyboard.press('ArrowRight');
  await handle(page, 'paint', 'cell').focus();
  await page.keyboard.press('o');
  await page.getByRole('button', { name: 'North' }).click();
  const states = async () => [await stateOf(page, 'walk'), await stateOf(page, 'paint')];
  const before = (await states()).map((state) => ({ ...state, cell: undefined }));
  assert.deepEqual(before[1].edits, [['yard', 0, 8, 4, 'o']]);
  assert.deepEqual(
    [before[1].light, before[1].old, before[1].split, before[1].at],
    ['off', 'Big pixels', 0.51, 2.05],
  );
  await page.waitForFunction(
    () =>
      /walk=.*eye:.*&paint=|paint=.*&walk=/.test(location.search) &&
      /edits:/.test(location.search) &&
      /eye:[^&]*270/.test(location.search),
  );
  const address = page.url();
  assert.match(address, /\?other=1&/);
  assert.match(address, /#walk$/);
  await page.goto('about:blank');
  await page.goto(address);
  for (const name of ['walk', 'paint']) {
    await page.locator(`#${name}`).scrollIntoViewIfNeeded();
    await page.waitForSelector(`#${name} .fig.live`);
  }
  const again = await states();
  before.forEach((state, index) => {
    for (const [field, value] of Object.entries(state)) {
      if (field === 'eye')
        for (const [part, number] of Object.entries(value))
          assert.ok(
            number === again[index].eye[part] || Math.abs(number - again[index].eye[part]) < 1e-4,
            part,
          );
      else if (!['brush', 'cell'].includes(field))
        assert.deepEqual(again[index][field], value, field);
    }
  });
  await agree(page);
  const told = await page.evaluate(() => {
    const [left, right] = document.querySelectorAll('#paint ray-caster');
    return [
      left.get('light'),
      right.get('light'),
      left.get('method'),
      right.get('method'),
      right.get('classic.pixelSize'),
      left.cells('yard', 0)[4][8],
    ];
  });
  assert.deepEqual(told, ['off', 'off', 'exact', 'classic', '8', 'o']);
  // Reset clears the figure's own part of the address.
  for (const name of ['walk', 'paint']) await page.locator(`#${name} [data-tool=reset]`).click();
  await page.waitForFunction(() => location.search === '?other=1');
  await page.locator('#walk [data-tool=link]').click();
  await page.waitForFunction(() =>
    /Copied|address/.test(document.querySelector('#walk [data-tool=link]').textContent),
  );
});

test('the divider shows two ways of drawing the same view', async (t) => {
  const { page } = await open(t, ['paint']);
  const pictures = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('#paint ray-caster')].map((caster) => ({
        view: caster.currentView,
        sum: caster
          .pixels()
          .data.reduce((sum, part, index) => (sum + part * (index % 1009)) % 1e9, 0),
        clip: getComputedStyle(caster).clipPath,
      })),
    );
  const [left, right] = await pictures();
  assert.deepEqual(left.view, right.view);
  assert.notEqual(left.sum, right.sum);
  assert.deepEqual([left.clip, right.clip], ['none', 'inset(0px 0px 0px 50%)']);
  const { width } = await page.locator('#paint .fig-frame').boundingBox();
  await drag(page, handle(page, 'paint', 'split'), width / 4, 0);
  await page.getByRole('radio', { name: 'Big pixels' }).check();
  await page.getByRole('button', { name: 'North' }).click();
  await frames(page);
  const [left2, right2] = await pictures();
  assert.match(right2.clip, /^inset\(0px 0px 0px (74|75)\.?\d*%\)$/);
  assert.deepEqual([left2.view.heading, left2.view], [270, right2.view]);
  assert.notEqual(right2.sum, right.sum);
  const labels = await page.evaluate(() =>
    [...document.querySelectorAll('#paint .fig-label')].map((label) => label.textContent),
  );
  assert.deepEqual(labels, ['exact', 'Big pixels']);
});

test('a figure without a picture has its numbers from an element out of sight', async (t) => {
  const { page } = await open(t, ['blind']);
  assert.equal(
    await page.evaluate(() => document.querySelector('#blind .fig-says').textContent),
    built.blind.says,
  );
  assert.equal(await page.evaluate(() => document.querySelector('#blind ray-caster').inert), true);
});

test('the wheel scrolls the page over every part, and nothing plays by itself', async (t) => {
  const { page } = await open(t, ['walk', 'paint']);
  const states = async () =>
    JSON.stringify([await stateOf(page, 'walk'), await stateOf(page, 'paint')]);
  const before = await states();
  const parts = await page.evaluate(
    () => document.querySelectorAll('.fig-panel, .fig-controls').length,
  );
  for (let part = 0; part < parts; ++part) {
    const node = page.locator('.fig-panel, .fig-controls').nth(part);
    const top = await node.evaluate((each) => each.getBoundingClientRect().top + window.scrollY);
    await page.evaluate((to) => window.scrollTo(0, to), top - 300);
    const { x, y, width, height } = await node.boundingBox();
    await page.mouse.move(x + width / 2, y + Math.min(height / 2, 200));
    const from = await page.evaluate(() => window.scrollY);
    await page.mouse.wheel(0, 120);
    await page.waitForFunction((at) => window.scrollY !== at, from);
  }
  await page.waitForTimeout(400);
  assert.equal(await states(), before);
  const steps = await page.evaluate(() =>
    [...document.querySelectorAll('ray-caster')].map((caster) => caster.player.steps),
  );
  assert.deepEqual(steps, [0, 0, 0]);
});

test('axe finds nothing, in light and dark, wide and narrow', async (t) => {
  for (const [colorScheme, width] of [
    ['light', 1280],
    ['dark', 360],
  ]) {
    const { page } = await open(t, ['walk', 'paint', 'blind'], { width, context: { colorScheme } });
    await page.evaluate(readFileSync(kAxe, 'utf8'));
    const complaints = await page.evaluate(async () => {
      const { violations } = await window.axe.run(document);
      return violations.flatMap(({ id, nodes }) =>
        nodes.map(
          ({ target, failureSummary }) => `${id}: ${target.flat().join(' > ')}: ${failureSummary}`,
        ),
      );
    });
    assert.deepEqual(complaints, [], `${colorScheme} ${width}`);
  }
});

test('without scripts there are pictures, drawings and numbers, and nothing to press', async (t) => {
  const { page } = await open(t, ['walk', 'paint'], {
    context: { javaScriptEnabled: false },
    expectErrors: true,
  });
  const image = await page.locator('#walk .fig-frame img').evaluate((node) => {
    const { width, height } = node.getBoundingClientRect();
    return [node.complete && node.naturalWidth, Math.round((100 * width) / height)];
  });
  assert.deepEqual(image, [480, 160]);
  const text = await page.locator('#walk .fig-says').textContent();
  assert.equal(text, built.walk.says.replace(/<[^>]*>/g, ''));
  const tall = (selector) =>
    page.locator(selector).evaluate((node) => node.getBoundingClientRect().height);
  assert.ok((await tall('#walk [data-panel="1.0"] svg')) > 100);
  for (const selector of ['#walk .fig-scrub', '#walk .fig-tools', '#paint .fig-palette'])
    assert.equal(await tall(selector), 0, selector);
});

test('a figure with a mistake says in its place what it is', async (t) => {
  const script = `
    import { mapView, mount, picture } from './learn/figures.js';
    const figure = { scene: 'first-steps.json', view: '5,5,0.5,250', rows: [[picture()]] };
    const scenes = new URL('scenes/', location.href);
    const change = {
      a: { scene: 'first-steps' },
      b: { rows: [picture()] },
      c: { rows: [[mapView({ handels: ['eye'] })]] },
      d: {},
    };
    for (const [name, its] of Object.entries(change))
      mount(document.getElementById(name), { ...figure, ...its }, { name, scenes }).ready.then(
        () => (document.getElementById(name).dataset.is = 'live'),
        () => (document.getElementById(name).dataset.is = 'told'));`;
  const { page } = await openPage(t, browser, {
    query: 'mistakes.html',
    viewport: { width: 700, height: 900 },
    expectErrors: true,
    server: {
      files: {
        'mistakes.html': `<!doctype html><html lang="en"><meta charset="utf-8"><title>Figures</title>
          <link rel="icon" href="favicon.svg"><link rel="stylesheet" href="learn/figures.css">
          <script type="module" src="ray-caster.js"></script>
          <script type="module" src="mistakes.js"></script>
          ${['a', 'b', 'c', 'd'].map((id) => `<figure id="${id}"></figure>`).join('')}`,
        'mistakes.js': script,
      },
    },
  });
  await page.waitForFunction(() => document.querySelectorAll('figure[data-is]').length === 4);
  const told = (id) =>
    page.evaluate((which) => {
      const [node, more] = document.querySelectorAll(`#${which} [role=alert]`);
      return more === undefined ? (node?.innerText ?? '') : 'twice';
    }, id);
  assert.match(
    await told('a'),
    /^scene: .*first-steps could not.*404. Did you mean 'first-steps.json'\?/,
  );
  assert.match(await told('b'), /rows\[0\]: found a view, expected a list of views/);
  assert.match(await told('c'), /Unknown option 'handels'. Did you mean 'handles'\?/);
  assert.equal(await told('d'), '');
});
