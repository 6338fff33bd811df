// The error for a foreign map that cannot be taken at all: it says where, what was found there and
// what was expected. What can be left out is no error; it goes into the list `notTaken`.
//
//     throw new ImportError('town.tmx', 'layer "Walls"', '7 tiles', '64, as its size says');
//     `found ${quoted(value)}`                // a value of a stranger, of bounded length

const kMostQuoted = 60; // characters

export class ImportError extends Error {
  name = 'ImportError';

  constructor(file, place, found, expected) {
    super(`${file}${place === '' ? '' : `, ${place}`}: found ${found}, expected ${expected}`);
    Object.assign(this, { file, place, found, expected });
  }
}

export function quoted(value) {
  if (typeof value === 'number' || typeof value === 'boolean' || value == null)
    return String(value);
  if (typeof value !== 'string') return Array.isArray(value) ? 'a list' : `an ${typeof value}`;
  const isLong = value.length > kMostQuoted;
  return JSON.stringify(isLong ? `${value.slice(0, kMostQuoted)}...` : value);
}
