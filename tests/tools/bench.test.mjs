// What tools/bench makes of its measurements: the tables. Nothing is measured here.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { phasesTable, table } from '../../tools/bench-table.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const view = (title, ratio) => ({
  title,
  nsPerPixel: 12.345,
  spread: 0.2,
  ratio,
  walkShare: 0.5,
  replay: 12.34,
  phases: { setUp: 0.01, walk: 5, paint: 6, copy: 0.99 },
  large: { nsPerPixel: 9, spread: 0.1, ratio: 11.5 },
});
const run = (name) => ({
  name,
  title: 'Node, WebAssembly with SIMD',
  width: 1280,
  height: 720,
  rounds: 150,
  copy: { nsPerPixel: 0.07, spread: 0.1 },
  limit: {
    nsPerPixel: 0.6,
    spread: 0.1,
    ratio: 8.6,
    large: { width: 3840, height: 2160, nsPerPixel: 0.85, spread: 0.1 },
  },
  views: [view('castle, start', 2.5), view('garden, 10,000 objects, 100 seen', 13.25)],
  missed: ['garden, 10,000 objects, 100 seen'],
});

test('the tables of two builds fit a terminal of 120 columns and mark what misses its target', () => {
  const runs = [run('native'), run('wasm')];
  const lines = [...table(runs).split('\n'), ...phasesTable(runs).split('\n')];
  for (const line of lines) assert.ok(line.length <= 120, `${line.length}: ${line}`);
  const rowOf = (title) => lines.find((line) => line.startsWith(title));
  assert.match(rowOf('castle, start'), /(\s+12\.35\s+±10 %\s+2\.50\s+50 %\s+12\.34 11\.50){2}$/);
  assert.doesNotMatch(rowOf('castle, start'), /!/);
  assert.equal(rowOf('garden, 10,000').match(/13\.25!/g).length, 2);
});

for (const [words, message] of [
  [['--chekc'], /unknown option "--chekc"/],
  [['--rounds', '0'], /--rounds needs a number from 1 to 999999/],
  [['--json', '--overlays'], /--json and --overlays do not go together/],
]) {
  test(`tools/bench ${words.join(' ')} is refused at once`, () => {
    const { status, stderr } = spawnSync(`${root}tools/bench`, words, { encoding: 'utf8' });
    assert.equal(status, 1);
    assert.match(stderr, message);
  });
}
