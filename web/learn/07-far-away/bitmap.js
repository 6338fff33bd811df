// Texels as images in a page's markup.

const made = new WeakMap(); // by texels

// RGBA bytes as the address of a BMP picture, without alpha.
export function imageAddress(level) {
  if (!made.has(level.texels)) made.set(level.texels, bitmap(level));
  return made.get(level.texels);
}

function bitmap({ width, height, texels }) {
  const stride = (3 * width + 3) & ~3;
  const bytes = new Uint8Array(54 + stride * height);
  const header = new DataView(bytes.buffer);
  bytes.set([0x42, 0x4d]);
  header.setUint32(2, bytes.length, true);
  header.setUint32(10, 54, true);
  header.setUint32(14, 40, true);
  header.setInt32(18, width, true);
  header.setInt32(22, height, true);
  header.setUint16(26, 1, true);
  header.setUint16(28, 24, true);
  for (let row = 0; row < height; ++row) {
    let to = 54 + stride * (height - 1 - row); // from the lowest row up
    for (let column = 0; column < width; ++column, to += 3) {
      const from = 4 * (row * width + column);
      bytes[to] = texels[from + 2];
      bytes[to + 1] = texels[from + 1];
      bytes[to + 2] = texels[from];
    }
  }
  let binary = '';
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return `data:image/bmp;base64,${btoa(binary)}`;
}

// A texture of the world that the reader's program is given, by the name of its blueprint's face.
export function textureOf({ source, eye }, character, face = 'south') {
  return source.drawnWorld.maps[eye.map].blocks[character].faces[face].texture;
}

export function texelAt({ width, texels }, column, row) {
  const at = 4 * (row * width + column);
  return [texels[at], texels[at + 1], texels[at + 2]];
}

// The mean of a square of texels, of which some at its edges are only partly inside.
export function meanOf(level, left, top, side) {
  const sum = [0, 0, 0];
  const share = (index, from) =>
    Math.max(0, Math.min(index + 1, from + side) - Math.max(index, from));
  for (let row = Math.floor(top); row < top + side; ++row)
    for (let column = Math.floor(left); column < left + side; ++column) {
      const weight = share(column, left) * share(row, top);
      const inside = (index, size) => ((index % size) + size) % size;
      texelAt(level, inside(column, level.width), inside(row, level.height)).forEach(
        (value, channel) => {
          sum[channel] += weight * value;
        },
      );
    }
  return sum.map((value) => value / (side * side));
}
