// Puts the element's script and all that it imports into one file: a page then waits for one answer, not for thirty, one layer after the other.
//
//     node tools/bundle.mjs FOLDER        FOLDER/ray-caster.js becomes that file; the engine's files stay by themselves

import { writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { build } from 'esbuild';

const [folder] = process.argv.slice(2);
if (folder === undefined) throw new Error('tools/bundle.mjs: found no folder, expected one that holds ray-caster.js');
const script = path.join(folder, 'ray-caster.js');

const { outputFiles: [{ text }] } = await build({
  entryPoints: [script],
  outfile: script,
  write: false,
  bundle: true,
  format: 'esm',
  target: 'es2022',
  external: ['./engine/*'],
  minify: true,
  logLevel: 'warning',
});

// An address that is known only while the page runs is nothing for other bundlers to follow; the comment that tells them so has been taken off.
const followed = text.replaceAll(/\bimport\((?!")/g, 'import(/* @vite-ignore */ ');
await writeFile(script, `// <ray-caster> in one file, made of the modules beside it.\n${followed}`);
