// Which scene a <ray-caster> shows: an address, or what its children hold. A source is as scene-source.js describes it; its files are fetched once per page.
//
//     const scene = findScene(element);             // {key, source()}, null without one; throws a Trouble
//     const source = namedScene('castle');          // one of those that lie beside the script
//     source.failures                               // file -> why it could not be read

import { kHome } from '../home.js';
import { bringRows } from './late.js';
import { fetchOnce } from './page-cache.js';
import { Trouble } from '../trouble.js';

const kScenes = new URL('scenes/', kHome); // what an inline scene names is looked for there

const kInline = ':scope > script[type="application/json"]';
const kRows = ':scope > script[type="text/plain"][data-rows], :scope > pre[slot="rows"]';
const kName = /^[\w-]+$/;

export function findScene(element) {
  const { scene } = element;
  if (scene !== '') {
    const address = addressOf(scene, (name) => new URL(`${name}.json`, kScenes), element, 'scene');
    return { key: address.href, source: () => sceneFrom(address) };
  }
  const inline = element.querySelector(kInline);
  if (inline !== null) return { key: `json ${inline.textContent}`, source: () => sceneOf('inline scene', async () => inline.textContent) };
  const rows = element.querySelector(kRows);
  if (rows === null) return null;
  const title = element.label || undefined;
  const text = rows.textContent;
  const read = async () => JSON.stringify((await bringRows()).sceneOfRows(text, { title }));
  return { key: `rows ${title} ${text}`, source: () => sceneOf('rows', read) };
}

// One of the shipped scenes, as recordings name them.
export function namedScene(name) {
  return sceneFrom(new URL(`${name.replace(/\.json$/i, '')}.json`, kScenes));
}

// The address of a recording: a shipped one by its name, else relative to the document.
export function tourAddress(element) {
  return addressOf(element.tour, (name) => new URL(`tours/${name}.txt`, kHome), element, 'tour');
}

// {name, bytes} of a recording. Throws a Trouble.
export async function readTour(address) {
  const bytes = await fetchOnce(address).catch((error) => {
    throw new Trouble('The tour could not be loaded', `${address.href}: ${error.message}.`, [], 'tour');
  });
  return { name: nameOf(address), bytes };
}

function addressOf(text, named, element, attribute) {
  if (kName.test(text)) return named(text);
  try {
    return new URL(text, element.ownerDocument.baseURI);
  } catch {
    throw new Trouble('An attribute cannot be read', `${attribute}: found "${text}", expected an address or the name of a shipped ${attribute}`, [], 'address');
  }
}

// Others (data:, blob:) have neither a name nor anything beside them: what they hold is as a scene inside the element.
function isFile(address) {
  return /^(https?|file):$/.test(address.protocol);
}

// For messages.
function nameOf(address) {
  if (!isFile(address)) return `${address.protocol} address`;
  const name = address.pathname.split('/').pop();
  try {
    return decodeURIComponent(name);
  } catch {
    return name;
  }
}

function sceneFrom(address) {
  return {
    name: nameOf(address),
    address,
    readText: () => fetchOnce(address).catch((error) => {
      throw new Trouble('The scene could not be loaded', `${address.href}: ${error.message}.`, [], error.code);
    }),
    ...filesBeside(isFile(address) ? address : kScenes),
  };
}

function sceneOf(name, read) {
  return { name, address: null, readText: async () => new TextEncoder().encode(await read()), ...filesBeside(kScenes) };
}

// readFile gives null for a file that cannot be read, which is tried once: the engine says which place of the scene names it, `failures` why.
function filesBeside(address) {
  const failures = new Map();
  return {
    failures,
    async readFile(file, onBytes) {
      if (failures.has(file)) return null;
      try {
        return await fetchOnce(new URL(file, address), onBytes);
      } catch (error) {
        failures.set(file, error.message);
        return null;
      }
    },
  };
}
