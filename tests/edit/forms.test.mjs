// What forms know of the schema: every key of it has a kind that a form can show, and the value
// that a form puts first is one that the schema takes.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import Ajv from 'ajv';

import { editModules, schemaParts } from './modules.mjs';

const { Schema, kindOfValue } = await editModules();

const kSchema = JSON.parse(
  readFileSync(new URL('../../assets/scene.schema.json', import.meta.url), 'utf8'),
);
const ajv = new Ajv({ strict: true, strictTypes: false, strictRequired: false });
const names = (what) =>
  ({
    textures: ['brick'],
    sprites: ['oak'],
    maps: ['yard'],
    motions: ['lift'],
    gates: ['door'],
    finds: ['shell'],
  })[what];

test('every key has a kind, words, and a first value that the schema takes', () => {
  const schema = new Schema(kSchema);
  const checked = new Set();
  for (const [at, node, said] of schemaParts(schema, kSchema)) {
    const mark = `${at.split('/').at(-1)} ${JSON.stringify(node)}`;
    if (at === '' || checked.has(mark)) continue;
    checked.add(mark);
    assert.ok(said.kinds.length > 0, at);
    assert.ok(
      said.kinds.every(({ type }) => typeof type === 'string'),
      at,
    );
    const value = schema.sample(node, names, at.split('/').at(-1));
    const takes = ajv.compile({ definitions: kSchema.definitions, allOf: [node] });
    assert.ok(takes(value), `${at}: ${JSON.stringify(value)}, ${JSON.stringify(takes.errors)}`);
    assert.notEqual(kindOfValue(said.kinds, value), undefined, at);
  }
  assert.ok(checked.size > 150, `${checked.size}`);
});

test('no two keys of an object have one title', () => {
  const schema = new Schema(kSchema);
  for (const [at, , { kinds }] of schemaParts(schema, kSchema))
    for (const { keys = new Map() } of kinds) {
      const titles = [...keys].map(([key, node]) => schema.of(node, key).title);
      assert.equal(new Set(titles).size, titles.length, `${at}: ${titles}`);
    }
});

test('a place of a scene is found in the schema', () => {
  const schema = new Schema(kSchema);
  assert.equal(schema.at(['maps', 0, 'fog', 'end']).kinds[0].type, 'number');
  assert.equal(schema.at(['blueprints', 'anything', 'top']).fallback, 1);
  assert.equal(schema.at(['maps', 3, 'objects', 7, 'sprite']).kinds[0].names, 'sprites');
  assert.equal(schema.at(['maps', 0, 'nonsense']), undefined);
  assert.deepEqual(
    schema.at(['maps', 0, 'sky']).kinds.map(({ type }) => type),
    ['text', 'object', 'object'],
  );
  const { kinds } = schema.at(['maps', 0, 'sky']);
  assert.ok(kindOfValue(kinds, { panorama: 'sky.png' }).keys.has('panorama'));
});
