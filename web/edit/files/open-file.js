// Opens files from the visitor's computer as a world: a scene, a zip that was saved here, or a map
// of another program with the files that it names. Takes files; gives {name, text, pictures,
// notTaken, form, scene}: `form` is that of text-form.js, `scene` the file that is a scene itself.
// Throws an Error in plain words; changes nothing.
//
//     const world = await openFiles([...input.files]);

import { strFromU8, Unzip, UnzipInflate } from 'fflate';
import { kMostFileBytes, kMostSceneBytes } from '../../engine/limits.js';
import { printed } from '../json-text.js';
import { textIn } from './text-form.js';

const kMostBytes = 64 << 20; // of all files of a zip together, unpacked
const kMostFiles = 4000; // of a zip
const kMaps = /\.(tmx|tmj|ldtk|csv|txt)$/i;
const kHidden = /(^|\/)(\.|__MACOSX\/)/; // what systems put beside one's files

export async function openFiles(list) {
  const files = new Map();
  const sources = new Map();
  for (const file of list) {
    const name = file.webkitRelativePath || file.name;
    checkSize(name, file.size);
    files.set(name, new Uint8Array(await file.arrayBuffer()));
    sources.set(name, file);
  }
  const [first] = files.keys();
  if (first === undefined) throw new Error('There is no file.');
  if (files.size === 1 && /\.zip$/i.test(first)) return ofScene(unpacked(files.get(first)));
  const map = [...files.keys()].find((name) => kMaps.test(name)) ?? foreignJson(files);
  if (map !== undefined) return ofMap(map, files);
  const world = ofScene(files);
  return { ...world, scene: sources.get(world.file) };
}

function checkSize(name, size) {
  const most = /\.json$/i.test(name) ? kMostSceneBytes : kMostFileBytes;
  if (size > most)
    throw new Error(
      `${name} is too large: found ${megabytes(size)}, expected ${megabytes(most)} at most.`,
    );
}

const megabytes = (bytes) => `${Math.ceil(bytes / 2 ** 20)} MB`;

// A scene has maps and a start; a map of Tiled has layers.
function foreignJson(files) {
  return [...files.keys()].find((name) => {
    if (!/\.json$/i.test(name)) return false;
    try {
      const value = JSON.parse(strFromU8(files.get(name)));
      return value.maps === undefined && (value.layers !== undefined || value.levels !== undefined);
    } catch {
      return false;
    }
  });
}

function ofScene(files) {
  const names = [...files.keys()];
  const file = names.find((one) => /\.json$/i.test(one));
  if (file === undefined)
    throw new Error(
      `Found ${names.slice(0, 3).join(', ') || 'nothing'}, expected a scene (.json), a zip, or a map (.tmx, .tmj, .ldtk).`,
    );
  const { text, form } = textIn(files.get(file));
  checkScene(file, text);
  // The scene names them from its own folder.
  const folder = file.split('/').slice(0, -1);
  const pictures = new Map();
  for (const [name, bytes] of files)
    if (name !== file) pictures.set(relative(name.split('/'), folder), bytes);
  return { name: nameOf(file), text, form, pictures, notTaken: [], file };
}

function relative(steps, folder) {
  let same = 0;
  while (same < folder.length && steps[same] === folder[same]) ++same;
  return [...folder.slice(same).map(() => '..'), ...steps.slice(same)].join('/');
}

function checkScene(file, text) {
  let value = null;
  try {
    value = JSON.parse(text);
  } catch (error) {
    throw new Error(`${file} is no JSON: ${error.message}`, { cause: error });
  }
  if (!Array.isArray(value?.maps) || value.maps.length === 0)
    throw new Error(`${file} has no maps, expected a scene.`);
}

async function ofMap(map, files) {
  const { makeScene, readForeign } = await import('../import.js');
  const proposal = await readForeign({
    name: map,
    bytes: files.get(map),
    // Files are chosen without their folders.
    async readFile(name) {
      const bytes = files.get(name) ?? files.get(name.split('/').at(-1));
      if (bytes === undefined) throw new Error(`"${name}" was not chosen together with the map.`);
      return bytes;
    },
  });
  const { scene, pictures, notTaken } = await makeScene(proposal);
  return { name: nameOf(map), text: `${printed(scene, '')}\n`, pictures, notTaken };
}

const nameOf = (file) =>
  file
    .split('/')
    .at(-1)
    .replace(/\.\w+$/, '');

function unpacked(bytes) {
  const files = new Map();
  let size = 0;
  let count = 0;
  const unzip = new Unzip((file) => {
    count += 1;
    if (count > kMostFiles)
      throw new Error(
        `The zip has more than ${kMostFiles} files, expected a scene and its pictures.`,
      );
    checkName(file.name);
    const isWanted = !file.name.endsWith('/') && !kHidden.test(file.name);
    const parts = [];
    file.ondata = (error, part, isLast) => {
      if (error) throw new Error(`The zip is damaged: ${error.message}.`);
      size += part.length;
      if (size > kMostBytes)
        throw new Error('The zip is too large: found more than 64 MB, expected less.');
      parts.push(part);
      if (isLast && isWanted) files.set(file.name, joined(parts));
    };
    file.start();
  });
  unzip.register(UnzipInflate);
  const step = 1 << 12; // so that it stops soon after the limit
  for (let at = 0; at < bytes.length; at += step)
    unzip.push(bytes.subarray(at, at + step), at + step >= bytes.length);
  return files;
}

// Such names lead out of the folder that a zip is unpacked into.
function checkName(name) {
  const steps = name.split('/');
  if (/[\\\0]|^[a-z]:/i.test(name) || steps[0] === '' || steps.includes('..'))
    throw new Error(`The zip names a file "${name}", expected one in its own folder.`);
}

function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
