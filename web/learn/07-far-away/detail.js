// The level of detail of a texture at a depth, with the last one that it has.

export function levelAt(depth, size, distance, last) {
  let level = 0;
  while ((depth * size) / distance > 2 ** level && level < last) ++level;
  return level;
}
