// The version is defined in CMakeLists.txt, and everything that is built has the same.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { RayCaster, apiVersion } from '../../build/web/ray-caster.js';
import { loadModule, root } from '../wasm/load.mjs';

const read = (name) => readFileSync(join(root, name), 'utf8');
const version = /project\(Slicecast VERSION (\d+\.\d+\.\d+) /.exec(read('CMakeLists.txt'))[1];

test('the package has the version of the project, which no other source repeats', () => {
  assert.equal(JSON.parse(read('build/web/package.json')).version, version);
  assert.equal(RayCaster.version, version);
  for (const name of ['web', 'tools', 'tests', 'tests/hosts'])
    assert.equal(JSON.parse(read(`${name}/package.json`)).version, undefined, name);
});

for (const kind of ['simd', 'scalar']) {
  test(`the engine has it: ${kind}`, async () => {
    const module = await loadModule(kind);
    assert.equal(module.UTF8ToString(module._slicecast_version()), version);
  });
}

test('the documentation has it, and the version of the interface', () => {
  const [, told, api] = /Slicecast (\S+), API version (\d+)\./.exec(read('build/web/element.html'));
  assert.equal(told, version);
  assert.deepEqual(
    [Number(api), apiVersion],
    Array(2).fill(JSON.parse(read('web/element/api.json')).apiVersion),
  );
});
