// The finds that come with the editor: shipped sprites that look as if one would take them along.
// Takes a document; gives changes. Changes nothing itself.
//
//     kFinds                                   // [{name, height, picture}]
//     spriteFor(scene, 'crystal')              // {sprite, changes}: the scene's, or a new one

import { freeName, isSame } from './kinds.js';

const sheet = (name, height) => ({
  name,
  height,
  picture: { file: `../sprites/${name}.png`, frames: 8, rate: 6 },
});

export const kFinds = [
  sheet('crystal', 0.34),
  sheet('lantern', 0.42),
  sheet('shell', 0.42),
  sheet('moonflower', 0.46),
];

export function spriteFor(scene, name) {
  const { picture } = kFinds.find((find) => find.name === name);
  const { sprites = {} } = scene.value;
  const known = Object.keys(sprites).find((other) => isSame(sprites[other], picture));
  if (known !== undefined) return { sprite: known, changes: [] };
  const sprite = freeName(name, sprites);
  return { sprite, changes: [{ path: ['sprites', sprite], value: picture }] };
}
