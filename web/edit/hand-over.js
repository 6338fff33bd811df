// Between the play page and the editor. The play page loads this script when somebody opens a world
// from a link, or wants to edit a scene that was dropped onto it.
//
//     caster.source = linkedWorld('#world=...');       // throws an Error in plain words
//     location.assign(`edit.html${await handOver(caster.source)}`);      // dropped-scene.js

import { picturesOf } from './files/html-file.js';
import { textIn } from './files/text-form.js';
import { textOf } from './files/world-link.js';
import { keepOpened } from './files/world-store.js';
import { readPicture } from './open-world.js';

// Its pictures are shipped ones, and no others.
export function linkedWorld(link) {
  const text = textOf(link);
  return {
    name: 'world-from-a-link',
    link,
    readText: () => text,
    readFile: (file) => readPicture(new Map(), file),
  };
}

export async function handOver(source) {
  const { text, form } = textIn(await source.readText());
  const pictures = new Map();
  for (const file of picturesOf(JSON.parse(text))) {
    const bytes = await source.ownFile(file);
    if (bytes !== null) pictures.set(file, bytes);
  }
  const name = source.name.replace(/\.json$/i, '');
  return keepOpened(name, { text, pictures, base: { form, isSaved: false } });
}
