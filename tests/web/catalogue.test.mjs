// The catalogue of shipped pictures: it has every file, its sizes are right, its snippets load, and
// words that do not fit the files stop the build.

import assert from 'node:assert/strict';
import {
  cpSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { Catalogue } from '../../tools/docs/catalogue.mjs';
import { root } from '../wasm/load.mjs';

const assets = path.join(root, 'assets');
const page = readFileSync(path.join(root, 'build/web/docs/catalogue.html'), 'utf8');
const source = readFileSync(path.join(root, 'web/docs/catalogue.md'), 'utf8');
const pngs = readdirSync(assets, { recursive: true })
  .map((name) => name.replaceAll(path.sep, '/'))
  .filter((name) => name.endsWith('.png') && !name.startsWith('pictures/'));
const sidesOf = (name) => {
  const bytes = readFileSync(path.join(assets, name));
  return [bytes.readUInt32BE(16), bytes.readUInt32BE(20)];
};

test('every picture is shown, with its path and its size, and no other', () => {
  assert.ok(pngs.length > 100);
  const figures = page.match(/<figure[\s\S]*?<\/figure>/g);
  for (const name of pngs) {
    const [width, height] = sidesOf(name);
    const own = figures.filter((each) => each.includes(` src="../${name}"`));
    assert.equal(own.length, 1, name);
    const [, about] = own[0].split(`<code>../${name.replace('/', '/<wbr>')}</code>`);
    const [, sides, frames, wide, high] =
      /<span>(?:(\d) sides)?(?: × )?(?:(\d+) frames)?(?: of )?(\d+) × (\d+)/.exec(about);
    assert.deepEqual([wide * (frames ?? 1), high * (sides ?? 1)], [width, height], name);
    const numbers = /<ol class="numbers">(.*?)<\/ol>/.exec(own[0])?.[1].match(/<li>/g) ?? [0];
    assert.equal(numbers.length, Number(frames ?? 1), name);
  }
  const shown = [...page.matchAll(/<img[^>]* src="\.\.\/([^"]+\.png)"/g)].map(([, name]) => name);
  assert.deepEqual([...new Set(shown)].sort(), [...pngs].sort());
});

test('pictures keep their shape, load late, and have words', () => {
  for (const [tag, name] of page.matchAll(/<img[^>]* src="\.\.\/([^"]+\.png)"[^>]*>/g)) {
    const [width, height] = sidesOf(name);
    const [, wide, high] = / width="(\d+)" height="(\d+)" loading="lazy">/.exec(tag);
    assert.equal(wide * height, high * width, name);
  }
  const figures = page.match(/<figure[\s\S]*?<\/figure>/g);
  for (const figure of figures) assert.match(figure, /<img[^>]* alt="[^"]+"/);
});

test('every snippet loads without a warning', async () => {
  const names = [...source.matchAll(/^```json(.*)$/gm)].map(
    ([, info]) => / opens=([\w-]+)/.exec(info)?.[1] ?? info,
  );
  assert.ok(names.length > 15);
  for (const name of names) {
    assert.ok(page.includes(`?scene=docs/scenes/${name}.json`), name);
    const scene = await load(path.join(root, `build/web/docs/scenes/${name}.json`));
    assert.deepEqual(scene.warnings, [], name);
    scene.free();
  }
});

// A folder of assets with a texture, a sheet, and a sprite of four sides that a scene uses.
function smallAssets(t) {
  const folder = mkdtempSync(path.join(tmpdir(), 'slicecast-catalogue-'));
  t.after(() => rmSync(folder, { recursive: true }));
  for (const name of [
    'textures/brick.png',
    'sheets/lava.png',
    'sprites/fox.png',
    'sprites/oak.png',
  ])
    cpSync(path.join(assets, name), path.join(folder, name));
  mkdirSync(path.join(folder, 'scenes'));
  const sprites = { fox: { file: '../sprites/fox.png', views: 4 }, tree: '../sprites/oak.png' };
  const maps = [
    { objects: [{ sprite: 'tree', height: 3 }], sow: [{ sprite: 'tree', height: [2, 4] }] },
  ];
  writeFileSync(path.join(folder, 'scenes/a.json'), JSON.stringify({ sprites, maps }));
  return folder;
}
const lava = { textures: { lava: { file: '../sheets/lava.png', frames: 8 } } };
const fox = { sprites: { fox: { file: '../sprites/fox.png', views: 4 } } };

test('a picture that the page does not name is shown all the same', (t) => {
  const catalogue = new Catalogue(smallAssets(t));
  catalogue.sheets('Flows.', lava);
  catalogue.sheets('Stands.', fox);
  const html = catalogue.others();
  assert.match(html, /<h2 id="others">/);
  assert.match(html, /src="\.\.\/textures\/brick\.png"/);
  assert.match(html, /src="\.\.\/sprites\/oak\.png"[\s\S]*216 × 244, height 2 to 4</);
  assert.equal(catalogue.others(), '');
});

test('words that do not fit the files stop the build', (t) => {
  const folder = smallAssets(t);
  const refuses = (use, message) => assert.throws(() => use(new Catalogue(folder)), message);
  refuses((catalogue) => catalogue.others(), /about the sheet sheets\/lava\.png/);
  refuses((catalogue) => {
    catalogue.sheets('Flows.', lava);
    catalogue.others();
  }, /about the sheet sprites\/fox\.png/);
  refuses(
    (catalogue) => catalogue.list({}, 'sprites/fox.png\n'),
    /sheet sprites\/fox\.png in a list/,
  );
  refuses((catalogue) => catalogue.list({}, 'textures/straw.png\n'), /found textures\/straw\.png/);
  refuses(
    (catalogue) => catalogue.list({}, 'textures/brick.png\ntextures/brick.png\n'),
    /found textures\/brick\.png twice/,
  );
  refuses((catalogue) => catalogue.list({ joined: 'up' }, 'textures/brick.png\n'), /joined=up/);
  refuses((catalogue) => catalogue.sheets('', lava), /no words about \.\.\/sheets\/lava\.png/);
  refuses((catalogue) => catalogue.sheets(true, lava), /no words about/);
  refuses((catalogue) => catalogue.sheets('Flows.', {}), /frames="Flows\."/);
  refuses(
    (catalogue) =>
      catalogue.sheets('Gone.', { sprites: { owl: { file: '../sprites/owl.png', frames: 2 } } }),
    /found sprites\/owl\.png/,
  );
  refuses(
    (catalogue) =>
      catalogue.sheets('Runs.', {
        sprites: { fox: { file: '../sprites/fox.png', views: 4, frames: 2 } },
      }),
    /2 frames, 4 views of sprites\/fox\.png, expected 1, 4 as in a\.json/,
  );
  const sprites = { fox: '../sprites/fox.png' };
  writeFileSync(path.join(folder, 'scenes/b.json'), JSON.stringify({ sprites, maps: [] }));
  refuses((catalogue) => catalogue.sheets('Stands.', fox), /expected 1, 1 as in b\.json/);
  writeFileSync(path.join(folder, 'textures/text.png'), 'This is a text, and not a picture.');
  assert.throws(() => new Catalogue(folder), /textures\/text\.png: found other bytes/);
});
