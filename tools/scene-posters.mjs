// Draws the pictures of the menu of scenes into a built page, each scene of the list from its
// start, and adds them to the list; and those of the worlds that one can begin with in the editor.
//
//     node tools/scene-posters.mjs FOLDER
//       // FOLDER/scenes/posters/NAME.png, and "poster" in FOLDER/scenes/index.json
//       // FOLDER/edit/templates/NAME.png

import { encode } from 'fast-png';
import { mkdir, readFile, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';
import { templates } from '../web/edit/files/templates.js';

const kSize = { width: 480, height: 270 }; // pixels of a card of the menu
const kTemplate = { width: 320, height: 200 };

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
  const name = entry.file.replace(/\.json$/, '.png');
  await draw(scene, kSize, path.join(posters, name));
  entry.poster = `posters/${name}`;
}
await writeFile(index, JSON.stringify(list));

const pictures = path.join(folder, 'edit/templates');
await mkdir(pictures, { recursive: true });
for (const template of templates) {
  const scene = await load(template.scene());
  if (template.view !== undefined) scene.look({ ...template.view, flying: true });
  await draw(scene, kTemplate, path.join(pictures, `${template.name}.png`));
}

async function draw(scene, size, file) {
  await writeFile(file, encode({ ...scene.pixels(size), channels: 4, depth: 8 }));
  scene.free();
}
