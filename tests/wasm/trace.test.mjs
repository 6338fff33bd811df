// Traces as JavaScript gets them: of every shipped scene, the picture's texels and the arithmetic
// of the walk.

import assert from 'node:assert/strict';
import { basename } from 'node:path';
import { test } from 'node:test';

import { withBytes } from '../../build/web/engine/module-memory.js';
import { flavours, loadModule, roomScene, Session, shippedScenes, textureBytes } from './load.mjs';

const kWidth = 96;
const kHeight = 60;

test('in a room the numbers are as measured on paper', async () => {
  const session = new Session(await loadModule('simd'));
  assert.deepEqual(
    session.loadText(roomScene(), 'room.json', () => textureBytes),
    [],
  );
  assert.ok(session.setEye({ x: 2.5, y: 3.25, z: 0.5 }));
  for (const column of [0, 31, 63, 95]) {
    const trace = session.trace(kWidth, kHeight, column);
    const d = kWidth / 2 / Math.tan(Math.PI / 6);
    const sideways = (column + 0.5 - kWidth / 2) / d;
    assert.ok(Math.abs(trace.projectionDistance - d) < 1e-9);
    assert.deepEqual(
      [trace.scene, trace.size, trace.column, trace.eye.x, trace.ray[0]],
      ['A room', [kWidth, kHeight], column, 2.5, 1],
    );
    assert.ok(Math.abs(trace.ray[1] - sideways) < 1e-12);

    // The walk
    trace.walk.forEach(({ tile, axis, distance, speed, along, depth, next }, index) => {
      if (index === 0) return assert.deepEqual([tile, axis, depth], [[2, 3], null, 0]);
      const before = trace.walk[index - 1];
      const which = axis === 'x' ? 0 : 1;
      const [x, y] = [0, 1].map((i) => tile[i] - before.tile[i]);
      assert.deepEqual([Math.abs(x), Math.abs(y)], axis === 'x' ? [1, 0] : [0, 1]);
      const [eye, ray] = [[2.5, 3.25][which], trace.ray[which]];
      assert.equal(distance, ray > 0 ? tile[which] - eye : eye - tile[which] - 1);
      assert.ok(Math.abs(speed - d * Math.abs(ray)) < 1e-9);
      assert.equal(along, distance / speed);
      assert.equal(along, Math.min(...before.next.map((number) => number ?? Infinity)));
      assert.equal(depth, along * trace.projectionDistance);
      assert.equal(next.length, 2);
    });

    // The wall in the east is 4.5 units away for every column that meets it: no fish eye.
    const side = trace.runs.find(({ what }) => what === 'side');
    if (side.face !== 'west') continue;
    const [upper, lower] = side.texels;
    assert.deepEqual(
      [side.texture, side.layer, upper.row, lower.row, trace.hits[side.hit].tile[0]],
      ['brick', false, side.first, side.last, 7],
    );
    assert.ok(Math.abs(upper.depth - 4.5) < 1e-9);
    const y = 3.25 + 4.5 * sideways;
    assert.equal(upper.u, Math.floor((y - Math.floor(y)) * upper.size[0]));
    for (const { row, v, size } of side.texels)
      assert.equal(v, Math.floor((0.5 - ((kHeight / 2 - (row + 0.5)) * 4.5) / d) * size[1]));
  }
});

test('a picture in one trace: every row of every column has its kind', async () => {
  for (const flavour of flavours) {
    const session = new Session(await loadModule(flavour));
    for (const scene of shippedScenes) {
      assert.deepEqual(session.load(scene), []);
      const { columns, totals, textures, times, size } = session.trace(kWidth, kHeight, -1);
      assert.deepEqual(size, [kWidth, kHeight]);
      assert.equal(times, null);
      for (let column = 0; column < kWidth; ++column) {
        assert.equal(
          Object.values(columns.rows).reduce((sum, rows) => sum + rows[column], 0),
          kHeight,
          `${basename(scene)}, column ${column}`,
        );
      }
      assert.ok(totals.rowsFilled >= kWidth * kHeight && totals.tilesWalked >= kWidth);
      assert.ok(
        textures.length > 0 &&
          textures.every(
            ({ name, kind, texels }) =>
              name !== '' &&
              ['texture', 'sprite'].includes(kind) &&
              texels.some((number) => number > 0),
          ),
      );
      const column = session.trace(kWidth, kHeight, 40);
      const depths = column.runs
        .filter(({ hit, object }) => hit !== null || object !== null)
        .flatMap(({ texels }) => texels.map(({ depth }) => depth));
      assert.equal(columns.nearest[40], depths.length === 0 ? null : Math.min(...depths));
      assert.deepEqual(
        Object.fromEntries(
          Object.keys(session.hits(kWidth, kHeight, 40)).map((key) => [key, column[key]]),
        ),
        session.hits(kWidth, kHeight, 40),
      );
    }
  }
});

test('there is no trace without a game, or of a column beyond the picture', async () => {
  const session = new Session(await loadModule('simd'));
  assert.equal(session.trace(kWidth, kHeight, 0), null);
  session.loadText(roomScene(), 'room.json', () => textureBytes);
  assert.equal(session.trace(kWidth, kHeight, kWidth), null);
  assert.equal(session.trace(0, kHeight, -1), null);
});

test('a request for more columns than the widest picture has is refused', async () => {
  const module = await loadModule('simd');
  const session = new Session(module);
  assert.deepEqual(
    session.loadText(roomScene(), 'room.json', () => textureBytes),
    [],
  );
  const kMost = 8192;
  const ask = (method, count) =>
    withBytes(module, new Uint8Array(4 * count), (at) =>
      module[`_slicecast_${method}`](session.address, kWidth, kHeight, at, count),
    );
  for (const method of ['hits', 'trace']) {
    assert.notEqual(ask(method, kMost), 0);
    assert.equal(ask(method, kMost + 1), 0);
  }
});
