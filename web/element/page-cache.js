// What all elements of a page share: the engine is fetched and compiled once, each file that scenes
// name is fetched once, its picture is decoded once, and a scene that one of them plays is loaded
// once.
//
//     const release = holdCache();                                    // while an element is in the page
//     const files = await sharedEngineFiles('auto', onBytes);         // for Engine.create({files, canvas})
//     const bytes = await fetchOnce(address, onBytes);                // the same bytes for everybody: not to be written to
//     const pixels = pictures.get(bytes);                             // of a file's picture, if another engine has decoded it
//     pictures.keep(bytes, pixels);                                   // copies them, if anybody may want them
//     nowPlays(engine, key);                                          // a further engine of that key can adopt its scene
//     release();
//     forgetFiles();                                                  // before another try
//
// What has failed is forgotten, so that another try asks again. Files are kept while anybody holds
// the cache, pixels only until all of these play; the compiled engine stays with the page.

import { browserHasWebAssembly, chooseBuild } from '../engine/builds.js';
import { fetchEngine } from '../engine/engine-files.js';
import { askAnew, fetchBytes } from '../engine/fetch-bytes.js';

const kMostPixels = 16 << 20; // bytes: more than all shipped pictures have

const engines = new Map();
const files = new Map();
const pixelsOf = new Map(); // a file's bytes -> its picture's pixels
let pixelBytes = 0;
let holders = 0;

// The engines that play, with all that was asked of each: build, scene and tour. Who stops one
// takes it out.
export const players = new Map();

export function nowPlays(engine, key) {
  players.set(engine, key);
  dropPixels();
}

// What engines have decoded, for other elements whose scenes are still to come. An element alone
// keeps nothing.
export const pictures = {
  get: (bytes) => pixelsOf.get(bytes),
  keep(bytes, pixels) {
    if (holders - players.size < 2 || pixelBytes + pixels.length > kMostPixels) return;
    pixelBytes += pixels.length;
    pixelsOf.set(bytes, pixels.slice());
  },
};

function dropPixels() {
  if (players.size < holders) return;
  pixelsOf.clear();
  pixelBytes = 0;
}

// What fetchEngine gives, once per page and build.
export function sharedEngineFiles(kind = 'auto', onBytes = () => {}) {
  const build = browserHasWebAssembly() ? chooseBuild(kind) : kind;
  return share(engines, build, (report) => fetchEngine({ kind: build, onBytes: report }), onBytes);
}

// The bytes behind an address. Throws what fetchBytes throws.
export function fetchOnce(address, onBytes = () => {}, most) {
  const { href } = new URL(address);
  const bytes = share(files, href, (report) => fetchBytes(href, report, most), onBytes);
  const drop = () => holders === 0 && files.delete(href);
  bytes.then(drop, drop);
  return bytes;
}

// Whoever tries again after a fault wants the files as they are now, and no scene that was made of
// them before.
export function forgetFiles() {
  askAnew();
  files.clear();
  players.clear();
}

// Keeps what is fetched until the function that it gives is called.
export function holdCache() {
  holders += 1;
  let isHeld = true;
  return () => {
    if (!isHeld) return;
    isHeld = false;
    holders -= 1;
    if (holders === 0) files.clear();
    dropPixels();
  };
}

// One load for all who ask; who comes late hears at once how far it has come.
function share(entries, key, load, onBytes) {
  const entry = entries.get(key) ?? begin(entries, key, load);
  if (entry.progress !== null) onBytes(...entry.progress);
  entry.listeners?.add(onBytes);
  return entry.promise;
}

function begin(entries, key, load) {
  const entry = { listeners: new Set(), progress: null, promise: null };
  entries.set(key, entry);
  entry.promise = load((...progress) => {
    entry.progress = progress;
    for (const tell of entry.listeners) tell(...progress);
  });
  // A listener belongs to an element, which must not live as long as the page.
  const forgetListeners = () => {
    entry.listeners = null;
  };
  entry.promise.then(forgetListeners, () => {
    forgetListeners();
    if (entries.get(key) === entry) entries.delete(key);
  });
  return entry;
}
