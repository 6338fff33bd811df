// Runs the built measurements, one build after another, and makes a table of them: node
// tools/bench.mjs [--json] [--rounds N] PRESET... See tools/bench, which builds them.

import { spawnSync } from 'node:child_process';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';

const root = dirname(dirname(fileURLToPath(import.meta.url)));
const kMostTimesTheLimit = 3; // what a view may take
const kMostTimesTheSeen = 1.5; // what a view with many objects may take beside one with those alone that are seen
const kMostMillisecondsWithMany = 16; // and what it may take at all
const kMostTimesACopy = 10; // what the limit itself may take natively: a slow one would flatter the views

const builds = {
  release: { title: 'native, x86-64-v2', isNative: true, command: (program) => [program] },
  'wasm-simd': {
    title: 'WebAssembly, SIMD',
    command: (program) => [process.execPath, `${program}.js`],
  },
  'wasm-scalar': {
    title: 'WebAssembly, scalar',
    command: (program) => [process.execPath, `${program}.js`],
  },
};

const { values: options, positionals: presets } = parseArgs({
  options: {
    json: { type: 'boolean', default: false },
    rounds: { type: 'string', default: '150' },
  },
  allowPositionals: true,
});

function measure(preset) {
  const [command, ...start] = builds[preset].command(
    join(root, 'build', preset, 'bin', 'slicecast-bench'),
  );
  if (process.stderr.isTTY) process.stderr.write(`Measuring: ${builds[preset].title} ...`);
  const result = spawnSync(command, [...start, join(root, 'tests/frozen'), options.rounds], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'inherit'],
  });
  if (process.stderr.isTTY) process.stderr.write('\r\x1b[K');
  if (result.status !== 0) {
    console.error(
      `bench: the measurement of ${preset} failed${result.error ? `: ${result.error.message}` : ''}`,
    );
    process.exit(1);
  }
  return { preset, ...builds[preset], ...JSON.parse(result.stdout) };
}

// What asks for an exit status of 1. The scalar WebAssembly is for old browsers; its figures are
// only shown.
function shortcomings(run) {
  const found = [];
  if (run.isNative && run.limit.ratio > kMostTimesACopy) {
    found.push(
      `${run.title}: the limit takes ${run.limit.ratio.toFixed(1)} times a copy of the frame, at most ${kMostTimesACopy} are asked for`,
    );
  }
  if (run.preset === 'wasm-scalar') return found;
  for (const view of run.views) {
    const what = `${run.title}: ${view.scene}, ${view.name}`;
    if (view.ratio > kMostTimesTheLimit) {
      found.push(
        `${what} takes ${view.ratio.toFixed(2)} times the limit, at most ${kMostTimesTheLimit} are asked for`,
      );
    }
    if (view.comparedWith === undefined) continue;
    if (view.timesThat > kMostTimesTheSeen) {
      found.push(
        `${what} takes ${view.timesThat.toFixed(2)} times as long as ${view.comparedWith}, at most ${kMostTimesTheSeen} are asked for`,
      );
    }
    const milliseconds = (view.nsPerPixel * run.width * run.height) / 1e6;
    if (milliseconds > kMostMillisecondsWithMany) {
      found.push(
        `${what} takes ${milliseconds.toFixed(1)} ms, at most ${kMostMillisecondsWithMany} are asked for`,
      );
    }
  }
  return found;
}

function table(runs) {
  const nameWidth =
    Math.max(...runs[0].views.map((view) => `${view.scene}, ${view.name}`.length), 20) + 2;
  const cell = (figures, unit) =>
    `${figures.nsPerPixel.toFixed(3)} ±${String(Math.round((figures.spread / 2) * 100)).padStart(2)} % ${
      figures.ratio === undefined ? '' : `${figures.ratio.toFixed(2)} ${unit}`
    }${
      figures.painting === undefined
        ? ''
        : ` (${figures.painting.toFixed(2)}, ${Math.round(figures.walkShare * 100)} %)`
    }`;
  const line = (name, cells) =>
    `${name.padEnd(nameWidth)}${cells.map((text) => text.padEnd(40)).join('')}`.trimEnd();
  return [
    `ns per pixel of ${runs[0].width}x${runs[0].height}, medians of ${runs[0].rounds} rounds; ± half the range of the middle half; x: times the limit`,
    "In brackets: painting alone, times the limit; the walk's share of the time.",
    '',
    line(
      '',
      runs.map((run) => run.title),
    ),
    line(
      'copy of a frame',
      runs.map((run) => cell(run.copy)),
    ),
    line(
      'the limit',
      runs.map((run) => cell(run.limit, 'copies')),
    ),
    ...runs[0].views.map((view, i) =>
      line(
        `${view.scene}, ${view.name}`,
        runs.map((run) => cell(run.views[i], 'x')),
      ),
    ),
  ].join('\n');
}

const runs = presets.map(measure);
const found = runs.flatMap(shortcomings);
if (options.json) {
  console.log(
    JSON.stringify(
      { runs: runs.map(({ command, ...figures }) => figures), shortcomings: found },
      null,
      2,
    ),
  );
} else {
  console.log(table(runs));
  if (found.length > 0) console.log(`\n${found.join('\n')}`);
}
process.exitCode = found.length > 0 ? 1 : 0;
