// Fails the build if a WebAssembly program imports a function that its list does not name, because
// the page would not have it.
//
//     node tools/check-imports.mjs FILE.wasm LIST
//
// LIST has a line `MODULE NAME` for each import; lines that begin with # are comments.

import { readFileSync } from 'node:fs';
import { basename } from 'node:path';

const [file, list] = process.argv.slice(2);
const allowed = new Set(
  readFileSync(list, 'utf8')
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('#')),
);
const program = new WebAssembly.Module(readFileSync(file));
const others = WebAssembly.Module.imports(program)
  .map(({ module, name }) => `${module} ${name}`)
  .filter((line) => !allowed.has(line));
if (others.length > 0) {
  console.error(`error: ${basename(file)} asks for what no page has: ${others.join(', ')}.
Leave out what needs it (often time, files, the environment, printf), or give it in
web/engine/engine-module.js and add it to ${list}.`);
  process.exitCode = 1;
}
