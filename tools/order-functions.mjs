// Reorders the functions of a WebAssembly program so that it compresses better: similar functions
// come close together. gzip finds repetitions only within 32 KB, while the compiler's order, or one
// by number of calls, spreads them over the whole file. Nothing else changes.
//
//     node tools/order-functions.mjs BINARYEN PROGRAM.wasm FEATURE...
//
// BINARYEN is the folder of wasm-dis and wasm-as, which come with Emscripten. Features are spelled
// as Binaryen's options: --enable-simd.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kRun = 8; // so many equal lines count as a repetition
const kWindow = 12000; // so many lines of text are about 32 KB of program
const kShortIndices = 110; // functions whose index takes one byte, besides imported ones
const kSmallFunction = 8; // lines added to each function, because short ones resemble anything

const [binaryen, program, ...features] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'slicecast-order-'));
try {
  const text = join(folder, 'program.wat');
  execFileSync(join(binaryen, 'wasm-dis'), [program, '-o', text, ...features], {
    stdio: ['ignore', 'inherit', 'inherit'],
  });
  writeFileSync(text, reordered(readFileSync(text, 'utf8')));
  execFileSync(join(binaryen, 'wasm-as'), [text, '-o', program, ...features], {
    stdio: ['ignore', 'inherit', 'inherit'],
  });
} finally {
  rmSync(folder, { recursive: true });
}

function reordered(text) {
  const before = [];
  const functions = [];
  const behind = [];
  let isInside = false;
  for (const line of text.split('\n')) {
    if (line.startsWith(' (func ')) {
      functions.push([line]);
      isInside = !isWhole(line);
    } else if (isInside) {
      functions.at(-1).push(line);
      isInside = line !== ' )';
    } else {
      (functions.length === 0 ? before : behind).push(line);
    }
  }
  return [...before, ...inOrder(functions).flat(), ...behind].join('\n');
}

function isWhole(line) {
  return line.split('(').length === line.split(')').length;
}

// Greedy: always the function with the largest share of recently seen runs comes next. The most
// called ones come first, because they then have short indices.
function inOrder(functions) {
  const runs = functions.map(runsOf);
  const users = new Map();
  runs.forEach((own, index) =>
    own.forEach((run) => {
      if (!users.has(run)) users.set(run, []);
      users.get(run).push(index);
    }),
  );
  const seen = functions.map(() => 0); // how many of its runs are in the window
  const inWindow = new Map();
  const window = [];
  let size = 0;
  const count = (run, by) => {
    const before = inWindow.get(run) ?? 0;
    inWindow.set(run, before + by);
    if (before === 0 || before + by === 0)
      users.get(run).forEach((index) => {
        seen[index] += by;
      });
  };

  const calls = countCalls(functions);
  const byCalls = functions.map((_, index) => index).sort((a, b) => calls[b] - calls[a] || a - b);
  const order = [];
  for (const group of [byCalls.slice(0, kShortIndices), byCalls.slice(kShortIndices)]) {
    const left = new Set(group);
    while (left.size > 0) {
      let best = -1;
      let most = -1;
      for (const index of left) {
        const share =
          seen[index] / (runs[index].length + kSmallFunction) + runs[index].length * 1e-9;
        if (share > most) [best, most] = [index, share];
      }
      left.delete(best);
      order.push(functions[best]);
      runs[best].forEach((run) => count(run, 1));
      window.push(best);
      size += runs[best].length;
      while (size > kWindow && window.length > 1) {
        const oldest = window.shift();
        runs[oldest].forEach((run) => count(run, -1));
        size -= runs[oldest].length;
      }
    }
  }
  return order;
}

// All runs of lines, with names removed.
function runsOf(lines) {
  const bare = lines.map((line) => line.trim().replace(/\$[^\s()]+/g, '$'));
  const runs = [];
  for (let i = 0; i === 0 || i + kRun <= bare.length; ++i)
    runs.push(bare.slice(i, i + kRun).join('\n'));
  return runs;
}

function countCalls(functions) {
  const index = new Map(
    functions.map(([first], at) => [/^ \(func (\$[^\s()]+)/.exec(first)[1], at]),
  );
  const calls = functions.map(() => 0);
  for (const [, name] of functions
    .flat()
    .join('\n')
    .matchAll(/\(call (\$[^\s()]+)/g)) {
    if (index.has(name)) calls[index.get(name)] += 1;
  }
  return calls;
}
