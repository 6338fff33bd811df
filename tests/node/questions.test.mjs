// What figures ask, under Node: many columns at once, free rays, pixels, points, and cells that are
// read and changed.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { test } from 'node:test';

import { Engine } from '../../build/web/engine/engine.js';
import { readEngine } from '../../build/web/node/engine-files.js';
import { load } from '../../build/web/node/index.js';
import { openScene } from '../../build/web/node/scene-files.js';
import { root, shippedScenes } from '../wasm/load.mjs';

const kSize = { width: 96, height: 60 };
const kMostMilliseconds = 400; // far above what it takes, for machines that do much else

const castleText = await readFile(`${root}/assets/scenes/castle.json`, 'utf8');
const sameBytes = (a, b) => Buffer.from(a.data).equals(Buffer.from(b.data));

test('many columns are told in one call, as one after another', async () => {
  for (const name of ['wayhouse', 'water-palace', 'garden']) {
    const scene = await load(name);
    for (const ask of ['hits', 'trace']) {
      const all = scene[ask]({ first: 0, last: kSize.width - 1 }, kSize);
      assert.equal(all.length, kSize.width);
      for (const column of [0, 1, 15, 16, 47, 95])
        assert.deepEqual(all[column], scene[ask](column, kSize), `${name} ${ask} ${column}`);
      const some = scene[ask]([40, 3, -1, 40, 96, 1.5], kSize);
      assert.deepEqual(some, [all[40], all[3], null, all[40], null, null]);
      assert.deepEqual(scene[ask]([], kSize), []);
    }
    scene.free();
  }
});

test('lists that are read late are of the moment that was asked about', async () => {
  const scene = await load('water-palace');
  for (const ask of ['hits', 'trace']) {
    const columns = { first: 40, last: 60 };
    const now = scene[ask](columns, kSize).map((slice) => structuredClone(slice));
    const late = scene[ask](columns, kSize);
    scene.step(90, { forward: 1, turn: 1 });
    scene[ask](columns, kSize); // the engine's memory is written anew
    assert.deepEqual(late[3], now[3]);
    assert.deepEqual(JSON.parse(JSON.stringify(late[4])), now[4]);
    assert.deepEqual({ ...late[5] }, now[5]);
    late[6].hits = [];
    assert.deepEqual(late[6], { ...now[6], hits: [] });
    assert.equal(late[7].tiles, late[7].tiles);
    assert.notDeepEqual(scene[ask](columns, kSize)[3], now[3]);
  }
  scene.free();
});

test('all columns of the harbour are quick', async (t) => {
  const scene = await load('harbour-town');
  const size = { width: 320, height: 200 };
  for (const ask of ['hits', 'trace']) {
    const told = [];
    const times = Array.from({ length: 7 }, () => {
      const begin = performance.now();
      told.push(scene[ask]({ first: 0, last: 319 }, size));
      return performance.now() - begin;
    });
    const best = Math.min(...times);
    const begin = performance.now();
    const hits = told[6].reduce((sum, slice) => sum + slice.hits.length, 0);
    const reading = performance.now() - begin;
    assert.ok(hits > 10000);
    const list = times.map((time) => time.toFixed(1)).join(', ');
    t.diagnostic(`${ask}: ${list} ms; reading its ${hits} hits: ${reading.toFixed(1)} ms`);
    assert.ok(best < kMostMilliseconds, `${ask}: ${best} ms`);
  }
  scene.free();
});

test('invalid columns are refused', async () => {
  const scene = await load('first-walk');
  for (const columns of [
    {},
    { first: 3 },
    { first: 0.5, last: 3 },
    { first: 4, last: 3 },
    { first: 0, last: 8192 },
  ]) {
    for (const ask of ['hits', 'trace'])
      assert.throws(() => scene[ask](columns, kSize), {
        name: 'RangeError',
        message: /^(hits|trace): found columns from .*, expected a column, a list of columns, or /,
      });
  }
  for (const ask of ['hits', 'trace'])
    assert.throws(() => scene[ask](new Array(8193).fill(0), kSize), {
      name: 'RangeError',
      message: /: found 8193 columns, expected .* with at most 8192 columns\.$/,
    });
  scene.free();
});

test('a free ray walks tiles and hits blocks', async () => {
  const scene = await load('first-walk');
  const { x, y, map } = scene.currentView;
  for (const heading of [0, 33, 90, 200]) {
    const told = scene.cast({ map, x, y, heading });
    assert.deepEqual([told.map, told.z, told.heading], [map, null, heading]);
    assert.ok(Math.abs(Math.hypot(...told.ray) - 1) < 1e-12);
    assert.ok(Math.abs(told.ray[0] - Math.cos((heading * Math.PI) / 180)) < 1e-12);
    assert.deepEqual(told.tiles[0].tile, [Math.floor(x), Math.floor(y)]);
    assert.equal(told.tiles[0].axis, null);
    told.tiles.slice(1).forEach(({ tile, axis, distance }, index) => {
      const before = told.tiles[index];
      assert.equal(distance, Math.min(...before.next.map((next) => next ?? Infinity)));
      const moved = tile[axis === 'x' ? 0 : 1] - before.tile[axis === 'x' ? 0 : 1];
      assert.equal(Math.abs(moved), 1);
    });
    assert.equal(told.end.why, 'edge');

    // With a height it agrees with the middle row of a column of a level picture.
    const low = scene.cast({ map, x, y, z: 0.5, heading });
    assert.equal(low.z, 0.5);
    for (const { bottom, top } of low.hits) assert.ok(bottom <= 0.5 && top > 0.5);
    scene.look({ x, y, z: 0.5, heading, look: 0 });
    const trace = scene.hits(50, { width: 101, height: 61 });
    const met = trace.hits.find(({ bottom, top }) => bottom <= 0.5 && top > 0.5);
    if (low.end.why === 'block') {
      assert.deepEqual(low.hits.at(-1).tile, met.tile);
      assert.ok(Math.abs(low.end.distance - met.depth) < 1e-9);
    }
  }
  assert.deepEqual(scene.cast({ x, y, heading: 12 }).map, map, 'in the map of the eye');
  for (const [from, found] of [
    [undefined, /found undefined/],
    [{ x, y }, /heading undefined/],
    [{ x: '1', y, heading: 0 }, /x 1/],
    [{ x: 40000, y, heading: 0 }, /x 40000, expected a number from -32767 to 32767/],
    [{ x, y, heading: NaN }, /heading NaN/],
    [{ x, y, z: NaN, heading: 0 }, /z NaN/],
    [{ x, y, heading: 0, map: 'nowhere' }, /cast: Unknown map 'nowhere'\. Expected /],
    [
      { x, y, heading: 0, hight: 1 },
      /cast: Unknown field 'hight'\. Expected map, x, y, z or heading\.$/,
    ],
  ])
    assert.throws(() => scene.cast(from), { name: 'RangeError', message: found });
  scene.free();
});

test('every picked pixel is projected onto itself', async () => {
  const scene = await load('harbour-town');
  scene.set('light', false);
  scene.set('fog', false);
  const kinds = new Set();
  let points = 0;
  for (let row = 0; row < kSize.height; row += 3) {
    for (let column = 0; column < kSize.width; column += 3) {
      const pick = scene.pick(column, row, kSize);
      kinds.add(pick.what);
      assert.deepEqual([pick.column, pick.row], [column, row]);
      // The pick is the trace's run of that row, unless a layer covers it.
      const runs = scene
        .trace(column, kSize)
        .runs.filter(({ first, last }) => first <= row && row <= last);
      if (runs.length === 1)
        assert.deepEqual([pick.what, pick.texture], [runs[0].what, runs[0].texture]);
      if (pick.point === null || pick.portals > 0) continue;
      ++points;
      const { x, y, depth } = scene.project(...pick.point, pick.map, kSize);
      assert.ok(Math.abs(x - column - 0.5) < 1e-6 && Math.abs(y - row - 0.5) < 1e-6);
      assert.ok(Math.abs(depth - pick.depth) < 1e-9);
    }
  }
  assert.ok(points > 200 && kinds.size >= 4, [...kinds].join());
  assert.equal(scene.pick(96, 3, kSize), null);
  assert.equal(scene.pick(3, -0.5, kSize), null);
  assert.throws(() => scene.pick('3', 3, kSize), /^RangeError: pick: found column 3, expected a n/);
  const { x, y, z, heading } = scene.currentView;
  const behind = [x - Math.cos((heading * Math.PI) / 180), y - Math.sin((heading * Math.PI) / 180)];
  assert.equal(scene.project(...behind, z, undefined, kSize), null);
  assert.throws(() => scene.project(1, 2, NaN), /^RangeError: project: found z NaN/);
  scene.free();
});

test('the cells of every shipped scene are those of its text', async () => {
  for (const file of shippedScenes) {
    const scene = await load(file);
    const text = JSON.parse(await readFile(file, 'utf8'));
    scene.step(90); // what moves is elsewhere
    for (const map of text.maps) {
      const legend = { ...text.legend, ...map.legend };
      const firstOf = {};
      for (const [character, name] of Object.entries(legend)) firstOf[name] ??= character;
      const width = Math.max(...map.levels.flat().map((row) => [...row].length));
      const depth = Math.max(...map.levels.map((level) => level.length));
      const expected = map.levels.map((level) =>
        level.length === 0
          ? new Array(depth).fill('.'.repeat(width))
          : level.map((row) => [...row].map((one) => firstOf[legend[one]] ?? '.').join('')),
      );
      assert.deepEqual(scene.cells(map.name), expected, `${basename(file)} ${map.name}`);
      assert.deepEqual(scene.cells(map.name, 0), expected[0]);
      const blueprints = scene.blueprints(map.name);
      assert.deepEqual(
        blueprints.map(({ character }) => character).sort(),
        Object.keys(legend).sort(),
      );
      for (const { character, name, faces, top } of blueprints) {
        assert.equal(name, legend[character]);
        const highest = Math.max(...[text.blueprints[name].top ?? 1].flat());
        assert.ok(Math.abs(top - highest) < 1e-4, name);
        for (const { texture, colour } of Object.values(faces)) {
          if (texture !== null) assert.ok(Object.hasOwn(text.textures, texture));
          else assert.ok(text.blueprints[name].water && colour === null, name);
        }
      }
    }
    assert.throws(() => scene.cells('nowhere'), /^RangeError: cells: Unknown map 'nowhere'/);
    assert.throws(() => scene.cells(null, 99), /^RangeError: cells: found level 99, expected a/);
    scene.free();
  }
});

test('a set cell looks as if the scene had it', async () => {
  const scene = await load(JSON.parse(castleText));
  const start = scene.currentView;
  const before = scene.pixels(kSize);
  const cells = scene.cells(start.map);
  // A free cell two tiles ahead, in the way of the body.
  const level = Math.floor(start.z - 0.3);
  const ahead = scene.cast(start);
  assert.ok(ahead.tiles.length > 3);
  const [x, y] = ahead.tiles[2].tile;
  assert.equal([...cells[level][y]][x], '.');
  const plain = scene.blueprints().find((one) => !one.moves && !one.gate && one.top === 1);
  scene.setCell(start.map, level, x, y, plain.character);
  assert.deepEqual(scene.currentView, start);
  const after = scene.pixels(kSize);
  assert.ok(!sameBytes(after, before));

  const text = JSON.parse(castleText);
  const map = text.maps.find(({ name }) => name === start.map);
  const row = [...map.levels[level][y]];
  row[x] = plain.character;
  map.levels[level][y] = row.join('');
  const written = await load(text);
  assert.ok(sameBytes(written.pixels(kSize), after), 'drawn');
  assert.deepEqual(written.trace(48, kSize), scene.trace(48, kSize));
  for (const one of [scene, written]) one.step(240, { forward: 1 });
  assert.deepEqual(scene.currentView, written.currentView, 'solid');
  assert.ok(sameBytes(written.pixels(kSize), scene.pixels(kSize)));

  scene.reset();
  assert.deepEqual(scene.cells(start.map), cells);
  assert.ok(sameBytes(scene.pixels(kSize), before));
  for (const [words, message] of [
    [[start.map, 0, 1, 1, 'ab'], /found "ab", expected one of \. .* legend\.$/u],
    [[start.map, 0, 1, 1, ''], /found "", expected one of \. /],
    [[start.map, 0, 1, 1], /found undefined, expected a character of the map's legend/],
    [[start.map, 0, 1.5, 1, '.'], /found x 1.5, expected a whole number/],
    [[start.map, 0, -1, 1, '.'], /found x -1, expected a whole number from 0 to /],
    [[start.map, 99, 1, 1, '.'], /found level 99, expected a whole number from 0 to /],
    [['cellar', 0, 1, 1, '.'], /Unknown map 'cellar'/],
    [[start.map, 0, 1, 1, '\u{1F3F0}'], /found "\u{1F3F0}", expected one of \. .* legend\.$/u],
  ])
    assert.throws(() => scene.setCell(...words), { name: 'RangeError', message });
  for (const one of [scene, written]) one.free();
});

test('many cells are changed at once, or none', async () => {
  const one = await load('castle');
  const many = await load('castle');
  const { map } = one.currentView;
  const characters = one
    .blueprints()
    .filter(({ moves, gate }) => !moves && !gate)
    .map(({ character }) => character);
  const cells = one.cells(map, 0);
  const changes = [];
  for (let x = 0; x < 40; ++x)
    if (characters.includes([...cells[1]][x]))
      changes.push({ level: 0, x, y: 1, character: [...characters, '.'][x % 3] });
  assert.ok(changes.length > 20);
  for (const { level, x, y, character } of changes) one.setCell(map, level, x, y, character);
  many.setCells(map, changes);
  assert.deepEqual(many.cells(map), one.cells(map));
  assert.ok(sameBytes(many.pixels(kSize), one.pixels(kSize)));
  many.reset();
  assert.deepEqual(many.cells(map, 0), cells);
  assert.throws(() => many.setCells(map, [...changes, { level: 0, x: 1, y: 1, character: 'ab' }]), {
    name: 'RangeError',
    message: /found "ab", expected one of/,
  });
  assert.throws(
    () => many.setCells(map, [{ level: 0, x: 1, y: 1, character: 'a\0b' }]),
    RangeError,
  );
  assert.deepEqual(many.cells(map, 0), cells);
  many.setCells(map, []);
  for (const scene of [one, many]) scene.free();
});

test('marks are lines over the picture, until they are removed', async () => {
  const scene = await load('first-walk');
  const { x, y, z, heading } = scene.currentView;
  const before = scene.pixels(kSize);
  const angle = (heading * Math.PI) / 180;
  const ahead = (far, right) => [
    x + far * Math.cos(angle) - right * Math.sin(angle),
    y + far * Math.sin(angle) + right * Math.cos(angle),
    z,
  ];
  scene.mark([{ from: ahead(0.5, -0.1), to: ahead(0.5, 0.1), colour: '#ff0080' }]);
  const after = scene.pixels(kSize);
  const marked = [];
  for (let at = 0; at < after.data.length; at += 4)
    if (after.data[at] > after.data[at + 1] + 90 && after.data[at + 2] > after.data[at + 1] + 30)
      marked.push([(at / 4) % kSize.width, Math.floor(at / 4 / kSize.width)]);
  const ends = [-0.1, 0.1].map((right) => scene.project(...ahead(0.5, right), null, kSize));
  assert.ok(marked.length > (ends[1].x - ends[0].x) * 0.8);
  for (const [column, row] of marked) {
    assert.ok(column + 1 >= ends[0].x && column <= ends[1].x, `${column}`);
    assert.ok(Math.abs(row + 0.5 - ends[0].y) <= 1, `${row}`);
  }
  scene.mark([{ map: scene.currentView.map, from: ahead(0.5, 0), to: ahead(-0.5, 0) }]);
  assert.ok(!sameBytes(scene.pixels(kSize), before));
  scene.mark([]);
  assert.ok(sameBytes(scene.pixels(kSize), before));
  const good = { from: [1, 1, 1], to: [2, 2, 2] };
  for (const [line, message] of [
    [{ ...good, to: [1, 2] }, /mark: found to 1,2 in line 0, expected three numbers/],
    [{ ...good, from: [1, NaN, 2] }, /mark: found from 1,NaN,2 in line 0, expected three numbers/],
    [{ ...good, colour: 'red' }, /mark: found colour red in line 0, expected a colour as #c03020/],
    [{ ...good, map: 'cellar' }, /mark: Unknown map 'cellar'/],
  ])
    assert.throws(() => scene.mark([line]), { name: 'RangeError', message });
  assert.throws(
    () => scene.mark(Array(16385).fill(good)),
    /found 16385 lines, expected at most 16384/,
  );
  scene.free();
});

test('an engine that adopted the scene does not change', async () => {
  const create = async () => Engine.create({ files: await readEngine('auto'), canvas: {} });
  const one = await create();
  assert.deepEqual(await one.loadScene(openScene('first-walk')), []);
  const cells = one.questions.cells();
  const solid = one.questions.blueprints().find(({ moves, gate }) => !moves && !gate);
  const y = cells[0].findIndex((row) => row.includes('.'));
  const x = cells[0][y].indexOf('.');
  const early = await create();
  assert.equal(early.adopt(one), true);
  one.questions.setCells(null, [{ level: 0, x, y, character: solid.character }]);
  const late = await create();
  assert.equal(late.adopt(one), true);
  assert.notDeepEqual(one.questions.cells(), cells);
  assert.deepEqual(early.questions.cells(), cells);
  assert.deepEqual(late.questions.cells(), cells, 'the scene as it was loaded');
  late.questions.setCells(null, [{ level: 0, x, y, character: solid.character }]);
  assert.deepEqual(late.questions.cells(), one.questions.cells());
  assert.deepEqual(early.questions.cells(), cells);
  for (const engine of [one, early, late]) engine.stop();
});

test('drawnColumns draws only the first columns, forwards and back', async () => {
  const scene = await load('first-walk');
  const whole = scene.pixels(kSize);
  const columnsOf = ({ data }) =>
    Array.from({ length: kSize.width }, (_, x) => {
      let same = true;
      for (let y = 0; y < kSize.height; ++y)
        for (let c = 0; c < 4; ++c) {
          const at = 4 * (y * kSize.width + x) + c;
          same &&= data[at] === whole.data[at];
        }
      return same;
    });
  const seen = new Map();
  for (const drawn of [10, 70, 40, 10, 0, 40, 95]) {
    scene.set('drawnColumns', drawn);
    const picture = scene.pixels(kSize);
    assert.deepEqual(
      columnsOf(picture),
      Array.from({ length: kSize.width }, (_, x) => x < drawn),
    );
    if (seen.has(drawn)) assert.ok(sameBytes(seen.get(drawn), picture));
    seen.set(drawn, picture);
  }
  for (const drawn of [96, 8192, -1]) {
    scene.set('drawnColumns', drawn);
    assert.ok(sameBytes(scene.pixels(kSize), whole));
  }
  assert.throws(() => scene.set('drawnColumns', -2), { code: 'option' });
  scene.free();
});
