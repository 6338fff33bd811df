// Sources of scenes under Node, for Engine.loadScene.
//
//     openScene('worlds/castle.json')     // or 'https://...', a URL, 'castle' (a shipped scene)
//     openScene({ title: 'A garden', ... }, 'worlds')  // an object, and the folder of its pictures
//     openScene(castle)                                  // the export of slicecast/scenes/castle
//     openScene({ rows: '####\n#>.#\n####' })            // plain rows of characters
//     source.failures                                    // file -> why it could not be read
//
// Instead of the folder, a file in it will do.

import { createReadStream, statSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { inspect } from 'node:util';

import { kMostFileBytes, kMostSceneBytes, tooLong } from '../engine/limits.js';
import { coded } from '../engine/trouble.js';
import { sceneOfObject } from '../engine/rows.js';
import { readSceneObject } from '../engine/scene-object.js';
import {
  filesBy,
  isFile,
  isShippedFile,
  nameOf,
  placesOf,
  readFirst,
} from '../engine/source-parts.js';

// Bundled as a classic script, this has no address. Then shipped files are not found, and reading
// them fails.
export const kPackage = new URL('../', import.meta.url ?? 'file:///');

const kShipped = new URL('scenes/', kPackage);
const kPiece = 1 << 20; // bytes per read
const kMostReads = 32; // files open at a time, because a process may open only so many

export function openScene(scene, base) {
  const folder = folderOf(base === undefined ? kShipped : base);
  if (typeof scene === 'object' && scene !== null && !(scene instanceof URL)) {
    const isRows = 'rows' in scene;
    const { text, addressOf: pictureOf } = readSceneObject(scene);
    const whole = isRows ? JSON.stringify(sceneOfObject(JSON.parse(text), 'rows'), null, 2) : text;
    // The pictures of standard characters are shipped; those that the author names are not.
    const own = isRows ? folderOf(base === undefined ? '.' : base) : folder;
    return {
      name: isRows ? 'rows' : 'scene',
      readText: async () => new TextEncoder().encode(whole),
      ...filesBy((file) =>
        bytesOf(
          file,
          pictureOf(file) ?? new URL(file, isRows && isShippedFile(file) ? kShipped : own),
        ),
      ),
    };
  }
  const isName = typeof scene === 'string' && /^[\w-]+$/.test(scene);
  const address = isName ? new URL(`${scene}.json`, kShipped) : addressOf('scene', scene);
  let beside = folder;
  return {
    name: nameOf(address),
    async readText() {
      const { bytes, from } = await readAt(address, kMostSceneBytes).catch(async (error) => {
        throw isName && error.message.includes('ENOENT') ? await noSuchName(scene) : error;
      });
      if (isFile(from)) beside = from;
      return bytes;
    },
    ...filesBy((file) => bytesOf(file, new URL(file, beside))),
  };
}

// Returns {bytes, from}; `from` is the final address after redirects. Throws an Error with the code
// 'fetch'.
export async function readAt(address, most = kMostFileBytes) {
  try {
    return await inTurn(() =>
      address.protocol === 'file:'
        ? collect(createReadStream(address, { highWaterMark: kPiece }), most).then((bytes) => ({
            bytes,
            from: address,
          }))
        : fetchAt(address, most),
    );
  } catch (error) {
    // The first part of a file error is the reason; the rest repeats the path.
    const [reason] = (error.cause?.message || error.cause?.code || error.message).split(
      /, \w+(?: '|$)/,
    );
    throw coded('fetch', `${isFile(address) ? address.href : nameOf(address)}: ${reason}`);
  }
}

function bytesOf(file, beside) {
  return readFirst(placesOf(file, beside, kPackage), bytesAt);
}

async function bytesAt(address) {
  return (await readAt(address)).bytes;
}

async function fetchAt(address, most) {
  const answer = await fetch(address);
  if (!answer.ok)
    throw new Error(`the server answers ${answer.status} ${answer.statusText}`.trim());
  return { bytes: await collect(answer.body ?? [], most), from: new URL(answer.url) };
}

// Closes the file or answer even if it is not read to its end.
async function collect(pieces, most) {
  const all = [];
  let length = 0;
  for await (const piece of pieces) {
    length += piece.length;
    if (length > most) throw tooLong(length, most);
    all.push(piece);
  }
  const bytes = new Uint8Array(length);
  all.reduce((at, piece) => (bytes.set(piece, at), at + piece.length), 0);
  return bytes;
}

let reads = 0;
const waiting = [];

async function inTurn(read) {
  if (reads < kMostReads) ++reads;
  else await new Promise((resolve) => waiting.push(resolve));
  try {
    return await read();
  } finally {
    // Passes the slot to the next one who waits.
    if (waiting.length > 0) waiting.shift()();
    else --reads;
  }
}

// Reads a path, or an address if it begins like one.
function addressOf(what, reference) {
  if (reference instanceof URL) return reference;
  if (typeof reference === 'string' && reference !== '') {
    if (!/^[a-z]{2,}:/i.test(reference)) return pathToFileURL(reference);
    try {
      return new URL(reference);
    } catch {
      // Not an address after all.
    }
  }
  throw misread(what, reference);
}

function folderOf(base) {
  const address = addressOf('base', base);
  if (!isFile(address)) throw misread('base', base);
  if (address.protocol !== 'file:' || !isFolder(address) || address.pathname.endsWith('/'))
    return address;
  const folder = new URL(address);
  folder.pathname += '/';
  return folder;
}

// Returns false if the path cannot be examined: reading from it then gives the reason.
function isFolder(address) {
  try {
    return statSync(address).isDirectory();
  } catch {
    return false;
  }
}

function misread(what, found) {
  const expected =
    what === 'base'
      ? 'the path or address of a folder or a file in it'
      : 'a path, an address, the name of a shipped scene or an object';
  return new TypeError(
    `${what}: found ${typeof found === 'string' ? `"${found}"` : inspect(found, { depth: 0 })}, expected ${expected}`,
  );
}

async function noSuchName(name) {
  const list = JSON.parse(new TextDecoder().decode(await bytesAt(new URL('index.json', kShipped))));
  const names = list.map(({ file }) => file.replace(/\.json$/, '')).join(', ');
  return coded(
    'fetch',
    `scene: found "${name}", expected the name of a shipped scene (${names}), or a path, which ./${name} would be`,
  );
}
