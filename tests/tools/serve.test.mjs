// The server behind tools/play: what it hands out, what it keeps to itself, and when it tells the
// page that a scene was saved.

import assert from 'node:assert/strict';
import { mkdir, mkdtemp, rename, rm, symlink, writeFile } from 'node:fs/promises';
import http from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { startServer } from '../../tools/serve.mjs';

let root, server, origin;

before(async () => {
  root = await mkdtemp(path.join(tmpdir(), 'slicecast-serve-'));
  for (const folder of ['page/engine', 'mine/scenes', 'mine/textures'])
    await mkdir(path.join(root, folder), { recursive: true });
  await writeFile(path.join(root, 'page/index.html'), '<title>page</title>');
  await writeFile(path.join(root, 'page/engine/x.wasm'), 'wasm');
  await writeFile(
    path.join(root, 'mine/scenes/my scene.json'),
    '{ "wall": "brick.png", "roof": "../textures/named.png" }',
  );
  await writeFile(path.join(root, 'mine/scenes/brick.png'), 'brick');
  await writeFile(path.join(root, 'mine/scenes/private.txt'), 'secret');
  await writeFile(path.join(root, 'mine/textures/named.png'), 'named');
  await writeFile(path.join(root, 'mine/textures/other.png'), 'secret');
  await symlink(
    path.join(root, 'mine/textures/other.png'),
    path.join(root, 'mine/scenes/link.png'),
  );
  server = await startServer({
    folder: path.join(root, 'page'),
    scene: path.join(root, 'mine/scenes/my scene.json'),
  });
  origin = new URL(server.address).origin;
});

after(async () => {
  server.close();
  await rm(root, { recursive: true });
});

// A request whose path goes out exactly as written.
function get(rawPath) {
  return new Promise((resolve, reject) => {
    const { hostname, port } = new URL(origin);
    http
      .get({ hostname, port, path: rawPath }, (response) => {
        let body = '';
        response.on('data', (chunk) => (body += chunk));
        response.on('end', () =>
          resolve({ status: response.statusCode, type: response.headers['content-type'], body }),
        );
      })
      .on('error', reject);
  });
}

test('the page and its engine', async () => {
  assert.equal((await get('/')).body, '<title>page</title>');
  assert.equal((await get('/engine/x.wasm')).type, 'application/wasm');
  assert.equal((await get('/nothing.html')).status, 404);
});

test('the address names the scene, which is served with the pictures that it uses', async () => {
  const address = new URL(server.address);
  assert.equal(address.searchParams.get('live'), '1');
  const scene = await get(`/${encodeURI(address.searchParams.get('scene'))}`);
  assert.equal(scene.status, 200);
  assert.match(scene.body, /brick/);
  assert.equal((await get('/-/scene/brick.png')).body, 'brick');
  assert.equal((await get('/-/textures/named.png')).body, 'named');
});

test('nothing else beside or above the scene is served', async () => {
  for (const hidden of [
    '/-/scene/private.txt',
    '/-/textures/other.png',
    '/-/scene/link.png',
    '/-/scene/../textures/other.png',
    '/-/scene/%2e%2e/textures/other.png',
    '/-/scene/..%2f..%2f..%2fetc/passwd',
    '/-/scene//etc/passwd',
    '/../mine/scenes/private.txt',
    '/%2e%2e/mine/scenes/private.txt',
    '/-/scene/',
    '/-/',
  ]) {
    const answer = await get(hidden);
    assert.equal(answer.status, 404, hidden);
    assert.doesNotMatch(answer.body, /secret|root:/, hidden);
  }
  assert.equal((await get('/-/scene/%ff')).status, 400);
});

// The number of `scene` events within the time, while `act` runs.
async function countEvents(act, milliseconds = 600) {
  const { hostname, port } = new URL(origin);
  let text = '';
  const request = http.get({ hostname, port, path: '/-/events' });
  const response = await new Promise((resolve) => request.on('response', resolve));
  assert.equal(response.headers['content-type'], 'text/event-stream');
  response.on('data', (chunk) => (text += chunk));
  response.on('error', () => {});
  await act();
  await new Promise((resolve) => setTimeout(resolve, milliseconds));
  request.destroy();
  return text.match(/^event: scene$/gm)?.length ?? 0;
}

test('a saved scene is told once, however the editor saves it', async () => {
  const scene = path.join(root, 'mine/scenes/my scene.json');
  const text = '{ "wall": "brick.png", "roof": "../textures/named.png", "more": 1 }';
  assert.equal(await countEvents(() => writeFile(scene, text)), 1, 'written in place');
  assert.equal(
    await countEvents(async () => {
      await writeFile(`${scene}~`, `${text} `);
      await rename(`${scene}~`, scene);
    }),
    1,
    'replaced',
  );
});

test('a picture of the scene counts, other files do not', async () => {
  assert.equal(
    await countEvents(() => writeFile(path.join(root, 'mine/scenes/brick.png'), 'brick 2')),
    1,
  );
  assert.equal(
    await countEvents(() => writeFile(path.join(root, 'mine/textures/named.png'), 'named 2')),
    1,
  );
  assert.equal(
    await countEvents(() => writeFile(path.join(root, 'mine/scenes/private.txt'), 'changed')),
    0,
  );
});

test('the next free port is taken, unless one was asked for', async () => {
  const second = await startServer({ folder: path.join(root, 'page') });
  const taken = Number(new URL(origin).port);
  assert.ok(Number(new URL(second.address).port) > taken);
  second.close();
  await assert.rejects(startServer({ folder: path.join(root, 'page'), port: taken }), {
    code: 'EADDRINUSE',
  });
});

test('without a scene there are no events', async () => {
  const plain = await startServer({ folder: path.join(root, 'page') });
  const saved = origin;
  origin = new URL(plain.address).origin;
  assert.equal((await get('/-/events')).status, 404);
  origin = saved;
  plain.close();
});
