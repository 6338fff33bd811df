// How much is read, as in the engine (src/scene/limits.h, src/base/image.cpp): more than that is
// refused while it comes, before it fills the memory.

import { coded } from './trouble.js';

export const kMostSceneBytes = 2 ** 27; // of a scene's text
export const kMostFileBytes = 2 ** 26; // of a picture or a recording

// What a file is refused with that has `found` bytes or more.
export function tooLong(found, most) {
  return coded('fetch', `it has ${found} bytes or more, at most ${most} are read`);
}
