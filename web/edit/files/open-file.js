// Opens files from the visitor's computer as a world: a scene, a zip that was saved here, or a map
// of another program with the files that it names. Takes files; gives {name, text, pictures, form,
// scene} of a scene: `form` is that of text-form.js, `scene` the file itself, if it is one; or
// {name, proposal, reread} of such a map, for import-dialog.js. Throws an Error in plain words;
// changes nothing.
//
//     const world = await openFiles([...input.files]);

import { strFromU8, Unzip, UnzipInflate } from 'fflate';
import { kMostFileBytes, kMostSceneBytes } from '../../engine/limits.js';
import { textIn } from './text-form.js';

const kMostBytes = 64 << 20; // of all files of a zip together, unpacked
const kMostFiles = 4000; // of a zip
const kMaps = /\.(tmx|tmj|ldtk)$/i;
// Of programs and courses, which hold a matrix or rows
const kTexts =
  /\.(txt|csv|map|cub|dat|c|h|cc|cpp|cs|go|java|js|kt|lua|mjs|py|rb|rs|swift|ts|zig)$/i;
const kHidden = /(^|\/)(\.|__MACOSX\/)/; // what systems put beside one's files

export async function openFiles(list) {
  const files = await filesOf(list);
  const [first] = files.keys();
  if (first === undefined) throw new Error('There is no file.');
  if (files.size === 1 && /\.zip$/i.test(first)) return ofFiles(unpacked(files.get(first)));
  const world = await ofFiles(files);
  const scene = [...list].find((file) => nameIn(file) === world.file);
  return { ...world, scene };
}

const nameIn = (file) => file.webkitRelativePath || file.name;

async function filesOf(list) {
  const files = new Map();
  for (const file of list) {
    checkSize(nameIn(file), file.size);
    files.set(nameIn(file), new Uint8Array(await file.arrayBuffer()));
  }
  return files;
}

function checkSize(name, size) {
  const most = /\.json$/i.test(name) ? kMostSceneBytes : kMostFileBytes;
  if (size > most)
    throw new Error(
      `${name} is too large: found ${megabytes(size)}, expected ${megabytes(most)} at most.`,
    );
}

const megabytes = (bytes) => `${Math.ceil(bytes / 2 ** 20)} MB`;

function ofFiles(files) {
  const names = [...files.keys()];
  const map =
    names.find((name) => kMaps.test(name)) ??
    names.find((name) => isForeignJson(name, files)) ??
    (names.some((name) => /\.json$/i.test(name))
      ? undefined
      : names.find((name) => kTexts.test(name)));
  return map === undefined ? ofScene(files) : ofMap(map, files);
}

// A scene has maps and a start; a map of Tiled has layers, and a matrix is a list.
function isForeignJson(name, files) {
  if (!/\.json$/i.test(name)) return false;
  try {
    const value = JSON.parse(strFromU8(files.get(name)));
    const isMap = value.layers !== undefined || value.levels !== undefined;
    return Array.isArray(value) || (value.maps === undefined && isMap);
  } catch {
    return false;
  }
}

// A text that somebody has copied: a scene, or what a map is read from.
export function openText(text) {
  const isScene = /^\s*\{/.test(text) && /"maps"\s*:/.test(text);
  const name = isScene ? 'pasted world.json' : 'pasted map.txt';
  return openFiles([new File([text], name)]);
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
  return { name: nameOf(file), text, form, pictures, file };
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
  const { readForeign } = await import('../import.js');
  let isMissing = false;
  const read = () =>
    readForeign({
      name: map,
      bytes: files.get(map),
      // Files are chosen without their folders.
      async readFile(name) {
        const last = name.split('/').at(-1);
        const found = files.get(name) ?? files.get(last) ?? files.get(ending(`/${last}`, files));
        if (found !== undefined) return found;
        isMissing = true;
        throw new Error('it was not chosen together with the map');
      },
    });
  const reread = async (list) => {
    for (const [name, bytes] of await filesOf(list)) files.set(name, bytes);
    return read();
  };
  try {
    return { name: nameOf(map), proposal: await read(), reread };
  } catch (error) {
    if (isMissing) error.missing = { name: nameOf(map), reread };
    throw error;
  }
}

const ending = (end, files) => [...files.keys()].find((name) => name.endsWith(end));

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
