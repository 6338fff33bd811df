// Questions to <ray-caster>: many columns at once, free rays, pixels, points, and cells that
// are read and changed.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { launch } from './browser.mjs';
import { elementPixel, openElements, ready } from './element.mjs';
import { kGreen, kGrey, kSky } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Its box is 320 x 200 of the window's pixels, two for each of the picture's.
const kRoom = `<div style="height: 30px"></div>
  <ray-caster id="a" scene="room" size="160x100" style="margin-left: 12px"></ray-caster>`;

async function openRoom(t, markup = kRoom) {
  const { page } = await openElements(t, browser, markup);
  await ready(page, 'a');
  return page;
}

test('pick() finds what is under the pointer, and project() maps it back', async (t) => {
  const page = await openRoom(t);
  const told = await page.evaluate(() => {
    const a = document.getElementById('a');
    const box = a.getBoundingClientRect();
    const at = (x, y) => a.pick(box.left + x, box.top + y);
    const middle = at(160, 101);
    const again = a.project(...middle.point);
    return {
      size: [box.width, box.height],
      middle,
      again: [again.x, again.y, again.clientX - box.left, again.clientY - box.top],
      sky: at(160, 3),
      floor: at(160, 197),
      corner: at(0.2, 0.2),
      last: at(319.9, 199.9),
      outside: [at(-1, 50), at(320.5, 50), at(50, -1), at(50, 200.5)],
      behind: a.project(1.5, 3.5, 0.5),
      elsewhere: (() => {
        try {
          return a.project(1, 1, 1, 'cellar');
        } catch (error) {
          return String(error);
        }
      })(),
    };
  });
  assert.deepEqual(told.size, [320, 200]);
  const { what, blueprint, tile, level, face, texture, point, depth } = told.middle;
  assert.deepEqual(
    [what, blueprint, tile, level, face, texture],
    ['side', 'wall', [6, 3], 0, 'west', 'green'],
  );
  assert.equal(depth, 2.5);
  assert.equal(point[0], 6);
  assert.deepEqual(
    told.again.map((number) => Math.round(number * 1e6) / 1e6),
    [80.5, 50.5, 161, 101],
  );
  assert.deepEqual([told.sky.what, told.sky.point], ['sky', null]);
  assert.deepEqual([told.floor.what, told.floor.texture], ['floor', 'grey']);
  assert.deepEqual([told.corner.column, told.corner.row], [0, 0]);
  assert.deepEqual([told.last.column, told.last.row], [159, 99]);
  assert.deepEqual(told.outside, [null, null, null, null]);
  assert.equal(told.behind, null);
  assert.match(told.elsewhere, /^RangeError: project: Unknown map 'cellar'\. Expected room\.$/);
});

test('every pixel of the canvas agrees with pick()', async (t) => {
  const page = await openRoom(t);
  const told = await page.evaluate(async () => {
    const a = document.getElementById('a');
    const colours = { red: [200, 40, 40], green: [40, 180, 60], blue: [50, 70, 210] };
    Object.assign(colours, { yellow: [230, 200, 50], grey: [120, 120, 120] });
    a.look({ x: 2.2, y: 4.1, z: 0.7, heading: 250, look: -0.1 });
    await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
    const canvas = a.shadowRoot.querySelector('canvas');
    const shown = canvas.getContext('2d').getImageData(0, 0, 160, 100).data;
    const pixels = a.pixels();
    const box = a.getBoundingClientRect();
    let wrong = 0;
    const seen = new Set();
    for (let row = 0; row < 100; row += 3) {
      for (let column = 0; column < 160; column += 3) {
        const pick = a.pick(box.left + 2 * column + 1, box.top + 2 * row + 1);
        seen.add(pick.texture ?? pick.what);
        const at = 4 * (row * 160 + column);
        const colour = colours[pick.texture] ?? [0x88, 0xa0, 0xb8];
        if (colour.some((value, i) => value !== shown[at + i])) ++wrong;
      }
    }
    return {
      wrong,
      seen: [...seen].sort(),
      same: pixels.data.every((value, i) => value === shown[i]),
      size: [pixels.width, pixels.height, pixels.data.constructor.name],
      other: a.pixels({ width: 8, height: 4 }).data.length,
      refused: (() => {
        try {
          a.pixels({ width: 4097, height: 1 });
        } catch (error) {
          return String(error);
        }
      })(),
    };
  });
  assert.equal(told.wrong, 0);
  assert.deepEqual(told.seen, ['grey', 'red', 'sky', 'yellow']);
  assert.ok(told.same);
  assert.deepEqual(told.size, [160, 100, 'Uint8ClampedArray']);
  assert.equal(told.other, 8 * 4 * 4);
  assert.match(told.refused, /^RangeError: pixels: found width 4097, expected a whole number/);
});

test('hits() and trace() take many columns at once, cast() a free ray', async (t) => {
  const page = await openRoom(t);
  const told = await page.evaluate(() => {
    const a = document.getElementById('a');
    const all = a.hits({ first: 0, last: 159 });
    const failure = (act) => {
      try {
        return act();
      } catch (error) {
        return String(error);
      }
    };
    return {
      count: all.length,
      same: JSON.stringify(all[80]) === JSON.stringify(a.hits(80)),
      list: a.trace([3, 999, 4]).map((one) => one?.column ?? null),
      alike: JSON.stringify(a.trace([12])[0]) === JSON.stringify(a.trace(12)),
      cast: a.cast({ map: 'room', x: 3.5, y: 3.5, z: 0.5, heading: 90 }),
      ofView: a.cast(a.currentView).end,
      range: failure(() => a.hits({ first: 4, last: 1 })),
      none: failure(() => a.hits('all')),
    };
  });
  assert.deepEqual([told.count, told.same, told.list, told.alike], [160, true, [3, null, 4], true]);
  assert.deepEqual(
    told.cast.tiles.map(({ tile, distance }) => [...tile, distance]),
    [
      [3, 3, 0],
      [3, 4, 0.5],
      [3, 5, 1.5],
      [3, 6, 2.5],
    ],
  );
  assert.deepEqual(
    told.cast.hits.map(({ blueprint, face, distance }) => [blueprint, face, distance]),
    [['wall', 'north', 2.5]],
  );
  assert.deepEqual(told.cast.end, { why: 'block', map: 'room', point: [3.5, 6], distance: 2.5 });
  assert.deepEqual(told.ofView.point, [6, 3.5]);
  assert.match(told.range, /^RangeError: hits: found columns from 4 to 1, expected a column, /);
  assert.match(told.none, /^RangeError: hits: found column all, expected a whole number, a list/);
});

test('setCell() changes the world of one element, and reset() undoes it', async (t) => {
  const page = await openRoom(
    t,
    '<ray-caster id="a" scene="room" size="160x100"></ray-caster><ray-caster id="b" scene="room" size="160x100"></ray-caster>',
  );
  await ready(page, 'b');
  assert.deepEqual(await elementPixel(page, 'a'), kGreen);
  const told = await page.evaluate(() => {
    const a = document.getElementById('a');
    const view = JSON.stringify(a.currentView);
    a.setCell('room', 0, 4, 3, '#');
    a.setCell('room', 0, 3, 0, '.');
    return {
      kept: JSON.stringify(a.currentView) === view,
      rows: a.cells('room', 0),
      ofB: document.getElementById('b').cells(),
      block: a.blueprints().map(({ character, name, faces }) => [character, name, faces.west]),
      depth: a.hits(80).hits[0].depth,
    };
  });
  assert.ok(told.kept);
  assert.deepEqual(told.rows.slice(0, 4), ['###.###', '#.....#', '#.....#', '#...#.#']);
  assert.deepEqual(told.ofB[0].slice(0, 4), ['#######', '#.....#', '#.....#', '#.....#']);
  assert.deepEqual(told.block, [
    ['#', 'wall', { texture: 'green', colour: '#28b43c', light: 1, glow: false, mirror: 0 }],
  ]);
  assert.equal(told.depth, 0.5);
  // The block is nearer now: where the sky was, it is.
  assert.deepEqual(await elementPixel(page, 'a', 0.5, 0.1), kGreen);
  assert.deepEqual(await elementPixel(page, 'b', 0.5, 0.1), kSky);

  // It is solid, and the player does not fly.
  const stopped = await page.evaluate(() => {
    const a = document.getElementById('a');
    a.step(240, { forward: 1 });
    const { x } = a.currentView;
    a.reset();
    return { x, rows: a.cells('room', 0) };
  });
  assert.ok(stopped.x < 4);
  assert.deepEqual(stopped.rows.slice(0, 4), ['#######', '#.....#', '#.....#', '#.....#']);
  assert.deepEqual(await elementPixel(page, 'a', 0.5, 0.1), kSky);
});

test('update() plays another text from the same place, or tells its faults', async (t) => {
  const page = await openRoom(t);
  const told = await page.evaluate(async () => {
    const a = document.getElementById('a');
    const text = await (await fetch('scenes/room.json')).text();
    const scene = JSON.parse(text);
    const fetched = () => performance.getEntriesByType('resource').length;
    a.look({ x: 2.5, y: 3.5, z: 0.8, heading: 30 });
    const before = JSON.stringify(a.currentView);
    const heard = [];
    for (const type of ['error', 'ready']) a.addEventListener(type, () => heard.push(type));
    a.set('fov', 75);
    const count = fetched();
    scene.title = 'Another';
    scene.maps[0].levels[0] = scene.maps[0].levels[0].map((row) => row.replaceAll('#', '.'));
    const good = await a.update(scene);
    const changed = {
      good,
      same: JSON.stringify(a.currentView) === before,
      fov: a.get('fov'),
      title: a.world.title,
      rows: a.cells('room', 0),
      fetched: fetched() - count,
    };
    const bad = await a.update(text.replace('"maps"', '"mops"'));
    const [first, second] = await Promise.all([a.update(text), a.update(scene)]);
    const broken = await a.update('{');
    return { ...changed, bad, first, second, broken, heard, state: a.state, last: a.world.title };
  });
  assert.deepEqual(told.good, { faults: [], warnings: [] });
  assert.ok(told.same);
  assert.equal(told.fov, '75');
  assert.equal(told.title, 'Another');
  assert.equal(told.rows[0], '.......');
  assert.equal(told.fetched, 0);
  assert.ok(told.bad.faults.some(({ pointer, found }) => pointer === '' || /mops/.test(found)));
  assert.equal(told.first, null);
  assert.deepEqual(told.second.faults, []);
  assert.equal(told.broken.faults.length, 1);
  assert.deepEqual([...new Set(told.heard)], ['ready']);
  assert.equal(told.last, 'Another');
  assert.equal(told.state, 'paused');
});

test('an eye inside of a new block stays where it is, and flies out', async (t) => {
  const page = await openRoom(t);
  const told = await page.evaluate(() => {
    const a = document.getElementById('a');
    const before = a.currentView;
    a.setCell(null, 0, 3, 3, '#');
    const kept = a.currentView;
    a.step(240, { forward: 1 });
    return { before, kept, out: a.currentView };
  });
  assert.deepEqual(told.kept, told.before);
  assert.ok(told.out.x > 4.2, `${told.out.x}`);
  assert.equal(told.out.z, told.before.z);
});

test('drawnColumns shows the picture with only so many slices drawn', async (t) => {
  const page = await openRoom(
    t,
    '<ray-caster id="a" scene="room" size="160x100" options="drawnColumns=40"></ray-caster>',
  );
  const notYet = [20, 22, 26];
  assert.deepEqual(await elementPixel(page, 'a', 0.1, 0.95), kGrey);
  assert.deepEqual(await elementPixel(page, 'a', 0.5), notYet);
  for (const [drawn, colour] of [
    [90, kGreen],
    [60, notYet],
    [-1, kGreen],
  ]) {
    await page.evaluate((count) => document.getElementById('a').set('drawnColumns', count), drawn);
    assert.deepEqual(await elementPixel(page, 'a'), colour, String(drawn));
  }
});

test('findMistakes() looks for more mistakes in a text, and leaves the game alone', async (t) => {
  const page = await openRoom(t);
  const told = await page.evaluate(async () => {
    const a = document.getElementById('a');
    const scene = await (await fetch('scenes/room.json')).json();
    const found = (mistakes) =>
      mistakes &&
      [mistakes.warnings, mistakes.spares].map((list) => list.map((one) => one.pointer));
    const sound = await a.findMistakes(scene);
    scene.title = 'Another';
    scene.blueprints.spare = scene.blueprints.wall;
    scene.maps[0].baked = {};
    scene.maps[0].light = {};
    const count = performance.getEntriesByType('resource').length;
    const bad = await a.findMistakes(scene);
    const fetched = performance.getEntriesByType('resource').length - count;
    const faulty = [await a.findMistakes('{'), await a.findMistakes('{}')];
    const both = await Promise.all([a.findMistakes(scene), a.findMistakes(scene)]);
    const [replaced] = await Promise.all([a.findMistakes(scene), a.update(scene)]);
    const last = await a.findMistakes(JSON.stringify(scene));
    return {
      sound,
      bad: found(bad),
      fetched,
      faulty,
      both: both.map(found),
      replaced,
      last: found(last),
      title: a.world.title,
    };
  });
  const none = { warnings: [], spares: [] };
  const mistakes = [['/maps/0/baked'], ['/blueprints/spare']];
  assert.deepEqual(told, {
    sound: none,
    bad: mistakes,
    fetched: 0,
    faulty: [none, none],
    both: [null, mistakes],
    replaced: null,
    last: mistakes,
    title: 'Another',
  });
});
