// Plays scenes and recordings that the visitor dropped or chose.
//
//     await playDropped(caster, address, entries);       // [{path, file}]; throws a Trouble
//
// A scene's pictures are looked up among the files first, then among the page's own. A recording is
// replayed in the scene that it names: the open one if it has that name, else the page's.

import { Trouble } from '../engine/trouble.js';
import { fetchBytes } from '../engine/fetch-bytes.js';
import { kMostFileBytes, kMostSceneBytes, tooLong } from '../engine/limits.js';
import { sceneAddress } from './scene-list.js';

export async function playDropped(caster, address, entries) {
  const scene = entries.find(({ path }) => /\.json$/i.test(path));
  const recording = entries.find(({ path }) => /\.txt$/i.test(path));
  if (scene === undefined && recording === undefined) {
    const found = entries.length === 0 ? 'nothing' : entries.map(({ path }) => path).join(', ');
    throw new Trouble(
      'There is no scene among these files',
      `Found ${found}; expected a .json file with the .png files that it names, or a .txt recording.`,
    );
  }
  const tour = recording === undefined ? null : URL.createObjectURL(recording.file);
  const named = recording === undefined ? null : sceneIn(await recording.file.text());
  const open = (address.reference ?? caster.source?.name ?? '').replace(/^.*\/|\.json$/gi, '');
  address.own(() => {
    if (scene !== undefined) caster.source = sourceOf(scene, entries);
    else if (open !== named) caster.source = null;
    if (scene !== undefined || open !== named) caster.scene = null;
    else if (caster.source === null) caster.scene = caster.address;
    caster.view = null;
    caster.tour = tour;
  });
}

// The scene that a recording names.
function sceneIn(text) {
  return /^scene (.+)$/m.exec(text)?.[1].trim() ?? '';
}

// A source for the element's property of that name.
function sourceOf(scene, entries) {
  const folder = scene.path.split('/').slice(0, -1);
  // The bytes of one of the files, or null.
  const ownFile = async (name) => {
    const path = joinPath(folder, name);
    const baseName = name.split('/').pop();
    const entry =
      entries.find((other) => other.path === path) ??
      entries.find((other) => other.file.name === baseName);
    return entry === undefined ? null : bytesOf(entry.file, kMostFileBytes);
  };
  return {
    name: scene.file.name,
    readText: () =>
      bytesOf(scene.file, kMostSceneBytes).catch((error) => {
        throw new Trouble(
          'The scene cannot be opened',
          `${scene.path}: ${error.message}.`,
          [],
          error.code,
        );
      }),
    ownFile,
    readFile: async (name) =>
      (await ownFile(name)) ?? fetchBytes(new URL(name, sceneAddress('index'))),
  };
}

async function bytesOf(file, most) {
  if (file.size > most) throw tooLong(file.size, most);
  return new Uint8Array(await file.arrayBuffer());
}

// All files of a drop, those in folders included: [{path, file}].
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
  // A reader returns a folder in portions; an empty one marks the end.
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
