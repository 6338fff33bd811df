// Bundles the tutorial's scripts: one per chapter, and what several chapters share in files of
// their own.

import { build } from 'esbuild';
import { copyFile } from 'node:fs/promises';
import path from 'node:path';

const kStyles = ['learn.css', 'figures/figures.css', 'write/write.css'];

// A chapter's script starts its figures, its exercises and its panel.
function scriptOf(chapter, staged) {
  const names = [...chapter.figures.keys()];
  return [
    `import { startPage } from '${staged}/learn.js';`,
    ...names.map((name, index) => `import f${index} from './${name}.js';`),
    `startPage({ figures: { ${names.map((name, index) => `'${name}': f${index}`).join(', ')} } });`,
  ].join('\n');
}

// `staged` holds the modules.
export async function buildScripts(staged, output, chapters) {
  const sources = new Map([...chapters.values()].map((chapter) => [chapter.name, chapter]));
  const generated = {
    name: 'chapters',
    setup: ({ onResolve, onLoad }) => {
      onResolve({ filter: /^chapter:/ }, ({ path: name }) => ({
        path: name.slice('chapter:'.length),
        namespace: 'chapter',
      }));
      onLoad({ filter: /.*/, namespace: 'chapter' }, ({ path: name }) => ({
        contents: scriptOf(sources.get(name), staged),
        resolveDir: path.join(staged, sources.get(name).folder),
      }));
    },
  };
  await build({
    entryPoints: [
      { in: path.join(staged, 'learn-index.js'), out: 'index' },
      { in: path.join(staged, 'figures/figures.js'), out: 'figures' },
      ...[...sources.keys()].map((name) => ({ in: `chapter:${name}`, out: name })),
    ],
    outdir: path.join(output, 'scripts'),
    bundle: true,
    splitting: true,
    format: 'esm',
    target: 'es2022',
    minify: true,
    legalComments: 'none',
    logLevel: 'warning',
    chunkNames: 'part-[hash]',
    plugins: [generated],
  });
  for (const style of kStyles)
    await copyFile(path.join(staged, style), path.join(output, path.basename(style)));
}
