// Draws the pictures of the menu of scenes into a built page: each scene of its list from the start.
//
//     node tools/scene-posters.mjs FOLDER        // FOLDER/scenes/posters/NAME.png

import { encode } from 'fast-png';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';

const kSize = { width: 480, height: 270 }; // pixels, as large as a card of the menu

const [given] = process.argv.slice(2);
if (given === undefined)
  throw new Error('tools/scene-posters.mjs: found no folder, expected that of a built page');
const folder = path.resolve(given);
const { load } = await import(pathToFileURL(path.join(folder, 'node/index.js')));
const posters = path.join(folder, 'scenes/posters');
await mkdir(posters, { recursive: true });
for (const { file } of JSON.parse(await readFile(path.join(folder, 'scenes/index.json'), 'utf8'))) {
  const scene = await load(path.join(folder, 'scenes', file));
  const png = encode({ ...scene.pixels(kSize), channels: 4, depth: 8 });
  await writeFile(path.join(posters, file.replace(/\.json$/, '.png')), png);
  scene.free();
}
