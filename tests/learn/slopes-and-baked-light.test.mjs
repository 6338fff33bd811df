// The figures of the chapters on slopes and on baked light compute horizons, rows and light
// themselves, and draw pictures. The engine agrees.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { drawRamps, rampsOf } from '../../web/learn/23-slopes/by-hand.js';
import { kFoot, kFov as kRampFov, kHead, planeOf } from '../../web/learn/23-slopes/plane.js';
import rows from '../../web/learn/23-slopes/rows.js';
import walk from '../../web/learn/23-slopes/walk.js';
import { byNodes, bySunRays, drawWorld, litWorld } from '../../web/learn/24-baked-light/tracer.js';
import { openingNow } from '../../web/learn/figures/draw.js';
import { placeOf } from '../../web/learn/figures/kit.js';
import { nodeSource } from '../../web/learn/figures/source.js';
import { openScene } from './reader.mjs';

const kSize = { width: 240, height: 150 };
const kFov = 66; // of the court

async function open(t, name) {
  const opened = await openScene(name);
  t.after(() => opened.engine.free());
  return { ...opened, source: nodeSource(opened.engine, { scene: opened.scene }) };
}

const blank = () => ({ ...kSize, data: new Uint8ClampedArray(4 * kSize.width * kSize.height) });

// The share of pixels whose channels differ by at most 1.
function alike(mine, engine) {
  let same = 0;
  for (let at = 0; at < mine.length; at += 4)
    if ([0, 1, 2].every((c) => Math.abs(mine[at + c] - engine[at + c]) <= 1)) same += 1;
  return (4 * same) / mine.length;
}

function look(engine, view, fov = kFov) {
  const options = { fov, detail: 'off', light: 'off', baked: 'on' };
  for (const [name, value] of Object.entries(options)) engine.set(name, value);
  engine.look(view);
  return engine.pixels(kSize).data;
}

const kRamps = [
  '1.5,4.5,0.5,0',
  '2.4,6.4,0.8,320',
  '3.6,7.9,0.5,300',
  '10.5,2.2,1.4,160,-0.1',
  '7.5,10.2,2.6,250,-0.3',
];

test('ramps drawn under their own horizons are the engine’s, and mistakes are not', async (t) => {
  const { engine, scene, world } = await open(t, 'ramps.json');
  const ramps = rampsOf(world, scene);
  const worst = { right: 1, middle: 1, flat: 1, sign: 1 };
  for (const view of kRamps) {
    const picture = look(engine, view, kRampFov);
    for (const mistake of Object.keys(worst)) {
      const mine = blank();
      drawRamps(mine, ramps, engine.currentView, mistake === 'right' ? null : mistake);
      worst[mistake] = Math.min(worst[mistake], alike(mine.data, picture));
    }
  }
  t.diagnostic(JSON.stringify(worst));
  assert.ok(worst.right > 0.999, `right: ${worst.right}`);
  for (const mistake of ['middle', 'flat', 'sign'])
    assert.ok(worst[mistake] < 0.97, `${mistake}: ${worst[mistake]}`);
});

test('the rows of a ramp are the engine’s, and its sight lines end on it', async (t) => {
  const { source } = await open(t, 'ramps.json');
  let above = 0;
  for (const heading of [350, 0, 8, 20])
    for (const column of [100, 240, 400]) {
      const now = openingNow(rows, source, {
        column,
        eye: { ...source.view, x: 1.5, y: 3.6, z: 0.5, heading },
      });
      const plane = planeOf(now);
      for (const hit of now.slice.hits.filter(({ blueprint }) =>
        /(low|high) ramp/.test(blueprint),
      )) {
        assert.ok(Math.abs(plane.rowAt(hit.depth) - hit.topFrontRow) < 1e-6);
        assert.ok(Math.abs(plane.rowAt(hit.backDepth) - hit.topBackRow) < 1e-6);
      }
      for (const run of now.slice.runs) {
        if (run.what !== 'roof' || !/(low|high) ramp/.test(now.slice.hits[run.hit].blueprint))
          continue;
        if (run.first < now.slice.horizonRow) above += 1;
        const middle = run.first + 0.5;
        const { depth, z } = placeOf(run, middle, now.slice);
        assert.ok(Math.abs(depth - run.texels[0].depth) < 1e-6, 'depth');
        const x = now.slice.eye.x + depth * now.slice.ray[0];
        assert.ok(x > kFoot - 1e-6 && x < kHead + 1e-6);
        assert.ok(Math.abs(z - (x - kFoot) / 2) < 1e-6, 'height');
      }
    }
  assert.ok(above > 4, 'rows above the true horizon');
});

test('the side view draws ramps with slanted tops', async (t) => {
  const { source } = await open(t, 'ramps.json');
  const now = openingNow(rows, source);
  const [side] = rows.rows[1];
  const drawn = side.markup(now, { width: 600, height: 280, id: 'side' });
  const ramps = [...drawn.matchAll(/<polygon points="([^"]+)" class="fig-solid/g)];
  assert.equal(
    ramps.length,
    now.slice.hits.filter(({ blueprint }) => /(low|high) ramp/.test(blueprint)).length,
  );
  for (const [, points] of ramps) {
    const [front, back] = points.split(' ').map((point) => Number(point.split(',')[1]));
    assert.ok(back < front - 5, points);
  }
});

test('bodies walk up the gentle ramp, stay on it, and slide down the steep one', async (t) => {
  const { source } = await open(t, 'ramps.json');
  const [up, stay, slide] = walk.controls
    .filter(({ kind }) => kind === 'button')
    .map(({ press }) => press());
  const after = (change, time) =>
    openingNow(walk, source, { ...change, eye: { ...source.view, ...change.eye }, time }).eye;
  assert.ok(after(up, 170).z > 1.4, 'up');
  assert.ok(Math.abs(after(stay, 240).x - 5) < 0.01, 'stays');
  // On the highest point that it touches, 0.2 ahead
  assert.ok(Math.abs(after(stay, 240).z - 0.5 - (5.2 - kFoot) / 2) < 0.001, 'its feet');
  const end = after(slide, 240);
  assert.ok(end.x > 9 && Math.abs(end.z - 0.5) < 0.02, 'slides');
});

const kLit = [
  '10.8,7.8,1.2,225,-0.1',
  '5.6,3.7,0.75,168,-0.16',
  '11.2,11.2,4.6,245,-0.42',
  '8.5,2.2,0.6,20',
  '8.3,6.3,0.3,350',
];

test('light between nodes is the engine’s, and other ways are not', async (t) => {
  const { engine, scene, world } = await open(t, 'sunlit.json');
  const lit = litWorld(world, scene);
  const ways = {
    right: byNodes(lit.lightOf(), lit.map),
    'not linked': byNodes(lit.lightOf({ linked: false }), lit.map),
    coarse: byNodes(lit.lightOf({ squares: 1 }), lit.map),
    fine: byNodes(lit.lightOf({ squares: 4 }), lit.map),
  };
  const worst = Object.fromEntries(Object.keys(ways).map((name) => [name, 1]));
  for (const view of kLit) {
    const picture = look(engine, view);
    for (const [name, way] of Object.entries(ways)) {
      const mine = blank();
      drawWorld(mine, lit, engine.currentView, kFov, way);
      const share = alike(mine.data, picture);
      worst[name] = Math.min(worst[name], share);
    }
  }
  t.diagnostic(JSON.stringify(worst));
  assert.ok(worst.right > 0.995, `right: ${worst.right}`);
  for (const name of ['not linked', 'coarse', 'fine'])
    assert.ok(worst[name] < 0.97, `${name}: ${worst[name]}`);
});

test('without lift, pixels in the sun darken, and none brightens', async (t) => {
  const { engine, scene, world } = await open(t, 'sunlit.json');
  const lit = litWorld(world, scene);
  engine.look(kLit[0]);
  const [lifted, flat] = [16 / 65536, 0].map((lift) => {
    const picture = blank();
    drawWorld(picture, lit, engine.currentView, kFov, bySunRays(lit.lightOf(), lift));
    return picture.data;
  });
  let darker = 0;
  let brighter = 0;
  for (let at = 0; at < flat.length; at += 4) {
    if (flat[at] < lifted[at]) darker += 1;
    if (flat[at] > lifted[at]) brighter += 1;
  }
  t.diagnostic(`${darker} darker, ${brighter} brighter`);
  assert.ok(darker > 500, String(darker));
  assert.equal(brighter, 0);
});
