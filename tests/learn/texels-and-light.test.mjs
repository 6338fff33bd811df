// The figures of the chapters on textures, floors, skies and light compute some things themselves,
// and their text claims some. The engine agrees.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import texel, { sideOf } from '../../web/learn/06-textures/texel.js';
import faces from '../../web/learn/06-textures/faces.js';
import down, { rowsAround } from '../../web/learn/06-textures/down.js';
import { levelAt } from '../../web/learn/07-far-away/detail.js';
import sparkle from '../../web/learn/07-far-away/sparkle.js';
import across from '../../web/learn/08-floor-and-ceiling/across.js';
import gradient from '../../web/learn/09-sky-looking-up/gradient.js';
import pixel from '../../web/learn/10-light-fog-night/pixel.js';
import { openingNow } from '../../web/learn/figures/draw.js';
import { nodeSource } from '../../web/learn/figures/source.js';

const kScenes = new URL('../../web/learn/scenes/', import.meta.url);
const kShipped = new URL('../../assets/scenes/here/', import.meta.url); // ../../textures from here

async function open(t, { scene, size = [480, 300] }) {
  const json =
    typeof scene === 'string' ? JSON.parse(await readFile(new URL(scene, kScenes), 'utf8')) : scene;
  const running = await load(json, { base: kShipped });
  t.after(() => running.free());
  return { running, source: nodeSource(running, { scene: json, size }) };
}

test('u is the fraction, or one minus it on northern and eastern sides', async (t) => {
  const { source } = await open(t, texel);
  for (const [view, face] of [
    ['8.37,7.9,0.5,275', 'south'],
    ['8.37,4.6,0.5,85', 'north'],
    ['7.2,6.37,0.5,5', 'west'],
    ['9.9,6.37,0.5,175', 'east'],
  ]) {
    const now = openingNow({ ...texel, view }, source, { row: 150 });
    const side = sideOf(now);
    assert.equal(side.face, face);
    const reversed = face === 'north' || face === 'east';
    const u = reversed ? 1 - side.share : side.share;
    assert.equal(side.u, Math.floor(u * 128), face);
    const facesNow = openingNow({ ...faces, view }, source);
    assert.match(faces.says(facesNow), new RegExp(`the ${face} side`));
    assert.equal(/1 minus/.test(faces.says(facesNow)), reversed);
  }
});

test('rows of a wall show the texels that the table computes', async (t) => {
  const { source } = await open(t, down);
  for (const row of [75, 96, 150, 200]) {
    const now = openingNow(down, source, { row });
    const { z, texel: shown } = rowsAround(now).find((each) => each.row === row);
    assert.equal(Math.floor(128 * (1 - z)), shown, `row ${row}`);
  }
});

test('levels of detail begin where the figures say', async (t) => {
  const { source } = await open(t, { scene: 'sparkle.json' });
  const now = openingNow({ rows: [], view: '4.5,1.5,0.5,90', options: { fov: 66 } }, source);
  const { projectionDistance } = now.slice;
  const seen = new Set();
  for (let row = 299; row > 155; --row) {
    const pick = source.pick(240, row);
    if (pick.what !== 'floor') continue;
    assert.equal(levelAt(pick.depth, 128, projectionDistance, 7), pick.texel.detail, `row ${row}`);
    seen.add(pick.texel.detail);
  }
  assert.deepEqual([...seen], [0, 1, 2, 3, 4]);
});

test('without levels of detail the distance flickers as much as the text says', async (t) => {
  const { running, source } = await open(t, sparkle);
  const now = openingNow(sparkle, source);
  const [width, height] = sparkle.size;
  const { horizonRow, projectionDistance, eye } = now.slice;
  const draw = (y) => {
    running.look({ ...now.eye, y });
    return source.pixels().data;
  };
  const share = (detail) => {
    running.set('detail', detail);
    let [all, changed] = [0, 0];
    for (let step = 0; step < 10; ++step) {
      const [before, after] = [draw(1.5 + 0.02 * step), draw(1.52 + 0.02 * step)];
      for (let row = 0; row < height; ++row) {
        const depth = (eye.z * projectionDistance) / (row + 0.5 - horizonRow);
        if (!(depth > 16 && depth < 64)) continue;
        for (let column = 100; column < 180; ++column, ++all) {
          const at = 4 * (row * width + column);
          if (Math.abs(before[at] - after[at]) > 16) changed += 1;
        }
      }
    }
    return (100 * changed) / all;
  };
  assert.equal(share('off').toFixed(0), '33');
  assert.equal(share('on').toFixed(1), '0.4');
});

test('a row shows the floor at the depth that the figure computes', async (t) => {
  const { source } = await open(t, across);
  for (const row of [190, 230, 299]) {
    const now = openingNow(across, source, { row });
    assert.equal(across.numbers.depth(now), now.pick.depth.toFixed(2));
  }
});

test('the sky’s colours are those of the picture', async (t) => {
  const { source } = await open(t, gradient);
  for (const row of [0, 30, 60]) {
    const now = openingNow(gradient, source, { row });
    assert.equal(now.pick.what, 'sky');
    const [red] = source.pixels().data.subarray(4 * (row * 480 + now.column));
    assert.equal(gradient.numbers.red(now), String(red), `row ${row}`);
  }
});

test('a pixel’s light and fog follow the formulas', async (t) => {
  const { source } = await open(t, pixel);
  const now = openingNow(pixel, source);
  const { light, fog } = source.scene.maps[0];
  const { depth, texel: shown, face } = now.pick;
  assert.equal(face, 'south');
  const bright = Math.min(1, Math.max(light.darkest, (1.5 * light.multiplier) / depth));
  assert.equal(shown.light, Math.floor(256 * bright + 0.5));
  const share = (depth - fog.start) / (fog.end - fog.start);
  assert.equal(shown.fog, Math.floor(255 * share + 0.5));
  assert.equal(pixel.numbers.north(now), '0.72');
});
