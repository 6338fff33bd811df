// The editor's modules that need no page, bundled as the page's scripts are.
//
//     const { SceneDocument, History } = await editModules();

import { mkdtemp, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const root = fileURLToPath(new URL('../..', import.meta.url));
const fromTools = createRequire(path.join(root, 'tools/package.json'));
const { build } = await import(pathToFileURL(fromTools.resolve('esbuild')));

const kModules = [
  'cells',
  'document',
  'editor',
  'files/templates',
  'files/world-link',
  'history',
  'handles',
  'json-text',
  'kinds',
  'link-marks',
  'links',
  'mark-lines',
  'names',
  'picture-view',
  'portal-ends',
  'shapes',
  'tools/box',
  'tools/fill',
  'tools/link',
  'tools/paint',
  'tools/place',
  'tools/replace',
  'tools/shape',
  'tools/thing',
  'forms/schema',
  'gates',
  'tools/strokes',
];

let modules = null;

export function editModules() {
  modules ??= bundled();
  return modules;
}

async function bundled() {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-edit-'));
  const outfile = path.join(folder, 'edit.mjs');
  await build({
    stdin: {
      contents: kModules.map((name) => `export * from './${name}.js';`).join('\n'),
      resolveDir: path.join(root, 'web/edit'),
    },
    nodePaths: [path.join(root, 'tools/node_modules')],
    bundle: true,
    outfile,
    format: 'esm',
    target: 'es2022',
    logLevel: 'warning',
  });
  try {
    return await import(pathToFileURL(outfile));
  } finally {
    await rm(folder, { recursive: true });
  }
}

// The same numbers every time.
export function seededRandom(seed) {
  let state = seed;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}
