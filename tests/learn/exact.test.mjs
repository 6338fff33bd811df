// The models of the chapters Speed and Exact: what they compute themselves agrees with the engine,
// and with what the text says.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { addresses, Cache, missesEachPixel, setsOfColumn } from '../../web/learn/21-speed/cache.js';
import { agreements, blockOn, tiesIn } from '../../web/learn/22-exact/ties.js';
import { load } from '../../build/web/node/index.js';

const kScene = new URL('../../web/learn/scenes/corner.json', import.meta.url); // plain colours
const kSize = { width: 481, height: 301 };
const kMiddle = 240;

async function cornerScene() {
  const scene = await load(fileURLToPath(kScene));
  const blueprints = new Map(scene.blueprints('corner').map((each) => [each.character, each]));
  return { scene, blueprints, cells: scene.cells('corner', 0) };
}

test('the rule for corners finds the blocks that the engine finds', async () => {
  const { scene, blueprints, cells } = await cornerScene();
  for (let heading = 0; heading < 360; heading += 15) {
    scene.look({ map: 'corner', x: 5, y: 5, z: 0.5, heading, look: 0 });
    const columns = Array.from({ length: kSize.width }, (_, column) => column);
    for (const slice of scene.trace(columns, kSize)) {
      const { tile } = blockOn(slice, cells, blueprints, 'exact');
      assert.deepEqual(tile, slice.hits[0].tile, `heading ${heading}, column ${slice.column}`);
    }
  }
  scene.free();
});

test('on diagonals the middle column meets corners, and wrong rules see other blocks', async () => {
  const { scene, blueprints, cells } = await cornerScene();
  const seen = (heading, rule) => {
    scene.look({ map: 'corner', x: 5, y: 5, z: 0.5, heading, look: 0 });
    const slice = scene.trace(kMiddle, kSize);
    assert.ok(tiesIn(slice).length >= 2, `heading ${heading}`);
    return blockOn(slice, cells, blueprints, rule).tile.join();
  };
  const differs = (rule) =>
    [45, 135, 225, 315].filter((heading) => seen(heading, 'exact') !== seen(heading, rule));
  assert.deepEqual(differs('always'), [135, 225]);
  assert.deepEqual(differs('both'), [45, 135, 225, 315]);
  scene.free();
});

test('quotients agree at every corner, sums do not', () => {
  const wrong = (list, way) => list.filter((each) => each[way][0] !== each[way][1]).length;
  for (const rounded of [Math.fround, (number) => number])
    for (let right = 1; right <= 40; ++right)
      for (let down = 1; down <= 40; ++down)
        assert.equal(wrong(agreements(right, down, 20, rounded), 'quotients'), 0);
  assert.equal(wrong(agreements(240, 80, 100), 'sums'), 93);
  assert.equal(wrong(agreements(2, 1, 100), 'sums'), 0);
  assert.equal(
    Array.from({ length: 7 }, () => 1 / 7).reduce((sum, part) => sum + part),
    0.9999999999999998,
  );
});

test('the cache: rows wait once a line, columns as their sets allow', () => {
  const misses = (order, isPadded) => missesEachPixel({ order, width: 480, height: 300, isPadded });
  assert.equal(misses('rows', false), 1 / 16);
  assert.equal(misses('columns', false), 1);
  assert.equal(misses('columns', true), 1 / 16);
  assert.ok(misses('strip', false) < 0.1);
});

test('a column falls into as many sets as the formula says', () => {
  for (const width of [320, 480, 512, 640, 1280])
    for (const isPadded of [false, true]) {
      const cache = new Cache();
      const sets = new Set();
      let count = 0;
      for (const address of addresses({ order: 'columns', width, height: 300, isPadded })) {
        if (++count > 300) break;
        sets.add(cache.touch(address).set);
      }
      assert.equal(sets.size, setsOfColumn(width, isPadded), `width ${width}, ${isPadded}`);
    }
});
