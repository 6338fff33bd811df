// What a picture file is, by its first bytes, before anything decodes it.
// Takes bytes; gives {type, width, height}. Throws an Error in plain words.
//
//     pictureSizeOf(bytes)       // {type: 'PNG', width: 64, height: 64}

const kMostSide = 16384; // pixels
const kMostPixels = 64 << 20; // that a browser decodes for us

export function pictureSizeOf(bytes) {
  const found = readers
    .map((read) => read(bytes, new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)))
    .find((one) => one !== null);
  if (found === undefined)
    throw new Error(`Found ${kindOf(bytes)}, expected a PNG, JPEG, WebP or GIF.`);
  const { width, height } = found;
  if (!(width > 0 && height > 0)) throw new Error('The picture is damaged: it has no size.');
  if (width > kMostSide || height > kMostSide || width * height > kMostPixels)
    throw new Error(
      `Found ${width} × ${height} pixels, expected at most ${kMostPixels >> 20} million.`,
    );
  return found;
}

const startsWith = (bytes, ...codes) => codes.every((code, at) => bytes[at] === code);
const wordAt = (bytes, at) => String.fromCharCode(...bytes.subarray(at, at + 4));

const readers = [
  (bytes, view) =>
    startsWith(bytes, 0x89, 0x50, 0x4e, 0x47) && bytes.length >= 24
      ? { type: 'PNG', width: view.getUint32(16), height: view.getUint32(20) }
      : null,
  (bytes, view) =>
    startsWith(bytes, 0x47, 0x49, 0x46, 0x38) && bytes.length >= 10
      ? { type: 'GIF', width: view.getUint16(6, true), height: view.getUint16(8, true) }
      : null,
  readJpeg,
  readWebp,
];

function readJpeg(bytes, view) {
  if (!startsWith(bytes, 0xff, 0xd8, 0xff)) return null;
  for (let at = 2; at + 9 < bytes.length;) {
    const mark = bytes[at + 1];
    if (bytes[at] !== 0xff) break;
    const isFrame = mark >= 0xc0 && mark <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(mark);
    if (isFrame)
      return { type: 'JPEG', width: view.getUint16(at + 7), height: view.getUint16(at + 5) };
    at += mark === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
  return { type: 'JPEG', width: 0, height: 0 };
}

function readWebp(bytes, view) {
  if (wordAt(bytes, 0) !== 'RIFF' || wordAt(bytes, 8) !== 'WEBP' || bytes.length < 30) return null;
  const type = 'WebP';
  const three = (at) => bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16);
  switch (wordAt(bytes, 12)) {
    case 'VP8X':
      return { type, width: three(24) + 1, height: three(27) + 1 };
    case 'VP8L': {
      const sides = view.getUint32(21, true);
      return { type, width: (sides & 16383) + 1, height: ((sides >> 14) & 16383) + 1 };
    }
    default:
      return {
        type,
        width: view.getUint16(26, true) & 16383,
        height: view.getUint16(28, true) & 16383,
      };
  }
}

function kindOf(bytes) {
  const text = new TextDecoder().decode(bytes.subarray(0, 400));
  return /<svg|<\?xml/i.test(text) ? 'an SVG, which may hold scripts,' : 'another kind of file';
}
