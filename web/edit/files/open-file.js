// Opens files from the visitor's computer as a world: a scene, a zip that was saved here, or a map
// of another program with the files that it names. Takes files; gives {name, text, pictures,
// notTaken}. Throws an Error in plain words; changes nothing.
//
//     const world = await openFiles(input.files);

import { strFromU8, Unzip, UnzipInflate } from 'fflate';
import { printed } from '../json-text.js';

const kMostBytes = 64 << 20; // of all files of a zip together, unpacked
const kMaps = /\.(tmx|tmj|ldtk|csv|txt)$/i;

export async function openFiles(list) {
  const files = new Map();
  for (const file of list)
    files.set(file.webkitRelativePath || file.name, new Uint8Array(await file.arrayBuffer()));
  const [first] = files.keys();
  if (first === undefined) throw new Error('There is no file.');
  if (files.size === 1 && /\.zip$/i.test(first)) return ofScene(unpacked(files.get(first)));
  const map = [...files.keys()].find((name) => kMaps.test(name)) ?? foreignJson(files);
  return map === undefined ? ofScene(files) : ofMap(map, files);
}

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
  const name = names.find((one) => /\.json$/i.test(one));
  if (name === undefined)
    throw new Error(
      `Found ${names.slice(0, 3).join(', ')}, expected a scene (.json), a zip, or a map (.tmx, .tmj, .ldtk).`,
    );
  const text = strFromU8(files.get(name));
  files.delete(name);
  return { name: nameOf(name), text, pictures: files, notTaken: [] };
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
