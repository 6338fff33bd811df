// Makes the scripts that a page waits for few and small. The element's script and all that it
// imports become one file, so that a page waits for one answer, not for thirty, one layer after the
// other; what it needs only later are files of their own.
//
//     node tools/bundle.mjs FOLDER        FOLDER/ray-caster.js and the others become those files

import { readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { build, transform } from 'esbuild';

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/bundle.mjs: found no folder, expected one that holds ray-caster.js');
const kScripts = ['ray-caster.js', 'ray-caster-steering.js', 'ray-caster-rows.js'].map((name) =>
  path.resolve(folder, name),
);
const kSmall = { target: 'es2022', minify: true, legalComments: 'none', logLevel: 'warning' };

// The sheets stand in the modules as text, `const kSheet = ...`.
const smallSheets = {
  name: 'small sheets',
  setup: ({ onLoad }) =>
    onLoad({ filter: /styles\.js$/ }, async ({ path: file }) => {
      const text = await readFile(file, 'utf8');
      const [whole, sheet] = /(?<=const kSheet = )`([^`]*)`/.exec(text);
      const { code } = await transform(sheet, { loader: 'css', minify: true });
      return { contents: text.replace(whole, () => JSON.stringify(code.trim())) };
    }),
};

const bundles = await Promise.all(
  kScripts.map((script) =>
    build({
      ...kSmall,
      entryPoints: [script],
      outfile: script,
      write: false,
      bundle: true,
      format: 'esm',
      external: kScripts,
      plugins: [smallSheets],
    }),
  ),
);
for (const {
  outputFiles: [{ path: script, text }],
} of bundles) {
  // An address that is known only while the page runs is nothing for other bundlers to follow; the
  // comment that tells them so has been taken off.
  const followed = text.replaceAll(/\bimport\((?!")/g, 'import(/* @vite-ignore */ ');
  await writeFile(
    script,
    `// Of <ray-caster>, in one file, made of the modules of web/element and those beside this one.\n${followed}`,
  );
}
