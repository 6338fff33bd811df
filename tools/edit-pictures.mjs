// Writes the list of shipped pictures that the editor offers: WEB/edit/pictures.json.
//
//     node tools/edit-pictures.mjs WEB
//
//     [{group: 'Stone and brick', pictures: [{file: 'textures/brick.png', frames, rate, views,
//       height}]}]
//
// Groups and their order are those of the catalogue; frames and heights are what the shipped scenes
// use most.

import { readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import process from 'node:process';
import { usesInScenes } from './docs/picture-uses.mjs';

const kCatalogue = 'web/docs/catalogue.md';
const kPicture = /\b(textures|see-through|sheets|sprites)\/[\w-]+\.png/g;
const kNotForBlocks = 'Skies';

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/edit-pictures.mjs: found no folder, expected that of the built page');

const uses = usesInScenes(path.join(folder, 'scenes'));
const seen = new Set();
const groups = readFileSync(kCatalogue, 'utf8')
  .split(/^## /m)
  .slice(1)
  .map((part) => ({
    group: part.slice(0, part.indexOf('\n')),
    pictures: [...part.matchAll(kPicture)]
      .map(([file]) => file)
      .filter((file) => !seen.has(file) && seen.add(file)),
  }))
  .filter(({ group, pictures }) => group !== kNotForBlocks && pictures.length > 0)
  .map(({ group, pictures }) => ({ group, pictures: pictures.map(described) }));
writeFileSync(path.join(folder, 'edit', 'pictures.json'), JSON.stringify(groups));

function described(file) {
  const { named = [], heights = [] } = uses.get(file) ?? {};
  const { frames = 1, views = 1, rate } = named[0] ?? {};
  const said = { file, height: heights[heights.length >> 1] };
  if (frames > 1) Object.assign(said, { frames, rate });
  if (views > 1) said.views = views;
  return said;
}
