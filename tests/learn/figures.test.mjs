// The figure kit under Node: each view is drawn from real scenes, and the numbers in its markup are
// the engine's; the page's own arithmetic is compared with the trace.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';

import { load } from '../../build/web/node/index.js';
import { drawStatic, openingNow } from '../../web/learn/figures/draw.js';
import { checkFigure } from '../../web/learn/figures/check.js';
import * as kit from '../../web/learn/figures/kit.js';
import { apply, makeNow } from '../../web/learn/figures/now.js';
import { nodeSource } from '../../web/learn/figures/source.js';
import { changed, openingState, readState, writeState } from '../../web/learn/figures/state.js';

const kSize = [480, 300];
const kScenes = new URL('../../web/learn/scenes/', import.meta.url);
const kShipped = new URL('../../assets/scenes/here/', import.meta.url); // ../../textures from here
const kViews = {
  'yard-1': ['1.6,6.7,0.5,345,0', '7.5,4.5,0.5,330,0', '8,12,5,270,-0.6'],
  'yard-4': ['7.4,7.5,0.5,235,0.12', '9,10,3.2,245,-0.2'],
  'yard-5': ['8.8,3.8,0.5,310,0'],
  'yard-7': ['9.4,4.5,0.5,190,0.02'],
  yard: ['7.4,7.5,0.5,235,0.12', '13,3.5,0.5,0,0', '7.5,6.4,0.5,95,0', '2.6,4.6,0.5,260,0.05'],
};

async function open(t, name, size = kSize) {
  const scene = JSON.parse(await readFile(new URL(`${name}.json`, kScenes), 'utf8'));
  const running = await load(scene, { base: kShipped });
  t.after(() => running.free());
  return nodeSource(running, { scene, size });
}

function nowOf(source, view, { column = 240, ...state } = {}, figure = {}) {
  return openingNow(
    { rows: [], view, size: kSize, state: { column, ...state }, ...figure },
    source,
  );
}

function drawn(view, now, width = 560) {
  const size = { width, height: view.height(width, now), id: 'test' };
  return view.markup(now, size);
}

const plain = (markup) => markup.replace(/<[^>]*>/g, ' ');
const near = (a, b, most) => Math.abs(a - b) <= most * Math.max(1, Math.abs(a), Math.abs(b));

async function eachMoment(t, check) {
  let count = 0;
  for (const [name, views] of Object.entries(kViews)) {
    const source = await open(t, name);
    for (const view of views)
      for (const column of [0, 101, 240, 333, 479]) {
        check(nowOf(source, view, { column }), `${name} ${view} ${column}`);
        ++count;
      }
  }
  assert.equal(count, 55);
}

test('the page’s own quotients, rays and rows are the engine’s', async (t) => {
  let crossings = 0;
  let rows = 0;
  let portals = 0;
  await eachMoment(t, (now, where) => {
    const { slice, eyes } = now;
    portals = Math.max(portals, slice.walk.at(-1).portals);
    slice.walk.forEach(({ axis, distance, depth, tile }, index) => {
      if (axis === null) return;
      ++crossings;
      const own = kit.crossing(slice, index, eyes);
      assert.ok(near(own.quotient, depth, 1e-14), `${where} ${index}: ${own.quotient} ${depth}`);
      assert.ok(near(Math.abs(own.border - own.eye), distance, 1e-9), `${where} ${index}`);
      const along = axis === 'x' ? tile[0] : tile[1];
      assert.ok(own.border === along || own.border === along + 1, `${where} ${index}`);
    });
    const ray = kit.rayOf(now.eye, now.column, now.size, slice.fov);
    slice.ray.forEach((part, axis) => assert.ok(near(ray[axis], part, 1e-12), where));
    assert.ok(near(kit.distanceOf(slice.fov, now.width), slice.projectionDistance, 1e-12));
    for (const hit of slice.hits) {
      if (hit.topFrontRow === null || hit.portals > 0) continue;
      ++rows;
      assert.ok(near(kit.rowOf(hit.top, hit.depth, slice), hit.topFrontRow, 1e-9), where);
      assert.ok(near(kit.rowOf(hit.bottom, hit.depth, slice), hit.bottomFrontRow, 1e-9), where);
    }
  });
  assert.ok(crossings > 400 && rows > 60 && portals > 0, `${crossings} ${rows} ${portals}`);
});

test('a run’s sight lines end where the engine’s texels are', async (t) => {
  let compared = 0;
  await eachMoment(t, (now, where) => {
    const { slice } = now;
    const ceiling = now.map(now.eye.map).ceiling?.height ?? null;
    for (const run of slice.runs) {
      if (run.portals > 0 || run.texels.length === 0 || run.what === 'object') continue;
      for (const { row, depth } of run.texels) {
        const own = kit.placeOf(run, row + 0.5, slice, { ceiling });
        assert.ok(
          near(own.depth, depth, 1e-6),
          `${where} ${run.what} ${row}: ${own.depth} ${depth}`,
        );
        ++compared;
      }
    }
  });
  assert.ok(compared > 300, String(compared));
});

test('the map, the rulers and the table tell the depths of the walk', async (t) => {
  const source = await open(t, 'yard-1');
  const now = nowOf(source, kViews['yard-1'][0], { column: 300 });
  const depths = now.slice.walk.slice(1).map(({ depth }) => kit.fixed(depth));
  assert.ok(depths.length > 8);
  const map = drawn(kit.mapView(), now, 900);
  const rulers = drawn(kit.rulers(), now, 1000);
  // Where labels would touch each other some are left out; what is written is right.
  const written = (markup) => plain(markup).match(/\d+\.\d\d/g);
  for (const [markup, least] of [
    [map, 0.6],
    [rulers, 1],
  ]) {
    assert.deepEqual(
      written(markup).filter((depth) => !depths.includes(depth)),
      [],
    );
    assert.ok(written(markup).length >= least * depths.length, String(written(markup)));
    assert.ok(written(markup).includes(depths.at(-1)));
  }
  const marks = (markup, kind) => markup.split(`class="fig-mark ${kind}"`).length - 1;
  for (const [axis, kind] of [
    ['x', 'across'],
    ['y', 'along'],
  ]) {
    const count = now.slice.walk.filter((tile) => tile.axis === axis).length;
    assert.equal(marks(map, kind), count);
    assert.equal(marks(rulers, kind), count);
  }
  const table = kit.numberTable({ of: 'walk' }).markup(now);
  assert.equal(table.split('<tr').length - 2, depths.length);
  for (const { depth } of now.slice.walk.slice(1)) assert.ok(table.includes(kit.fixed(depth, 6)));
});

test('= stands beside numbers that agree in every bit, and only there', async (t) => {
  const source = await open(t, 'yard-1');
  const seen = new Set();
  for (let column = 0; column < 480; column += 40) {
    const now = nowOf(source, kViews['yard-1'][1], { column });
    const cells = kit.numberTable({ of: 'walk' }).markup(now).split('<tr').slice(2);
    cells.forEach((row, index) => {
      const { quotient, depth } = kit.crossing(now.slice, index + 1);
      assert.equal(row.includes('>= '), quotient === depth);
      seen.add(quotient === depth);
    });
  }
  assert.deepEqual([...seen].sort(), [false, true]);
});

test('the strip has the rows of the runs, in their order', async (t) => {
  await eachMoment(t, (now, where) => {
    const strip = drawn(kit.sliceStrip({ tall: 900 }), now);
    const text = plain(strip).split(/\s{2,}/);
    now.slice.runs.forEach(({ first, last }, index) => {
      const rows = first === last ? `${first}` : `${first}–${last}`;
      const at = text.findIndex(
        (part, place) => part === String(index + 1) && text.slice(place, place + 4).includes(rows),
      );
      assert.ok(at >= 0, `${where}: run ${index + 1}, ${rows} in ${text}`);
    });
  });
});

test('the side view has every block and every run', async (t) => {
  await eachMoment(t, (now, where) => {
    const side = drawn(kit.sideView(), now);
    assert.equal(side.split('class="fig-solid').length - 1, now.slice.hits.length, where);
    const wedges = side.split('class="fig-wedge').length - 1;
    const mirrored = side.split('class="fig-wedge mirrored').length - 1;
    assert.equal(wedges - mirrored, now.slice.runs.length, where);
    assert.ok(!/NaN|Infinity|undefined/.test(side), where);
  });
});

test('no view writes what is not a number', async (t) => {
  const views = [
    kit.mapView({ heights: true, levels: [0, 1] }),
    kit.mapView({ window: [2, 1, 6, 5], column: true }),
    kit.rulers({ step: 0.3 }),
    kit.sideView({ edges: true, handles: ['eye', 'look'] }),
    kit.sliceStrip({ names: false }),
    kit.textureView(),
    kit.plot({
      x: { label: 'x', from: 0, to: 9, field: 'column' },
      y: { label: 'y', from: 0, to: 1 },
      lines: [{ label: 'one', of: (x) => Math.sqrt(x - 1) / x }],
    }),
  ];
  const panels = ['walk', 'runs', 'hits'].map((of) => kit.numberTable({ of }));
  panels.push(kit.codeView({ code: 'a\nb', lines: { x: 1 } }));
  await eachMoment(t, (now, where) => {
    for (const width of [320, 640])
      for (const view of views) {
        const markup = drawn(view, now, width);
        assert.ok(
          !/NaN|undefined|Infinity|null/.test(markup),
          `${where}: ${markup.match(/.{60}(NaN|undefined|Infinity|null).{20}/)}`,
        );
        for (const handle of view.handles(now, { width, height: view.height(width, now) }))
          assert.ok(Number.isFinite(handle.x + handle.y + handle.value), `${where} ${handle.id}`);
      }
    for (const view of panels) assert.ok(!/NaN|undefined/.test(view.markup(now)), where);
  });
});

test('why tells the engine’s numbers, and colours that follow from each other', async (t) => {
  const source = await open(t, 'yard-4');
  const view = kit.why();
  let lit = 0;
  let sides = 0;
  for (const row of [20, 90, 150, 220, 290])
    for (const column of [30, 200, 400]) {
      const now = nowOf(source, '9.4,4.5,0.5,192,0.1', { column, row });
      const { pick } = now;
      const markup = view.markup(now);
      const picture = [
        ...source
          .pixels()
          .data.subarray(4 * (row * 480 + column))
          .subarray(0, 3),
      ];
      assert.ok(markup.includes(`${kit.hex(picture)}`), `${column} ${row}`);
      if (pick.texel === null) continue;
      assert.ok(markup.includes(kit.fixed(pick.depth, 4)));
      assert.ok(markup.includes(`× ${pick.texel.light} ÷ 256`));
      const { texel, light } = source.colours(column, row);
      const share = Number(/<b>Side<\/b> <span>× ([\d.]+)/.exec(markup)?.[1] ?? 1);
      if (share < 1) ++sides;
      if (!markup.includes('<b>Layer')) {
        texel.forEach((part, index) =>
          assert.ok(
            Math.abs((part * pick.texel.light) / 256 / share - light[index]) <= 1.2,
            `${column} ${row}`,
          ),
        );
        if (pick.texel.light < 256) ++lit;
      }
      assert.deepEqual(
        ['light', 'fog'].map((name) => source.get(name)),
        ['on', 'on'],
      );
    }
  assert.ok(lit > 3 && sides > 1, `${lit} ${sides}`);
  const glass = await open(t, 'yard-5');
  const through = nowOf(glass, '8.8,3.8,0.5,310,0', { column: 300, row: 130 });
  const { texel, alpha } = through.pick;
  assert.ok(alpha < 255);
  const markup = view.markup(through);
  assert.ok(markup.includes(`× ${texel.light} ÷ 256`) && markup.includes(`${alpha} of 255 parts`));
});

test('code marks the lines of the step, and each view follows the scrub', async (t) => {
  const source = await open(t, 'yard-1');
  const figure = {
    rows: [],
    size: kSize,
    view: kViews['yard-1'][0],
    controls: [kit.scrub()],
  };
  const code = kit.codeView({
    code: 'a\nb\nc\nd',
    lines: { start: [1], x: [2], y: [3], side: [4] },
  });
  const now = openingNow(figure, source);
  const { walk, runs } = now.slice;
  assert.equal(now.steps.length, walk.length + runs.length);
  assert.equal(now.step, null);
  assert.deepEqual([now.tiles.length, now.runs.length], [walk.length, runs.length]);
  now.steps.forEach(({ kind, of, index }, step) => {
    const at = makeNow(figure, source, { ...now.state, step });
    const lines = code
      .markup(at)
      .split('<span class="fig-line')
      .filter((_, i) => i % 2 === 1);
    const marked = lines.findIndex((line) => line.startsWith(' now'));
    assert.equal(marked, { start: 0, x: 1, y: 2, side: 3 }[kind] ?? -1);
    const tiles = of === 'walk' ? index + 1 : walk.length;
    assert.equal(at.tiles.length, tiles);
    assert.equal(at.runs.length, of === 'walk' ? 0 : index + 1);
    assert.equal(drawn(kit.mapView(), at).split('class="fig-lit"').length - 1, tiles);
    assert.equal(
      drawn(kit.sliceStrip(), at).match(/class="fig-run [a-z]+"/g)?.length ?? 0,
      at.runs.length + (of === 'run' ? 1 : 0),
    );
  });
});

test('handles change what they say', async (t) => {
  const source = await open(t, 'yard-1');
  const now = nowOf(source, kViews['yard-1'][0]);
  const size = { width: 600, height: 400 };
  const handle = (view, id) => view.handles(now, size).find((each) => each.id === id);
  const map = kit.mapView();
  const eye = handle(map, 'eye');
  const unit = (600 - 20) / 16;
  const { eye: moved } = eye.drag({ x: eye.x + unit, y: eye.y - 2 * unit });
  assert.ok(Math.abs(moved.x - now.eye.x - 1) < 0.011 && Math.abs(moved.y - now.eye.y + 2) < 0.011);
  const { eye: pushed } = eye.drag({ x: -900, y: 9000 });
  assert.ok(pushed.x > 0 && pushed.y < 9);
  const heading = handle(map, 'heading');
  assert.equal(heading.drag({ x: eye.x, y: eye.y + 50 }).eye.heading, 90);
  assert.equal(heading.keys(10, 0).eye.heading, 355);
  const height = handle(kit.sideView(), 'height');
  const start = { state: now.state, now, point: { x: height.x, y: height.y } };
  assert.ok(height.drag({ x: 0, y: height.y - 30 }, now, start).eye.z > 0.5);
  const row = handle(kit.sliceStrip({ tall: 300 }), 'row');
  assert.equal(row.drag({ x: 0, y: 6 }).row, 0);
  assert.equal(row.drag({ x: 0, y: 305 }).row, 299);
  // The point at which a click on the map looks is in the column that it chooses.
  const clicked = kit
    .mapView({ column: true })
    .click({ x: eye.x + 5 * unit, y: eye.y - unit }, now, size);
  const [dx, dy] = kit.rayOf(now.eye, clicked.column, kSize, now.slice.fov);
  assert.ok(Math.abs(Math.atan2(dy, dx) - Math.atan2(-1, 5)) < 0.003);
});

test('painting edits cells, and the engine shows them at once', async (t) => {
  const source = await open(t, 'yard-1');
  const figure = { rows: [], size: kSize, view: kViews['yard-1'][0], state: { column: 240 } };
  const now = openingNow(figure, source);
  const { paint } = kit.mapView({ paint: true });
  assert.deepEqual(
    paint
      .blocksOf(now)
      .map(({ character }) => character)
      .sort(),
    ['#', '.', 'L', 'o', 'w'],
  );
  const painted = changed(figure, now.state, paint.edited([3, 6], 'o', now), now);
  assert.deepEqual(painted.edits, [['yard', 0, 3, 6, 'o']]);
  apply(figure, source, painted, now.state);
  const after = makeNow(figure, source, painted);
  assert.equal(paint.characterAt([3, 6], after), 'o');
  assert.deepEqual(after.slice.hits[0].tile, [3, 6]);
  const erased = changed(figure, painted, paint.edited([3, 6], '.', after), after);
  assert.equal(erased.edits.length, 1);
  apply(figure, source, erased, painted);
  assert.deepEqual(makeNow(figure, source, erased).slice.hits[0].tile, now.slice.hits[0].tile);
  const two = changed(figure, erased, paint.edited([3, 7], 'w', after), after);
  const three = changed(figure, two, paint.edited([4, 7], 'w', makeNow(figure, source, two)));
  assert.deepEqual(
    three.edits.map((edit) => edit.slice(2).join('')),
    ['36o', '37w', '47w'],
  );
  apply(figure, source, now.state, erased);
  assert.equal(source.cells('yard', 0)[6][3], '.');
});

test('a state comes back from the address as it was', () => {
  const figure = {
    rows: [],
    state: { way: 'plane', wall: 2, wrong: false, pair: [1, 2] },
    controls: [kit.choice({ label: 'x', field: 'name', of: { 'a b_*,:é': 'A', other: 'B' } })],
  };
  const view = { map: 'yard', x: 1.5, y: 2.25, z: 0.5, heading: 90, look: 0 };
  const opening = openingState(figure, view);
  assert.equal(writeState(opening, opening), '');
  const edits = [
    ['yard', 0, 3, 6, '#'],
    [null, 1, 0, 8, '_'],
    ['a*b', 0, 1, 1, ','],
  ];
  const state = changed(figure, opening, {
    eye: { x: 4.123456, heading: -90, look: 0.25 },
    column: 3,
    step: 4,
    way: 'a:b,c_d*e',
    wall: 0.125,
    wrong: true,
    pair: [-3, 0.5],
    name: 'other',
    edits,
  });
  const text = writeState(state, opening);
  assert.match(text, /^[\w.~:,*%'()!-]+$/);
  const again = changed(figure, opening, readState(text, opening));
  assert.deepEqual(again, { ...state, eye: { ...state.eye, x: 4.1235 } });
  // What others write into addresses does no harm.
  for (const odd of [
    '',
    'eye:1_2',
    'column:x,wall:NaN',
    'edits:1_2*3',
    '__proto__:1',
    'wrong:maybe',
    ':::',
    'way:%E0%A4%A',
  ])
    assert.doesNotThrow(() => changed(figure, opening, readState(odd, opening)), odd);
  assert.equal(changed(figure, opening, readState('column:99999', opening)).column, 479);
});

test('time and options bring the engine where they say, and back', async (t) => {
  const source = await open(t, 'yard-6');
  const figure = {
    rows: [],
    size: kSize,
    view: '8.5,4.5,0.5,0,0.1',
    controls: [
      kit.slider({ label: 'Field of view', option: 'fov', from: 30, to: 120, opening: 66 }),
    ],
    options: (state) => (state.dark ? { light: 'off' } : {}),
    state: { dark: false },
  };
  const opening = openingNow(figure, source);
  const gate = ({ slice }) => slice.hits.find(({ blueprint }) => blueprint === 'gate');
  const closed = gate(opening).bottom;
  const { eye } = opening;
  assert.equal(source.get('fov'), '66');
  const before = source.pixels().data.slice();
  let state = changed(figure, opening.state, { time: 240, dark: true, fov: 90 });
  apply(figure, source, state, opening.state);
  const later = makeNow(figure, source, state);
  assert.deepEqual(later.eye, eye);
  assert.deepEqual([source.get('fov'), source.get('light')], ['90', 'off']);
  assert.ok(gate(later).bottom > closed + 0.1);
  state = changed(figure, state, { ...opening.state });
  apply(figure, source, state, later.state);
  assert.deepEqual([source.get('fov'), source.get('light')], ['66', 'on']);
  assert.deepEqual(Buffer.from(source.pixels().data), Buffer.from(before));
});

test('a whole figure is drawn for the build', async (t) => {
  const source = await open(t, 'yard-4');
  const figure = {
    view: '7.4,7.5,0.5,235,0.12',
    size: kSize,
    state: { column: 120, old: 'Fish eye' },
    controls: [
      kit.choice({ label: 'Way', field: 'old', oldWays: ['Fish eye', 'Big pixels'] }),
      kit.scrub(),
    ],
    rows: [
      [kit.picture({ title: 'The picture' }), kit.mapView()],
      [
        kit.divider({ right: { oldWay: ({ old }) => old } }),
        kit.sideView({ when: ({ old }) => old === 'x' }),
      ],
      [kit.picture({ options: { light: 'off' } })],
    ],
    numbers: {
      depth: (now) => now.slice.hits[0].depth,
      tiles: (now) => String(now.slice.walk.length),
    },
    says: (now) => `Depth ${now.strong(now.fixed(now.slice.hits[0].depth))}.`,
  };
  const poster = (name) => `pictures/${name}.png`;
  const { html, posters, numbers, says } = drawStatic(figure, source, {
    name: 'all',
    poster,
    wide: true,
  });
  const [hit] = source.trace(120).hits;
  assert.deepEqual(numbers, {
    depth: kit.fixed(hit.depth),
    tiles: String(source.trace(120).walk.length),
  });
  assert.equal(says, `Depth <b>${kit.fixed(hit.depth)}</b>.`);
  assert.ok(html.includes(says));
  assert.deepEqual(
    posters.map(({ name }) => name),
    ['all', 'all-10', 'all-20'],
  );
  for (const { name, pixels } of posters) {
    assert.ok(html.includes(`src="pictures/${name}.png" width="480" height="300"`));
    assert.deepEqual([pixels.width, pixels.height, pixels.data.length], [480, 300, 576000]);
  }
  const bytes = ({ data }) => Buffer.from(data);
  assert.deepEqual(bytes(posters[0].pixels), bytes(source.pixels()));
  // Left of the divider the exact picture, right of it the other one.
  const way = source.oldWays.find(({ name }) => name === 'Fish eye').options;
  for (const [name, value] of Object.entries({ ...way, method: 'classic' }))
    source.set(name, value);
  const other = source.pixels().data.slice();
  for (const name of Object.keys({ ...way, method: 0 })) source.set(name, source.standard(name));
  const half = posters[1].pixels.data;
  for (let at = 0; at < half.length; ++at) {
    const side = at % 1920 < 960 ? posters[0].pixels.data : other;
    if (half[at] !== side[at]) assert.fail(`byte ${at}`);
  }
  assert.ok(!Buffer.from(other).equals(bytes(posters[0].pixels)));
  assert.ok(!bytes(posters[2].pixels).equals(bytes(posters[0].pixels)));
  assert.deepEqual([source.get('light'), source.get('method')], ['on', 'exact']);
  assert.match(html, /<div class="fig-panel fig-drawing fig-share-2" data-panel="1\.1" hidden="">/);
  assert.ok(!/style=|onclick|undefined|NaN/.test(html));
  // Every id once.
  const ids = [...html.matchAll(/ id="([^"]+)"/g)].map(([, id]) => id);
  assert.equal(new Set(ids).size, ids.length);
});

test('the kit is small', async (t) => {
  const tools = createRequire(new URL('../../tools/package.json', import.meta.url));
  const { build } = tools('esbuild');
  const folder = new URL('../../web/learn/figures/', import.meta.url).pathname;
  const bytes = async (names) => {
    const { outputFiles } = await build({
      stdin: {
        contents: `export { ${names} } from './kit.js'; export { mount } from './mount.js';`,
        resolveDir: folder,
      },
      bundle: true,
      splitting: true,
      minify: true,
      format: 'esm',
      outdir: 'out',
      write: false,
    });
    // What loads later is in files of its own.
    return gzipSync(outputFiles.find(({ path }) => path.endsWith('stdin.js')).contents).length;
  };
  const usual =
    'picture, mapView, rulers, sideView, sliceStrip, numberTable, scrub, slider, choice, toggle';
  const [some, all] = [await bytes(usual), await bytes(Object.keys(kit).join())];
  t.diagnostic(`the usual views: ${some} bytes, all: ${all}`);
  assert.ok(some < 25000 && all < 29000, `${some} ${all}`);
});

test('what is left out of a figure, or misspelt, is named', () => {
  const { divider, mapView, picture, slider } = kit;
  const good = {
    scene: 'yard-1.json',
    view: '1,1,0.5,0',
    controls: [slider({ eye: 'heading' })],
    rows: [[picture({ alt: () => '' }), mapView({ handles: ['eye'] })], [mapView({ paint: true })]],
  };
  checkFigure(good);
  for (const [change, ...expected] of [
    [{ scene: undefined, sceen: 'a.json' }, /Unknown field 'sceen'.*'scene'/, /scene: found undef/],
    [{ rows: undefined }, /rows: found none, expected a list of rows/],
    [{ rows: [picture()] }, /rows\[0\]: found a view, expected a list of views, as in \[picture/],
    [{ rows: [[picture]] }, /rows\[0\]\[0\]: found .*, expected a view, as picture\(\) returns/],
    [{ rows: [[picture(), mapView({ handels: [] })]] }, /rows\[0\]\[1\]: .*'handels'.*'handles'/],
    [{ rows: [[mapView({ levles: [0] })]] }, /'levles'. Did you mean 'levels'/],
    [{ rows: [[divider({ right: { oldway: 'x' } })]] }, /\[0\].right: .*'oldway'.*'oldWay'/],
    [{ controls: [slider] }, /controls\[0\]: found .*, expected a control/],
  ])
    for (const pattern of expected)
      assert.throws(() => checkFigure({ ...good, ...change }), pattern);
});
