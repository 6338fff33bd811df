// The sizes of pictures that a page may ask for.

import { kLargestSide } from './stage.js';

// Throws a RangeError for another size; `method` is the page's.
export function checkSize(method, { width, height }) {
  for (const [name, side] of Object.entries({ width, height })) {
    if (!Number.isInteger(side) || side < 1 || side > kLargestSide)
      throw new RangeError(
        `${method}: found ${name} ${side}, expected a whole number from 1 to ${kLargestSide}.`,
      );
  }
  return { width, height };
}
