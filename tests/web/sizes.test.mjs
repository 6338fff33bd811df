// What a page loads before the first picture of an element: the program and the element's
// script, as a server sends them.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { root } from '../wasm/load.mjs';

const kLoaded = ['ray-caster.js', 'engine/slicecast-simd.wasm'];
const kSound = 'ray-caster-sound.js';
const kLater = [
  'engine/slicecast-simd-later.wasm',
  'ray-caster-steering.js',
  'ray-caster-rows.js',
  'ray-caster-more.js',
  kSound,
];
const kSoundLimit = 60_000; // bytes, as they lie on the disk: all that is needed for sound
const kLimit = 224_000; // bytes; web/docs/architecture.md lists what they are for

const sizeOf = (name) => gzipSync(readFileSync(join(root, 'build/web', name)), { level: 9 }).length;

test('the first picture takes few bytes', (t) => {
  const sizes = kLoaded.map(sizeOf);
  const sum = sizes.reduce((total, size) => total + size, 0);
  t.diagnostic(
    `gzip -9: ${sum} bytes: ${kLoaded.map((name, index) => `${name} ${sizes[index]}`).join(', ')}; later ${kLater.map((name) => `${name} ${sizeOf(name)}`).join(', ')}`,
  );
  assert.ok(sum <= kLimit, `${sum} bytes, at most ${kLimit}`);
});

test('the sounds take few bytes, and load later', () => {
  const bytes = readFileSync(join(root, 'build/web', kSound)).length;
  assert.ok(bytes <= kSoundLimit, `${bytes} bytes, at most ${kSoundLimit}`);
  for (const name of [...kLoaded, 'ray-caster-steering.js'])
    assert.doesNotMatch(
      readFileSync(join(root, 'build/web', name), 'latin1'),
      /AudioContext/,
      name,
    );
});
