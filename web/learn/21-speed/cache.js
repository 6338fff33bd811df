// A small model of a processor's first cache, and the orders in which a picture can be written.

export const kLine = 64; // bytes
export const kSets = 64;
export const kWays = 8;
const kPixel = 4; // bytes
const kStrip = 16; // columns

export class Cache {
  sets = Array.from({ length: kSets }, () => []); // lines, the one used longest ago first
  misses = 0;

  // Touches an address; returns {set, line, isHit}.
  touch(address) {
    const line = Math.floor(address / kLine);
    const set = line % kSets;
    const lines = this.sets[set];
    const place = lines.indexOf(line);
    if (place >= 0) lines.splice(place, 1);
    else {
      this.misses += 1;
      if (lines.length === kWays) lines.shift();
    }
    lines.push(line);
    return { set, line, isHit: place >= 0 };
  }
}

// Bytes from one row of the picture to the next.
export function pitchOf(width, isPadded) {
  return kPixel * width + (isPadded ? kLine : 0);
}

// The addresses that are touched, one after another.
export function* addresses({ order, width, height, isPadded }) {
  const pitch = pitchOf(width, isPadded);
  const at = (x, y) => y * pitch + kPixel * x;
  if (order === 'rows') {
    for (let y = 0; y < height; ++y) for (let x = 0; x < width; ++x) yield at(x, y);
  } else if (order === 'columns') {
    for (let x = 0; x < width; ++x) for (let y = 0; y < height; ++y) yield at(x, y);
  } else {
    // A strip of columns behind the picture, an odd number of lines apart.
    const strip = Math.ceil((pitch * height) / 4096) * 4096;
    const column = kLine * (Math.ceil((kPixel * height) / kLine) | 1);
    for (let first = 0; first < width; first += kStrip) {
      const columns = Math.min(kStrip, width - first);
      for (let c = 0; c < columns; ++c)
        for (let y = 0; y < height; ++y) yield strip + c * column + kPixel * y;
      for (let y = 0; y < height; ++y)
        for (let c = 0; c < columns; ++c) {
          yield strip + c * column + kPixel * y;
          yield at(first + c, y);
        }
    }
  }
}

const kept = new Map();

// Misses for each pixel of a whole picture.
export function missesEachPixel(picture) {
  const key = JSON.stringify(picture);
  if (!kept.has(key)) {
    const cache = new Cache();
    for (const address of addresses(picture)) cache.touch(address);
    kept.set(key, cache.misses / (picture.width * picture.height));
  }
  return kept.get(key);
}

// How many different sets the pixels of one column fall into.
export function setsOfColumn(width, isPadded) {
  return kSets / greatestDivisor(kSets, pitchOf(width, isPadded) / kLine);
}

function greatestDivisor(a, b) {
  return b === 0 ? a : greatestDivisor(b, a % b);
}
