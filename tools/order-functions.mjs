// Reorders the functions of a WebAssembly program so that it compresses better: similar functions
// come close together. gzip finds repetitions only within 32 KB, while the compiler's order, or one
// by number of calls, spreads them over the whole file. Nothing else changes.
//
//     node tools/order-functions.mjs BINARYEN PROGRAM.wasm FEATURE...
//
// BINARYEN is the folder of wasm-dis and wasm-as, which come with Emscripten. Features are spelled
// as Binaryen's options: --enable-simd. wasm-opt should follow: wasm-as writes more bytes than it.

import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const kRun = 6; // so many equal bytes count as a repetition
const kWindow = 32000; // bytes: nearly gzip's 32 KB
const kShortIndices = 128; // functions whose index takes one byte; imported ones come first
const kSmallFunction = 2; // bytes added to each function, because short ones resemble anything

const kSectionsAt = 8;
const kCodeSection = 10;

const [binaryen, program, ...features] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'slicecast-order-'));
try {
  const text = join(folder, 'program.wat');
  execFileSync(join(binaryen, 'wasm-dis'), [program, '-o', text, ...features], {
    stdio: ['ignore', 'inherit', 'inherit'],
  });
  writeFileSync(text, reordered(readFileSync(text, 'utf8'), bodiesOf(readFileSync(program))));
  execFileSync(join(binaryen, 'wasm-as'), [text, '-o', program, ...features], {
    stdio: ['ignore', 'inherit', 'inherit'],
  });
} finally {
  rmSync(folder, { recursive: true });
}

// The bytes of each function.
function bodiesOf(bytes) {
  let at = kSectionsAt;
  const number = () => {
    let value = 0;
    for (let shift = 0; ; shift += 7) {
      const byte = bytes[at++];
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) return value;
    }
  };
  while (at < bytes.length) {
    const section = bytes[at++];
    const size = number();
    if (section === kCodeSection) {
      return Array.from({ length: number() }, () => {
        const end = number() + at;
        const body = bytes.subarray(at, end);
        at = end;
        return body;
      });
    }
    at += size;
  }
  return [];
}

function reordered(text, bodies) {
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
  if (functions.length !== bodies.length) throw new Error('cannot read what wasm-dis writes');
  const imported = before.filter((line) => /^ \(import .* \(func /.test(line)).length;
  const shortIndices = Math.max(0, kShortIndices - imported);
  const order = inOrder(bodies, callsOf(functions), shortIndices);
  return [...before, ...order.flatMap((index) => functions[index]), ...behind].join('\n');
}

function isWhole(line) {
  return line.split('(').length === line.split(')').length;
}

// Greedy: always the function with the largest share of recently seen runs comes next. The most
// called ones come first, as many as can have a short index.
function inOrder(bodies, calls, shortIndices) {
  const runs = bodies.map(runsOf);
  const users = new Map();
  runs.forEach((own, index) =>
    own.forEach((run) => {
      if (!users.has(run)) users.set(run, []);
      users.get(run).push(index);
    }),
  );
  const seen = bodies.map(() => 0); // how many of its runs are in the window
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

  const byCalls = bodies.map((_, index) => index).sort((a, b) => calls[b] - calls[a] || a - b);
  const order = [];
  for (const group of [byCalls.slice(0, shortIndices), byCalls.slice(shortIndices)]) {
    const left = new Set(group);
    while (left.size > 0) {
      let best = -1;
      let most = -1;
      for (const index of left) {
        const share = seen[index] / (runs[index].size + kSmallFunction) + runs[index].size * 1e-9;
        if (share > most) [best, most] = [index, share];
      }
      left.delete(best);
      order.push(best);
      runs[best].forEach((run) => count(run, 1));
      window.push(best);
      size += bodies[best].length;
      while (size > kWindow && window.length > 1) {
        const oldest = window.shift();
        runs[oldest].forEach((run) => count(run, -1));
        size -= bodies[oldest].length;
      }
    }
  }
  return order;
}

// All runs of bytes, each as a number.
function runsOf(body) {
  const runs = new Set();
  for (let i = 0; i + kRun <= body.length; ++i) runs.add(body.readUIntLE(i, kRun));
  return runs;
}

function callsOf(functions) {
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
