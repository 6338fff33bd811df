// Worlds in links and templates: each opens as it was, and a stranger's link is bounded.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { Buffer } from 'node:buffer';
import { createRequire } from 'node:module';
import process from 'node:process';
import { test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { mistakesOf, shippedScenes } from '../wasm/load.mjs';
import { editModules, seededRandom } from './modules.mjs';

const { kSureCharacters, linkOf, printed, templates, textOf } = await editModules();
const { deflateSync } = createRequire(new URL('../../tools/package.json', import.meta.url))(
  'fflate',
);

const kBase = 'https://example.org/slicecast/edit.html?template=cave';
const hashOf = (bytes) => `#world=${bytes.toString('base64url')}`;

for (const { name, scene } of templates) {
  test(`the template ${name} is a scene without faults, and fits into a link`, async () => {
    const text = printed(scene(), '');
    assert.deepEqual(JSON.parse(text), JSON.parse(JSON.stringify(scene())));
    const running = await load(scene());
    assert.deepEqual(running.warnings, []);
    // Blocks that stand nowhere yet are there to build with.
    const { warnings, spares } = await mistakesOf(scene());
    assert.deepEqual(warnings, []);
    for (const { pointer } of spares)
      assert.match(pointer, /^\/(blueprints|legend|textures|sprites)\//);
    running.step(60, { forward: 1 });
    running.free();
    const link = linkOf(text, kBase);
    assert.ok(link.startsWith('https://example.org/slicecast/edit.html?template=cave#world='));
    assert.deepEqual(JSON.parse(textOf(new URL(link).hash)), scene());
  });
}

test('a link keeps the order of keys, and every letter within quotes', () => {
  const text =
    '{ "title": "a  \\"b\\" \\\\",\n\t"legend": { "#": "wall", "2": "two",\r\n "1": "one", " ": null } }';
  const same = '{"title":"a  \\"b\\" \\\\","legend":{"#":"wall","2":"two","1":"one"," ":null}}';
  assert.equal(textOf(new URL(linkOf(text, kBase)).hash), same);
});

test('shipped scenes have links, and a world that is too large has none', () => {
  for (const file of shippedScenes)
    assert.ok(linkOf(readFileSync(file, 'utf8'), kBase).length < 16000, file);
  const random = seededRandom(1);
  const noise = Array.from({ length: 40000 }, () => random(10)).join('');
  assert.equal(linkOf(JSON.stringify({ title: noise }), kBase).length > kSureCharacters, true);
  assert.equal(linkOf(JSON.stringify({ title: noise + noise }), kBase), null);
});

test('damaged and hostile links are refused in words', () => {
  const link = new URL(linkOf(printed(templates[0].scene(), ''), kBase)).hash;
  for (const damaged of [
    '#world=',
    '#world=%%%',
    link.slice(0, -20),
    `${link.slice(0, 40)}AAAA${link.slice(44)}`,
  ]) {
    let text = null;
    try {
      text = textOf(damaged);
    } catch (error) {
      assert.match(error.message, /^The link is damaged/);
    }
    if (text !== null) assert.throws(() => JSON.parse(text));
  }
  const bomb = Buffer.from(deflateSync(new Uint8Array(64 << 20)));
  assert.ok(bomb.length < 100_000);
  const before = process.memoryUsage().rss;
  assert.throws(() => textOf(hashOf(bomb)), /too large: found more than 4 MB/);
  assert.ok(process.memoryUsage().rss - before < 48 << 20);
});
