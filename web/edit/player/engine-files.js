// The engine of the one HTML file: its program lies in the page. Stands in for
// engine/engine-files.js there (tools/bundle.mjs).
//
//     const files = await fetchEngine();
//     const engine = await Engine.create({files, canvas});

import { browserHasWebAssembly, chooseBuild } from '../../engine/builds.js';
import { openCanvas } from '../../engine/engine-canvas.js';
import { Trouble } from '../../engine/trouble.js';

export async function fetchEngine() {
  if (!browserHasWebAssembly() || chooseBuild('auto') !== 'simd')
    throw new Trouble(
      'This browser is too old for this file',
      'It has no WebAssembly with SIMD. Open the file in a newer one.',
      [],
      'no-webassembly',
    );
  const [program, later] = await Promise.all(
    ['program', 'later'].map(async (id) => WebAssembly.compile(await globalThis.slicecastPart(id))),
  );
  return {
    kind: 'simd',
    program,
    later: { program: later, async load() {}, readNow: () => later },
    openCanvas,
    canCompileNow: false,
  };
}
