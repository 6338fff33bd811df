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
  'carrying',
  'cells',
  'differences',
  'document',
  'editor',
  'files/dense-text',
  'files/file-homes',
  'files/html-file',
  'files/line-differences',
  'files/open-file',
  'files/picture-size',
  'files/saving',
  'files/share-texts',
  'files/shipped',
  'files/templates',
  'files/text-form',
  'files/world-link',
  'history',
  'handles',
  'ground',
  'json-text',
  'kinds',
  'levels',
  'link-marks',
  'links',
  'map-size',
  'mark-lines',
  'names',
  'parts',
  'picture-view',
  'portal-ends',
  'selection',
  'shapes',
  'things',
  'tiles',
  'tools/box',
  'tools/fill',
  'tools/line',
  'tools/link',
  'tools/paint',
  'tools/place',
  'tools/replace',
  'tools/select',
  'tools/shape',
  'tools/stamp',
  'tools/thing',
  'forms/schema',
  'gates',
  'height-drags',
  'section',
  'tools/strokes',
  'turning',
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

// Every value that the schema has: [pattern, node, what is said of it].
export function* schemaParts(schema, node, at = [], seen = new Set()) {
  const said = schema.of(node, at.at(-1) ?? '');
  yield [at.join('/'), node, said];
  for (const { type, item, keys, rest } of said.kinds) {
    const inner =
      type === 'list'
        ? [['*', item]]
        : type === 'object'
          ? [...keys, ...(rest ? [['*', rest]] : [])]
          : [];
    for (const [key, child] of inner) {
      const mark = `${key} ${JSON.stringify(child)}`;
      if (!seen.has(mark))
        yield* schemaParts(schema, child, [...at, key], new Set([...seen, mark]));
    }
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
