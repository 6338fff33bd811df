// Turns a scene object into text. Pictures in it may be URL objects, so that scripts can name files
// that a bundler moves.
//
//     const { text, addresses, addressOf } = readSceneObject({
//       textures: { brick: new URL('brick.png', import.meta.url) }, ... });
//     addresses                          // all URLs, as one text
//     addressOf('brick.png')             // that URL
//     addressOf('../textures/oak.png')   // null: the scene names this file by a text

import { isFile, nameOf } from './source-parts.js';
import { Trouble } from './trouble.js';

export function readSceneObject(scene) {
  const addresses = new Map(); // name in the text -> URL
  // Pictures from two folders may have the same name.
  const nameFor = (address) => {
    const name = isFile(address) ? nameOf(address) : 'picture.png'; // data: and blob: have none
    for (let count = 1; ; ++count) {
      const one = count === 1 ? name : `${count}/${name}`;
      if ((addresses.get(one) ?? address).href !== address.href) continue;
      addresses.set(one, address);
      return one;
    }
  };
  try {
    // JSON.stringify passes URLs as text; `this` still holds the URL object.
    const text = JSON.stringify(
      scene,
      function (key, value) {
        return this[key] instanceof URL ? nameFor(this[key]) : value;
      },
      2,
    );
    return {
      text,
      addresses: [...addresses.values()].join(' '),
      addressOf: (name) => addresses.get(name) ?? null,
    };
  } catch (error) {
    throw new Trouble(
      'The scene cannot be read',
      `scene: not possible as JSON: ${error.message}`,
      [],
      'scene',
    );
  }
}
