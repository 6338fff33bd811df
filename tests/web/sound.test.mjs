// What sounds are made of: every kind and material of the engine has a recipe, within ranges that
// can be heard.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import {
  kLasting,
  kLevels,
  kMaterials,
  kOnce,
  lastingRecipe,
  onceRecipe,
  variation,
} from '../../web/sound/recipes.js';
import { root } from '../wasm/load.mjs';

const read = (file) => readFileSync(join(root, file), 'utf8');

// The names in an enumeration of the header, in its order.
function enumerated(name) {
  const [, body] = new RegExp(`enum class ${name} : std::uint8_t \\{([^}]*)\\}`).exec(
    read('src/include/slicecast/sound.h'),
  );
  return body.replaceAll(/\/\/.*$/gm, '').match(/\w+/g);
}

test('kinds and materials are those of the engine', () => {
  assert.deepEqual(kMaterials, enumerated('Material'));
  assert.deepEqual([...kOnce, ...kLasting], enumerated('SoundKind'));
  assert.match(read('src/include/slicecast/sound.h'), /kFirstLasting = SoundKind::gate;/);
  assert.equal(kLasting[0], 'gate');
});

// All recipes by name.
function allRecipes() {
  const all = new Map();
  for (const material of kMaterials) {
    for (const kind of kOnce) all.set(`${kind} ${material}`, onceRecipe(kind, material));
    for (const kind of kLasting) {
      const recipe = lastingRecipe(kind, material);
      if (recipe !== null) all.set(`${kind} ${material}`, recipe);
      else assert.equal(kind, 'submerged');
    }
  }
  return all;
}

test('all layers can be heard and played', () => {
  for (const [name, layers] of allRecipes()) {
    assert.ok(layers.length > 0 && layers.length <= 8, name);
    assert.ok(kLevels[name.split(' ')[0]] > 0, name);
    for (const layer of layers) {
      assert.ok((layer.noise === undefined) !== (layer.tone === undefined), name);
      for (const hertz of [layer.hertz, layer.to ?? layer.hertz])
        assert.ok(hertz >= 40 && hertz <= 8000, `${name}: ${hertz} Hz`);
      assert.ok(layer.gain > 0 && layer.gain <= 3, `${name}: gain ${layer.gain}`);
      if (layer.decay !== undefined) {
        assert.ok(layer.attack > 0, `${name} would begin with a click`);
        assert.ok(layer.delay + layer.attack + layer.decay < 1.5, `${name} is over soon`);
      }
      const { sway, pulse } = layer;
      assert.ok(sway === undefined || sway.hertz < layer.hertz, `${name} sways below 0 Hz`);
      assert.ok(pulse === undefined || (pulse.depth > 0 && pulse.depth <= 1), name);
    }
  }
});

test('no two materials sound the same underfoot', () => {
  const steps = kMaterials.map((material) => JSON.stringify(onceRecipe('step', material)));
  assert.equal(new Set(steps).size, kMaterials.length);
});

test('each step differs a little from the last, in the same way each time', () => {
  const many = Array.from({ length: 500 }, (_, count) => variation(count));
  assert.deepEqual(many[7], variation(7));
  assert.ok(new Set(many.map(({ pitch }) => pitch)).size > 490);
  for (const { pitch, gain } of many) {
    assert.ok(Math.abs(pitch - 1) <= 0.06, `pitch ${pitch}`);
    assert.ok(gain > 0.84 && gain <= 1, `gain ${gain}`);
  }
});

test('the guide lists the words that tell a material', () => {
  const rows = [...read('web/docs/scenes.md').matchAll(/^\| (\w+) \| (`\w+`.*) \|$/gm)];
  const told = new Map(
    rows
      .filter(([, material]) => kMaterials.includes(material))
      .map(([, material, words]) => [material, words.match(/(?<=`)\w+(?=`)/g).sort()]),
  );
  const known = new Map(kMaterials.map((material) => [material, [material]]));
  const table = /kTellingWords\[\] = \{([\s\S]*?)\n\};/.exec(read('src/world/material.cpp'))[1];
  for (const [, material, word] of table.matchAll(/Material::(\w+), "(\w+)"/g))
    known.get(material).push(word);
  for (const words of known.values()) words.sort();
  assert.deepEqual(told, known);
});
