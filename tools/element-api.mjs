// Makes files of the built page from the table of the element's interface (web/element/api.json):
// types, the custom elements manifest, the documentation, and the package's version.
//
//     node tools/element-api.mjs FOLDER        // a built page with its engine

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { jsxDeclarations } from './element-api/jsx.mjs';
import { customElementsManifest } from './element-api/manifest.mjs';
import { documentation } from './element-api/page.mjs';
import { table } from './element-api/table.mjs';
import { declarations } from './element-api/types.mjs';

const root = dirname(dirname(fileURLToPath(import.meta.url)));

if (process.argv.length !== 3) {
  console.error('element-api: expected one argument, the folder of the built page');
  process.exit(1);
}
const folder = resolve(process.argv[2]);
const inFolder = (name) => pathToFileURL(join(folder, name)).href;

const { errorCodes } = await import(inFolder('element/faults.js'));
const { Engine } = await import(inFolder('engine/engine.js'));
const { readEngine } = await import(inFolder('node/engine-files.js'));

const defined = Object.keys(errorCodes).sort().join(' ');
const listed = [...table.errorCodes].sort().join(' ');
if (defined !== listed)
  throw new Error(
    `web/element/api.json lists the error codes ${listed}; web/element/faults.js has ${defined}`,
  );

const engine = await Engine.create({ files: await readEngine('auto') });
const version = readFileSync(join(root, 'CMakeLists.txt'), 'utf8').match(
  /project\(Slicecast VERSION ([0-9.]+)/,
)[1];
// The version is defined only in CMakeLists.txt.
const { name, ...others } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
const manifest = { name, version, ...others };

const json = (value) => `${JSON.stringify(value, null, 2)}\n`;
const files = {
  ...declarations(table),
  ...jsxDeclarations(table),
  'custom-elements.json': json(customElementsManifest(table)),
  'element.html': documentation({
    errorCodes,
    version,
    options: engine.options,
    scenes: JSON.parse(readFileSync(join(folder, 'scenes/index.json'), 'utf8')),
  }),
  'package.json': json(manifest),
};
engine.stop();
for (const [name, text] of Object.entries(files)) {
  mkdirSync(dirname(join(folder, name)), { recursive: true });
  writeFileSync(join(folder, name), text);
}
