// The published schema accepts every shipped scene, rejects exactly those broken scenes that are
// marked so, and describes every key.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv';

import { brokenScenes } from './broken-scenes.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const assets = join(here, '../../assets');
const schema = JSON.parse(readFileSync(join(assets, 'scene.schema.json'), 'utf8'));
const validate = new Ajv({
  allErrors: true,
  strict: true,
  strictTypes: false,
  strictRequired: false,
}).compile(schema);

// Reads a file as an editor does: only UTF-8, with or without a byte order mark.
const parse = (bytes) => JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
const parseFile = (path) => parse(readFileSync(path));
const words = () =>
  (validate.errors ?? []).map((error) => `${error.instancePath} ${error.message}`).join('; ');

test('the schema accepts every scene that is shipped', () => {
  const folder = join(assets, 'scenes');
  const names = readdirSync(folder).filter((name) => name.endsWith('.json'));
  assert.ok(names.length > 1);
  for (const name of names) {
    if (name === 'index.json') continue; // the list of the others
    assert.ok(validate(parseFile(join(folder, name))), `${name}: ${words()}`);
  }
});

test('the schema accepts the scene that uses every key', () => {
  assert.ok(validate(parseFile(join(here, 'everything.json'))), words());
});

test('the schema rejects exactly the broken scenes that are marked so', () => {
  for (const { name, bytes, verdict } of brokenScenes()) {
    let found;
    try {
      found = validate(parse(bytes)) ? 'the schema accepts it' : 'the schema rejects it';
    } catch {
      found = 'not JSON';
    }
    assert.equal(found, verdict, `${name}: ${words()}`);
  }
});

test('the schema describes every key, so that an editor can explain it', () => {
  const resolve = (node) =>
    node.$ref ? { ...schema.definitions[node.$ref.split('/').pop()], ...node } : node;
  let count = 0;
  const visit = (node, path) => {
    for (const [key, property] of Object.entries(node.properties ?? {})) {
      const resolved = resolve(property);
      assert.ok(resolved.title, `${path}/${key} has no title`);
      count += 1;
    }
    if (node.properties)
      assert.equal(node.additionalProperties, false, `${path} lets unknown keys pass`);
    // A condition repeats keys without explaining them.
    for (const [key, child] of Object.entries(node))
      if (key !== 'if' && child && typeof child === 'object') visit(child, `${path}/${key}`);
  };
  visit(schema, '');
  assert.ok(count > 50);
});
