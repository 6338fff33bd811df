// The server behind tools/play: what it serves, what it refuses, and when it tells the
// page that a scene was saved.

import assert from 'node:assert/strict';
import { renameSync, writeFileSync } from 'node:fs';
import { chmod, mkdir, mkdtemp, readdir, rm, symlink, writeFile } from 'node:fs/promises';
import http from 'node:http';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { startServer } from '../../tools/serve.mjs';

const kLarge = 2 ** 25; // bytes: more than fits into the buffers on the way

let root, server, origin;

before(async () => {
  root = await mkdtemp(path.join(tmpdir(), 'slicecast-serve-'));
  for (const folder of ['page/engine', 'page/textures', 'mine/scenes', 'mine/textures'])
    await mkdir(path.join(root, folder), { recursive: true });
  await writeFile(path.join(root, 'page/index.html'), '<title>page</title>');
  await writeFile(path.join(root, 'page/engine/x.wasm'), 'wasm');
  for (const name of ['named.png', 'oak.png', 'oak.txt'])
    await writeFile(path.join(root, 'page/textures', name), 'shipped');
  await writeFile(
    path.join(root, 'mine/scenes/my scene.json'),
    '{ "wall": "brick.png", "roof": "../textures/named.png", "door": ["away.png", "text.png", "near.png", "../textures/away.png"], "\\"sill.png": "..\\/textures\\/m\\u00fcr.png", "odd": "\\x.png" }',
  );
  await writeFile(path.join(root, 'mine/scenes/brick.png'), 'brick');
  await writeFile(path.join(root, 'mine/scenes/private.txt'), 'secret');
  await writeFile(path.join(root, 'mine/textures/named.png'), 'named');
  await writeFile(path.join(root, 'mine/textures/mür.png'), 'wall');
  await writeFile(path.join(root, 'mine/textures/other.png'), 'secret');
  await symlink(
    path.join(root, 'mine/textures/other.png'),
    path.join(root, 'mine/scenes/link.png'),
  );
  await writeFile(path.join(root, 'away.png'), 'secret');
  await symlink('../../away.png', path.join(root, 'mine/scenes/away.png'));
  await symlink('../../away.png', path.join(root, 'mine/textures/away.png'));
  await symlink('private.txt', path.join(root, 'mine/scenes/text.png'));
  await symlink('../textures/named.png', path.join(root, 'mine/scenes/near.png'));
  await symlink('engine/x.wasm', path.join(root, 'page/inside.wasm'));
  await symlink('../mine/scenes/private.txt', path.join(root, 'page/outside.txt'));
  await symlink('../mine/scenes', path.join(root, 'page/outside'));
  await writeFile(path.join(root, 'page/large.bin'), new Uint8Array(kLarge));
  await writeFile(path.join(root, 'mine/scenes/large.png'), new Uint8Array(kLarge));
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

// Sends a request whose path is exactly as written.
function get(rawPath, options = {}) {
  return new Promise((resolve, reject) => {
    const { hostname, port } = new URL(origin);
    http
      .request({ hostname, port, path: rawPath, ...options }, (response) => {
        const { statusCode: status, headers } = response;
        let body = '';
        response.on('data', (chunk) => (body += chunk));
        response.on('end', () => resolve({ status, headers, type: headers['content-type'], body }));
      })
      .on('error', reject)
      .end();
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
  assert.equal((await get('/-/textures/m%C3%BCr.png')).body, 'wall', 'named with escapes of JSON');
});

test('a shipped picture that is not beside the scene is that of the page', async () => {
  const { body, type } = await get('/-/textures/oak.png');
  assert.deepEqual([body, type], ['shipped', 'image/png']);
  for (const missing of ['textures/oak.txt', 'textures/elm.png', 'engine/x.wasm', 'scene/oak.png'])
    assert.equal((await get(`/-/${missing}`)).status, 404, missing);
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

test('a link that the scene names is followed only to a picture beside the scene', async () => {
  assert.equal((await get('/-/scene/near.png')).body, 'named');
  for (const hidden of ['/-/scene/away.png', '/-/textures/away.png', '/-/scene/text.png']) {
    const answer = await get(hidden);
    assert.equal(answer.status, 404, hidden);
    assert.doesNotMatch(answer.body, /secret/, hidden);
  }
});

// Whoever asks for a part of a file may get all of it.
test('whatever range is asked for, the whole file comes', async () => {
  for (const rawPath of ['/engine/x.wasm', '/-/scene/near.png']) {
    const whole = (await get(rawPath)).body;
    for (const range of ['9-1', '-5', '0-0', '-', '1-', '99-', '0-1,2-3', 'a-b', '-0']) {
      const answer = await get(rawPath, { headers: { range: `bytes=${range}` } });
      assert.deepEqual([answer.status, answer.body], [200, whole], `${rawPath} ${range}`);
    }
  }
});

test('links are followed within the folder, and not out of it', async () => {
  assert.equal((await get('/inside.wasm')).body, 'wasm');
  for (const hidden of ['/outside.txt', '/outside/private.txt', '/outside/']) {
    const answer = await get(hidden);
    assert.equal(answer.status, 404, hidden);
    assert.doesNotMatch(answer.body, /secret/, hidden);
  }
});

test('only hosts of this machine are served, and those that are named', async () => {
  const { port } = new URL(origin);
  const statusFor = async (host, rawPath) =>
    (await get(rawPath, { headers: { host: `${host}:${port}` } })).status;
  for (const rawPath of ['/', '/-/scene/brick.png']) {
    for (const host of ['localhost', 'LOCALHOST', '127.0.0.1', '[::1]'])
      assert.equal(await statusFor(host, rawPath), 200, host);
    for (const host of ['evil.example', 'localhost.evil.example', '127.0.0.1.evil.example', 'a b'])
      assert.equal(await statusFor(host, rawPath), 403, host);
  }
  const { body } = await get('/', { headers: { host: 'evil.example' } });
  assert.match(body, /found the host "evil\.example", expected localhost/i);

  const wider = await startServer({ folder: path.join(root, 'page'), hosts: ['my.example'] });
  const { status } = await get('/', {
    port: new URL(wider.address).port,
    headers: { host: 'my.example' },
  });
  wider.close();
  assert.equal(status, 200);
});

test('only GET and HEAD are allowed', async () => {
  for (const rawPath of ['/', '/-/scene/brick.png', '/-/events']) {
    for (const method of ['POST', 'PUT', 'DELETE', 'OPTIONS']) {
      const { status, headers } = await get(rawPath, { method });
      assert.equal(status, 405, `${method} ${rawPath}`);
      assert.equal(headers.allow, 'GET, HEAD');
    }
    const { status, body } = await get(rawPath, { method: 'HEAD' });
    assert.equal(status, 200, `HEAD ${rawPath}`);
    assert.equal(body, '');
  }
});

// The files that this process has open: Linux tells.
const openFiles = async () => (await readdir('/proc/self/fd')).length;

test(
  'a download that is broken off leaves no file open',
  { skip: process.platform !== 'linux' },
  async () => {
    const { hostname, port } = new URL(origin);
    const before = await openFiles();
    for (const rawPath of ['/large.bin', '/-/scene/large.png']) {
      for (let i = 0; i < 10; ++i) {
        await new Promise((resolve, reject) => {
          http
            .get({ hostname, port, path: rawPath, agent: false }, (response) => {
              response.once('data', () => response.destroy());
              response.once('close', resolve);
              response.once('error', () => {});
            })
            .on('error', reject);
        });
      }
    }
    for (let i = 0; i < 50 && (await openFiles()) > before + 2; ++i) await sleep(20);
    assert.ok((await openFiles()) <= before + 2, `${before} before, ${await openFiles()} now`);
  },
);

// The number of `scene` events after `act`: once the first one has come, those of a short time
// more. If none is wanted, those of the time in which one would come.
async function countEvents(act, wanted = 1) {
  const { hostname, port } = new URL(origin);
  let text = '';
  const count = () => text.match(/^event: scene$/gm)?.length ?? 0;
  const request = http.get({ hostname, port, path: '/-/events' });
  const response = await new Promise((resolve) => request.on('response', resolve));
  assert.equal(response.headers['content-type'], 'text/event-stream');
  response.on('data', (chunk) => (text += chunk));
  response.on('error', () => {});
  act();
  for (let i = 0; i < 200 && count() < wanted; ++i) await sleep(50);
  await sleep(600);
  request.destroy();
  return count();
}

// Saves at once: a server that looked in the middle would see two changes, and rightly so.
test('a saved scene is reported once, however the editor saves it', async () => {
  const scene = path.join(root, 'mine/scenes/my scene.json');
  const text = '{ "wall": "brick.png", "roof": "..\\/textures\\/n\\u0061med.png", "more": 1 }';
  assert.equal(await countEvents(() => writeFileSync(scene, text)), 1, 'written in place');
  assert.equal(
    await countEvents(() => {
      writeFileSync(`${scene}~`, `${text} `);
      renameSync(`${scene}~`, scene);
    }),
    1,
    'replaced',
  );
});

test('a picture of the scene counts, other files do not', async () => {
  const save = (name, text) => () => writeFileSync(path.join(root, 'mine', name), text);
  assert.equal(await countEvents(save('scenes/brick.png', 'brick 2')), 1);
  assert.equal(await countEvents(save('textures/named.png', 'named 2')), 1);
  assert.equal(await countEvents(save('scenes/private.txt', 'changed'), 0), 0);
});

test('the next free port is taken, unless one was asked for', async () => {
  const second = await startServer({ folder: path.join(root, 'page') });
  const taken = Number(new URL(origin).port);
  assert.notEqual(Number(new URL(second.address).port), taken);
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

test('others in the network are served only if asked for, by an address of this machine', async (t) => {
  const ask = (host, port) =>
    new Promise((resolve) => {
      const place = { host, port, path: '/', agent: false };
      const request = http.get(place, ({ statusCode }) => resolve(statusCode));
      request.on('error', () => resolve(0));
    });
  const open = await startServer({ folder: path.join(root, 'page'), lan: true });
  t.after(() => open.close());
  const placeOf = (address) => {
    const { hostname, port } = new URL(address);
    return { hostname: hostname.replace(/[[\]]/g, ''), port };
  };
  for (const address of [open.address, ...open.others]) {
    const { hostname, port } = placeOf(address);
    assert.equal(await ask(hostname, port), 200, address);
    const { status } = await get('/', { hostname, port, headers: { host: 'stranger.example' } });
    assert.equal(status, 403);
  }
  for (const address of open.others) {
    assert.equal(await ask(placeOf(address).hostname, new URL(origin).port), 0, address);
  }
});

// A server whose command waits for the file `go`, and then does the rest of the script.
async function withRest(t, script, ask) {
  const folder = await mkdtemp(path.join(root, 'rest-'));
  const command = path.join(folder, 'build');
  const wait = 'while [ ! -f go ]; do sleep 0.02; done';
  await writeFile(command, `#!/bin/sh\ncd '${folder}'\n${wait}\n${script}\n`);
  await chmod(command, 0o755);
  const page = path.join(folder, 'page');
  await mkdir(page);
  const building = await startServer({ folder: page, rest: command });
  const saved = origin;
  origin = new URL(building.address).origin;
  t.after(() => {
    origin = saved;
    building.close();
  });
  await ask(() => writeFile(path.join(folder, 'go'), ''), building);
}
const html = { headers: { accept: 'text/html,*/*' } };

test('a page that is not built yet says so and looks again; files come when they are built', async (t) => {
  const script = 'mkdir page/docs; echo docs >page/docs/index.html; echo program >page/x.wasm';
  await withRest(t, script, async (go) => {
    const early = await get('/docs/', html);
    assert.equal(early.status, 503);
    assert.match(early.body, /http-equiv="refresh"[^]*being built/);
    const program = get('/x.wasm');
    const nothing = get('/nothing.png');
    await go();
    assert.equal((await program).body, 'program\n');
    assert.equal((await nothing).status, 404);
    assert.equal((await get('/docs/', html)).body, 'docs\n');
    assert.equal((await get('/nowhere/', html)).status, 404);
  });
});

test('what could not be built is missing, and the output says why', async (t) => {
  await withRest(t, 'echo no paper >&2; exit 1', async (go, building) => {
    assert.equal((await get('/docs/', html)).status, 503);
    await go();
    assert.equal(await building.built, 'no paper');
    assert.equal((await get('/docs/', html)).status, 404);
  });
});
