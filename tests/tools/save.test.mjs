// Saving a scene through the server behind tools/play: whole or not at all, into that one file, and
// for the page of this server only.

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import {
  chmod,
  lstat,
  mkdir,
  mkdtemp,
  readFile,
  readdir,
  rm,
  stat,
  symlink,
  writeFile,
} from 'node:fs/promises';
import http from 'node:http';
import { networkInterfaces, tmpdir } from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { startServer } from '../../tools/serve.mjs';

const kText = '{ "maps": [] }\r\n';

async function started(t, { name = 'my scene.json', isLink = false, ...options } = {}) {
  const root = await mkdtemp(path.join(tmpdir(), 'slicecast-save-'));
  await mkdir(path.join(root, 'page'));
  await mkdir(path.join(root, 'mine'));
  await mkdir(path.join(root, 'real'));
  await writeFile(path.join(root, 'page/index.html'), '<title>page</title>');
  const file = path.join(root, 'mine', name);
  const real = isLink ? path.join(root, 'real/world.json') : file;
  await writeFile(real, kText);
  if (isLink) await symlink('../real/world.json', file);
  const server = await startServer({ folder: path.join(root, 'page'), scene: file, ...options });
  t.after(async () => {
    server.close();
    await rm(root, { recursive: true });
  });
  const { port, host } = new URL(server.address);
  const ask = (rawPath, { body, ...more } = {}) =>
    new Promise((resolve, reject) => {
      const request = http.request(
        { hostname: '127.0.0.1', port, path: rawPath, agent: false, ...more },
        (response) => {
          const parts = [];
          response.on('data', (part) => parts.push(part));
          response.on('end', () =>
            resolve({
              status: response.statusCode,
              headers: response.headers,
              body: Buffer.concat(parts).toString(),
            }),
          );
        },
      );
      request.on('error', reject);
      request.setHeader('Host', host);
      for (const [key, value] of Object.entries(more.headers ?? {})) request.setHeader(key, value);
      request.end(body);
    });
  const about = async (more) => JSON.parse((await ask('/-/save', more)).body);
  const { address, token } = await about();
  const read = () => ask(`/${address}`);
  const save = async (body, headers = {}, more = {}) => {
    const all = {
      Origin: `http://${host}`,
      'X-Slicecast-Token': token,
      'If-Match': (await read()).headers.etag,
      ...headers,
    };
    for (const [key, value] of Object.entries(all)) if (value === null) delete all[key];
    return ask(more.at ?? `/${address}`, { method: 'PUT', body, headers: all });
  };
  return { root, file, real, server, host, port, ask, about, read, save, address };
}

const isSaved = ({ body }) => JSON.parse(body).saved;

test('a save replaces the text, keeps permissions, and leaves nothing else behind', async (t) => {
  const { file, save, read, root } = await started(t);
  await chmod(file, 0o640);
  const text = '\uFEFF{ "maps": [1] }\r\n\r\n';
  const answer = await save(text);
  assert.equal(answer.status, 200);
  assert.deepEqual(JSON.parse(answer.body), { saved: true, tag: (await read()).headers.etag });
  assert.equal(await readFile(file, 'utf8'), text);
  assert.equal((await stat(file)).mode & 0o777, 0o640);
  assert.deepEqual(await readdir(path.join(root, 'mine')), ['my scene.json']);
});

test('a link to the scene stays a link', async (t) => {
  const { file, real, save } = await started(t, { isLink: true });
  assert.ok(isSaved(await save('{ "maps": [2] }')));
  assert.ok((await lstat(file)).isSymbolicLink());
  assert.equal(await readFile(real, 'utf8'), '{ "maps": [2] }');
});

test('what somebody else has saved meanwhile is not overwritten', async (t) => {
  const { file, read, save, root } = await started(t);
  const { etag } = (await read()).headers;
  await writeFile(file, '{ "maps": ["theirs"] }');
  const answer = await save('{ "maps": ["mine"] }', { 'If-Match': etag });
  assert.equal(answer.status, 200);
  assert.deepEqual(JSON.parse(answer.body), { saved: false, tag: (await read()).headers.etag });
  assert.equal(await readFile(file, 'utf8'), '{ "maps": ["theirs"] }');
  assert.deepEqual(await readdir(path.join(root, 'mine')), ['my scene.json']);
  assert.equal((await save('{}', { 'If-Match': null })).status, 428);
  assert.ok(!isSaved(await save('{}', { 'If-Match': '*' })));
});

test('of saves at the same moment one is made, the others are told that it has changed', async (t) => {
  const { save, read, file } = await started(t);
  const tag = (await read()).headers.etag;
  const texts = Array.from({ length: 20 }, (_, at) => `{ "maps": [${at}] }`);
  const answers = await Promise.all(texts.map((text) => save(text, { 'If-Match': tag })));
  const made = texts.filter((_, at) => isSaved(answers[at]));
  assert.equal(made.length, 1);
  assert.ok(answers.every(({ status }) => status === 200));
  assert.equal(await readFile(file, 'utf8'), made[0]);
});

test('only the page of this server saves', async (t) => {
  const { save, host, port, file, ask, address } = await started(t);
  const refused = async (headers) => {
    const { status } = await save('{}', headers);
    assert.equal(status, 403, JSON.stringify(headers));
  };
  for (const origin of [
    null,
    'null',
    'http://evil.example',
    `https://${host}`,
    `http://127.0.0.1:${port}`,
    `http://localhost:1${port}`,
    'http://localhost',
  ])
    await refused({ Origin: origin });
  for (const token of [null, '', 'x'.repeat(32), 'x'])
    await refused({ 'X-Slicecast-Token': token });
  await refused({ 'Sec-Fetch-Site': 'cross-site' });
  await refused({ 'Sec-Fetch-Site': 'same-site' });
  await refused({ 'X-Forwarded-For': '203.0.113.7' });
  await refused({ Host: `evil.example:${port}`, Origin: `http://evil.example:${port}` });
  assert.equal(await readFile(file, 'utf8'), kText);
  const asked = await ask(`/${address}`, {
    method: 'OPTIONS',
    headers: { Origin: 'http://evil.example', 'Access-Control-Request-Method': 'PUT' },
  });
  assert.equal(asked.status, 405, 'no leave for other origins');
  assert.equal(asked.headers['access-control-allow-origin'], undefined);
});

test('another site does not get the token', async (t) => {
  const { about, ask } = await started(t);
  const answer = await ask('/-/save', { headers: { Origin: 'http://evil.example' } });
  assert.equal(answer.headers['access-control-allow-origin'], undefined);
  for (const headers of [{ 'Sec-Fetch-Site': 'cross-site' }, { Via: '1.1 tunnel' }]) {
    const { token, reason } = await about({ headers });
    assert.equal(token, null);
    assert.match(reason, /Only this machine|another site/);
  }
});

test('a name of a tunnel may see the page, but not save', async (t) => {
  const { about, save, port } = await started(t, { hosts: ['my.example'] });
  const headers = { Host: `my.example:${port}` };
  assert.equal((await about({ headers })).token, null);
  const { status } = await save('{}', { ...headers, Origin: `http://my.example:${port}` });
  assert.equal(status, 403);
});

test('with --lan nobody saves, and the page is told why', async (t) => {
  const { about, save, file } = await started(t, { lan: true });
  const { token, reason } = await about();
  assert.equal(token, null);
  assert.match(reason, /--lan/);
  const answer = await save('{}', { 'X-Slicecast-Token': 'x' });
  assert.equal(answer.status, 403);
  assert.match(answer.body, /--lan/);
  assert.equal(await readFile(file, 'utf8'), kText);
});

test(
  'an address of this machine in the network does not save',
  {
    skip: !Object.values(networkInterfaces())
      .flat()
      .some(({ internal, family }) => !internal && family === 'IPv4'),
  },
  async (t) => {
    const { server, about } = await started(t, { lan: true });
    const { hostname, host } = new URL(server.others.find((one) => !one.includes('[')));
    assert.equal((await about({ hostname, headers: { Host: host } })).token, null);
  },
);

test('nothing but the scene is written', async (t) => {
  const { save, root, file } = await started(t);
  for (const at of [
    '/-/scene/other.json',
    '/-/scene/../my%20scene.json',
    '/-/scene/my scene.json/../other.json',
    '/-/scene/brick.png',
    '/-/other.json',
    '/index.html',
    '/-/save',
    '/-/scene/',
  ]) {
    const answer = await save('{}', {}, { at: at.replaceAll(' ', '%20') });
    assert.ok([404, 405].includes(answer.status), `${at}: ${answer.status}`);
  }
  assert.deepEqual(await readdir(path.join(root, 'mine')), ['my scene.json']);
  assert.equal(await readFile(file, 'utf8'), kText);
  assert.equal(await readFile(path.join(root, 'page/index.html'), 'utf8'), '<title>page</title>');
});

test('what is no scene is refused in words', async (t) => {
  const { save, file, root } = await started(t);
  for (const [body, message] of [
    ['', /no JSON/],
    ['<script>', /no JSON/],
    ['[]', /no object/],
    ['null', /no object/],
    ['{ "maps": ', /no JSON/],
    [Buffer.from([0x7b, 0xff, 0x7d]), /no JSON/],
  ]) {
    const answer = await save(body);
    assert.equal(answer.status, 422);
    assert.match(answer.body, message);
  }
  assert.equal(await readFile(file, 'utf8'), kText);
  assert.deepEqual(await readdir(path.join(root, 'mine')), ['my scene.json']);
});

test('a body that is announced as too large is refused before it comes', async (t) => {
  const { host, port, address, about, read } = await started(t);
  const { token } = await about();
  const headers = {
    Host: host,
    Origin: `http://${host}`,
    'X-Slicecast-Token': token,
    'If-Match': (await read()).headers.etag,
    'Content-Length': 2 ** 27 + 1,
  };
  const place = { hostname: '127.0.0.1', port, path: `/${address}`, method: 'PUT', headers };
  const status = await new Promise((resolve) => {
    const request = http.request(place, ({ statusCode }) => {
      resolve(statusCode);
      request.destroy();
    });
    request.on('error', () => {});
    request.setTimeout(3000, () => request.destroy());
    request.on('close', () => resolve('no answer'));
    request.flushHeaders();
  });
  assert.equal(status, 413);
});

test('a request that breaks off writes nothing', async (t) => {
  const { ask, address, host, port, file, about, read } = await started(t);
  const { token } = await about();
  const { etag } = (await read()).headers;
  await new Promise((resolve) => {
    const request = http.request({
      hostname: '127.0.0.1',
      port,
      path: `/${address}`,
      method: 'PUT',
      headers: {
        Host: host,
        Origin: `http://${host}`,
        'X-Slicecast-Token': token,
        'If-Match': etag,
        'Content-Length': 40,
      },
    });
    request.on('error', resolve);
    request.write('{ "maps": []', () => request.destroy());
    request.on('close', resolve);
  });
  assert.equal((await ask('/')).status, 200, 'the server goes on');
  assert.equal(await readFile(file, 'utf8'), kText);
});

test('a file that may not be written stays', { skip: process.getuid?.() === 0 }, async (t) => {
  const { file, save } = await started(t);
  await chmod(file, 0o444);
  const answer = await save('{}');
  assert.equal(answer.status, 403);
  assert.match(answer.body, /may not be written/);
  assert.equal(await readFile(file, 'utf8'), kText);
});

test('without a scene nothing is saved', async (t) => {
  const { root } = await started(t);
  const plain = await startServer({ folder: path.join(root, 'page') });
  t.after(() => plain.close());
  for (const [method, status] of [
    ['PUT', 405],
    ['GET', 404],
  ]) {
    const answer = await fetch(new URL('-/save', plain.address), { method });
    assert.equal(answer.status, status);
  }
});
