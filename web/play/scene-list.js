// The scenes that come with the page.

import { allowed } from '../engine/allowed.js';
import { fetchBytes } from '../engine/fetch-bytes.js';
import { Trouble } from '../engine/trouble.js';

const kScenes = new URL('scenes/', document.baseURI);

// [{file, title, about, tour, group, flight, poster}], the opening scene first; `tour` is true where
// a recorded tour has the scene's name, `group` names those that stand apart, one after the other,
// under a title of their own; `flight` is that of the opening (flight.js); `poster` is the path of
// its picture for the menu, which tools/page draws and writes into the list.
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

// A name among the page's scenes ("castle" or "castle.json"), or, with a slash in it, an address
// relative to the page, as far as the page's owner allows it. Throws a Trouble.
export function sceneAddress(reference) {
  const file = /\.json$/i.test(reference) ? reference : `${reference}.json`;
  return allowed(new URL(file, file.includes('/') ? document.baseURI : kScenes));
}

// The other way round: what names that address.
export function referenceOf(address) {
  const folders = [kScenes.href, new URL('.', document.baseURI).href];
  const folder = folders.find((one) => address.startsWith(one)) ?? '';
  return decodeURIComponent(address.slice(folder.length));
}

export function tourAddress(name) {
  return new URL(`tours/${name}.txt`, document.baseURI);
}

// The picture of a scene for the menu, by the path that the list has for it.
export function posterAddress(path) {
  return new URL(path, kScenes);
}
