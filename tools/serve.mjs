// Serves the page in build/web on this machine, and a scene that somebody is working on.
//
//     node tools/serve.mjs [--folder FOLDER] [--rest COMMAND] [--scene SCENE.json] [--port N]
//                          [--host NAME]... [--lan]
//
// COMMAND builds what is missing in the folder, while the rest is served. Meanwhile a page that is
// not there yet is one that says so and looks again; any other file comes when it is built.
//
// It answers only requests from this machine, with --lan also those of others in its network, and
// only if they use a host name or an address of this machine or a name of --host. Otherwise a
// stranger's page whose name resolves to this machine could read the files (DNS rebinding).
//
//     /...                   the page
//     /-/scene/NAME.json     the scene, read again for each request; PUT saves it (scene-saves.mjs)
//     /-/save                what the editor needs to save the scene
//     /-/scene/...           pictures in the scene's folder; ../x in the scene is at /-/x. Links
//                            are followed where they lead to a picture that could be served itself.
//                            A shipped one that is not there is that of the page
//     /-/events              an event stream: `scene` when the scene or a picture of it was saved

import { spawn } from 'node:child_process';
import { createReadStream, watch } from 'node:fs';
import { access, constants, readFile, realpath, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { networkInterfaces } from 'node:os';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import sirv from 'sirv';
import { isShippedFile } from '../web/engine/source-parts.js';
import { SceneSaves, tagOf } from './scene-saves.mjs';

const kFirstPort = 8080;
const kPortsTried = 50;
const kHosts = ['localhost', '127.0.0.1', '[::1]'];
const kMethods = ['GET', 'HEAD'];
const kNotBeside = 'There is no such file beside the scene.';
const kSettleMilliseconds = 80; // an editor's save is several events: truncate, write, rename

// The scene that somebody is working on: which files may be served, and when one of them changes.
class WatchedScene {
  constructor(file) {
    this.file = path.resolve(file);
    this.folder = path.dirname(this.file);
    this.name = path.basename(this.file);
    this.listeners = new Set();
    this.watchers = new Map();
    this.lastState = '';
  }

  // The query that opens the scene, relative to the page.
  get address() {
    return `?scene=-/scene/${this.urlName}&live=1`;
  }

  get urlName() {
    return encodeURIComponent(this.name);
  }

  // Every picture that the text names. The text may be invalid JSON while somebody edits it, so
  // this only looks for strings.
  async namedPictures() {
    const text = await readFile(this.file, 'utf8').catch(() => '');
    const names = text.match(/"(?:[^"\\\n]|\\.)+\.png"/gi) ?? [];
    return [...new Set(names.flatMap(textOfJson).map((name) => path.resolve(this.folder, name)))];
  }

  // The file for a path below /-/, or null if there is none or it may not be served.
  async resolve(urlPath) {
    if (urlPath.includes('\0') || urlPath.includes('\\')) return null;
    const inFolder = urlPath.startsWith('scene/');
    const file = inFolder
      ? path.join(this.folder, urlPath.slice('scene/'.length))
      : path.join(this.folder, '..', urlPath);
    if (file === this.file) return file;
    if (!/\.png$/i.test(file)) return null;
    // Pictures that the scene does not name are served only from the scene's own folder.
    const isNamed = (await this.namedPictures()).includes(file);
    const real = await realPathWithin(isNamed ? path.dirname(this.folder) : this.folder, file);
    return /\.png$/i.test(real ?? '') ? real : null;
  }

  async start() {
    this.lastState = await this.state();
    await this.watchFolders();
  }

  // Folders are watched, not files: many editors save by putting a new file in the old one's place.
  async watchFolders() {
    const wanted = new Set([
      this.folder,
      ...(await this.namedPictures()).map((file) => path.dirname(file)),
    ]);
    for (const [folder, watcher] of this.watchers) {
      if (wanted.has(folder)) continue;
      watcher.close();
      this.watchers.delete(folder);
    }
    for (const folder of wanted) {
      if (this.watchers.has(folder)) continue;
      try {
        const watcher = watch(folder, () => this.settle());
        watcher.on('error', () => {
          watcher.close();
          this.watchers.delete(folder);
        });
        this.watchers.set(folder, watcher);
      } catch {
        // A picture's folder does not exist: the page shows that as a fault of the scene.
      }
    }
  }

  settle() {
    clearTimeout(this.timer);
    // What cannot be read now is looked at again after the next change.
    this.timer = setTimeout(() => this.look().catch(() => {}), kSettleMilliseconds);
  }

  async look() {
    await this.watchFolders();
    const state = await this.state();
    if (state === this.lastState || state.startsWith('gone')) return;
    this.lastState = state;
    for (const listener of this.listeners) listener();
  }

  // Size and time of the scene and its pictures; changes of other files in the folder do not
  // matter.
  async state() {
    const describe = async (file) => {
      const found = await stat(file).catch(() => null);
      return found === null ? 'gone' : `${found.size} ${found.mtimeMs} ${found.ino}`;
    };
    return (await Promise.all([this.file, ...(await this.namedPictures())].map(describe))).join(
      '\n',
    );
  }

  stop() {
    clearTimeout(this.timer);
    for (const watcher of this.watchers.values()) watcher.close();
    this.watchers.clear();
  }
}

// The text that a JSON string stands for, as a list; empty if its escapes are malformed.
function textOfJson(string) {
  try {
    return [JSON.parse(string)];
  } catch {
    return [];
  }
}

// Follows links; returns the real path, or null if it is outside the folder.
async function realPathWithin(folder, file) {
  const real = await realpath(file).catch(() => null);
  const root = await realpath(folder);
  const isWithin =
    real !== null && real.startsWith(root.endsWith(path.sep) ? root : root + path.sep);
  return isWithin ? real : null;
}

// The page's file for an address, links followed; null if there is none.
async function pagePath(folder, urlPath) {
  for (const name of [urlPath, `${urlPath}/index.html`]) {
    const real = await realPathWithin(folder, path.join(folder, name));
    if (real !== null && (await stat(real)).isFile())
      return path
        .relative(await realpath(folder), real)
        .split(path.sep)
        .join('/');
  }
  return null;
}

// The name in a Host header, without the port; '' if it is malformed.
function hostName(header) {
  try {
    return new URL(`http://${header}`).hostname;
  } catch {
    return '';
  }
}

function refuse(response, status, text, headers = {}) {
  response.writeHead(status, {
    'Content-Type': 'text/plain; charset=utf-8',
    'Cache-Control': 'no-store',
    ...headers,
  });
  response.end(`${text}\n`);
}

// `otherwise` answers if the file is not there.
async function serveSceneFile(scene, urlPath, response, otherwise) {
  const file = await scene.resolve(urlPath);
  if (file === scene.file) return serveScene(file, response);
  const found = file === null ? null : await stat(file).catch(() => null);
  if (found === null || !found.isFile()) return otherwise();
  response.writeHead(200, {
    'Content-Type': 'image/png',
    'Content-Length': found.size,
    'Cache-Control': 'no-store',
  });
  createReadStream(file).pipe(response);
}

// With the tag by which a save knows that nobody else has saved meanwhile.
async function serveScene(file, response) {
  const bytes = await readFile(file).catch(() => null);
  if (bytes === null) return refuse(response, 404, kNotBeside);
  response.writeHead(200, {
    'Content-Type': 'application/json; charset=utf-8',
    'Content-Length': bytes.length,
    'Cache-Control': 'no-store',
    ETag: tagOf(bytes),
  });
  response.end(bytes);
}

function serveEvents(scene, request, response) {
  response.writeHead(200, { 'Content-Type': 'text/event-stream', 'Cache-Control': 'no-store' });
  if (request.method === 'HEAD') return response.end();
  response.write('retry: 1000\n\n');
  const send = () => response.write(`event: scene\ndata: -/scene/${scene.urlName}\n\n`);
  const beat = setInterval(() => response.write(': still here\n\n'), 15000);
  scene.listeners.add(send);
  request.on('close', () => {
    clearInterval(beat);
    scene.listeners.delete(send);
  });
}

// What a command builds while the server runs. `isBuilding` until it ends; `done` then gives its
// output if it failed, else ''.
class Rest {
  constructor(command) {
    this.isBuilding = true;
    this.child = spawn('nice', [command], { stdio: ['ignore', 'pipe', 'pipe'] });
    let output = '';
    for (const stream of [this.child.stdout, this.child.stderr])
      stream.setEncoding('utf8').on('data', (text) => (output += text));
    this.done = new Promise((resolve) => {
      this.child.on('error', (error) => resolve(error.message));
      this.child.on('close', (status) => resolve(status === 0 ? '' : output.trim()));
    });
    this.done.then(() => (this.isBuilding = false));
  }

  stop() {
    this.child.kill();
  }
}

const kLooksAgain = 2; // seconds

function refuseYet(response) {
  response.writeHead(503, {
    'Content-Type': 'text/html; charset=utf-8',
    'Cache-Control': 'no-store',
    'Retry-After': kLooksAgain,
  });
  response.end(`<!doctype html>
<html lang="en">
<meta charset="utf-8">
<meta http-equiv="refresh" content="${kLooksAgain}">
<meta name="viewport" content="width=device-width">
<meta name="color-scheme" content="light dark">
<title>Being built</title>
<body style="font: 1.1rem/1.5 system-ui, sans-serif; max-width: 36rem; margin: 20vh auto; padding: 0 1rem">
<h1 style="font-size: 1.5rem">This page is being built</h1>
<p>It appears here by itself, within a minute or two. The scenes can be <a href="/">played</a> already.
</html>
`);
}

// The addresses by which others in the network reach this machine, as in a Host header.
function ownAddresses() {
  return Object.values(networkInterfaces())
    .flat()
    .filter(({ internal, address }) => !internal && !address.startsWith('fe80'))
    .map(({ family, address }) => (family === 'IPv6' ? `[${address}]` : address));
}

function listen(server, port, host) {
  return new Promise((resolve, reject) => {
    server.once('error', reject);
    server.listen(port, host, () => {
      server.off('error', reject);
      resolve();
    });
  });
}

// Starts the server. Without `port` it takes the first free one; `hosts` are names besides those of
// this machine, with `lan` others in the network are served, too, `rest` is a command that builds
// what is missing. Returns the page's address, those for others in the network, a function that
// stops the server, and `built`, a promise of the command's output if it failed, else of ''.
export async function startServer({
  folder,
  scene: sceneFile,
  port,
  hosts = [],
  lan = false,
  rest: command,
}) {
  const others = lan ? ownAddresses() : [];
  const known = [...kHosts, ...others, ...hosts.map((host) => host.toLowerCase())];
  const scene = sceneFile === undefined ? null : new WatchedScene(sceneFile);
  await scene?.start();
  const saves = scene === null ? null : new SceneSaves(scene, { hosts: kHosts, lan });
  let rest = null;

  const page = sirv(folder, {
    dev: true, // the folder may be replaced while the server runs
    setHeaders(response) {
      response.setHeader('Cache-Control', 'no-store');
      response.setHeader('Access-Control-Allow-Origin', '*'); // for sandboxed frames
    },
  });
  async function answer(request, response) {
    if (!known.includes(hostName(request.headers.host)))
      return refuse(
        response,
        403,
        `Found the host "${request.headers.host}", expected ${known.join(' or ')}. tools/play --host NAME allows another one.`,
      );
    const isSave =
      request.method === 'PUT' && scene !== null && request.url === `/-/scene/${scene.urlName}`;
    if (isSave) return saves.take(request, response);
    if (!kMethods.includes(request.method))
      return refuse(
        response,
        405,
        `Found the method ${request.method}, expected ${kMethods.join(' or ')}.`,
        { Allow: kMethods.join(', ') },
      );
    const missing = () => refuse(response, 404, 'There is no such file.');
    const servePage = (name) => {
      request.url = `/${name.split('/').map(encodeURIComponent).join('/')}`;
      // Every file is sent whole: sirv misreads ranges such as bytes=-5, and fails at bytes=9-1.
      delete request.headers.range;
      return page(request, response, missing);
    };
    // The raw path: URL() would resolve ".." before it can be checked.
    const rawPath = request.url.split(/[?#]/, 1)[0];
    let urlPath;
    try {
      urlPath = decodeURIComponent(rawPath);
    } catch {
      return refuse(response, 400, 'The address is malformed.');
    }
    if (urlPath.startsWith('/-/')) {
      if (scene === null) return refuse(response, 404, 'No scene was given to tools/play.');
      if (urlPath === '/-/events') return serveEvents(scene, request, response);
      if (urlPath === '/-/save') return saves.tell(request, response);
      const beside = urlPath.slice('/-/'.length);
      return serveSceneFile(scene, beside, response, async () => {
        const name = isShippedFile(`../${beside}`) ? await pagePath(folder, beside) : null;
        return name === null ? refuse(response, 404, kNotBeside) : servePage(name);
      });
    }
    let name = await pagePath(folder, urlPath);
    if (name === null && rest?.isBuilding) {
      if (/text\/html/.test(request.headers.accept ?? '')) return refuseYet(response);
      await rest.done;
      name = await pagePath(folder, urlPath);
    }
    return name === null ? missing() : servePage(name);
  }
  const server = createServer((request, response) => {
    // Closes the file if the client disconnects, and ends the answer if the file cannot be read.
    response.on('pipe', (file) => {
      file.on('error', () => response.destroy());
      response.on('close', () => file.destroy());
    });
    answer(request, response).catch(() => {
      if (response.headersSent) response.destroy();
      else refuse(response, 500, 'The file cannot be read.');
    });
  });

  let at = port ?? kFirstPort;
  for (;;) {
    try {
      await listen(server, at, lan ? undefined : '127.0.0.1');
      break;
    } catch (error) {
      const next =
        error.code === 'EADDRINUSE' && port === undefined && at < kFirstPort + kPortsTried;
      if (!next) {
        scene?.stop();
        throw error;
      }
      ++at;
    }
  }
  if (command !== undefined) rest = new Rest(command);
  const addressAt = (host) => `http://${host}:${server.address().port}/${scene?.address ?? ''}`;
  return {
    built: rest?.done ?? Promise.resolve(''),
    address: addressAt('localhost'),
    others: others.map(addressAt),
    close() {
      scene?.stop();
      rest?.stop();
      server.close();
      server.closeAllConnections?.();
    },
  };
}

// Opens a browser, but only on a desktop.
function openInBrowser(address) {
  const command = process.platform === 'darwin' ? 'open' : 'xdg-open';
  const hasDesktop =
    process.platform === 'darwin' || process.env.DISPLAY || process.env.WAYLAND_DISPLAY;
  if (!hasDesktop || !process.stdout.isTTY) return;
  const child = spawn(command, [address], { stdio: 'ignore', detached: true });
  child.on('error', () => {}); // the address is on the terminal
  child.unref();
}

async function main() {
  const { values } = parseArgs({
    options: {
      folder: { type: 'string' },
      rest: { type: 'string' },
      scene: { type: 'string' },
      port: { type: 'string' },
      host: { type: 'string', multiple: true },
      lan: { type: 'boolean' },
    },
  });
  const folder = values.folder ?? fileURLToPath(new URL('../build/web', import.meta.url));
  const port = values.port === undefined ? undefined : Number(values.port);
  await access(folder, constants.R_OK);
  const { scene, rest, lan, host: hosts } = values;
  const server = await startServer({ folder, scene, port, hosts, lan, rest });
  server.built.then((failure) => {
    if (failure !== '')
      console.error(
        `The rest of the page cannot be built, as documentation and tutorial:\n${failure}`,
      );
  });
  const end = () => {
    server.close();
    process.exit(0);
  };
  process.on('SIGINT', end);
  process.on('SIGTERM', end);
  console.log(`Slicecast is at ${server.address}`);
  for (const address of server.others) console.log(`and for others in your network at ${address}`);
  if (lan) console.log('Everybody in this network can see the page, your scene and its pictures.');
  console.log('Stop it with Ctrl-C.');
  openInBrowser(server.address);
}

if (
  process.argv[1] !== undefined &&
  (await realpath(process.argv[1])) === fileURLToPath(import.meta.url)
) {
  main().catch((error) => {
    const port = error.port === undefined ? '' : ` ${error.port}`;
    const text = {
      EADDRINUSE: `port${port} is in use; choose another one, or leave --port out to get the next free one.`,
      EACCES: `you may not use port${port}; choose one above 1023.`,
    };
    console.error(`tools/play: ${text[error.code] ?? error.message}`);
    process.exit(1);
  });
}
