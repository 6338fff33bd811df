// The published schema: it accepts every scene that is shipped, rejects of the broken ones exactly
// those that are marked so, and explains itself.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv';

const here = dirname(fileURLToPath(import.meta.url));
const assets = join(here, '../../assets');
const broken = join(here, 'broken');
const schema = JSON.parse(readFileSync(join(assets, 'scene.schema.json'), 'utf8'));
const validate = new Ajv({
  allErrors: true,
  strict: true,
  strictTypes: false,
  strictRequired: false,
}).compile(schema);

// Besides scenes the folders hold a list each: of the menu's entries, and of what is wrong with the
// broken scenes.
const lists = ['index.json', 'expected.json'];
const scenesIn = (folder) =>
  readdirSync(folder).filter((name) => name.endsWith('.json') && !lists.includes(name));
// As an editor reads a file: UTF-8 and nothing else, with or without a byte order mark.
const parse = (path) =>
  JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(readFileSync(path)));
const words = () =>
  (validate.errors ?? []).map((error) => `${error.instancePath} ${error.message}`).join('; ');

test('the schema accepts every scene that is shipped', () => {
  const names = scenesIn(join(assets, 'scenes')).filter((name) => name !== 'index.json'); // the list of the others
  assert.ok(names.length > 0);
  for (const name of names)
    assert.ok(validate(parse(join(assets, 'scenes', name))), `${name}: ${words()}`);
});

test('the schema accepts the scene that uses every key', () => {
  assert.ok(validate(parse(join(here, 'everything.json'))), words());
});

test('the schema rejects exactly the broken scenes that are marked so', () => {
  const list = parse(join(broken, 'expected.json'));
  assert.deepEqual(list.map((entry) => entry.file).sort(), scenesIn(broken).sort());
  for (const { file, schema: verdict } of list) {
    const path = join(broken, file);
    if (verdict === 'is not JSON') {
      assert.throws(() => parse(path), file);
    } else {
      assert.ok(['rejects', 'accepts'].includes(verdict), file);
      const isAccepted = validate(parse(path));
      assert.equal(isAccepted ? 'accepts' : 'rejects', verdict, `${file}: ${words()}`);
    }
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
    for (const [key, child] of Object.entries(node))
      if (child && typeof child === 'object') visit(child, `${path}/${key}`);
  };
  visit(schema, '');
  assert.ok(count > 50);
});
