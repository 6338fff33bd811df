// The command `slicecast import`, in a package that is put together as npm would.

import assert from 'node:assert/strict';
import { cp, mkdtemp, readFile, readdir, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { root, tilesPicture } from './load.mjs';
import { folderWith as folderIn } from './command-folder.mjs';

let home;
before(async () => {
  home = await mkdtemp(path.join(tmpdir(), 'slicecast-command-'));
  for (const folder of ['node', 'edit'])
    await cp(path.join(root, 'web', folder), path.join(home, 'slicecast', folder), {
      recursive: true,
    });
  await writeFile(path.join(home, 'slicecast/package.json'), '{"type":"module"}');
  const links = { node_modules: 'tools/node_modules', engine: 'build/web/engine' };
  for (const art of ['textures', 'sprites', 'scenes']) links[art] = `assets/${art}`;
  for (const [name, to] of Object.entries(links))
    await symlink(path.join(root, to), path.join(home, 'slicecast', name));
});
after(() => rm(home, { recursive: true }));

const folderWith = (files) => folderIn(home, files);

const kMatrix = '1 1 1 1\n1 0 2 1\n1 0 0 1\n1 1 1 1\n';
const kTmx = `<map orientation="orthogonal" width="3" height="2" tilewidth="16" tileheight="16">
  <tileset firstgid="1" source="../sets/town.tsx"/>
  <imagelayer id="2" name="Sky"><image source="sky.png"/></imagelayer>
  <layer id="1" name="Walls" width="3" height="2"><data encoding="csv">1,1,1,1,0,1</data></layer>
</map>`;
const kTsx = `<tileset name="town" tilewidth="16" tileheight="16" tilecount="6" columns="3"><image source="town.png" width="48" height="32"/></tileset>`;

test('it writes a scene with its pictures beside it, and says what it left out', async () => {
  const { folder, call } = await folderWith({ 'maze.txt': kMatrix });
  const { status, stdout, stderr } = await call('import', 'maze.txt');
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(
    stdout,
    /^Wrote maze-scene\.json and 3 pictures\.\n {2}Maze: 4 x 4 tiles, levels: 1\n/,
  );
  assert.match(stdout, /Not taken, or not as it was:\n {2}the start: there is none/);
  const shipped = await readFile(path.join(root, 'assets/textures/flagstones.png'));
  const copied = await readFile(path.join(folder, 'maze-scene/textures/flagstones.png'));
  assert.deepEqual(copied, shipped);
  const scene = await load(path.join(folder, 'maze-scene.json'));
  assert.equal(scene.world.title, 'Maze');
  scene.free();
});

test('it overwrites nothing unless it is told to, and never the map', async () => {
  const { folder, call } = await folderWith({ 'maze.txt': kMatrix, 'a/out.json': 'mine' });
  const first = await call('import', 'maze.txt', '-o', 'a/out.json');
  assert.deepEqual([first.status, first.stdout], [1, '']);
  assert.match(first.stderr, /a\/out\.json: already there; --force overwrites files/);
  assert.deepEqual(await readdir(path.join(folder, 'a')), ['out.json']);
  assert.equal(await readFile(path.join(folder, 'a/out.json'), 'utf8'), 'mine');
  assert.equal((await call('import', 'maze.txt', '-o', 'a/out.json', '--force')).status, 0);
  const onto = await call('import', 'maze.txt', '-o', './maze.txt', '--force');
  assert.equal(onto.status, 2);
  assert.equal(await readFile(path.join(folder, 'maze.txt'), 'utf8'), kMatrix);
});

test('it reads what lies in the folder that it is given, and nothing beyond', async () => {
  const { folder, call } = await folderWith({
    'maps/town.tmx': kTmx,
    'sets/town.tsx': kTsx,
    'sets/town.png': tilesPicture(),
  });
  const without = await call('import', 'maps/town.tmx');
  assert.equal(without.status, 1);
  assert.match(without.stderr, /town\.tmx, tileset .*which leaves the map's folder/);
  const within = await call('import', 'maps/town.tmx', '--root', '.');
  assert.deepEqual([within.status, within.stderr], [0, '']);
  assert.match(within.stdout, /layer "Sky": layers of the type "imagelayer"/);
  assert.ok((await readdir(path.join(folder, 'town'))).length > 0);
  assert.equal((await call('import', 'maps/town.tmx', '--root', 'sets')).status, 2);
});

test('errors have the exit status 1, wrong calls 2', async () => {
  const { call } = await folderWith({ 'bad.tmj': '{"layers":5}', 'empty.txt': '' });
  for (const [words, status, expected] of [
    [['import', 'none.tmx'], 1, /^slicecast: ENOENT: .*none\.tmx/],
    [['import', 'bad.tmj'], 1, /^slicecast: bad\.tmj: found a file without layers, expected a map/],
    [['import', 'empty.txt'], 1, /^slicecast: empty\.txt: found ""/],
    [[], 2, /^slicecast: found nothing, expected import or html\n\nslicecast import FILE/],
    [['export', 'x'], 2, /found export, expected import or html/],
    [['import'], 2, /found 0 files, expected one/],
    [['import', 'a', 'b'], 2, /found 2 files/],
    [['import', 'a', '--what'], 2, /Unknown option '--what'/],
  ]) {
    const answer = await call(...words);
    assert.deepEqual([answer.status, answer.stdout], [status, ''], words.join(' '));
    assert.match(answer.stderr, expected);
    assert.doesNotMatch(answer.stderr, /\n {4}at /);
  }
  const help = await call('--help');
  assert.deepEqual([help.status, help.stderr], [0, '']);
  assert.match(help.stdout, /^slicecast import FILE/);
});
