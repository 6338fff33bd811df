// Runs the measurements of the given builds one after another and prints the results: node
// tools/bench.mjs OPTION... PRESET... See tools/bench, which builds them and lists the options.

import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { join } from 'node:path';
import { text } from 'node:stream/consumers';
import { parseArgs } from 'node:util';

import { check, figuresOf, ratiosText, readRatios, recordFor, reportOf } from './bench-ratios.mjs';
import { againstTable, phasesTable, slowestTable, table } from './bench-table.mjs';
import {
  kBeside,
  kMoments,
  moments,
  mostOf,
  root,
  scenes,
  views,
  viewsLike,
} from './bench-views.mjs';

const kRatios = 'tests/bench/ratios.json';
const kRounds = 15;
const kSlowestEvery = 60; // steps: half a second
// Asked of the limit itself, natively: a slow limit would flatter the views.
const kMostTimesACopy = 10;
const kTimesMoreRounds = 3; // when measuring a suspected loss again
const kTurnMilliseconds = 60; // of each of two builds

const builds = {
  release: { name: 'native', title: 'native, x86-64-v2' },
  'wasm-simd': { name: 'wasm', title: 'Node, WebAssembly with SIMD' },
};

const { values: options, positionals: presets } = parseArgs({
  options: {
    json: { type: 'boolean', default: false },
    phases: { type: 'boolean', default: false },
    record: { type: 'boolean', default: false },
    check: { type: 'boolean', default: false },
    overlays: { type: 'boolean', default: false },
    page: { type: 'boolean', default: false },
    light: { type: 'boolean', default: false },
    slowest: { type: 'boolean', default: false },
    against: { type: 'string' },
    rounds: { type: 'string' },
    view: { type: 'string', multiple: true, default: [] },
  },
  allowPositionals: true,
});
const processor = cpus()[0]?.model.trim() ?? 'unknown';
const rounds = Number(options.rounds ?? kRounds);

function fail(message) {
  console.error(`bench: ${message}`);
  process.exit(1);
}

function programOf(preset, folder = root) {
  const program = join(folder, 'build', preset, 'bin', 'slicecast-bench');
  return preset === 'release' ? [program] : [process.execPath, `${program}.js`];
}

// Runs slicecast-bench. Its output is returned, or shown at once.
function run(preset, words, output = 'pipe') {
  const [command, ...start] = programOf(preset);
  if (process.stderr.isTTY) process.stderr.write(`Measuring: ${builds[preset].title} ...`);
  const result = spawnSync(command, [...start, root, ...words.map(String)], {
    encoding: 'utf8',
    stdio: ['ignore', output, 'inherit'],
  });
  if (process.stderr.isTTY) process.stderr.write('\r\x1b[K');
  if (result.status !== 0)
    fail(`the measurement of ${preset} failed${result.error ? `: ${result.error.message}` : ''}`);
  return result.stdout;
}

const namesOf = (wanted) => wanted.map(({ name }) => name);
const measure = (preset, wanted, times = rounds) =>
  runOf(preset, wanted, run(preset, [times, ...namesOf(wanted)]));

// A measurement of these views, from slicecast-bench's output.
function runOf(preset, wanted, output) {
  const measured = JSON.parse(output);
  const { limit } = measured;
  const { name: build } = builds[preset];
  limit.ratio = limit.nsPerPixel / measured.copy.nsPerPixel;
  limit.most = build === 'native' ? kMostTimesACopy : Infinity;
  for (const [index, view] of measured.views.entries()) {
    const { title } = wanted[index];
    const { setUp, walk, paint, copy } = view.phases;
    const sum = setUp + walk + paint + copy;
    Object.assign(view, {
      title,
      walkShare: walk / sum,
      replay: (view.ratio * (paint + copy)) / sum,
      most: mostOf(title, build),
    });
  }
  return { preset, ...builds[preset], ...measured };
}

// What is missed of what is asked: the exit status is 1 then.
function shortcomings({ name, limit, views: all }) {
  const found = [];
  const missed = all.filter(({ ratio, most }) => ratio > most);
  if (missed.length > 0)
    found.push(`${name}: ${missed.length} of ${all.length} views are too slow`);
  if (limit.ratio > limit.most)
    found.push(`${name}: the limit takes more than ${kMostTimesACopy} times a copy of the frame`);
  for (const [title, most, beside] of kBeside) {
    const [view, other] = [title, beside].map((wanted) => all.find((one) => one.title === wanted));
    const times = view && other ? view.nsPerPixel / other.nsPerPixel : 0;
    if (times > most)
      found.push(`${name}: ${title}: ${times.toFixed(2)} times ${beside}, asked is ${most}`);
  }
  return found;
}

function pastRatios() {
  try {
    return readRatios(readFileSync(join(root, kRatios), 'utf8'), kRatios);
  } catch ({ message }) {
    return fail(message);
  }
}

// Returns true if no view has become slower.
function checkRatios(wanted) {
  const record = recordFor(pastRatios(), processor);
  if (record === undefined) fail(`${kRatios} is empty; tools/bench --record adds a record.`);
  const result = check(record, (suspects) =>
    figuresOf(
      presets.map((preset) =>
        suspects === null
          ? measure(preset, wanted)
          : measure(
              preset,
              wanted.filter(({ title }) => suspects.includes(title)),
              rounds * kTimesMoreRounds,
            ),
      ),
    ),
  );
  console.log(reportOf(result, record, processor));
  return result.losses.length === 0;
}

function record(runs) {
  const commit = spawnSync('git', ['-C', root, 'log', '-1', '--format=%s'], { encoding: 'utf8' });
  const date = new Date();
  const two = (number) => String(number).padStart(2, '0');
  const records = pastRatios();
  records.push({
    date: `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())}`,
    commit: commit.stdout?.trim() ?? '',
    processor,
    rounds,
    views: figuresOf(runs),
  });
  writeFileSync(join(root, kRatios), ratiosText(records));
  console.log(`\nRecorded in ${kRatios}.`);
}

// Both builds run at once, but one of them is always stopped: so whatever else the machine does
// falls on both alike.
async function runInTurns(programs, words) {
  const children = programs.map(([command, ...start]) =>
    spawn(command, [...start, ...words], { stdio: ['ignore', 'pipe', 'inherit'] }),
  );
  let turn = 0;
  const timer = setInterval(() => {
    children[turn].kill('SIGSTOP');
    turn = 1 - turn;
    children[turn].kill('SIGCONT');
  }, kTurnMilliseconds);
  const outputs = children.map(async (child) => {
    const [output] = await Promise.all([text(child.stdout), once(child, 'exit')]);
    clearInterval(timer);
    for (const other of children) other.kill('SIGCONT');
    if (child.exitCode !== 0) fail('the measurement failed');
    return output;
  });
  return Promise.all(outputs);
}

async function compareWith(folder, wanted) {
  const pairs = [];
  for (const preset of presets) {
    const programs = [folder, root].map((from) => programOf(preset, from));
    const outputs = await runInTurns(programs, [root, String(rounds), ...namesOf(wanted)]);
    pairs.push(outputs.map((output) => runOf(preset, wanted, output)));
  }
  console.log(againstTable(pairs));
}

function findSlowest(names) {
  const found = JSON.parse(run('release', [options.rounds ?? kSlowestEvery, 'slowest', ...names]));
  console.log(slowestTable(found));
  const steps = Object.fromEntries(found.map(({ scene, step }) => [scene, step]));
  writeFileSync(join(root, kMoments), `${JSON.stringify({ ...moments, ...steps }, null, 2)}\n`);
  console.log(`\nThe steps are in ${kMoments}: tools/bench draws these moments.`);
}

const wanted = viewsLike(options.view);
if (wanted.length === 0)
  fail(`no view is named so; there are:\n  ${views.map(({ title }) => title).join('\n  ')}`);
const shown = new Set(wanted.map(({ scene }) => scene));
const shownScenes = scenes.filter(({ scene }) => shown.has(scene));

if (options.overlays || options.light) {
  for (const preset of presets) {
    console.log(builds[preset].title);
    if (options.overlays) run(preset, [options.rounds ?? 150, 'overlays'], 'inherit');
    else
      run(
        preset,
        [options.rounds ?? 15, 'light', ...shownScenes.map(({ scene }) => scene)],
        'inherit',
      );
  }
} else if (options.page) {
  const { measurePage } = await import('./bench-page.mjs');
  await measurePage(wanted);
} else if (options.slowest) {
  findSlowest(shownScenes.filter(({ tour }) => tour).map(({ scene }) => scene));
} else if (options.against !== undefined) {
  await compareWith(options.against, wanted);
} else if (options.check) {
  process.exitCode = checkRatios(wanted) ? 0 : 1;
} else {
  // Reports an unreadable file before measuring.
  if (options.record) pastRatios();
  const runs = presets.map((preset) => measure(preset, wanted));
  const found = runs.flatMap(shortcomings);
  if (options.json) {
    console.log(JSON.stringify({ processor, runs, shortcomings: found }, null, 2));
  } else {
    console.log(table(runs));
    if (options.phases) console.log(`\n${phasesTable(runs)}`);
    if (found.length > 0) console.log(`\n${found.join('\n')}`);
  }
  if (options.record) record(runs);
  else process.exitCode = found.length > 0 ? 1 : 0;
}
