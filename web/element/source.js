// Which scene a <ray-caster> shows: an address, or what its children hold. A source is as
// source-parts.js describes it; its files are fetched once per page.
//
//     const scene = findScene(element);             // {key, source()}, null without one; throws a Trouble
//     const source = namedScene('castle');          // one of those that lie beside the script
//     source.failures                               // file -> why it could not be read

import { finalAddress } from '../engine/fetch-bytes.js';
import { kHome } from '../engine/home.js';
import { bringRows } from './late.js';
import { fetchOnce } from './page-cache.js';
import { filesBy, isFile, nameOf } from '../engine/source-parts.js';
import { Trouble, coded } from '../engine/trouble.js';

const kScenes = new URL('scenes/', kHome); // what an inline scene names is looked for there

const kInline = ':scope > script[type="application/json"]';
const kRows = ':scope > script[type="text/plain"][data-rows], :scope > pre[slot="rows"]';
const kName = /^[\w-]+$/;
const kShipped = /^(scenes|textures|see-through|sheets|sprites|tours)\//;

export function findScene(element) {
  const { scene } = element;
  if (scene !== '') {
    const address = addressOf(scene, (name) => new URL(`${name}.json`, kScenes), element, 'scene');
    return { key: address.href, source: () => sceneFrom(address) };
  }
  const inline = element.querySelector(kInline);
  if (inline !== null)
    return {
      key: `json ${inline.textContent}`,
      source: () => sceneOf('inline scene', async () => inline.textContent),
    };
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
  const bytes = await fetchFile(address).catch((error) => {
    throw new Trouble(
      'The tour could not be loaded',
      `${address.href}: ${error.message}.`,
      [],
      'tour',
    );
  });
  return { name: nameOf(address), bytes };
}

function addressOf(text, named, element, attribute) {
  if (kName.test(text)) return named(text);
  try {
    return new URL(text, element.ownerDocument.baseURI);
  } catch {
    throw new Trouble(
      'An attribute cannot be read',
      `${attribute}: found "${text}", expected an address or the name of a shipped ${attribute}`,
      [],
      'address',
    );
  }
}

function sceneFrom(address) {
  return {
    name: nameOf(address),
    address,
    readText: () =>
      fetchFile(address).catch((error) => {
        throw new Trouble(
          'The scene could not be loaded',
          `${address.href}: ${error.message}.`,
          [],
          error.code,
        );
      }),
    ...filesBeside(isFile(address) ? address : kScenes),
  };
}

function sceneOf(name, read) {
  return {
    name,
    address: null,
    readText: async () => new TextEncoder().encode(await read()),
    ...filesBeside(kScenes),
  };
}

function filesBeside(address) {
  return filesBy((file, onBytes) => fetchFile(new URL(file, finalAddress(address)), onBytes));
}

// A page in place of a shipped file: the folders of the package are not where the element looks for
// them.
function fetchFile(address, onBytes) {
  return fetchOnce(address, onBytes).catch((error) => {
    const isShipped =
      address.href.startsWith(kHome.href) && kShipped.test(address.href.slice(kHome.href.length));
    if (error.code !== 'mime' || !isShipped) throw error;
    throw coded(
      'mime',
      `${error.message}; the package's scenes, pictures and tours must be served in ${kHome.href}`,
    );
  });
}
