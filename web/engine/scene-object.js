// A scene as an object: its text, and where the pictures lie that it names by a URL. So scripts name
// pictures that a bundler puts elsewhere.
//
//     const { text, addresses, addressOf } = readSceneObject({ textures: { brick: new URL('brick.png', import.meta.url) }, ... });
//     addresses                          // all of them, as a text
//     addressOf('brick.png')             // that URL
//     addressOf('../textures/oak.png')   // null: a text names a file beside the scene

import { isFile, nameOf } from './source-parts.js';
import { Trouble } from './trouble.js';

export function readSceneObject(scene) {
  const addresses = new Map(); // name in the text -> URL
  // Two pictures may have one name in two folders.
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
    // A URL becomes a text before it is passed on: the object still has it.
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
      `scene: found what JSON cannot hold: ${error.message}`,
      [],
      'scene',
    );
  }
}
