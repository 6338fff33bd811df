// The figures of the chapters on walking, heights and objects compute some things themselves: where
// a body stops, which pillar is hidden, how large an object is. The engine agrees.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { kHalfWidth, solidOf, sweep } from '../../web/learn/11-walking/body.js';
import walkers, { walk } from '../../web/learn/11-walking/three-walkers.js';
import { laneEdits } from '../../web/learn/12-heights/lane.js';
import tops, { pillarsOf } from '../../web/learn/12-heights/tops.js';
import size, { seenAs } from '../../web/learn/15-objects/size.js';
import { openingNow } from '../../web/learn/figures/draw.js';
import { nodeSource } from '../../web/learn/figures/source.js';

const kSize = [480, 300];
const kScenes = new URL('../../web/learn/scenes/', import.meta.url);
const kShipped = new URL('../../assets/scenes/here/', import.meta.url); // ../../textures from here

async function open(t, scene) {
  const json =
    typeof scene === 'string' ? JSON.parse(await readFile(new URL(scene, kScenes), 'utf8')) : scene;
  const running = await load(json, { base: kShipped });
  t.after(() => running.free());
  return { running, source: nodeSource(running, { scene: json, size: kSize }) };
}

test('a body stops where the engine’s player stops', async (t) => {
  const { running, source } = await open(t, 'yard-2.json');
  const now = openingNow({ rows: [], view: '8.6,3.5,0.5,0' }, source);
  const solid = solidOf(now);
  const headings = { 0: ['x', 1], 90: ['y', 1], 180: ['x', -1], 270: ['y', -1] };
  let stopped = 0;
  // All ways end at blocks higher than a step, with nothing low before them.
  for (const [x, y] of [
    [8.6, 3.5],
    [7.4, 6.5],
    [7.4, 6.3],
    [9.2, 6.5],
    [8.5, 4.5],
    [12.5, 3.5],
    [13.3, 6.4],
  ]) {
    for (const [heading, [axis, sign]] of Object.entries(headings)) {
      const { way, border } = sweep(solid, { x, y, r: kHalfWidth }, axis, 2 * sign);
      if (border === null) continue;
      running.reset();
      running.look({ map: 'yard', x, y, z: 0.5, heading: Number(heading), look: 0 });
      running.step(240, { forward: 1 });
      const { x: toX, y: toY } = running.currentView;
      const moved = axis === 'x' ? toX - x : toY - y;
      assert.ok(Math.abs(moved - way) < 1e-4, `${x}, ${y}, ${heading}: ${moved}, not ${way}`);
      stopped += 1;
    }
  }
  assert.ok(stopped >= 10, String(stopped));
});

test('the walkers’ figure opens where its first walker ends', async (t) => {
  const { source } = await open(t, walkers.scene);
  const now = openingNow(walkers, source);
  const { x, y } = walk(solidOf(now), walkers.state.way, walkers.state.wish).at(-1);
  assert.deepEqual([now.eye.x, now.eye.y, now.eye.heading], [x, y, walkers.state.wish]);
});

test('a pillar is hidden if the engine fills no row with it', async (t) => {
  const { source } = await open(t, tops.scene);
  let hidden = 0;
  for (let i = 0; i < 120; ++i) {
    const heights = [i % 7, (5 * i + 2) % 11, (7 * i + 3) % 13];
    const z = 0.3 + 0.2 * (i % 5) + 0.03;
    const state = { ...tops.state, heights, edits: laneEdits(heights) };
    const now = openingNow({ ...tops, view: `0.5,1.5,${z},0`, state }, source);
    for (const { depth, top, isSeen, hiddenTo } of pillarsOf(now)) {
      if (top === 0 || Math.abs(top - hiddenTo) < 0.05) continue; // less than a row
      const sides = now.slice.hits
        .filter((hit) => Math.abs(hit.depth - depth) < 1e-4)
        .flatMap(({ filled }) => filled.filter(({ what }) => what === 'side'));
      assert.equal(sides.length > 0, isSeen, `${heights} at ${z}: the one at ${depth}`);
      if (!isSeen) hidden += 1;
    }
  }
  assert.ok(hidden > 30, String(hidden));
});

test('an object has the depth and the rows that the engine gives it', async (t) => {
  const { source } = await open(t, size.scene);
  for (const view of ['2.2,4.6,0.5,345', '4.1,1.2,1.3,50', '6.5,6.4,0.3,268', '9.1,3.4,0.8,181']) {
    const now = openingNow({ ...size, view }, source);
    const { depth, left, end, head, feet } = seenAs(now);
    const column = Math.round((left + end) / 2);
    const [object] = source.trace(column).objects;
    assert.ok(Math.abs(object.depth - depth) < 1e-4, view);
    assert.ok(Math.abs(object.first - Math.max(0, head)) <= 1, view);
    assert.ok(Math.abs(object.last + 1 - Math.min(kSize[1], feet)) <= 1, view);
    for (const [at, isMet] of [
      [left - 2, false],
      [left + 2, true],
      [end - 3, true],
      [end + 2, false],
    ]) {
      if (at < 0 || at >= kSize[0]) continue;
      assert.equal(source.trace(Math.round(at)).objects.length > 0, isMet, `${view}: ${at}`);
    }
  }
});
