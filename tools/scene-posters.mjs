// Draws the pictures of the menu of scenes into a built page, each scene of the list from its
// start, and adds them to the list.
//
//     node tools/scene-posters.mjs FOLDER
//       // FOLDER/scenes/posters/NAME.png, and "poster" in FOLDER/scenes/index.json

import { encode } from 'fast-png';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';

const kSize = { width: 480, height: 270 }; // pixels of a card of the menu

const [argument] = process.argv.slice(2);
if (argument === undefined)
  throw new Error('tools/scene-posters.mjs: found no folder, expected that of a built page');
const folder = path.resolve(argument);
const { load } = await import(pathToFileURL(path.join(folder, 'node/index.js')));
const posters = path.join(folder, 'scenes/posters');
await mkdir(posters, { recursive: true });
const index = path.join(folder, 'scenes/index.json');
const list = JSON.parse(await readFile(index, 'utf8'));
for (const entry of list) {
  let scene;
  try {
    scene = await load(path.join(folder, 'scenes', entry.file));
  } catch (error) {
    console.error(`${error.message}\nThe menu has no picture of ${entry.file}.`);
    continue;
  }
  const png = encode({ ...scene.pixels(kSize), channels: 4, depth: 8 });
  const name = entry.file.replace(/\.json$/, '.png');
  await writeFile(path.join(posters, name), png);
  entry.poster = `posters/${name}`;
  scene.free();
}
await writeFile(index, JSON.stringify(list));
