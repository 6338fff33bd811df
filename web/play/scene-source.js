// Where a scene and its pictures come from: an address, or files that somebody dropped on the page.

import { fetchBytes, finalAddress } from '../engine/fetch-bytes.js';
import { filesBy, nameOf } from '../engine/source-parts.js';
import { Trouble } from '../engine/trouble.js';

const kScenes = new URL('scenes/', document.baseURI);

// The list of the scenes that come with the page: [{file, title, about, tour}], the opening scene
// first; `tour` is true where a recorded tour has the scene's name.
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
// relative to the page.
export function sceneAddress(reference) {
  const file = /\.json$/i.test(reference) ? reference : `${reference}.json`;
  return new URL(file, file.includes('/') ? document.baseURI : kScenes);
}

export function sceneAt(reference) {
  const address = sceneAddress(reference);
  return {
    name: nameOf(address),
    async readText() {
      return fetchBytes(address).catch((error) => {
        throw new Trouble(
          'The scene could not be loaded',
          `${address.href}: ${error.message}.`,
          [],
          error.code,
        );
      });
    },
    ...filesBy((name, onBytes) => fetchBytes(new URL(name, finalAddress(address)), onBytes)),
  };
}

// Files as they were dropped or chosen, each {path, file}. A picture that is not among them is
// looked for among the page's own.
export function sceneAmong(entries) {
  const scene = entries.find((entry) => /\.json$/i.test(entry.path));
  if (scene === undefined) {
    const found = entries.length === 0 ? 'nothing' : entries.map((entry) => entry.path).join(', ');
    throw new Trouble(
      'There is no scene among these files',
      `Found ${found}; expected a .json file, and beside it the .png files that it names.`,
    );
  }
  const folder = scene.path.split('/').slice(0, -1);
  return {
    name: scene.file.name,
    readText: async () => new Uint8Array(await scene.file.arrayBuffer()),
    ...filesBy(async (name, onBytes) => {
      const path = joinPath(folder, name);
      const baseName = name.split('/').pop();
      const entry =
        entries.find((other) => other.path === path) ??
        entries.find((other) => other.file.name === baseName);
      return entry === undefined
        ? fetchBytes(new URL(name, kScenes), onBytes)
        : new Uint8Array(await entry.file.arrayBuffer());
    }),
  };
}

// What a drop holds, folders included: [{path, file}].
export async function droppedEntries(dataTransfer) {
  const entries = [...dataTransfer.items]
    .map((item) => item.webkitGetAsEntry?.())
    .filter((entry) => entry);
  if (entries.length === 0) return chosenEntries(dataTransfer.files);
  return (await Promise.all(entries.map(filesOf))).flat();
}

export function chosenEntries(files) {
  return [...files].map((file) => ({ path: file.name, file }));
}

async function filesOf(entry) {
  if (entry.isFile) {
    const file = await new Promise((resolve, reject) => entry.file(resolve, reject));
    return [{ path: entry.fullPath.replace(/^\//, ''), file }];
  }
  const reader = entry.createReader();
  const found = [];
  // A reader hands out a folder in portions, and an empty one at the end.
  for (;;) {
    const portion = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (portion.length === 0) break;
    found.push(...portion);
  }
  return (await Promise.all(found.map(filesOf))).flat();
}

function joinPath(folder, name) {
  const steps = [...folder];
  for (const step of name.split('/')) {
    if (step === '..') steps.pop();
    else if (step !== '.') steps.push(step);
  }
  return steps.join('/');
}
