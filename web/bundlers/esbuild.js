// An esbuild plugin: copies the engine and the pictures of imported scenes into the output folder,
// for every output format.
//
//     import slicecast from 'slicecast/esbuild';
//     await build({ entryPoints: ['main.js'], bundle: true, outdir: 'dist',
//                   plugins: [slicecast()] });

import { readFile } from 'node:fs/promises';
import path from 'node:path';

import { isOurs, replaceNames } from './named-files.js';

const kFile = '?slicecast-file';

// Only ES modules have import.meta.url. A classic script can read its address while it first runs.
const kHere = 'const slicecastHere =';
const kHereInModules = `${kHere} import.meta.url;`;
const kHereInScripts = `${kHere} globalThis.document?.currentScript?.src ?? globalThis.document?.baseURI ?? 'file:///';`;

export default function slicecast() {
  return {
    name: 'slicecast',
    setup({ initialOptions: { format }, onResolve, onLoad }) {
      onLoad({ filter: /\.js$/, namespace: 'file' }, async ({ path: file }) => {
        if (!isOurs(file)) return null;
        const imports = new Map();
        const followed = replaceNames(await readFile(file, 'utf8'), (named) => {
          if (!imports.has(named)) imports.set(named, `slicecastFile${imports.size}`);
          return `new URL(${imports.get(named)}, slicecastHere)`;
        });
        if (imports.size === 0) return null;
        const lines = Array.from(imports, ([named, as]) => `import ${as} from '${named}${kFile}';`);
        return {
          contents: [
            ...lines,
            format === 'esm' ? kHereInModules : kHereInScripts,
            followed.replaceAll('import.meta.url', 'slicecastHere'),
          ].join('\n'),
          loader: 'js',
          resolveDir: path.dirname(file),
        };
      });
      onResolve({ filter: /\?slicecast-file$/ }, ({ path: named, resolveDir }) => ({
        path: path.resolve(resolveDir, named.slice(0, -kFile.length)),
        namespace: 'slicecast-file',
      }));
      onLoad({ filter: /.*/, namespace: 'slicecast-file' }, async ({ path: file }) => ({
        contents: await readFile(file),
        loader: 'file',
      }));
    },
  };
}
