// Passes bytes and texts to the engine's functions in memory that is freed afterwards.

import { Trouble } from './trouble.js';

export function withBytes(module, bytes, use) {
  const at = module._malloc(Math.max(1, bytes.length));
  if (at === 0) throw new Trouble('The scene is too large', 'There is not enough memory for it.');
  try {
    module.HEAPU8.set(bytes, at);
    return use(at);
  } finally {
    module._free(at);
  }
}

// Replaces zero characters, which would end the string early.
export function withStrings(module, strings, use) {
  const places = strings.map((string) => {
    const bytes = new TextEncoder().encode(`${String(string).replaceAll('\0', '\uFFFD')}\0`);
    const at = module._malloc(bytes.length);
    module.HEAPU8.set(bytes, at);
    return at;
  });
  try {
    return use(...places);
  } finally {
    for (const at of places) module._free(at);
  }
}
