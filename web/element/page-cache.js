// Shared by all elements of a page: the engine is fetched and compiled once, each file is fetched
// once, each picture is decoded once, and the same scene is loaded once.
//
//     const release = holdCache();                            // while an element is in the page
//     const files = await sharedEngineFiles('auto', onBytes); // for Engine.create({files, canvas})
//     const bytes = await fetchOnce(address, onBytes);        // shared: do not write to them
//     const pixels = pictures.get(bytes);                     // if another engine has decoded them
//     pictures.keep(bytes, pixels);                           // copies them if they may be needed
//     nowPlays(engine, key);                                  // other engines can adopt its scene
//     release();
//     forgetFiles();                                          // before trying again
//     const settled = await roomForEngine();                  // before an engine is made
//     settled(engine);                                        // it has its first picture; or null
//     nowWakes(engine);                                       // an engine that has rested
//     nowStops(engine);
//
// Failures are not cached. Files are kept while anybody holds the cache, pixels only until all
// holders play; the compiled engine stays until the page is closed.

import { browserHasWebAssembly, chooseBuild } from '../engine/builds.js';
import { fetchEngine } from '../engine/engine-files.js';
import { askAnew, fetchBytes } from '../engine/fetch-bytes.js';

const kMostPixels = 16 << 20; // bytes; more than all shipped pictures together
// Browsers reserve addresses for each engine, Chromium 10 GB, and have few on phones. Beyond so
// many, those that play least recently rest, if they are paused.
const kMostAwake = 32;

const engines = new Map();
const files = new Map();
const pixelsOf = new Map(); // a file's bytes -> its picture's pixels
let pixelBytes = 0;
let holders = 0;

// The playing engines with their keys: build, scene and tour.
export const players = new Map();

export function nowPlays(engine, key) {
  players.set(engine, key);
  dropPixels();
}

// Decoded pictures for elements whose scenes have not loaded yet. A single element keeps none.
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

const awake = new Set(); // engines with a picture, that which woke first at the front
let loads = 0; // of new engines
const waiting = []; // functions that let a load try again

function hasRoom() {
  for (const engine of awake) {
    if (awake.size + loads < kMostAwake) break;
    if (engine.rest()) awake.delete(engine);
  }
  return awake.size + loads < kMostAwake;
}

// Waits for others to get their pictures if only then they can rest. More are allowed to play.
export async function roomForEngine() {
  while (!hasRoom() && loads > 0) await new Promise((resolve) => waiting.push(resolve));
  loads += 1;
  return (engine) => {
    loads -= 1;
    if (engine !== null) awake.add(engine);
    for (const tryAgain of waiting.splice(0)) tryAgain();
  };
}

export function nowWakes(engine) {
  hasRoom();
  awake.add(engine);
}

export function nowStops(engine) {
  players.delete(engine);
  awake.delete(engine);
}

// fetchEngine(), once per page and build.
export function sharedEngineFiles(kind = 'auto', onBytes = () => {}) {
  const build = browserHasWebAssembly() ? chooseBuild(kind) : kind;
  return share(engines, build, (report) => fetchEngine({ kind: build, onBytes: report }), onBytes);
}

// fetchBytes(), once per address.
export function fetchOnce(address, onBytes = () => {}, most) {
  const { href } = new URL(address);
  const bytes = share(files, href, (report) => fetchBytes(href, report, most), onBytes);
  const drop = () => holders === 0 && files.delete(href);
  bytes.then(drop, drop);
  return bytes;
}

// Trying again after an error needs the files as they are now, and no scene made of older ones.
export function forgetFiles() {
  askAnew();
  files.clear();
  players.clear();
}

// Keeps fetched files until the returned function is called.
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

// One load for all callers; a late caller gets the current progress at once.
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
  // Listeners would keep removed elements in memory.
  const forgetListeners = () => {
    entry.listeners = null;
  };
  entry.promise.then(forgetListeners, () => {
    forgetListeners();
    if (entries.get(key) === entry) entries.delete(key);
  });
  return entry;
}
