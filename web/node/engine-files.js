// The engine's files, read from beside this folder and compiled once: what Engine.create takes.
//
//     const engine = await Engine.create({ files: await readEngine('auto') });

import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

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
  const [glue, bytes] = await Promise.all([
    import(new URL(`slicecast-${kind}.js`, kEngine).href),
    readFile(new URL(`slicecast-${kind}.wasm`, kEngine)),
  ]);
  return { kind, createModule: (options) => withNamesOfScripts(() => glue.default(options)), program: await WebAssembly.compile(bytes) };
}

// The glue of older Emscriptens looks for two names of scripts that modules do not have; it does so only while it begins.
function withNamesOfScripts(begin) {
  const names = { require: createRequire(import.meta.url), __dirname: fileURLToPath(kEngine) };
  const missing = Object.keys(names).filter((name) => !(name in globalThis));
  for (const name of missing) globalThis[name] = names[name];
  try {
    return begin();
  } finally {
    for (const name of missing) delete globalThis[name];
  }
}
