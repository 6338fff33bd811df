// Hands a scene that was dropped onto the play page over to the editor. The play page loads this
// script when somebody wants to edit such a scene.
// Takes the element's source (play/dropped-scene.js); gives the query that opens the scene.
//
//     location.assign(`edit.html${await handOver(caster.source)}`);

import { picturesOf } from './files/html-file.js';
import { textIn } from './files/text-form.js';
import { keepOpened } from './files/world-store.js';

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
