// What tools/play and tools/setup refuse, with which message. No test here gets as far as
// building.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, symlinkSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const tools = fileURLToPath(new URL('../../tools/', import.meta.url));

function run(command, args, env = process.env) {
  return spawnSync(path.join(tools, command), args, { encoding: 'utf8', env, timeout: 60000 });
}

for (const [args, message] of [
  [['no-such-scene.json'], /there is no scene "no-such-scene\.json"/],
  [['/'], /"\/" is not a file/],
  [[path.join(tools, 'play')], /must end in \.json/],
  [['a.json', 'b.json'], /only one scene can be opened/],
  [['--port'], /--port needs a number/],
  [['--port', '0'], /from 1 to 65535, not "0"/],
  [['--port=70000'], /from 1 to 65535, not "70000"/],
  [['--host'], /--host needs a name/],
  [['--prot', '80'], /unknown option "--prot"/],
]) {
  test(`tools/play ${args.map((arg) => arg.replace(tools, '')).join(' ')} is refused at once`, () => {
    const { status, stderr } = run('play', args);
    assert.equal(status, 1);
    assert.match(stderr, message);
    assert.equal(stderr.trim().split('\n').length, 1, stderr);
  });
}

test('without a home folder, what is kept lies in the project, where nobody else writes', () => {
  const cacheOf = (more) =>
    spawnSync('bash', ['-c', 'source "$0/common.sh"; echo "$cacheHome"', tools], {
      encoding: 'utf8',
      env: { PATH: process.env.PATH, ...more },
    }).stdout.trim();
  assert.equal(cacheOf({}), path.join(tools, '../build/cache/slicecast'));
  assert.equal(cacheOf({ HOME: '/home/one' }), '/home/one/.cache/slicecast');
  assert.equal(cacheOf({ HOME: '', XDG_CACHE_HOME: '/x' }), '/x/slicecast');
});

test('--help lists arguments and options', () => {
  assert.match(run('play', ['--help']).stdout, /SCENE\.json.*--port/s);
  assert.match(run('setup', ['--help']).stdout, /native.*browser/s);
  assert.match(run('test', ['--help']).stdout, /native.*all/s);
});

test('if it cannot install, tools/setup stops with a list of everything missing', (t) => {
  // A system with only a shell.
  const folder = mkdtempSync(path.join(tmpdir(), 'slicecast-bare-'));
  t.after(() => rmSync(folder, { recursive: true }));
  for (const name of [
    'bash',
    'env',
    'sed',
    'grep',
    'tr',
    'uname',
    'id',
    'basename',
    'dirname',
    'cat',
    'readlink',
  ]) {
    const from = process.env.PATH.split(path.delimiter)
      .map((place) => path.join(place, name))
      .find(existsSync);
    symlinkSync(from, path.join(folder, name));
  }
  const { status, stderr } = run('setup', [], { PATH: folder, HOME: folder });
  assert.equal(status, 1);
  for (const name of ['cmake', 'ninja', 'emscripten', 'clang', 'npm', 'chromium'])
    assert.match(stderr, new RegExp(`apt-get install .*${name}`));
  assert.match(stderr, /brew install .*emscripten/);
  assert.match(stderr, /dnf install .*gcc-c\+\+/);
  assert.match(stderr, /pacman -S .*ninja/);
  assert.equal(run('setup', ['everything']).status, 1);
});
