// Runs the measurements of the given builds one after another and prints the results: node
// tools/bench.mjs OPTION... PRESET... See tools/bench, which builds them and lists the options.

import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { cpus } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

import { check, figuresOf, ratiosText, readRatios, recordFor, reportOf } from './bench-ratios.mjs';
import { phasesTable, table } from './bench-table.mjs';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const kRatios = 'tests/bench/ratios.json';
const kMostTimesTheLimit = { native: 3, wasm: 3 }; // target of a view
const kTargets = {
  'yardstick, flat hall': { native: 1.35, wasm: 1.6 },
  'yardstick, hall of heights': { native: 1.4, wasm: 1.8 },
};
const kMostMillisecondsWithMany = 16; // target of a view with many objects
// Target of the limit itself, natively: a slow limit would flatter the views.
const kMostTimesACopy = 10;
const kTimesMoreRounds = 3; // when measuring a suspected loss again

// `name` is the build's name in the file of ratios. The scalar WebAssembly is for old browsers and
// has no target.
const builds = {
  release: { name: 'native', title: 'native, x86-64-v2' },
  'wasm-simd': { name: 'wasm', title: 'Node, WebAssembly with SIMD' },
  'wasm-scalar': { name: 'scalar', title: 'Node, WebAssembly without SIMD' },
};

const { values: options, positionals: presets } = parseArgs({
  options: {
    json: { type: 'boolean', default: false },
    phases: { type: 'boolean', default: false },
    record: { type: 'boolean', default: false },
    check: { type: 'boolean', default: false },
    rounds: { type: 'string' },
    view: { type: 'string', multiple: true, default: [] },
  },
  allowPositionals: true,
});
const processor = cpus()[0]?.model.trim() ?? 'unknown';

function fail(message) {
  console.error(`bench: ${message}`);
  process.exit(1);
}

// Measures the views with these titles, or all if there are none.
function measure(preset, rounds, titles = []) {
  const program = join(root, 'build', preset, 'bin', 'slicecast-bench');
  const [command, ...start] =
    preset === 'release' ? [program] : [process.execPath, `${program}.js`];
  const words = [join(root, 'tests/frozen'), String(rounds)];
  if (titles.length > 0) words.push('views', ...titles);
  if (process.stderr.isTTY) process.stderr.write(`Measuring: ${builds[preset].title} ...`);
  const result = spawnSync(command, [...start, ...words], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  if (process.stderr.isTTY) process.stderr.write('\r\x1b[K');
  if (result.status !== 0)
    fail(`the measurement of ${preset} failed${result.error ? `: ${result.error.message}` : ''}`);
  const run = { preset, ...builds[preset], ...JSON.parse(result.stdout) };
  const targetOf = (title) => (kTargets[title] ?? kMostTimesTheLimit)[run.name] ?? Infinity;
  run.missed = run.views
    .filter(({ title, ratio }) => ratio > targetOf(title))
    .map(({ title }) => title);
  return run;
}

// The missed targets, which make the exit status 1.
function shortcomings(run) {
  const found = [];
  if (run.name === 'scalar') return found;
  if (run.missed.length > 0) {
    const own = Object.entries(kTargets).map(([title, target]) => `${title} ${target[run.name]}`);
    found.push(
      `${run.name}: ${run.missed.length} of ${run.views.length} views are above ` +
        `their target of ${kMostTimesTheLimit[run.name]} (${own.join('; ')})`,
    );
  }
  if (run.name === 'native' && run.limit.ratio > kMostTimesACopy) {
    found.push(
      `${run.name}: the limit takes ${run.limit.ratio.toFixed(1)} times a copy of the frame, ` +
        `the target is at most ${kMostTimesACopy}`,
    );
  }
  for (const view of run.views) {
    if (view.comparedWith === undefined) continue;
    if (view.timesThat > view.mostTimes) {
      found.push(
        `${run.name}: ${view.title} takes ${view.timesThat.toFixed(2)} times as long as ` +
          `${view.comparedWith}, the target is at most ${view.mostTimes}`,
      );
    }
    const milliseconds = (view.nsPerPixel * run.width * run.height) / 1e6;
    if (milliseconds > kMostMillisecondsWithMany) {
      found.push(
        `${run.name}: ${view.title} takes ${milliseconds.toFixed(1)} ms, ` +
          `the target is at most ${kMostMillisecondsWithMany}`,
      );
    }
  }
  return found;
}

function pastRatios() {
  let text;
  try {
    text = readFileSync(join(root, kRatios), 'utf8');
  } catch {
    return null;
  }
  try {
    return readRatios(text, kRatios);
  } catch ({ message }) {
    return fail(message);
  }
}

// Returns true if no view has become slower.
function checkRatios(rounds) {
  const records = pastRatios();
  if (records === null) fail(`there is no ${kRatios}; tools/bench --record writes it.`);
  const record = recordFor(records, processor);
  const result = check(record, (names, isAgain) =>
    figuresOf(
      presets
        .filter((preset) => names === null || names.includes(builds[preset].name))
        .map((preset) => measure(preset, isAgain ? rounds * kTimesMoreRounds : rounds)),
    ),
  );
  console.log(reportOf(result, record, processor));
  return result.losses.length === 0;
}

function record(runs) {
  const commit = spawnSync('git', ['-C', root, 'log', '-1', '--format=%s'], { encoding: 'utf8' });
  const date = new Date();
  const two = (number) => String(number).padStart(2, '0');
  const records = pastRatios() ?? [];
  records.push({
    date: `${date.getFullYear()}-${two(date.getMonth() + 1)}-${two(date.getDate())}`,
    commit: commit.stdout?.trim() ?? '',
    processor,
    rounds: runs[0].rounds,
    views: figuresOf(runs),
  });
  writeFileSync(join(root, kRatios), ratiosText(records));
  console.log(`\nRecorded in ${kRatios}.`);
}

if (options.check) {
  process.exitCode = checkRatios(Number(options.rounds ?? 50)) ? 0 : 1;
} else {
  // Reports an unreadable file before measuring.
  if (options.record) pastRatios();
  const rounds = Number(options.rounds ?? 150);
  const runs = presets.map((preset) => measure(preset, rounds, options.view));
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
