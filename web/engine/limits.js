// Size limits of files, as in the engine (src/scene/limits.h, src/base/image.cpp). Larger files are
// refused while they download, before they fill the memory.

import { coded } from './trouble.js';

export const kMostSceneBytes = 2 ** 27; // of a scene's text
export const kMostFileBytes = 2 ** 26; // of a picture or a recording

// The error for a file of at least `found` bytes.
export function tooLong(found, most) {
  return coded('fetch', `it has ${found} bytes or more, the limit is ${most}`);
}
