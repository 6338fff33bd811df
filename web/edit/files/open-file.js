// Opens files from the visitor's computer as a world: a scene, a zip that was saved here, or a map
// of another program with the files that it names. Takes files; gives {name, text, pictures} of a
// scene, or {name, proposal, reread} of such a map, for import-dialog.js. Throws an Error in plain
// words; changes nothing.
//
//     const world = await openFiles(input.files);

import { strFromU8, Unzip, UnzipInflate } from 'fflate';

const kMostBytes = 64 << 20; // of all files of a zip together, unpacked
const kMaps = /\.(tmx|tmj|ldtk)$/i;
// Of programs and courses, which hold a matrix or rows
const kTexts =
  /\.(txt|csv|map|cub|dat|c|h|cc|cpp|cs|go|java|js|kt|lua|mjs|py|rb|rs|swift|ts|zig)$/i;

export async function openFiles(list) {
  const files = await filesOf(list);
  const [first] = files.keys();
  if (first === undefined) throw new Error('There is no file.');
  const isZip = files.size === 1 && /\.zip$/i.test(first);
  return ofFiles(isZip ? unpacked(files.get(first)) : files);
}

async function filesOf(list) {
  const files = new Map();
  for (const file of list)
    files.set(file.webkitRelativePath || file.name, new Uint8Array(await file.arrayBuffer()));
  return files;
}

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
  const name = names.find((one) => /\.json$/i.test(one));
  if (name === undefined)
    throw new Error(
      `Found ${names.slice(0, 3).join(', ')}, expected a scene (.json), a zip, or a map (.tmx, .tmj, .ldtk).`,
    );
  const text = strFromU8(files.get(name));
  files.delete(name);
  return { name: nameOf(name), text, pictures: files };
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
        throw new Error(`"${name}" was not chosen together with the map.`);
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
  const unzip = new Unzip((file) => {
    const parts = [];
    file.ondata = (error, part, isLast) => {
      if (error) throw new Error(`The zip is damaged: ${error.message}.`);
      size += part.length;
      if (size > kMostBytes)
        throw new Error('The zip is too large: found more than 64 MB, expected less.');
      parts.push(part);
      if (isLast) files.set(file.name, joined(parts));
    };
    file.start();
  });
  unzip.register(UnzipInflate);
  const step = 1 << 16; // so that it stops soon after the limit
  for (let at = 0; at < bytes.length; at += step)
    unzip.push(bytes.subarray(at, at + step), at + step >= bytes.length);
  return files;
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
