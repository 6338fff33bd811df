// Which scene a <ray-caster> shows: an address, or what its children hold. A source is as
// source-parts.js describes it; its files are fetched once per page.
//
//     const scene = findScene(element);             // {key, source()}, null without one; throws a Trouble
//     const source = namedScene('castle');          // one of those that lie beside the script
//     source.failures                               // file -> why it could not be read

import { finalAddress } from '../engine/fetch-bytes.js';
import { kHome, reachable } from '../engine/home.js';
import { kMostSceneBytes } from '../engine/limits.js';
import { bringRows } from './late.js';
import { fetchOnce, pictures } from './page-cache.js';
import { readSceneObject } from '../engine/scene-object.js';
import { filesBy, isFile, isShippedFile, nameOf } from '../engine/source-parts.js';
import { Trouble, coded } from '../engine/trouble.js';

const kScenes = new URL('scenes/', kHome); // what an inline scene names is looked for there

const kInline = 'script[type="application/json"]';
const kRows = 'script[type="text/plain"][data-rows], pre[slot="rows"], pre[data-rows]';
const kPre = 'pre'; // where nothing else is a scene
const kName = /^[\w-]+$/;
const kImported = Symbol.for('slicecast.scenes'); // name -> {scene, tour} of the modules slicecast/scenes/NAME
const kShipped = /^(scenes|textures|see-through|sheets|sprites|tours)\//;

const keys = new WeakMap(); // of sources that pages have made
let keyCount = 0;

export function findScene(element) {
  const { scene, source } = element;
  if (source !== null) {
    if (!keys.has(source)) keys.set(source, `source ${++keyCount}`);
    return { key: keys.get(source), source: () => sceneOfPage(source) };
  }
  const given = typeof scene === 'object' ? scene : importedBy(scene)?.scene;
  if (given !== undefined) return ofObject(element, given);
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

// What is missing, where findScene gives null.
export function noScene(element) {
  const text = bareText(element).trim();
  return new Trouble(
    'There is no scene',
    `Found ${text === '' ? 'nothing' : `"${text.slice(0, 40)}"`}, expected scene="castle" or another address, a scene as JSON in <script type="application/json">, or two rows of characters or more, as text or in <pre>`,
    [],
    'address',
  );
}

// `#yard`: another element's scene, or a script or rows that stand elsewhere in the page.
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

// Text between the tags, beside elements.
function bareText(element) {
  return [...element.childNodes]
    .filter(({ nodeType }) => nodeType === Node.TEXT_NODE)
    .map(({ data }) => data)
    .join('');
}

function isRows(text) {
  return text.split('\n').filter((line) => line.trim() !== '').length > 1;
}

// Where the files lie that a scene names which has no address of its own: where the attribute says,
// else where `otherwise(file)` says.
function filesFor(element, otherwise) {
  const { base, ownerDocument } = element;
  const folder = base === '' ? null : addressOf(base, null, element, 'base');
  return (file) => new URL(file, folder ?? otherwise(file, ownerDocument.baseURI));
}

// The author's own pictures lie beside the page.
function rowsFiles(element) {
  const ofOwn = filesFor(element, (_, page) => page);
  return (file) => (isShippedFile(file) ? new URL(file, kScenes) : ofOwn(file));
}

// One of the shipped scenes, as recordings name them.
export function namedScene(name) {
  const bare = name.replace(/\.json$/i, '');
  const scene = importedBy(bare)?.scene;
  return scene === undefined
    ? sceneFrom(new URL(`${bare}.json`, kScenes))
    : ofObject({ base: '' }, scene).source();
}

// What the page's scripts have imported of a scene.
function importedBy(name) {
  return globalThis[kImported]?.get(name);
}

// The address of a recording: a shipped one by its name, else relative to the document.
export function tourAddress(element) {
  const named = (name) =>
    reachable(() => new URL(importedBy(name).tour), `tours/${name}.txt`, kHome);
  return addressOf(element.tour, named, element, 'tour');
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
      fetchFile(address, undefined, kMostSceneBytes).catch((error) => {
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

function sceneOf(name, read, addressOfFile) {
  return {
    name,
    address: null,
    pictures,
    readText: async () => new TextEncoder().encode(await read()),
    ...filesBy((file, onBytes) => fetchFile(addressOfFile(file), onBytes)),
  };
}

// What the property `source` holds.
function sceneOfPage(source) {
  return {
    name: source.name ?? 'scene',
    address: null,
    async readText() {
      const text = await source.readText();
      return typeof text === 'string' ? new TextEncoder().encode(text) : text;
    },
    ...filesBy((file) => source.readFile(file)),
  };
}

function filesBeside(address) {
  return filesBy((file, onBytes) => fetchFile(new URL(file, finalAddress(address)), onBytes));
}

// A page in place of a shipped file: the folders of the package are not where the element looks for
// them.
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
