// Pictures of the reader's raycaster, and how they differ.

import { drawWith } from '../by-hand.js';

// What a program draws of this moment.
export function drawnBy(draw, { width, height, source, eye, state }, fov = 60) {
  const picture = { width, height, data: new Uint8ClampedArray(4 * width * height) };
  drawWith(draw, { fov })(picture, source.drawnWorld, eye, state);
  return picture.data;
}

// {pixels: how many differ by more than 1, columns: those in which one does, at: 1 for each}.
export function differing(mine, other, width) {
  const at = new Uint8Array(mine.length / 4);
  const columns = new Set();
  let pixels = 0;
  for (let i = 0; i < at.length; ++i) {
    const isOff = [0, 1, 2].some((c) => Math.abs(mine[4 * i + c] - other[4 * i + c]) > 1);
    if (!isOff) continue;
    at[i] = 1;
    pixels += 1;
    columns.add(i % width);
  }
  return { pixels, columns: [...columns].sort((a, b) => a - b), at };
}
