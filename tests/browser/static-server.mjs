// A plain static server, like that of any host. Tests can change it: other
// files, other headers, a subfolder.
//
//     const server = await serve({files: {'scenes/room.json': '...'}, prefix: '/some/where/'});
//     await page.goto(server.address);
//     await server.close();

import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const kPage = fileURLToPath(new URL('../../build/web/', import.meta.url));

const kPieces = 8;

const kTypes = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.wasm': 'application/wasm',
};

// `files` stand in front of the page's own: path -> text, bytes, null (not there) or a function
// that gives one of them. `headers` go with every answer. `asked` lists the paths in the order
// in which they were wanted. `headersOf(path)` gives more headers for a file. `folder` is
// another one than the page's. `redirects`: path -> where the server sends one on. With `mayGo`
// every file comes in pieces, each after `await mayGo(path, bytes sent of it)`.
export async function serve({
  folder = kPage,
  files = {},
  prefix = '/',
  headers = {},
  headersOf = () => ({}),
  types = {},
  redirects = {},
  mayGo = null,
} = {}) {
  const asked = [];
  const server = createServer(async (request, response) => {
    const address = decodeURIComponent(request.url.split(/[?#]/, 1)[0]);
    if (!address.startsWith(prefix)) return response.writeHead(404).end();
    const name = address.slice(prefix.length) || 'index.html';
    asked.push(name);
    if (Object.hasOwn(redirects, name))
      return response.writeHead(302, { Location: redirects[name] }).end();
    const content = await contentOf(folder, name, files);
    if (content === null)
      return response
        .writeHead(404, { 'Content-Type': 'text/plain' })
        .end('There is no such file.');
    const type = types[name] ?? kTypes[path.extname(name)] ?? 'application/octet-stream';
    response.writeHead(200, {
      'Content-Type': type,
      'Content-Length': content.length,
      ...headers,
      ...headersOf(name),
    });
    if (mayGo === null) return response.end(content);
    await sendInPieces(response, content, (sent) => mayGo(name, sent));
    return response.end();
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  return {
    address: `http://localhost:${server.address().port}${prefix}`,
    asked,
    close() {
      server.closeAllConnections();
      return new Promise((resolve) => server.close(resolve));
    },
  };
}

async function sendInPieces(response, content, mayGo) {
  const size = Math.ceil(content.length / kPieces);
  for (let at = 0; at < content.length; at += size) {
    await mayGo(at);
    response.write(content.subarray(at, at + size));
  }
}

async function contentOf(folder, name, files) {
  if (!Object.hasOwn(files, name))
    return readFile(path.join(folder, path.normalize(`/${name}`))).catch(() => null);
  const content = typeof files[name] === 'function' ? files[name]() : files[name];
  return content === null ? null : Buffer.from(content);
}
