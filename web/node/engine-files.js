// The engine's files, read from beside this folder and compiled once: what Engine.create takes.
//
//     const engine = await Engine.create({ files: await readEngine('auto') });

import { readFile } from 'node:fs/promises';

import { browserHasSimd } from '../engine-files.js';

const kEngine = new URL('../engine/', import.meta.url);
const kBuilds = ['simd', 'scalar'];

const read = new Map();

export function readEngine(kind) {
  const build = kind === 'auto' ? (browserHasSimd() ? 'simd' : 'scalar') : kind;
  if (!kBuilds.includes(build)) throw new TypeError(`engine: found "${kind}", expected "auto", "simd" or "scalar"`);
  if (!read.has(build)) read.set(build, readBuild(build));
  return read.get(build);
}

async function readBuild(kind) {
  return { kind, program: await WebAssembly.compile(await readFile(new URL(`slicecast-${kind}.wasm`, kEngine))) };
}
