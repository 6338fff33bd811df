// What the first bytes of a PNG file say about its picture.

const kSignature = '89504e470d0a1a0a';
const kColourTypesWithAlpha = [4, 6];

// {width, height, hasAlpha}; throws if the bytes are not those of a PNG file.
export function readPngHeader(bytes, name) {
  const isPng =
    bytes.toString('hex', 0, 8) === kSignature && bytes.toString('latin1', 12, 16) === 'IHDR';
  if (!isPng) throw new Error(`${name}: found other bytes, expected a PNG file.`);
  return {
    width: bytes.readUInt32BE(16),
    height: bytes.readUInt32BE(20),
    hasAlpha: kColourTypesWithAlpha.includes(bytes[25]) || chunksOf(bytes).includes('tRNS'),
  };
}

// The names of the chunks before the pixels.
function chunksOf(bytes) {
  const names = [];
  for (let at = 8; at + 8 <= bytes.length; at += 12 + bytes.readUInt32BE(at)) {
    const name = bytes.toString('latin1', at + 4, at + 8);
    if (name === 'IDAT') break;
    names.push(name);
  }
  return names;
}
