// The page and the engine split texts into the same signs.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { sceneOfRows } from '../../web/engine/rows.js';
import { signsOf } from '../../web/engine/signs.js';

// tests/scene/source_text_test.cpp reads the same list: texts with a space between their signs.
const list = readFileSync(new URL('../scene/signs.txt', import.meta.url), 'utf8')
  .trimEnd()
  .split('\n');

test('texts are split into signs as in the engine', () => {
  for (const line of list) assert.deepEqual(signsOf(line.replaceAll(' ', '')), line.split(' '));
  assert.deepEqual(signsOf(''), []);
  assert.deepEqual(signsOf('\ud83e#'), ['\ud83e', '#'], 'half a pair');
});

// The browser's own rule is finer where no key of a scene goes, as within Indian scripts.
test('signs that people type are those of Unicode', () => {
  const segmenter = new Intl.Segmenter('en', { granularity: 'grapheme' });
  const typed = list.filter((line) => !/[#x]\u200d|x\u0301|🇫$|^\u0301/u.test(line));
  assert.ok(typed.length > 14);
  for (const line of typed) {
    const text = line.replaceAll(' ', '');
    assert.deepEqual(
      signsOf(text),
      [...segmenter.segment(text)].map(({ segment }) => segment),
    );
  }
});

test('rows take signs of several characters as one tile', () => {
  const scene = sceneOfRows('❤️🇩🇪#\n>.❤️', {
    legend: { '❤️': '#c03020', '🇩🇪': 'brick floor', '1️⃣': '#' },
  });
  assert.deepEqual(scene.maps[0].levels, [['❤️.#', '..❤️']]);
  assert.equal(scene.legend['❤️'], 'block ❤️');
  assert.equal(scene.maps[0].floor.legend['🇩🇪'], 'brick');
  assert.throws(
    () => sceneOfRows('#👩🏽\n>.'),
    ({ faults }) => faults[0].message.startsWith('rows:1:2: found "👩🏽"'),
  );
  for (const open of ['🇩', '❤\u200d', '\u0301'])
    assert.throws(
      () => sceneOfRows('>#', { legend: { [open]: '#c03020' } }),
      ({ faults }) => /expected one that is printed/.test(faults[0].message),
      JSON.stringify(open),
    );
});
