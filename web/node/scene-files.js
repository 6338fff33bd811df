// Where a scene and its pictures come from under Node, in the form that Engine.loadScene takes.
//
//     const source = openScene('worlds/castle.json');       // or 'https://...', a URL, 'castle' (a shipped scene), or an object

import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';

const kShipped = new URL('../scenes/', import.meta.url);

export function openScene(scene, base = kShipped) {
  if (typeof scene === 'string' || scene instanceof URL) {
    const address = addressOf(scene);
    return {
      name: decodeURIComponent(address.pathname.split('/').pop()),
      readText: () => readBytes(address),
      readFile: (name) => readBytes(new URL(name, address)).catch(() => null),
    };
  }
  if (typeof scene !== 'object' || scene === null) throw new TypeError(`scene: found ${scene}, expected a path, an address or an object`);
  return {
    name: 'scene',
    readText: async () => new TextEncoder().encode(JSON.stringify(scene, null, 2)),
    readFile: (name) => readBytes(new URL(name, addressOf(base))).catch(() => null),
  };
}

// A word alone is the name of a shipped scene; what begins like an address is one, anything else is a path.
function addressOf(reference) {
  if (reference instanceof URL) return reference;
  if (/^[\w-]+$/.test(reference)) return new URL(`${reference}.json`, kShipped);
  return /^[a-z]{2,}:/i.test(reference) ? new URL(reference) : pathToFileURL(reference);
}

async function readBytes(address) {
  try {
    if (address.protocol === 'file:') return await readFile(address);
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`the server answers ${answer.status} ${answer.statusText}`.trim());
    return new Uint8Array(await answer.arrayBuffer());
  } catch (error) {
    throw Object.assign(new Error(`${address.href}: ${error.cause?.message ?? error.message}`), { code: 'fetch' });
  }
}
