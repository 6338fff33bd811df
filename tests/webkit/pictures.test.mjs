// A third engine: WebKit draws the pixels that the native program draws, and plays.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { noScreen, root, Screen } from '../app/screen.mjs';
import { serve } from '../browser/static-server.mjs';
import { pixelsOf } from './png-pixels.mjs';
import { Browser, noWebKit } from './web-driver.mjs';

const kScenes = ['castle', 'water-palace', 'harbour-town', 'glassworks', 'wayhouse', 'first-walk'];
const [kWidth, kHeight] = [320, 200];

const skip = noScreen || noWebKit;
let screen;
let browser;
let server;

before(async () => {
  if (skip) return;
  server = await serve();
  screen = await Screen.open(1024, 768);
  browser = await Browser.open(screen.environment);
});

after(async () => {
  await browser?.close();
  await screen?.close();
  await server?.close();
});

function nativeHash(scene) {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-webkit-'));
  try {
    const file = join(folder, 'picture.png');
    const { status, stderr } = spawnSync(
      join(root, 'build/native/bin/slicecast-render'),
      [`${root}/assets/scenes/${scene}.json`, '--size', `${kWidth}x${kHeight}`, '--out', file],
      { encoding: 'utf8' },
    );
    assert.equal(status, 0, stderr);
    return createHash('sha256')
      .update(pixelsOf(readFileSync(file)))
      .digest('hex');
  } finally {
    rmSync(folder, { recursive: true });
  }
}

const kCanvasHash = `
  const canvas = document.querySelector('ray-caster').shadowRoot.querySelector('canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  return crypto.subtle.digest('SHA-256', data).then((digest) =>
    [canvas.width, canvas.height, ...new Uint8Array(digest)]);`;

for (const engine of ['simd', 'scalar']) {
  for (const scene of kScenes) {
    test(`${scene}, ${engine}: WebKit shows the native program's pixels`, { skip }, async () => {
      const page = `embed.html?scene=${scene}&size=${kWidth}x${kHeight}&engine=${engine}`;
      await browser.go(server.address + page);
      await browser.until(`return document.querySelector('ray-caster')?.state === 'paused'`);
      const [width, height, ...digest] = await browser.run(kCanvasHash);
      assert.deepEqual([width, height], [kWidth, kHeight]);
      assert.equal(Buffer.from(digest).toString('hex'), nativeHash(scene));
    });
  }
}

test('the play page opens, and its player walks', { skip }, async () => {
  await browser.go(server.address);
  await browser.until(`return document.body.dataset.state === 'paused'`);
  const place = `window.slicecast.player.x + window.slicecast.player.y`;
  const start = await browser.run(`return ${place}`);
  await browser.click('#play');
  await browser.until(`return document.body.dataset.state === 'playing'`);
  await browser.holdKey('w', 1000);
  await browser.until(`return Math.abs(${place} - arguments[0]) > 0.5`, start);
});
