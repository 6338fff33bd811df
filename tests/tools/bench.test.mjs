// How tools/bench reports: the tables, the views, the file of past ratios, and when --check calls
// something a loss. Nothing is measured here.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import {
  check,
  compare,
  figuresOf,
  ratiosText,
  readRatios,
  recordFor,
  reportOf,
} from '../../tools/bench-ratios.mjs';
import { againstTable, phasesTable, table } from '../../tools/bench-table.mjs';
import { moments, mostOf, scenes, views, viewsLike } from '../../tools/bench-views.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const kFile = 'ratios.json';
const then = { native: 2, wasm: 3 };
const record = {
  date: '2026-11-23',
  commit: 'Walls stand closer',
  processor: 'AMD EPYC',
  rounds: 25,
  views: { 'castle, start': then, 'garden, start': then },
};
const same = { 'castle, start': then, 'garden, start': then };
const slower = { ...same, 'garden, start': { ...then, wasm: 3.6 } };

const view = (title, ratio) => ({
  title,
  nsPerPixel: 12.345,
  spread: 0.1,
  ratio,
  most: 3,
  walkShare: 0.5,
  replay: 12.34,
  phases: { setUp: 0.01, walk: 6, paint: 5, copy: 0.99 },
});
const run = (name) => ({
  name,
  title: 'Node, WebAssembly with SIMD',
  width: 1280,
  height: 720,
  rounds: 25,
  copy: { nsPerPixel: 0.07, spread: 0.1 },
  limit: { nsPerPixel: 0.6, spread: 0.1, ratio: 8.6, most: 10 },
  views: [view('castle, start', 2.5), view('10,000 objects, 100 seen', 13.25)],
});

test('the tables of two builds fit a terminal of 120 columns and mark what misses its target', () => {
  const runs = [run('native'), run('wasm')];
  const lines = [...table(runs).split('\n'), ...phasesTable(runs).split('\n')];
  for (const line of lines) assert.ok(line.length <= 120, `${line.length}: ${line}`);
  const rowOf = (title) => lines.find((line) => line.startsWith(title));
  assert.match(rowOf('castle, start'), /(\s+12\.35\s+10 %\s+2\.50\s+3\.00\s+50 %\s+12\.34){2}$/);
  assert.doesNotMatch(rowOf('castle, start'), /!/);
  assert.equal(rowOf('10,000').match(/13\.25!/g).length, 2);
});

test('records are read as they were written, one line per view', () => {
  const text = ratiosText([record, { ...record, date: '2026-11-24' }]);
  assert.deepEqual(readRatios(text, kFile), [record, { ...record, date: '2026-11-24' }]);
  assert.equal(text.match(/^ {8}"castle, start": \{.*\},?$/gm).length, 2);
});

test('two builds are compared view by view', () => {
  const that = run('native');
  const here = { ...that, views: that.views.map((one) => ({ ...one, nsPerPixel: 6 })) };
  assert.match(againstTable([[that, here]]), /^castle, start\s+12\.35\s+6\.00\s+-51\.4 %$/m);
});

test('the past ratios of this repository can be read', () => {
  const name = 'tests/bench/ratios.json';
  readRatios(readFileSync(`${root}${name}`, 'utf8'), name);
});

test('every tour has its slowest moment, one of its steps', () => {
  const tours = scenes.filter(({ tour }) => tour).map(({ scene }) => scene);
  assert.deepEqual(Object.keys(moments).sort(), tours.sort());
  for (const scene of tours) {
    const tour = readFileSync(`${root}assets/tours/${scene}.txt`, 'utf8');
    const steps = Number(/^end (\d+)/m.exec(tour)[1]);
    assert.ok(moments[scene] > 0 && moments[scene] <= steps, scene);
  }
});

test('views are found by words of their titles, however they are written', () => {
  const namesLike = (...words) => viewsLike(words).map(({ name }) => name);
  assert.deepEqual(namesLike('Water Palace'), [
    'water-palace',
    `water-palace@${moments['water-palace']}`,
  ]);
  assert.deepEqual(namesLike('castle, start', 'flat hall'), ['castle', 'flat hall']);
  assert.deepEqual(viewsLike([]), views);
  assert.deepEqual(namesLike('nowhere'), []);
});

test('more is asked natively, and less of a tour than of a start', () => {
  const { title } = views.find(({ name }) => name.startsWith('castle@'));
  assert.ok(mostOf('castle, start', 'native') < mostOf('castle, start', 'wasm'));
  assert.ok(mostOf('castle, start', 'wasm') < mostOf(title, 'wasm'));
  assert.equal(mostOf('hill-abbey, start', 'wasm').toFixed(2), '13.81');
  assert.equal(mostOf('100 objects', 'wasm'), Infinity);
});

for (const [what, text, message] of [
  [
    'a comma too many',
    '{"records": [\n  {"date": "x",}]}',
    'ratios.json:2:16: found "}", expected ',
  ],
  [
    'a merge that was not finished',
    '{"records": [\n<<<<<<< HEAD\n]}',
    'ratios.json:2:1: found "<", expected JSON',
  ],
  ['half a file', '{"records":', 'ratios.json:1:12: found the end, expected JSON'],
  ['no list', '{}', 'ratios.json: records: found nothing, expected a list of records'],
  ['null', 'null', 'ratios.json: records: found nothing, expected a list of records'],
  [
    'no processor',
    ratiosText([{ ...record, processor: undefined }]).replace('"processor": undefined, ', ''),
    'ratios.json: records[0].processor: found nothing, expected a text',
  ],
  [
    'a ratio in words',
    ratiosText([{ ...record, views: { 'castle, start': { native: 'fast' } } }]),
    'ratios.json: records[0].views["castle, start"]["native"]: found "fast", expected a number above 0',
  ],
]) {
  test(`a bad file is refused, and the message says where: ${what}`, () => {
    assert.throws(
      () => readRatios(text, kFile),
      (error) => error.message.startsWith(message) || assert.equal(error.message, message),
    );
  });
}

test('the figures of the builds are merged by view', () => {
  const figures = figuresOf([run('native'), run('wasm')]);
  assert.deepEqual(figures['castle, start'], { native: 2.5, wasm: 2.5 });
});

test('the record is the newest of this processor, else the newest of any', () => {
  const other = { ...record, processor: 'another' };
  const newer = { ...record, date: '2026-12-01' };
  assert.equal(recordFor([record, newer, other], 'AMD EPYC'), newer);
  assert.equal(recordFor([record, newer, other], 'a third one'), other);
});

test('a loss of more than 10 % counts, one of 10 % does not', () => {
  const at = (wasm) => compare(record, { 'castle, start': { ...then, wasm } }).losses;
  assert.deepEqual(at(3.3), []);
  assert.deepEqual(at(3.31), [{ title: 'castle, start', figure: 'wasm', then: 3, now: 3.31 }]);
});

test('a view without a record is reported, but is not a loss', () => {
  const found = compare(record, { ...same, 'a new view': then });
  assert.deepEqual(found, { losses: [], unknown: ['a new view'] });
});

// Returns these measurements one after another, and notes which titles were asked for.
function measurements(...results) {
  const asked = [];
  const measure = (titles) => {
    asked.push(titles);
    return results[asked.length - 1];
  };
  return { asked, measure };
}

test('without a suspected loss everything is measured once', () => {
  const { asked, measure } = measurements(same);
  const result = check(record, measure);
  assert.deepEqual(asked, [null]);
  assert.match(
    reportOf(result, record, 'AMD EPYC'),
    /^None of 2 views is more than 10 % slower since 2026-11-23 \(Walls stand closer\)\.$/,
  );
});

test('a view that seems slower is measured again, and named if it still is', () => {
  const { asked, measure } = measurements(slower, slower);
  const result = check(record, measure);
  assert.deepEqual(asked, [null, ['garden, start']]);
  assert.equal(result.losses.length, 1);
  assert.match(
    reportOf(result, record, 'AMD EPYC'),
    /garden, start, wasm: then 3\.00, now 3\.60 \(\+20 %\)$/,
  );
});

test('noise is not a loss: slow only the first time, or only the second time', () => {
  for (const again of [same, { ...same, 'castle, start': { ...then, wasm: 4 } }])
    assert.deepEqual(check(record, measurements(slower, again).measure).losses, []);
});

test('the report warns about a record of another processor', () => {
  const result = check(record, measurements(same).measure);
  assert.match(
    reportOf(result, record, 'Z80'),
    /^Recorded on another processor \(AMD EPYC; this is Z80\): ratios differ/,
  );
});

for (const [words, message] of [
  [['--chekc'], /unknown option "--chekc"/],
  [['--rounds', '0'], /--rounds needs a number from 1 to 999999/],
  [['--check', '--record'], /--check and --record cannot be combined/],
  [['--against', 'nowhere'], /--against needs a folder with builds/],
  [['--record', '--view', 'castle'], /--record measures all views/],
  [['--record', '--native'], /--record measures every build/],
]) {
  test(`tools/bench ${words.join(' ')} is refused at once`, () => {
    const { status, stderr } = spawnSync(`${root}tools/bench`, words, { encoding: 'utf8' });
    assert.equal(status, 1);
    assert.match(stderr, message);
  });
}
