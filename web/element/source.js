// Finds the scene of a <ray-caster>: an address, an object, or its children. source-parts.js
// describes sources; their files are fetched once per page.
//
//     const scene = findScene(element);             // {key, source()} or null; throws a Trouble
//     const source = namedScene('castle');          // a shipped scene
//     source.failures                               // file -> why it could not be read

import { finalAddress } from '../engine/fetch-bytes.js';
import { kHome, reachable } from '../engine/home.js';
import { kMostSceneBytes } from '../engine/limits.js';
import { nearestName } from '../engine/nearest-name.js';
import { bringRows } from './later-parts.js';
import { fetchOnce, pictures } from './page-cache.js';
import { readSceneObject } from '../engine/scene-object.js';
import {
  filesBy,
  isFile,
  isShippedFile,
  nameOf,
  placesOf,
  readFirst,
  shippedAddress,
} from '../engine/source-parts.js';
import { Trouble, coded } from '../engine/trouble.js';

const kScenes = new URL('scenes/', kHome); // inline scenes name files relative to this folder

const kInline = 'script[type="application/json"]';
const kRows = 'script[type="text/plain"][data-rows], pre[slot="rows"], pre[data-rows]';
const kPre = 'pre'; // if nothing else is a scene
const kName = /^[\w-]+$/;
// name -> {scene, tour} of imported modules slicecast/scenes/NAME
const kImported = Symbol.for('slicecast.scenes');
const kShipped = /^((scenes|textures|see-through|sheets|sprites|tours)\/|pictures\.json$)/;

const keys = new WeakMap(); // source made by a page -> its key
let keyCount = 0;

export function findScene(element) {
  const { scene, source } = element;
  if (source !== null) {
    if (!keys.has(source)) keys.set(source, `source ${++keyCount}`);
    return { key: keys.get(source), source: () => sceneOfPage(source) };
  }
  const object = typeof scene === 'object' ? scene : importedBy(scene)?.scene;
  if (object !== undefined) return ofObject(element, object);
  if (scene.startsWith('#')) return ofElement(element, referredTo(element, scene));
  if (scene !== '') {
    const address = addressOf(scene, (name) => new URL(`${name}.json`, kScenes), element, 'scene');
    return { key: address.href, source: () => sceneFrom(address) };
  }
  for (const selector of [kInline, kRows, ...(element.tour === '' ? [kPre] : [])]) {
    const inside = element.querySelector(`:scope > :is(${selector})`);
    if (inside !== null) return ofElement(element, inside);
  }
  const text = element.tour === '' ? bareText(element) : '';
  return isRows(text) ? ofRows(element, text) : null;
}

// The error for an element without a scene.
export function noScene(element) {
  const text = bareText(element).trim();
  return new Trouble(
    'There is no scene',
    `Found ${text === '' ? 'nothing' : `"${text.slice(0, 40)}"`}, expected scene="castle" or another address, a scene as JSON in <script type="application/json">, or at least two rows of characters, as text or in <pre>`,
    [],
    'address',
  );
}

// Resolves `#yard`: another element's scene, or a script or rows elsewhere in the page.
function referredTo(element, reference) {
  const seen = new Set([element]);
  let found = element;
  while (seen.size < 100) {
    const { scene } = found;
    if (found.localName !== element.localName || typeof scene !== 'string' || scene[0] !== '#')
      return found;
    found = element.getRootNode().querySelector(`[id="${CSS.escape(scene.slice(1))}"]`);
    if (found === null || seen.has(found)) break;
    seen.add(found);
  }
  throw new Trouble(
    'There is no scene',
    `scene: found "${reference}", expected the id of an element with a scene`,
    [],
    'address',
  );
}

function ofElement(element, inside) {
  if (inside.localName === element.localName) return findScene(inside);
  const text = inside.textContent;
  if (!inside.matches(kInline)) return ofRows(element, text, inside.dataset.rows);
  return {
    key: `json ${element.base} ${text}`,
    source: () =>
      sceneOf(
        'inline scene',
        async () => text,
        filesFor(element, () => kScenes),
      ),
  };
}

function ofObject(element, scene) {
  const { text, addresses, addressOf: pictureOf } = readSceneObject(scene);
  const isRows = 'rows' in scene;
  const read = async () =>
    isRows ? JSON.stringify((await bringRows()).sceneOfObject(JSON.parse(text), 'rows')) : text;
  return {
    key: `json ${element.base} ${addresses} ${text}`,
    source: () => {
      const others = isRows ? rowsFiles(element) : filesFor(element, () => kScenes);
      return sceneOf('scene', read, (file) => {
        const address = pictureOf(file);
        if (address === null) return others(file);
        return reachable(() => address, address.pathname.slice(1), kHome);
      });
    },
  };
}

function ofRows(element, text, how = '') {
  const title = element.label || undefined;
  const colours = /^colou?rs$/.test(how);
  const read = async () =>
    JSON.stringify((await bringRows()).sceneOfRows(text, { title, colours }));
  return {
    key: `rows ${element.base} ${title} ${colours} ${text}`,
    source: () => sceneOf('rows', read, rowsFiles(element)),
  };
}

// The element's own text, without that of child elements; but browsers that translate a page put
// it into <font>.
function bareText(element) {
  return [...element.childNodes]
    .map((node) =>
      node.nodeType === Node.TEXT_NODE
        ? node.data
        : node.localName === 'font'
          ? bareText(node)
          : '',
    )
    .join('');
}

function isRows(text) {
  return text.split('\n').filter((line) => line.trim() !== '').length > 1;
}

// Resolves files of a scene without an address: relative to the attribute `base`, else to
// `otherwise(file)`.
function filesFor(element, otherwise) {
  const { base, ownerDocument } = element;
  const folder = base === '' ? null : addressOf(base, null, element, 'base');
  return (file) => new URL(file, folder ?? otherwise(file, ownerDocument.baseURI));
}

// The author's own pictures are relative to the page.
function rowsFiles(element) {
  const ofOwn = filesFor(element, (_, page) => page);
  return (file) => (isShippedFile(file) ? new URL(file, kScenes) : ofOwn(file));
}

// A shipped scene by its name, as recordings use it.
export function namedScene(name) {
  const scene = importedBy(bare(name))?.scene;
  return scene === undefined
    ? sceneFrom(new URL(`${bare(name)}.json`, kScenes))
    : ofObject({ base: '' }, scene).source();
}

// A scene that the page's scripts imported.
function importedBy(name) {
  return globalThis[kImported]?.get(name);
}

// The address of a recording: a shipped one by its name, else relative to the document.
export function tourAddress(element) {
  const named = (name) =>
    reachable(() => new URL(importedBy(name).tour), `tours/${name}.txt`, kHome);
  return addressOf(element.tour, named, element, 'tour');
}

// Returns {name, bytes} of a recording. Throws a Trouble.
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
  if (named !== null && kName.test(text)) return named(text);
  try {
    return new URL(text, element.ownerDocument.baseURI);
  } catch {
    throw new Trouble(
      'An attribute cannot be read',
      `${attribute}: found "${text}", expected an address${named === null ? '' : ` or the name of a shipped ${attribute}`}`,
      [],
      'address',
    );
  }
}

function sceneFrom(address) {
  return {
    name: nameOf(address),
    address,
    pictures,
    readText: () =>
      fetchFile(address, undefined, kMostSceneBytes).catch(async (error) => {
        throw new Trouble(
          'The scene could not be loaded',
          `${address.href}: ${error.message}.${await probablyMeant(address)}`,
          [],
          error.code,
        );
      }),
    ...filesAt((file) => new URL(file, finalAddress(isFile(address) ? address : kScenes))),
  };
}

// A hint, if the name of a shipped scene is similar to that of a missing one.
async function probablyMeant(address) {
  if (new URL('.', address).href !== kScenes.href) return '';
  try {
    const list = await fetchOnce(new URL('index.json', kScenes));
    const names = JSON.parse(new TextDecoder().decode(list)).map(({ file }) => bare(file));
    const name = nearestName(bare(nameOf(address)), names);
    return name === null ? '' : ` Did you mean '${name}'?`;
  } catch {
    return ''; // the list is missing too
  }
}

const bare = (file) => file.replace(/\.json$/i, '');

function sceneOf(name, read, addressOfFile) {
  return {
    name,
    address: null,
    pictures,
    readText: async () => new TextEncoder().encode(await read()),
    ...filesAt(addressOfFile),
  };
}

// Wraps the property `source`.
function sceneOfPage(source) {
  return {
    name: source.name ?? 'scene',
    address: null,
    async readText() {
      const text = await source.readText();
      return typeof text === 'string' ? new TextEncoder().encode(text) : text;
    },
    ...filesBy((file, onBytes) => {
      const shipped = shippedAddress(file, kHome);
      return shipped ? fetchFile(shipped, onBytes) : source.readFile(file);
    }),
  };
}

function filesAt(addressOfFile) {
  const places = (file) => placesOf(file, addressOfFile(file), kHome);
  return {
    addressOf: (file) => places(file)[0],
    ...filesBy((file, onBytes) => readFirst(places(file), (place) => fetchFile(place, onBytes))),
  };
}

// If the server sends a web page instead of a shipped file, the package's folders are missing where
// the element looks for them.
function fetchFile(address, onBytes, most) {
  return fetchOnce(address, onBytes, most).catch((error) => {
    const isShipped =
      address.href.startsWith(kHome.href) && kShipped.test(address.href.slice(kHome.href.length));
    if (error.code !== 'mime' || !isShipped) throw error;
    throw coded(
      'mime',
      `${error.message}; the package's scenes, pictures and tours must be served in ${kHome.href}`,
    );
  });
}
