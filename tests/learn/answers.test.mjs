// What comes out of the frame of a reader's program is checked before the page uses it.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import fc from 'fast-check';

import { checkedAnswer, checkedError } from '../../web/learn/write/answers.js';

const kSize = { width: 4, height: 2 };
const kPixels = new Uint8ClampedArray(32);
const kView = { map: 'yard', x: 1, y: 2, z: 0.5, heading: 30, look: 0 };
const kDifference = {
  ...{ column: 3, row: 1, mine: [1, 2, 3], engine: [255, 0, 9], what: 'the sky', ray: [1, 0.2] },
  walk: { mine: [{ x: 1, y: 'one' }], engine: [{ x: 1, y: 2, near: 0 }], first: null },
};
const kAsked = {
  run: {},
  draw: kSize,
  check: {},
  explain: { mine: kSize },
  move: { view: kView },
};
const checked = (action, answer) => checkedAnswer(action, kAsked[action], answer);

test('Answers as the worker gives them pass, with the fields that are used', () => {
  assert.deepEqual(checked('run', { leftOut: [] }), {});
  assert.deepEqual(checked('draw', { milliseconds: 1, picture: { ...kSize, data: kPixels } }), {
    picture: { ...kSize, data: kPixels },
  });
  const checks = [{ name: 'rowOf', ok: false, says: '`rowOf` is not there.' }];
  assert.deepEqual(checked('check', { checks }), { checks });
  assert.deepEqual(checked('explain', { difference: null }), { difference: null });
  const { difference } = checked('explain', { difference: kDifference });
  // What the reader's own functions return may be anything.
  assert.deepEqual(difference.walk.mine, [{ x: 1, y: undefined, near: undefined }]);
  assert.deepEqual({ ...difference, walk: kDifference.walk }, kDifference);
  const moved = { ...kView, x: 3, map: 'elsewhere', more: 1 };
  assert.deepEqual(checked('move', { view: moved }), { view: { ...kView, x: 3 } });
  assert.deepEqual(checkedError({ name: 'Error', message: 'x', line: 2, column: 1 }), {
    ...{ name: 'Error', message: 'x', line: 2, column: 1, isEnd: false },
  });
});

test('Anything else is refused', () => {
  const away = '0) url(http://host/leak';
  for (const [action, answer] of [
    ['draw', { picture: { width: 1e9, height: 1e9, data: 'x' } }],
    ['draw', { picture: { ...kSize, data: new Uint8ClampedArray(33) } }],
    ['draw', { picture: { ...kSize, data: new Uint8Array(32) } }],
    ['draw', {}],
    ['draw', null],
    ['check', { checks: 'no' }],
    [
      'check',
      { checks: Array.from({ length: 300000 }, () => ({ name: 'f', ok: true, says: '' })) },
    ],
    ['check', { checks: [{ name: '"] , *', ok: false, says: '' }] }],
    ['check', { checks: [{ name: 'f', ok: false, says: { length: 1 } }] }],
    ['check', { checks: [null] }],
    ['explain', { difference: 5 }],
    ['explain', {}],
    ...[
      ...[{ mine: ['0', '0', away] }, { engine: [0, 0, 256] }, { mine: [0, 0] }, { column: 4 }],
      ...[{ row: 0.5 }, { column: '1' }, { what: 7 }, { ray: [1] }, { ray: [NaN, 1] }, { walk: 1 }],
      ...[{ walk: { mine: 1, engine: [], first: null } }, { walk: undefined }],
    ].map((change) => ['explain', { difference: { ...kDifference, ...change } }]),
    ['move', { view: { ...kView, x: NaN } }],
    ['move', { view: { ...kView, y: 1e9 } }],
    ['move', { view: { ...kView, z: '1' } }],
    ['move', { view: null }],
  ])
    assert.throws(() => checked(action, answer), undefined, JSON.stringify(answer).slice(0, 200));
  for (const error of [null, 'x', {}, { name: 'E', message: 'm', line: -1, column: 0 }])
    assert.throws(() => checkedError(error));
});

test('Whatever is answered, a picture, colours and places are numbers in their ranges', () => {
  const part = fc.oneof(fc.anything(), fc.integer({ min: -1, max: 300 }), fc.double());
  const shaped = fc.record({
    ...{ column: part, row: part, mine: fc.array(part), engine: fc.array(part), what: fc.string() },
    ...{ ray: fc.array(part), walk: fc.constantFrom(null, kDifference.walk) },
  });
  fc.assert(
    fc.property(fc.oneof(shaped, fc.anything()), (difference) => {
      let found;
      try {
        ({ difference: found } = checked('explain', { difference }));
      } catch {
        return;
      }
      if (found === null) return;
      for (const value of [found.column, found.row, ...found.mine, ...found.engine])
        assert.ok(Number.isInteger(value) && value >= 0 && value <= 255);
      assert.ok(found.column < kSize.width && found.row < kSize.height);
    }),
    { numRuns: 2000 },
  );
});
