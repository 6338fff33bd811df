// The boundary is what src/wasm/bindings.h says it is, in both flavours.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { flavours, loadModule, root, Session } from './load.mjs';

const header = readFileSync(join(root, 'src/wasm/bindings.h'), 'utf8');
const declared = [...header.matchAll(/^[a-zA-Z].*[ *](slicecast_\w+)\(/gm)]
  .map((match) => match[1])
  .sort();

for (const flavour of flavours) {
  test(`the ${flavour} module exports what the header declares, and nothing else`, async () => {
    const module = await loadModule(flavour);
    // Names without the underscore are the program's own, for its listeners in the page.
    const exported = Object.keys(module)
      .filter((name) => /slicecast_/.test(name))
      .map((name) => name.replace(/^_/, ''))
      .sort();
    assert.ok(declared.length > 20);
    assert.deepEqual(exported, declared);
    for (const name of ['UTF8ToString', '_malloc', '_free'])
      assert.equal(typeof module[name], 'function', name);
    assert.ok(module.HEAPU8 instanceof Uint8Array);
  });
}

test('every function of the header has a comment of its own', () => {
  for (const name of declared)
    assert.match(
      header,
      new RegExp(`// [^\\n]*\\n(?:[^\\n/][^\\n]*\\n)?[^\\n/]*\\b${name}\\(`),
      name,
    );
});

test('the version is that of the build', async () => {
  const module = await loadModule('simd');
  const version = readFileSync(join(root, 'CMakeLists.txt'), 'utf8').match(
    /project\(Slicecast VERSION ([0-9.]+)/,
  )[1];
  assert.equal(module.UTF8ToString(module._slicecast_version()), version);
});

test('the help lists the keys', async () => {
  const module = await loadModule('simd');
  const lines = JSON.parse(module.UTF8ToString(module._slicecast_keys()));
  assert.ok(lines.length > 10);
  for (const { keys, does } of lines) assert.ok(keys.length > 0 && does.length > 0);
  assert.match(lines.find(({ keys }) => keys === 'W S').does, /walk/);
});

test("without a game nothing moves, nothing is drawn, and the program's session is empty too", async () => {
  const module = await loadModule('simd');
  const session = new Session(module);
  for (const address of [session.address, module._slicecast_programSession()]) {
    session.address = address;
    session.step([1, 0, 0, 0, 0, 0, 0, 0]);
    assert.equal(session.draw(16, 16), null);
    assert.equal(session.state(), null);
    assert.equal(session.world(), null);
    assert.equal(session.setEye({ x: 1, y: 1, z: 1 }), false);
  }
});

test("freeing the program's session does nothing", async () => {
  const module = await loadModule('simd');
  const session = module._slicecast_programSession();
  module._slicecast_free(session);
  assert.equal(module._slicecast_programSession(), session);
});
