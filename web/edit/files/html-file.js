// One HTML file that plays a world from a disk: without a server, and without a request.
// Takes the player's file (tools/player-page.mjs makes it), a scene's text and its pictures; gives
// the bytes of the file. Throws an Error in plain words. Works in pages and under Node; `deflate`
// packs without a frame.
//
//     const bytes = await htmlFile({ player, text, readPicture: async (file) => bytes, deflate });
//     picturesOf(scene)              // the files that a scene names
//     wordsIn(scene)                 // a Set: a picture whose name is not among them is not used
//
// All that others have written, names and texts, is packed into letters that mean nothing to HTML;
// only the title stands there as it is, escaped.

import { denseText, utf16 } from './dense-text.js';
import { escaped } from './share-texts.js';
import { declared } from './shipped.js';

export async function htmlFile({ player, text, readPicture, deflate }) {
  const own = readScene(text);
  const words = wordsIn(own);
  const scene = declared(own, (name) => words.has(name));
  leaveOutUnused(scene);
  const title = String(scene.title || 'A world');
  const pictures = [];
  for (const file of picturesOf(scene)) {
    const bytes = await readPicture(file);
    if (bytes === null) throw new Error(`The picture "${file}" is not there.`);
    pictures.push([file, bytes]);
  }
  const head = JSON.stringify({
    title,
    text: JSON.stringify(scene),
    pictures: pictures.map(([file, { length }]) => [file, length]),
  });
  // Each part of the page has a zero before it.
  const world = joined([
    new TextEncoder().encode(`\0${head}\0`),
    ...pictures.map(([, bytes]) => bytes),
  ]);
  // The title last: it stands before the world, so nothing that others have written is a place.
  const page = [
    ['{{world}}', denseText(deflate(world))],
    ['{{title}}', escaped(title)],
  ].reduce(filledIn, new TextDecoder('utf-16le').decode(player));
  return utf16(page);
}

// At the first such place.
function filledIn(page, [mark, text]) {
  const at = page.indexOf(mark);
  if (at < 0) throw new Error(`The player lacks ${mark}: it is of another release.`);
  return page.slice(0, at) + text + page.slice(at + mark.length);
}

function readScene(text) {
  let scene = null;
  try {
    scene = JSON.parse(text);
  } catch (error) {
    throw new Error(`The scene is no JSON: ${error.message}`, { cause: error });
  }
  if (!Array.isArray(scene?.maps)) throw new Error('Found no maps, expected a scene.');
  return scene;
}

const fileOf = (picture) => (typeof picture === 'string' ? picture : picture?.file);

export function picturesOf({ textures = {}, sprites = {}, maps = [] }) {
  const named = [
    ...Object.values(textures).map(fileOf),
    ...Object.values(sprites).map(fileOf),
    ...maps.map((map) => map?.sky?.panorama),
  ];
  const files = named.filter((file) => typeof file === 'string' && !file.startsWith('#'));
  return [...new Set(files)];
}

// Textures and sprites whose name stands nowhere else in the scene.
function leaveOutUnused(scene) {
  const words = wordsIn(scene);
  for (const table of [scene.textures, scene.sprites])
    for (const name of Object.keys(table ?? {})) if (!words.has(name)) delete table[name];
}

// All texts and keys of a scene but the names of its pictures.
export function wordsIn({ textures, sprites, ...rest }) {
  const words = new Set();
  const take = (value) => {
    if (typeof value === 'string') words.add(value);
    else if (typeof value === 'object' && value !== null)
      for (const [key, member] of Object.entries(value)) {
        words.add(key);
        take(member);
      }
  };
  take(rest);
  for (const picture of [...Object.values(textures ?? {}), ...Object.values(sprites ?? {})])
    if (typeof picture === 'object') take(picture);
  return words;
}

function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
