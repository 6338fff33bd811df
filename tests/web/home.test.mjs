// Where the element looks for the shipped scenes and the engine: web/engine/home.js in pages of
// every kind.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { reachable } from '../../web/engine/home.js';

const kPage = 'https://example.org/app/index.html';

for (const [what, script, page, expected] of [
  [
    'the script has an address',
    'https://cdn.example/slicecast/ray-caster.js',
    kPage,
    'https://cdn.example/slicecast/',
  ],
  ['the script has none', undefined, kPage, 'https://example.org/app/'],
  [
    'the script has that of where it was built',
    'file:///home/somebody/app/ray-caster.js',
    kPage,
    'https://example.org/app/',
  ],
  [
    'page and script are files',
    'file:///app/assets/ray-caster.js',
    'file:///app/index.html',
    'file:///app/assets/',
  ],
  ['the script is a blob', 'blob:https://example.org/1-2-3', kPage, 'https://example.org/app/'],
  [
    'Vite has put packages together',
    'https://example.org/@fs/app/node_modules/.vite/deps/slicecast.js?v=1',
    kPage,
    'https://example.org/@fs/app/node_modules/slicecast/',
  ],
  [
    'an app has a scheme of its own',
    'capacitor://localhost/assets/ray-caster.js',
    'capacitor://localhost/',
    'capacitor://localhost/assets/',
  ],
]) {
  test(`the folder of shipped files: ${what}`, () =>
    assert.equal(reachable(() => new URL('./', script), './', page, page).href, expected));
}

test('an engine with its own address is used as it is', () => {
  assert.equal(
    reachable(() => new URL('data:application/wasm;base64,AGFzbQ=='), 'engine/x.wasm', kPage, kPage)
      .protocol,
    'data:',
  );
});

let imports = 0;

async function homeIn(page, content) {
  globalThis.document = {
    baseURI: page,
    querySelector: (selector) =>
      selector === 'meta[name=slicecast-home]' && content !== undefined ? { content } : null,
  };
  try {
    return (await import(`../../web/engine/home.js?${++imports}`)).kHome.href;
  } finally {
    delete globalThis.document;
  }
}

test('the page can name the folder of shipped files', async () => {
  assert.equal(await homeIn(kPage, '/art/'), 'https://example.org/art/');
  assert.equal(await homeIn(kPage, 'art'), 'https://example.org/app/art/');
  assert.equal(await homeIn(kPage, 'https://cdn.example/art'), 'https://cdn.example/art/');
  assert.equal(await homeIn(kPage, ''), 'https://example.org/app/');
  assert.equal(await homeIn(kPage), 'https://example.org/app/');
});
