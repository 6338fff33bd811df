// The documentation as it was built: its links lead somewhere, the reference has every key of the
// schema, no page needs a script of its own, and building it again changes nothing.

import assert from 'node:assert/strict';
import { execFile, execFileSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { promisify } from 'node:util';

import { Pictures } from '../../tools/docs/pictures.mjs';
import { objectKinds } from '../../tools/docs/schema-kinds.mjs';
import { crashToo } from '../node/crash.mjs';
import { mistakesOf, root } from '../wasm/load.mjs';

const run = promisify(execFile);

const site = path.join(root, 'build/web');
const sources = path.join(root, 'web/docs');
const read = (...names) => readFileSync(path.join(...names), 'utf8');
const filesIn = (folder, end) => readdirSync(folder).filter((name) => name.endsWith(end));
const pages = filesIn(path.join(site, 'docs'), '.html').map((name) => `docs/${name}`);
const others = [
  'index.html',
  'element.html',
  ...['examples', 'learn'].flatMap((folder) =>
    filesIn(path.join(site, folder), '.html').map((name) => `${folder}/${name}`),
  ),
];

const attributesOf = (html, name) =>
  [...html.matchAll(new RegExp(`\\s${name}="([^"]*)"`, 'g'))].map(([, value]) =>
    value.replaceAll('&amp;', '&'),
  );
const isElsewhere = (address) => /^[a-z]+:/.test(address);

test('each Markdown file is a page', () => {
  const names = filesIn(sources, '.md').map((name) => `docs/${name.replace('.md', '.html')}`);
  assert.ok(names.length > 10);
  assert.deepEqual(pages.sort(), names.sort());
  for (const page of pages) {
    const html = read(site, page);
    for (const other of pages)
      assert.ok(html.includes(`href="${path.basename(other)}"`), `${page} leads to ${other}`);
  }
});

test('links lead to files and to places in them', () => {
  for (const page of [...pages, ...others]) {
    const html = read(site, page).replaceAll(/<pre[\s\S]*?<\/pre>/g, '');
    const all = ['href', 'src', 'poster'].flatMap((name) => attributesOf(html, name));
    for (const address of all.filter((each) => !isElsewhere(each))) {
      const [, file, place] = /^([^?#]*)(?:\?[^#]*)?(?:#(.*))?$/.exec(address);
      const target = file === '' ? page : path.join(path.dirname(page), file);
      assert.ok(existsSync(path.join(site, target)), `${page}: ${address}`);
      if (place && target.endsWith('.html'))
        assert.ok(attributesOf(read(site, target), 'id').includes(place), `${page}: ${address}`);
    }
    const scenes = [...attributesOf(html, 'scene'), ...attributesOf(html, 'href')]
      .map((address) => /^(?:[^?]*\?scene=)?((?:docs\/)?scenes\/[\w-]+\.json)/.exec(address)?.[1])
      .filter((address) => address && pages.includes(page));
    for (const scene of scenes)
      assert.ok(
        existsSync(path.join(site, 'docs/scenes', path.basename(scene))),
        `${page}: ${scene}`,
      );
  }
});

test('ids are unique', () => {
  for (const page of pages) {
    const ids = attributesOf(read(site, page), 'id');
    assert.deepEqual(ids.sort(), [...new Set(ids)].sort(), page);
  }
});

// The ids of headings as code hosts spell them.
const slugsOf = (markdown) =>
  [...markdown.matchAll(/^#+ (.*)$/gm)].map(([, title]) =>
    title
      .toLowerCase()
      .replaceAll(/[^\p{L}\p{N}\s_-]/gu, '')
      .replaceAll(/\s/g, '-'),
  );

test('links in the Markdown lead somewhere in the repository, too', () => {
  const files = ['README.md', 'CONTRIBUTING.md'];
  files.push(...filesIn(sources, '.md').map((name) => `web/docs/${name}`));
  let count = 0;
  for (const file of files) {
    for (const [, address] of read(root, file).matchAll(/\]\(([^)\s]+)\)/g)) {
      if (isElsewhere(address)) continue;
      const [name, place] = address.split('#');
      count += 1;
      // Files that the build makes are not in the repository.
      if (file.startsWith('web/docs/') && name.startsWith('../')) continue;
      const target = path.join(root, name === '' ? file : path.join(path.dirname(file), name));
      assert.ok(existsSync(target), `${file}: ${address}`);
      if (place)
        assert.ok(slugsOf(readFileSync(target, 'utf8')).includes(place), `${file}: ${address}`);
    }
  }
  assert.ok(count > 40);
});

test('lines of Markdown have at most 100 characters, except tables and first lines of blocks', () => {
  const files = ['README.md', 'CONTRIBUTING.md'];
  files.push(...filesIn(sources, '.md').map((name) => `web/docs/${name}`));
  for (const file of files) {
    for (const [index, line] of read(root, file).split('\n').entries())
      if (!/^(\||```|!\[)/.test(line))
        assert.ok(
          [...line].length <= 100,
          `${file}:${index + 1} has ${[...line].length} characters`,
        );
  }
});

test('no page has a script, a style or a handler of its own', () => {
  for (const page of pages) {
    const html = read(site, page).replaceAll(/<pre[\s\S]*?<\/pre>/g, '');
    for (const [tag, text] of html.matchAll(/<script\b[^>]*>([\s\S]*?)<\/script>/g))
      assert.ok(/ src="\.\.\/[\w-]+\.js"/.test(tag) && text === '', `${page}: ${tag}`);
    assert.doesNotMatch(html, /<style\b|\sstyle=|\son[a-z]+=|javascript:/, page);
  }
});

test('pages have the same policy as the others', () => {
  const policies = (page) => read(site, page).match(/<meta http-equiv=[^>]*>/g) ?? [];
  for (const page of pages) assert.deepEqual(policies(page), policies('element.html'), page);
});

// Every object of the schema: the keys that it may have.
function* objectsOf(node) {
  if (typeof node !== 'object' || node === null) return;
  if (node.properties) yield Object.keys(node.properties);
  for (const value of Object.values(node)) yield* objectsOf(value);
}

test('no scene of the docs has a probable mistake', async () => {
  const folder = path.join(site, 'docs/scenes');
  const names = filesIn(folder, '.json');
  assert.ok(names.length > 15);
  for (const name of names)
    assert.deepEqual((await mistakesOf(path.join(folder, name))).warnings, [], name);
});

test('the reference has every key of the schema, with what it takes and an example', () => {
  const html = read(site, 'docs/scene-reference.html');
  const tables = html.split('<table class="reference keys">').slice(1);
  const keysOf = (table) =>
    [...table.matchAll(/<th scope="row"><code>([^<]+)<\/code>/g)].map(([, key]) => key);
  const told = tables.map(keysOf);
  let count = 0;
  for (const keys of objectsOf(JSON.parse(read(root, 'assets/scene.schema.json')))) {
    const wanted = keys.filter((key) => key !== 'comment' && key !== 'data');
    count += wanted.length;
    assert.ok(
      told.some((table) => wanted.every((key) => table.includes(key))),
      `no table has ${wanted.join(', ')}`,
    );
  }
  assert.ok(count > 100);
  for (const key of ['comment', 'data']) assert.ok(told.flat().includes(key), key);
  for (const [row, id, cells] of html.matchAll(/<tr id="([^"]+)">([\s\S]*?)<\/tr>/g)) {
    for (const label of ['Takes', 'Default', 'Example', 'What it does'])
      assert.match(cells, new RegExp(`data-label="${label}">.+?</td>`), `${id}: ${row}`);
    assert.doesNotMatch(cells, /data-label="Example"><span class="none">/, `${id} has an example`);
  }
});

test('every picture has its scene, and a text alternative', () => {
  const html = read(site, 'docs/scenes.html');
  const names = [...html.matchAll(/<img src="scenes\/([\w-]+)\.png" alt="([^"]+)"/g)];
  assert.ok(names.length >= 20);
  for (const [, name] of names) {
    assert.ok(existsSync(path.join(site, 'docs/scenes', `${name}.json`)));
    assert.ok(existsSync(path.join(site, 'docs/scenes', `${name}.png`)));
  }
});

test('a snippet that does not load stops the build', async (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'slicecast-docs-'));
  t.after(() => rmSync(folder, { recursive: true }));
  cpSync(site, folder, { recursive: true });
  const draw = (name, snippet) => {
    const pictures = new Pictures(folder);
    pictures.add({ picture: name, alt: 'A wall' }, snippet, (text) => text);
    return pictures.draw();
  };
  await draw('right', '"blueprints": { "wall": { "faces": "brick" } }');
  await assert.rejects(draw('wrong', '"blueprints": { "wall": { "faces": "brik" } }'), /brik/);
  assert.throws(() => draw('broken', '"blueprints": {'), /picture broken/);
  const unseen = new Pictures(folder);
  unseen.addUnseen({ opens: 'unseen' }, '"blueprints": { "wall": { "faces": "brik" } }');
  await assert.rejects(unseen.draw(), /brik/);
  const pictures = new Pictures(folder);
  assert.throws(() => pictures.add({ picture: 'silent' }, '', String), /silent has no alt/);
});

// Blocks without main() are the bodies of functions that have a game and an image.
test('the C++ snippets compile', (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'slicecast-docs-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const snippets = ['README.md', 'web/docs/library.md'].flatMap((name) =>
    [...read(root, name).matchAll(/^```cpp\n([\s\S]*?)^```/gm)].map(([, code]) => code),
  );
  assert.ok(snippets.length >= 5);
  const compiler = process.env.CXX ?? 'c++';
  const folders = ['src/include', 'build/native/include'].map((folder) => path.join(root, folder));
  const options = ['-std=c++20', '-fsyntax-only', ...folders.flatMap((folder) => ['-I', folder])];
  const bodies = snippets.filter((code) => !code.includes('int main('));
  const functions = bodies.map(
    (code, index) =>
      `void f${index}([[maybe_unused]] slicecast::Game& game,` +
      ` [[maybe_unused]] slicecast::Image& image) {\n${code}}\n`,
  );
  const together = `#include <slicecast/slicecast.h>\n#include <utility>\n${functions.join('')}`;
  for (const code of [...snippets.filter((one) => !bodies.includes(one)), together]) {
    const file = path.join(folder, 'snippet.cpp');
    writeFileSync(file, code);
    execFileSync(compiler, [...options, file], { stdio: 'pipe' });
  }
});

test('two different objects of one name stop the reference', () => {
  const object = (key) => ({ type: 'object', properties: { [key]: { type: 'number' } } });
  const schema = (second) => ({
    properties: { sky: { properties: { sun: object('size') } }, light: { properties: second } },
    definitions: {},
  });
  assert.throws(() => objectKinds(schema({ sun: object('azimuth') })), /two different .* "sun"/);
  assert.equal(objectKinds(schema({ lamp: object('azimuth') })).length, 5);
});

test('building it again gives the same bytes', async (t) => {
  const folder = mkdtempSync(path.join(tmpdir(), 'slicecast-docs-'));
  t.after(() => rmSync(folder, { recursive: true }));
  cpSync(site, folder, { recursive: true });
  for (const tool of ['docs.mjs', 'cards.mjs'])
    await run(process.execPath, [path.join(root, 'tools', tool), folder]).catch(crashToo);
  const names = readdirSync(path.join(site, 'docs'), { recursive: true }).sort();
  assert.deepEqual(readdirSync(path.join(folder, 'docs'), { recursive: true }).sort(), names);
  for (const name of names.filter((each) => path.extname(each) !== ''))
    assert.deepEqual(
      readFileSync(path.join(folder, 'docs', name)),
      readFileSync(path.join(site, 'docs', name)),
      name,
    );
});
