// The command `slicecast html`, in a package that is put together as npm would.

import assert from 'node:assert/strict';
import { cp, mkdtemp, readFile, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { folderWith as folderIn } from '../import/command-folder.mjs';

const root = fileURLToPath(new URL('../../', import.meta.url));
const kBuilt = path.join(root, 'build/web');
const kArt = ['engine', 'textures', 'sprites', 'see-through', 'sheets', 'scenes', 'pictures.json'];

let home;
before(async () => {
  home = await mkdtemp(path.join(tmpdir(), 'slicecast-html-'));
  for (const folder of ['node', 'edit'])
    await cp(path.join(kBuilt, folder), path.join(home, 'slicecast', folder), { recursive: true });
  await writeFile(path.join(home, 'slicecast/package.json'), '{"type":"module"}');
  for (const name of kArt)
    await symlink(path.join(kBuilt, name), path.join(home, 'slicecast', name));
  await symlink(path.join(root, 'tools/node_modules'), path.join(home, 'slicecast/node_modules'));
});
after(() => rm(home, { recursive: true }));

const folderWith = (files) => folderIn(home, files);

const scene = (more = {}) =>
  JSON.stringify({
    title: 'A <yard>',
    textures: { own: 'own.png', brick: '../textures/brick.png' },
    blueprints: { a: { faces: 'own' }, b: { faces: 'brick' } },
    legend: { a: 'a', b: 'b' },
    maps: [{ name: 'yard', floor: 'brick', levels: [['aaaa', 'b..b', 'b..b', 'aaaa']] }],
    start: { x: 1.5, y: 1.5 },
    ...more,
  });
const kPicture = await readFile(path.join(kBuilt, 'textures/rock.png'));

test('it makes one file of a scene, its own pictures and shipped ones', async () => {
  const { call, read } = await folderWith({ 'maps/yard.json': scene(), 'maps/own.png': kPicture });
  const { status, stdout, stderr } = await call('html', 'maps/yard.json');
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(stdout, /^Wrote yard\.html: 4\d\d KB\.\n$/);
  const html = await read('yard.html', 'utf16le');
  assert.ok(html.includes('<title>A &lt;yard&gt;</title>'));
  for (const mark of ['title', 'world', 'parts', 'boot']) assert.ok(!html.includes(`{{${mark}}}`));
  const again = await call('html', 'maps/yard.json');
  assert.equal(again.status, 1);
  assert.match(again.stderr, /yard\.html: already there; --force/);
  assert.equal((await call('html', 'maps/yard.json', '-o', 'yard.html', '--force')).status, 0);
  assert.equal((await call('html', 'maps/yard.json', '-o', 'maps/yard.json')).status, 2);
});

test('it carries shipped pictures that the scene names without declaring them', async () => {
  const declared = { own: 'own.png', brick: '../textures/brick.png' };
  const { call, read } = await folderWith({
    'yard.json': scene({ textures: declared }),
    'named.json': scene({ textures: { own: 'own.png' } }),
    'own.png': kPicture,
  });
  for (const name of ['yard', 'named'])
    assert.equal((await call('html', `${name}.json`)).status, 0, name);
  const [yard, named] = [await read('yard.html', null), await read('named.html', null)];
  assert.equal(named.length, yard.length, 'the same scene');
  assert.deepEqual(named, yard);
});

test('of a scene with faults it makes none, and lists them', async () => {
  const { call, read } = await folderWith({
    'yard.json': scene(),
    'away.json': scene({ start: { x: 40, y: 1 } }),
    'none.json': '{',
  });
  for (const [file, message] of [
    ['yard.json', /yard\.json has faults:\n.*own\.png/],
    ['away.json', /away\.json has faults:/],
    ['none.json', /none\.json has faults:/],
    ['missing.json', /ENOENT/],
  ]) {
    const { status, stdout, stderr } = await call('html', file);
    assert.deepEqual([status, stdout], [1, ''], file);
    assert.match(stderr, message);
    assert.doesNotMatch(stderr, /\n {4}at /);
    await assert.rejects(read(file.replace('.json', '.html')));
  }
  assert.equal((await call('html', 'yard.json', '--root', '.')).status, 2);
});
