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
    // Names without slicecast_ are for the program's listeners in the page.
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
  assert.match(lines.find(({ keys }) => keys.join() === 'W,S').does, /walk/);
  const actions = lines.flatMap((line) => line.actions);
  assert.equal(new Set(actions.map(({ name }) => name)).size, actions.length);
  assert.deepEqual(
    actions.find(({ name }) => name === 'strafeLeft'),
    {
      name: 'strafeLeft',
      does: 'step left',
      press: 'hold',
      keys: [
        { code: 'KeyA', label: 'A' },
        { code: 'KeyQ', label: 'Q' },
      ],
    },
  );
});

test('keys get other actions, none, and the standard ones back', async () => {
  const module = await loadModule('simd');
  const withText = (texts, use) => {
    const places = texts.map((text) => {
      const bytes = Buffer.from(`${text}\0`);
      const at = module._malloc(bytes.length);
      module.HEAPU8.set(bytes, at);
      return at;
    });
    const answer = module.UTF8ToString(use(...places));
    for (const place of places) module._free(place);
    return answer;
  };
  const bind = (code, action) => withText([code, action], module._slicecast_bindKey);
  const scope = (code) => withText([code], module._slicecast_keyScope);
  const codesOf = (action) =>
    JSON.parse(module.UTF8ToString(module._slicecast_keys()))
      .flatMap((line) => line.actions)
      .find(({ name }) => name === action)
      .keys.map(({ code }) => code);

  assert.equal(bind('KeyM', 'forward'), '');
  assert.deepEqual(codesOf('forward'), ['KeyM', 'KeyW']);
  assert.deepEqual(codesOf('minimap'), []);
  assert.deepEqual(['KeyM', 'KeyB', 'F9', 'KeyZ', 'Tab'].map(scope), [
    'move',
    'element',
    'page',
    '',
    '',
  ]);
  assert.equal(bind('KeyM', ''), '');
  assert.equal(scope('KeyM'), '');
  assert.equal(bind('KeyM', 'foward'), "Unknown action 'foward'. Did you mean 'forward'?");
  assert.equal(bind('keym', 'forward'), "Unknown key 'keym'. Did you mean 'KeyM'?");
  assert.match(bind('Escape', 'forward'), /Escape always leaves the picture/);
  module._slicecast_standardKeys();
  assert.deepEqual(codesOf('minimap'), ['KeyM']);
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
