// Shipped pictures that a scene names without declaring them, in the editor.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { editModules } from './modules.mjs';

const assets = fileURLToPath(new URL('../../assets/', import.meta.url));
const table = JSON.parse(readFileSync(path.join(assets, 'pictures.json'), 'utf8'));
const {
  SceneDocument,
  declared,
  keyOf,
  namesToChoose,
  partOf,
  pasteChanges,
  pictureOf,
  tableOf,
  knowShipped,
} = await editModules();

before(() => knowShipped(table));

const kScene = {
  title: 'Named',
  textures: { grass: 'own.png' },
  blueprints: { wall: { faces: { all: 'brick', top: { texture: 'lava' } } } },
  legend: { '#': 'wall' },
  maps: [
    {
      name: 'room',
      floor: 'grass',
      levels: [['###', '#.#', '###']],
      objects: [{ sprite: 'fox', x: 1.5, y: 1.5, height: 0.5 }],
    },
  ],
  start: { x: 1.5, y: 1.5 },
};
const kLava = { file: '../sheets/lava.png', frames: 8, rate: 6 };

test('a name is what the scene says of it, or a shipped picture', () => {
  assert.equal(pictureOf(kScene, 'textures', 'grass'), 'own.png');
  assert.deepEqual(pictureOf(kScene, 'textures', 'lava'), kLava);
  assert.equal(pictureOf(kScene, 'textures', 'toString'), undefined);
  assert.deepEqual(tableOf(kScene, 'textures'), {
    grass: 'own.png',
    brick: '../textures/brick.png',
    lava: kLava,
  });
});

test('forms offer the own names, then the shipped ones', () => {
  const names = namesToChoose(kScene, 'textures');
  assert.equal(names[0], 'grass');
  assert.equal(names.filter((name) => name === 'grass').length, 1);
  assert.ok(names.includes('waterfall') && !names.includes('cat'));
  assert.ok(namesToChoose(kScene, 'sprites').includes('cat'));
});

test('a scene that is carried elsewhere declares what it names', () => {
  const { textures, sprites, ...rest } = declared(kScene, (name) =>
    ['brick', 'lava', 'fox'].includes(name),
  );
  assert.deepEqual(Object.keys(textures), ['grass', 'brick', 'lava']);
  assert.deepEqual(sprites, { fox: { file: '../sprites/fox.png', views: 4 } });
  const { textures: own, ...same } = kScene;
  assert.deepEqual([rest, own], [same, { grass: 'own.png' }]);
});

test('a part brings shipped pictures along, and into the same names without an entry', () => {
  const scene = new SceneDocument(JSON.stringify(kScene));
  const part = partOf(scene, 0, new Set([keyOf({ level: 0, x: 0, y: 0 })]));
  assert.deepEqual(part.textures, { brick: '../textures/brick.png', lava: kLava });
  const into = (textures) => {
    const other = {
      ...kScene,
      textures: { grass: 'own.png', ...textures },
      blueprints: {},
      legend: {},
    };
    const document = new SceneDocument(JSON.stringify(other));
    return pasteChanges(document, 0, part, { level: 0, x: 1, y: 1 })
      .flatMap(({ together = [] }) => together)
      .filter((change) => change.path[0] === 'textures');
  };
  assert.deepEqual(into({}), []);
  assert.equal(into({ lava: 'other.png' }).length, 1, 'the name means another picture there');
});

// Skies are no textures.
test('the table has all shipped pictures', () => {
  const files = ['textures', 'see-through', 'sheets', 'sprites'].flatMap((folder) =>
    readdirSync(path.join(assets, folder)).map((name) => `${folder}/${name}`),
  );
  const entries = [...Object.entries(table.textures), ...Object.entries(table.sprites)];
  const named = new Set(entries.map(([, entry]) => entry.file ?? entry));
  assert.deepEqual(files.filter((file) => !/\/sky-/.test(file)).sort(), [...named].sort());
  for (const [name, entry] of entries) {
    const file = entry.file ?? entry;
    assert.equal(path.basename(file, '.png'), name);
    const bytes = readFileSync(path.join(assets, file));
    const [width, height] = [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
    if (Object.hasOwn(table.textures, name) && table.textures[name] === entry)
      assert.equal(width, height * (entry.frames ?? 1), name);
  }
});

// What shipped scenes say of a picture most often.
test('the table says of sheets what the shipped scenes say', () => {
  const said = new Map();
  for (const name of readdirSync(path.join(assets, 'scenes'))) {
    const scene = JSON.parse(readFileSync(path.join(assets, 'scenes', name), 'utf8'));
    for (const what of ['textures', 'sprites'])
      for (const entry of Object.values(scene[what] ?? {})) {
        if (typeof entry === 'string') continue;
        const { file, frames, rate, views } = entry;
        if (frames === undefined && views === undefined) continue;
        const key = `${what} ${path.basename(file, '.png')}`;
        if (!said.has(key)) said.set(key, []);
        said.get(key).push(JSON.stringify({ frames, rate, views }));
      }
  }
  assert.ok(said.size > 20);
  for (const [key, ways] of said) {
    const [what, name] = key.split(' ');
    const { frames, rate, views } = table[what][name];
    const mine = JSON.stringify({ frames, rate, views });
    const count = (way) => ways.filter((other) => other === way).length;
    for (const way of ways) assert.ok(count(mine) >= count(way), `${key}: ${way}`);
  }
});
