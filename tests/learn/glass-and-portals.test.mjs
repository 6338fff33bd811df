// The figures of the chapters on glass, gates, mirrors and portals compute some things themselves:
// where a gate is, where a ray meets a mirror, where the eye is behind a portal. The engine agrees.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { layOver, over } from '../../web/learn/16-see-through/blending.js';
import { panesAtEye } from '../../web/learn/16-see-through/joined.js';
import { blockAt, gate, kStepsPerSecond, offsetAt } from '../../web/learn/17-gates-lifts/motion.js';
import head from '../../web/learn/17-gates-lifts/head.js';
import { turned } from '../../web/learn/19-portals/turn.js';
import { openingNow } from '../../web/learn/figures/draw.js';
import { nodeSource } from '../../web/learn/figures/source.js';

const kSize = [480, 300];
const kScenes = new URL('../../web/learn/scenes/', import.meta.url);
const kShipped = new URL('../../assets/scenes/here/', import.meta.url); // ../../textures from here

async function open(t, scene) {
  const json = JSON.parse(await readFile(new URL(scene, kScenes), 'utf8'));
  const running = await load(json, { base: kShipped });
  t.after(() => running.free());
  return { running, source: nodeSource(running, { scene: json, size: kSize }) };
}

test('a pane is blended to the nearest whole number', () => {
  for (let alpha = 0; alpha <= 255; alpha += 3)
    for (let pane = 0; pane <= 255; pane += 5)
      for (let behind = 0; behind <= 255; behind += 7)
        assert.equal(
          over(pane, alpha, behind),
          Math.round((pane * alpha + behind * (255 - alpha)) / 255),
        );
  assert.deepEqual(layOver([80, 0, 255], 102, [200, 255, 0]), [152, 153, 102]);
});

test('joined blocks show two panes, single ones two each', async (t) => {
  const { source } = await open(t, 'panes.json');
  for (const [y, panes] of [
    [2.5, 2],
    [4.5, 6],
  ])
    assert.equal(
      panesAtEye(openingNow({ rows: [], view: `1.5,${y},0.5,0,0` }, source)).length,
      panes,
    );
});

test('the gate’s formula is the engine’s gate', async (t) => {
  const { running, source } = await open(t, 'yard-6.json');
  running.look('7.6,4.5,0.5,0,0');
  const now = { source };
  const bottoms = new Set();
  for (let step = 0; step < gate.period * kStepsPerSecond; step += 7) {
    const { bottom } = blockAt(now, { x: 9, y: 4.5 }, 'gate');
    const formula = offsetAt(gate, step / kStepsPerSecond);
    assert.ok(Math.abs(bottom - formula) < 2 / 65536, `step ${step}: ${bottom}, not ${formula}`);
    bottoms.add(bottom);
    running.step(7);
  }
  assert.ok(bottoms.size > 50);
});

test('the gate waits above the body that creeps through', async (t) => {
  const { source } = await open(t, head.scene);
  let waits = 0;
  for (let time = 600; time <= 860; time += 10) {
    const now = openingNow({ ...head, state: { ...head.state, time } }, source);
    const { bottom } = blockAt(now, { x: 9, y: 4.5 }, 'gate');
    const isBelow = now.eye.x + 0.2 > 10 && now.eye.x - 0.2 < 11;
    assert.ok(!isBelow || bottom >= 0.72, `${time}: ${bottom}`);
    if (isBelow && head.numbers.into(now) > 0) waits += 1;
  }
  assert.ok(waits > 10, String(waits));
});

test('a ray meets the mirror where similar triangles say', async (t) => {
  const { running, source } = await open(t, 'yard.json');
  running.look('1.4,4.8,0.5,357,-0.06,hall');
  let mirrored = 0;
  for (let row = 180; row < kSize[1]; row += 4) {
    const seen = source.pick(240, row);
    if (seen.what !== 'floor' || seen.reflection?.point == null) continue;
    const { depth, point } = seen.reflection;
    const meets = (depth * 0.5) / (0.5 + point[2]);
    assert.ok(Math.abs(seen.depth - meets) < 1e-3, `row ${row}: ${seen.depth}, not ${meets}`);
    mirrored += 1;
  }
  assert.ok(mirrored > 10, String(mirrored));
});

test('the eye behind a portal is turned about the middle of its tile', async (t) => {
  const { source } = await open(t, 'yard.json');
  for (const [view, column] of [
    ['13,3.4,0.5,0,0', 240],
    ['7.3,6.4,0.5,89,0', 240],
    ['2.7,4.6,0.5,268,0', 240],
  ]) {
    const now = openingNow({ rows: [], view, state: { column } }, source);
    const [{ from, to, turn }] = now.slice.portals;
    const offset = [now.eye.x - from.tile[0] - 0.5, now.eye.y - from.tile[1] - 0.5];
    const [x, y] = turned(offset, turn / 90);
    assert.ok(Math.abs(now.eyes[1].x - (to.tile[0] + 0.5 + x)) < 1e-4, view);
    assert.ok(Math.abs(now.eyes[1].y - (to.tile[1] + 0.5 + y)) < 1e-4, view);
    // The depths go on: from there, the first tile behind the portal has the portal's depth.
    const first = now.slice.walk.find(({ portals }) => portals === 1);
    assert.equal(first.depth, now.slice.portals[0].depth);
  }
});
