// Saves the scene that somebody is working on with tools/play: into its own file, whole or not at
// all, and only from the page that the same server has sent.
//
//     const saves = new SceneSaves(scene, { hosts, lan });
//     await saves.tell(request, response);       // GET /-/save: what the page needs for saving
//     await saves.take(request, response);       // PUT /-/scene/NAME.json: {saved, tag}
//     tagOf(bytes)                               // the file's ETag: equal for equal bytes only
//
// `saved` is false if the file has changed since it was read: that is no error, which a browser
// would tell in its console. `tag` is that of the file as it is then.
//
// A page of another origin cannot read the token: that answer allows no other origin, and it is
// given only under a name of this machine. With --lan nobody can save, since others have the page.

import { createHash, randomBytes, timingSafeEqual } from 'node:crypto';
import {
  access,
  chmod,
  chown,
  constants,
  open,
  readFile,
  realpath,
  rename,
  rm,
  stat,
} from 'node:fs/promises';
import path from 'node:path';
import { kMostSceneBytes } from '../web/engine/limits.js';

const kThisMachine = ['127.0.0.1', '::1', '::ffff:127.0.0.1'];
const kForwarded = ['forwarded', 'x-forwarded-for', 'x-forwarded-host', 'via'];

export const tagOf = (bytes) => `"${createHash('sha256').update(bytes).digest('base64url')}"`;

class Refusal extends Error {
  constructor(status, message, headers = {}) {
    super(message);
    Object.assign(this, { status, headers });
  }
}

export class SceneSaves {
  #scene;
  #hosts;
  #lan;
  #token = randomBytes(24).toString('base64url');
  #last = Promise.resolve(); // saves are made one after the other

  constructor(scene, { hosts, lan }) {
    this.#scene = scene;
    this.#hosts = hosts;
    this.#lan = lan;
  }

  async tell(request, response) {
    const { name } = this.#scene;
    const file = await realpath(this.#scene.file);
    const answer = {
      address: `-/scene/${encodeURIComponent(name)}`,
      // Browsers keep what is edited under this: two scenes may have the same name.
      id: createHash('sha256').update(file).digest('base64url').slice(0, 16),
      token: null,
      reason: null,
    };
    try {
      this.#check(request);
      answer.token = this.#token;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      answer.reason = error.message;
    }
    send(response, 200, JSON.stringify(answer), { 'Content-Type': 'application/json' });
  }

  async take(request, response) {
    try {
      this.#check(request);
      this.#checkSender(request);
      const wanted = request.headers['if-match'];
      if (wanted === undefined)
        throw new Refusal(428, 'Found no If-Match, expected the ETag of the file as it was read.');
      const bytes = await bodyOf(request);
      checkScene(bytes);
      const save = this.#last.then(() => this.#write(bytes, wanted));
      this.#last = save.catch(() => {});
      const answer = JSON.stringify(await save);
      send(response, 200, answer, { 'Content-Type': 'application/json' });
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      // What was not read of the request would be taken for the next one.
      if (!request.complete) error.headers.Connection = 'close';
      send(response, error.status, `${error.message}\n`, error.headers);
    }
  }

  #check({ headers, socket }) {
    if (this.#lan)
      throw new Refusal(
        403,
        'Nothing is saved: with --lan, others in the network have this page, too. ' +
          'Start tools/play without it.',
      );
    const isOwn =
      kThisMachine.includes(socket.remoteAddress) &&
      this.#hosts.includes(nameIn(headers.host)) &&
      !kForwarded.some((name) => headers[name] !== undefined);
    if (!isOwn)
      throw new Refusal(403, `Only this machine can save, at ${this.#hosts.join(' or ')}.`);
    const site = headers['sec-fetch-site'];
    if (site !== undefined && site !== 'same-origin')
      throw new Refusal(403, `Found a request from another site (${site}), expected the editor.`);
  }

  #checkSender({ headers }) {
    if (headers.origin !== `http://${headers.host}`)
      throw new Refusal(
        403,
        `Found the origin ${headers.origin ?? 'nothing'}, expected http://${headers.host}.`,
      );
    const token = Buffer.from(headers['x-slicecast-token'] ?? '');
    const own = Buffer.from(this.#token);
    if (token.length !== own.length || !timingSafeEqual(token, own))
      throw new Refusal(403, 'The page is older than this server. Reload it, then save again.');
  }

  // A new file takes the old one's place in one step.
  async #write(bytes, wanted) {
    const file = await realpath(this.#scene.file);
    const { mode, uid, gid } = await stat(file);
    await access(file, constants.W_OK).catch(() => {
      throw new Refusal(403, `${this.#scene.name} may not be written.`);
    });
    const other = path.join(
      path.dirname(file),
      `.${path.basename(file)}.${randomBytes(6).toString('hex')}~`,
    );
    try {
      const handle = await open(other, 'wx', 0o600);
      try {
        await handle.writeFile(bytes);
        await handle.sync();
      } finally {
        await handle.close();
      }
      if (uid !== process.getuid?.() || gid !== process.getgid?.())
        await chown(other, uid, gid).catch(() => {}); // only root may
      await chmod(other, mode & 0o7777);
      // As late as possible: another program may save meanwhile.
      const tag = tagOf(await readFile(file));
      if (tag !== wanted) {
        await rm(other);
        return { saved: false, tag };
      }
      await rename(other, file);
      return { saved: true, tag: tagOf(bytes) };
    } catch (error) {
      await rm(other, { force: true });
      throw error instanceof Refusal
        ? error
        : new Refusal(500, `${this.#scene.name} could not be written: ${error.code}.`);
    }
  }
}

function nameIn(host) {
  try {
    return new URL(`http://${host}`).hostname;
  } catch {
    return '';
  }
}

async function bodyOf(request) {
  const tooLarge = (found) =>
    new Refusal(413, `Found ${found} bytes or more, expected at most ${kMostSceneBytes}.`);
  const announced = Number(request.headers['content-length'] ?? 0);
  if (announced > kMostSceneBytes) throw tooLarge(announced);
  const parts = [];
  let size = 0;
  for await (const part of request) {
    size += part.length;
    if (size > kMostSceneBytes) throw tooLarge(size);
    parts.push(part);
  }
  if (!request.complete) throw new Refusal(400, 'The request broke off.');
  return Buffer.concat(parts);
}

function checkScene(bytes) {
  let value;
  try {
    value = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch (error) {
    throw new Refusal(422, `Found no JSON, expected a scene: ${error.message}`);
  }
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    throw new Refusal(422, 'Found no object, expected a scene.');
}

function send(response, status, text, headers) {
  response.writeHead(status, {
    'Content-Type': 'text/plain; charset=utf-8',
    'Cache-Control': 'no-store',
    ...headers,
  });
  response.end(text);
}
