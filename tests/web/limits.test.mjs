// What a stranger's files and rows can cost: downloads stop at the engine's limits,
// and rows take linear time.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createServer } from 'node:http';
import { join } from 'node:path';
import { test } from 'node:test';
import { fetchBytes } from '../../web/engine/fetch-bytes.js';
import { kMostFileBytes, kMostSceneBytes } from '../../web/engine/limits.js';
import { sceneOfObject, sceneOfRows } from '../../web/engine/rows.js';
import { load } from '../../build/web/node/index.js';
import { root } from '../wasm/load.mjs';

const kPiece = new Uint8Array(1 << 20);

// Sends pieces for ever, or announces a length; `sent` counts the bytes sent.
async function serveWithoutEnd(t, { length = null, first = null } = {}) {
  const server = createServer(async (request, response) => {
    let isOpen = true;
    response.on('close', () => {
      isOpen = false;
      ended();
    });
    if (length !== null) response.setHeader('Content-Length', length);
    response.flushHeaders();
    if (request.url === '/scene.json' && first !== null) return response.end(first);
    while (isOpen) {
      if (!response.write(kPiece)) await new Promise((resolve) => setTimeout(resolve, 1));
      host.sent += kPiece.length;
      if (length !== null || host.sent > 1 << 30) break;
    }
  });
  let ended;
  const host = { sent: 0, closed: new Promise((resolve) => (ended = resolve)) };
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  t.after(() => {
    server.closeAllConnections();
    server.close();
  });
  host.address = `http://127.0.0.1:${server.address().port}/scene.json`;
  return host;
}

test('the limits are those of the engine', () => {
  const constant = (file, name) => {
    const [, number, shift] = new RegExp(`${name} =\\s+(\\d+)u << (\\d+);`).exec(
      readFileSync(join(root, 'src', file), 'utf8'),
    );
    return Number(number) * 2 ** Number(shift);
  };
  assert.equal(kMostSceneBytes, constant('scene/limits.h', 'kMaxSceneBytes'));
  assert.equal(kMostFileBytes, constant('base/image.cpp', 'kMaxPngBytes'));
  assert.equal(kMostFileBytes, constant('session/recording_text.h', 'kMaxRecordingBytes'));
});

test('a download stops at the limit', async (t) => {
  const host = await serveWithoutEnd(t);
  const heard = [];
  await assert.rejects(
    fetchBytes(host.address, (loaded) => heard.push(loaded), 4 << 20),
    ({ code, message }) => {
      assert.equal(code, 'fetch');
      assert.match(message, /^it has [4-9]\d{6} bytes or more, the limit is 4194304$/);
      return true;
    },
  );
  assert.ok(heard.length > 0 && heard.at(-1) <= 4 << 20, String(heard.at(-1)));
  await host.closed;
});

test('a download that announces too many bytes is not started', async (t) => {
  const host = await serveWithoutEnd(t, { length: 2 ** 40 });
  await assert.rejects(fetchBytes(host.address), {
    message: `it has ${2 ** 40} bytes or more, the limit is ${kMostFileBytes}`,
  });
  await host.closed;
});

test('the same limits under Node: texts, pictures, and files', { timeout: 60000 }, async (t) => {
  const endless = await serveWithoutEnd(t);
  await assert.rejects(
    load(endless.address),
    new RegExp(`scene\\.json: it has \\d+ bytes or more, the limit is ${kMostSceneBytes}`),
  );
  await endless.closed;

  const scene = {
    title: 'Endless',
    textures: { wall: 'endless.png' },
    maps: [{ name: 'room', levels: [['..']], floor: 'wall' }],
    start: { x: 0.5, y: 0.5 },
  };
  const pictures = await serveWithoutEnd(t, { first: JSON.stringify(scene) });
  await assert.rejects(
    load(pictures.address),
    new RegExp(`it has \\d+ bytes or more, the limit is ${kMostFileBytes}`),
  );
  await pictures.closed;

  if (process.platform === 'linux')
    await assert.rejects(
      load(new URL('file:///dev/zero')),
      new RegExp(`it has \\d+ bytes or more, the limit is ${kMostSceneBytes}`),
    );
});

// Texts that would take long if anything were done for each pair of characters.
const kSlow = {
  'one long row and many short ones': (n) => `>${'#'.repeat(n)}${'\n.'.repeat(n / 2)}`,
  'many levels': (n) => `>${'\n.'.repeat(n / 4)}${'\n---\n#'.repeat(n / 8)}`,
  'empty levels': (n) => '---\n'.repeat(n / 4) + '>',
  'short rows': (n) => `>${'\n#'.repeat(n / 2)}`,
  'unknown characters': (n) => `>\n${`${'§'.repeat(100)}\n`.repeat(n / 100)}`,
  'many starts': (n) => '>'.repeat(n),
  'dashes and blanks': (n) => `>\n---${' '.repeat(n)}x!`,
  'blanks in a meaning': (n) => `>\n--- legend\nx = a${' '.repeat(n)}b`,
  'blanks before an equals sign': (n) => `>\n--- legend\nx${' '.repeat(n)}b`,
  'equals signs': (n) => `>\n--- legend\n${'='.repeat(n)}\u2028x`,
  'a long legend of floors': (n) =>
    `>${'#'.repeat(n / 2)}\n--- legend\n${Array.from({ length: n / 20 }, (_, i) => `${String.fromCodePoint(0x4e00 + (i % 20000))} = brick floor`).join('\n')}`,
  'wrong meanings': (n) => `>\n--- legend\n${'xy = !\n'.repeat(n / 7)}`,
};

const secondsFor = (act) => {
  const begin = performance.now();
  let fault = null;
  try {
    act();
  } catch (error) {
    fault = error;
  }
  return { seconds: (performance.now() - begin) / 1000, fault };
};

for (const [what, textOf] of Object.entries(kSlow)) {
  test(`rows take linear time: ${what}`, () => {
    for (const n of [26_000, 1_000_000]) {
      const { seconds, fault } = secondsFor(() => sceneOfRows(textOf(n)));
      assert.ok(seconds < 10, `${n} characters take ${seconds.toFixed(1)} s`);
      assert.ok(fault === null || fault.code === 'scene', String(fault));
      assert.ok((fault?.faults.length ?? 0) <= 1000);
    }
  });
}

test('the error for too many tiles names their number and the limit', () => {
  const expected =
    /^rows: found 13001 x 6501 tiles, expected at most 1048576 on all levels together$/;
  const text = kSlow['one long row and many short ones'](13_000);
  for (const act of [
    () => sceneOfRows(text),
    () => sceneOfObject({ rows: text.split('\n') }, 'rows'),
  ]) {
    const { fault } = secondsFor(act);
    assert.match(fault.faults[0].message, expected);
    assert.equal(fault.faults.length, 1);
  }
  const { fault } = secondsFor(() => sceneOfRows(kSlow['many levels'](40_000)));
  assert.match(fault.faults[0].message, /found 1 x 10001 tiles on 5001 levels, expected at most/);
  const { maps } = sceneOfRows(`>${'.'.repeat(1023)}${`\n${'.'.repeat(1024)}`.repeat(1023)}`);
  assert.equal(maps[0].levels[0].length, 1024);
});
