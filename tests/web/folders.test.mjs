// Which folder of web may import which: node and element import engine, play imports both, node
// imports edit/import and edit/files too, and modules that Node imports need no document.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const web = fileURLToPath(new URL('../../web/', import.meta.url));
const kMayImport = {
  engine: ['engine'],
  element: ['element', 'engine', '.'], // '.': ray-caster-*.js, the scripts that load later
  node: ['node', 'engine', 'edit/import', 'edit/files'],
  'edit/import': ['edit/import', 'engine'],
  play: ['play', 'element', 'engine', '.', 'edit/hand-over.js'], // that one loads later, too
};

const textOf = (file) => readFileSync(path.join(web, file), 'utf8');
const withoutComments = (text) => text.replaceAll(/^\s*\/\/.*$|\s\/\/ .*$/gm, '');

// The modules that one imports, as paths in web.
function importsOf(file) {
  const found = withoutComments(textOf(file)).matchAll(
    /(?:\bfrom |\bimport |\bimport\()'(\.[^']*)'/g,
  );
  return [...found].map(([, to]) => path.join(path.dirname(file), to));
}

for (const [folder, allowed] of Object.entries(kMayImport)) {
  test(`modules of web/${folder} import only from ${allowed.join(', ')}`, () => {
    const files = readdirSync(path.join(web, folder)).filter((name) => name.endsWith('.js'));
    assert.ok(files.length > 0);
    for (const file of files) {
      for (const to of importsOf(path.join(folder, file)))
        assert.ok(
          allowed.includes(path.dirname(to)) || allowed.includes(to),
          `${folder}/${file} imports ${to}`,
        );
    }
  });
}

test('modules that Node imports need no document', () => {
  const known = new Set(['node/index.js', 'node/command.js']);
  for (const file of known) for (const to of importsOf(file)) known.add(to);
  for (const file of ['engine/engine-module.js', 'edit/import/tiled.js', 'edit/files/html-file.js'])
    assert.ok(known.has(file), 'the imports are followed');
  for (const file of known) {
    const words = /\b(document|window|navigator|location|HTML\w+|matchMedia)\b(?!-)/.exec(
      withoutComments(textOf(file)),
    );
    assert.equal(words?.[0], undefined, file);
  }
});
