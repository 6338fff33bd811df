// The pictures that a scene names: which names are allowed, by engine and schema alike, and which
// pictures are fetched before the engine has checked the scene.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import Ajv from 'ajv';
import fc from 'fast-check';
import { Engine } from '../../build/web/engine/engine.js';
import { readEngine } from '../../build/web/node/engine-files.js';
import { picturesIn } from '../../web/engine/source-parts.js';

const kHome = new URL('../../', import.meta.url);
const kSchema = JSON.parse(readFileSync(new URL('assets/scene.schema.json', kHome), 'utf8'));
const schemaTakes = new Ajv().compile(kSchema.definitions.file);
const kBases = ['https://here.example/a/b/c/scene.json', 'http://here.example/scene.json?x#y'];
const kSigns = [
  ...['a', 'Z', '0', '.', '..', '/', '//', '/../', '/./', ' ', '\t', '\n', '\u0000', '\u007f'],
  ...['\u0080', '\u009f', '\u00a0', '\u00ad', '\u2028', '\u202e', '\u3000', '\ufeff', '．', '／'],
  ...['\\', ':', '?', '#', '%2e', '%', '*', '"', '<', '>', '|', '@', '&', '=', ';', '+', '~', '$'],
  ...['{', '}', '^', '`', "'", '[', ']', 'é', '漢', '😀', 'http:', 'localhost', '.png', 'C:'],
];

let engine;
before(async () => {
  engine = await Engine.create({ files: await readEngine('auto') });
});
after(() => engine.stop());

// What the engine asks for, and its faults.
async function asked(text) {
  const files = [];
  const faults = await engine.loadScene({
    name: 'scene.json',
    readText: async () => new TextEncoder().encode(text),
    readFile: async (name) => {
      files.push(name);
      return null;
    },
  });
  return { files, faults };
}

const sceneWith = (name) =>
  JSON.stringify({
    title: 'One texture',
    textures: { a: name },
    maps: [{ name: 'm', levels: [['...', '...', '...']], floor: 'a' }],
    start: { x: 1.5, y: 1.5 },
  });

test('early, the pictures of a shipped scene are fetched that the engine asks for', async () => {
  const scenes = ['assets/scenes/', 'web/learn/scenes/', 'tests/scene/']
    .map((folder) => new URL(folder, kHome))
    .flatMap((folder) => readdirSync(folder).map((name) => new URL(name, folder)))
    .filter(({ pathname }) => pathname.endsWith('.json') && !pathname.endsWith('/index.json'));
  let count = 0;
  for (const scene of scenes) {
    const bytes = readFileSync(scene);
    const { files } = await asked(bytes.toString());
    count += files.length;
    assert.deepEqual(picturesIn(bytes).sort(), files.sort(), scene.pathname);
  }
  assert.ok(count > 500, `${count} pictures`);
});

test('early, nothing is fetched that is named elsewhere, or not plainly', () => {
  const names = (scene) => picturesIn(new TextEncoder().encode(JSON.stringify(scene)));
  const elsewhere = {
    title: 'title.png',
    comment: 'comment.png',
    maps: [{ name: 'name.png', haze: 'haze.png', legend: { a: { texture: 'legend.png' } } }],
  };
  assert.deepEqual(names(elsewhere), []);
  const kOdd = [
    ...['//host/x.png', ' //host/x.png', 'http://host/x.png', '/x.png', '\\\\host/x.png', 7, null],
    ...['x.png?', 'a?.png', 'a#.png', 'a:b.png', '%2e.png', 'a//b.png', '..//host.png', '#a.png'],
    ...['\t//host/x.png', 'a.jpg', 'a.png ', '\u00a0//host/x.png', 'data:image/png,x.png'],
  ];
  for (const file of kOdd)
    assert.deepEqual(
      names({
        textures: { a: file },
        sprites: { b: { file } },
        maps: [{ sky: { panorama: file } }],
      }),
      [],
      JSON.stringify(file),
    );
  assert.deepEqual(names({ textures: { a: 'a.png' }, maps: [{}] }), ['a.png']);
  assert.throws(() => names({ textures: { a: 'a.png' } }), TypeError);
});

const name = fc
  .array(fc.oneof(fc.constantFrom(...kSigns), fc.string({ unit: 'binary', maxLength: 2 })), {
    maxLength: 6,
  })
  .map((signs) => `${signs.join('')}.png`);

test('engine and schema take the same names, and an address reads them as a path', async () => {
  let taken = 0;
  await fc.assert(
    fc.asyncProperty(name, async (file) => {
      const { files, faults } = await asked(sceneWith(file));
      const isTaken = files.length > 0;
      assert.equal(schemaTakes(file), isTaken, faults[0]?.message);
      const isEarly = picturesIn(new TextEncoder().encode(sceneWith(file))).length > 0;
      if (!isTaken) {
        assert.match(faults[0].found, /^the (file name|text) "/);
        assert.ok(!isEarly);
        return;
      }
      taken += 1;
      assert.deepEqual(files, [file]);
      for (const base of kBases) {
        const { href, origin, pathname } = new URL(file, base);
        assert.equal(origin, new URL(base).origin);
        assert.equal(href, origin + pathname);
        // As a file system would go there.
        const steps = new URL(base).pathname.split('/').slice(1, -1);
        for (const step of file.split('/')) {
          if (step === '..') steps.pop();
          else if (step !== '.') steps.push(step);
        }
        assert.equal(decodeURIComponent(pathname), `/${steps.join('/')}`);
      }
    }),
    { numRuns: 3000 },
  );
  assert.ok(taken > 300, `${taken} names were taken`);
});
