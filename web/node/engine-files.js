// Reads the engine's files from the package and compiles them once, for Engine.create.
//
//     const engine = await Engine.create({ files: await readEngine('auto') });

import { chooseBuild } from '../engine/builds.js';
import { Questions } from '../engine/questions.js';
import { coded } from '../engine/trouble.js';
import { kPackage, readAt } from './scene-files.js';

const kKinds = ['auto', 'simd', 'scalar'];

const read = new Map();

// Failures are not cached, so that another try reads again.
export async function readEngine(kind) {
  if (!kKinds.includes(kind))
    throw new TypeError(`engine: found ${String(kind)}, expected ${kKinds.join(', ')}`);
  const build = chooseBuild(kind);
  if (!read.has(build)) read.set(build, readBuild(build));
  try {
    return await read.get(build);
  } catch (error) {
    read.delete(build);
    throw error;
  }
}

async function readBuild(kind) {
  const program = await readProgram(`slicecast-${kind}.wasm`);
  const later = kind === 'simd' ? await readProgram('slicecast-simd-later.wasm') : null;
  return { kind, program, later: later && { program: later, load() {} }, Questions };
}

async function readProgram(name) {
  const { bytes } = await readAt(new URL(`engine/${name}`, kPackage)).catch(({ message }) => {
    throw coded(
      'fetch',
      `${message}. The engine lies in the package slicecast, which a bundled program must leave external`,
    );
  });
  return WebAssembly.compile(bytes);
}
