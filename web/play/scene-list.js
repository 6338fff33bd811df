// The scenes that come with the page.

import { allowed } from '../engine/allowed.js';
import { fetchBytes } from '../engine/fetch-bytes.js';
import { Trouble } from '../engine/trouble.js';

const kScenes = new URL('scenes/', document.baseURI);

// Returns [{file, title, about, tour, group, flight, poster}], the opening scene first. `tour` is
// true if there is a tour of the scene's name. Consecutive scenes with the same `group` stand under
// that title. `flight` is for the opening (flight.js). `poster` is the path of the menu's picture,
// which tools/page draws and adds to the list.
export async function listScenes() {
  const address = new URL('index.json', kScenes);
  const bytes = await fetchBytes(address).catch((error) => {
    throw new Trouble(
      'The list of scenes could not be loaded',
      `${address.href}: ${error.message}.`,
      [],
      error.code,
    );
  });
  return JSON.parse(new TextDecoder().decode(bytes));
}

// The address for the name of one of the page's scenes: "castle" or "castle.json". With a slash in
// it, the text is an address relative to the page. Throws a Trouble if the page's owner does not
// allow the address.
export function sceneAddress(reference) {
  const file = /\.json$/i.test(reference) ? reference : `${reference}.json`;
  return allowed(new URL(file, file.includes('/') ? document.baseURI : kScenes));
}

// The reverse: the name for an address.
export function referenceOf(address) {
  const folders = [kScenes.href, new URL('.', document.baseURI).href];
  const folder = folders.find((one) => address.startsWith(one)) ?? '';
  const reference = address.slice(folder.length);
  try {
    return decodeURIComponent(reference);
  } catch {
    return reference; // "%" is a letter of its own here
  }
}

// The editor with one of the page's scenes in it, or that of tools/play.
export function editAddress(reference) {
  const isOwn = !reference.includes('/');
  const scene = isOwn ? reference.replace(/\.json$/i, '') : reference;
  return `edit.html?scene=${encodeURIComponent(scene)}`;
}

export function tourAddress(name) {
  return new URL(`tours/${name}.txt`, document.baseURI);
}

// `path` is the list's `poster`.
export function posterAddress(path) {
  return new URL(path, kScenes);
}
