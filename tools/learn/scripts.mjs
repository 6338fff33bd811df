// Bundles the tutorial's scripts: one per chapter, and what several chapters share in files of
// their own; and its style sheets.

import { build, transform } from 'esbuild';
import { copyFileSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import path from 'node:path';

const kSmall = {
  format: 'esm',
  target: 'es2022',
  minify: true,
  legalComments: 'none',
  logLevel: 'warning',
};
const kStyles = ['figures/figures.css', 'learn.css', 'write/write.css'];

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
  const { metafile } = await build({
    metafile: true,
    entryPoints: [
      { in: path.join(staged, 'learn-index.js'), out: 'index' },
      ...[...sources.keys()].map((name) => ({ in: `chapter:${name}`, out: name })),
    ],
    outdir: path.join(output, 'scripts'),
    bundle: true,
    external: ['node:*'], // by-hand.js reads files when the build draws
    splitting: true,
    ...kSmall,
    chunkNames: 'part-[hash]',
    plugins: [generated],
  });
  // The figure kit for other pages, in one file.
  await build({
    entryPoints: [path.join(staged, 'figures.js')],
    outfile: path.join(output, 'figures.js'),
    bundle: true,
    ...kSmall,
  });
  copyFileSync('web/learn/figures.d.ts', path.join(output, 'figures.d.ts'));
  copyLicences(Object.keys(metafile.inputs), path.join(output, '../licences'));
}

// Writes learn.css, the one sheet of a chapter, and figures.css, for other pages. `more` are
// further rules.
export async function buildStyles(staged, output, more) {
  const read = (name) => readFileSync(path.join(staged, name), 'utf8');
  const write = async (name, text) => {
    const { code } = await transform(text, { loader: 'css', minify: true });
    writeFileSync(path.join(output, name), code);
  };
  await write('learn.css', [...kStyles.map(read), more].join('\n'));
  await write('figures.css', read('figures/figures.css'));
}

// Copies the licences of the packages that these files belong to, and of Temml, whose style sheet
// is in learn.css.
function copyLicences(files, to) {
  const packages = new Set(['temml']);
  for (const file of files) {
    const name = /^.*node_modules\/((?:@[^/]+\/)?[^/]+)/.exec(file)?.[1];
    if (name !== undefined) packages.add(name);
  }
  mkdirSync(to, { recursive: true });
  for (const name of packages) {
    const folder = path.resolve('tools/node_modules', name);
    const licence = readdirSync(folder).find((file) => /^licen[cs]e/i.test(file));
    if (licence === undefined) throw new Error(`the package ${name} has no licence file.`);
    copyFileSync(
      path.join(folder, licence),
      path.join(to, `${name.replaceAll(/[@/]/g, ' ').trim().replaceAll(' ', '-')}.txt`),
    );
  }
}
