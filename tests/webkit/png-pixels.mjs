// The pixels of a PNG of 8 bits in RGB or RGBA, as a canvas gives them: R, G, B, A.

import { inflateSync } from 'node:zlib';

const kSignatureBytes = 8;

export function pixelsOf(png) {
  const parts = [];
  let width, height, channels;
  for (let at = kSignatureBytes; at < png.length;) {
    const length = png.readUInt32BE(at);
    const type = png.toString('latin1', at + 4, at + 8);
    const body = png.subarray(at + 8, at + 8 + length);
    if (type === 'IHDR') {
      [width, height] = [body.readUInt32BE(0), body.readUInt32BE(4)];
      channels = { 2: 3, 6: 4 }[body[9]];
      if (body[8] !== 8 || channels === undefined)
        throw new Error('neither RGB nor RGBA of 8 bits');
    }
    if (type === 'IDAT') parts.push(body);
    at += length + 12;
  }
  const bytes = unfiltered(inflateSync(Buffer.concat(parts)), width * channels, height, channels);
  const pixels = new Uint8Array(width * height * 4).fill(255);
  for (let i = 0; i < width * height; ++i)
    for (let channel = 0; channel < channels; ++channel)
      pixels[4 * i + channel] = bytes[channels * i + channel];
  return pixels;
}

// Each row begins with the number of its filter: what was taken away from each byte.
function unfiltered(data, rowBytes, rows, channels) {
  const bytes = new Uint8Array(rowBytes * rows);
  for (let row = 0; row < rows; ++row) {
    const filter = data[row * (rowBytes + 1)];
    for (let i = 0; i < rowBytes; ++i) {
      const to = row * rowBytes + i;
      const left = i >= channels ? bytes[to - channels] : 0;
      const above = row > 0 ? bytes[to - rowBytes] : 0;
      const corner = i >= channels && row > 0 ? bytes[to - rowBytes - channels] : 0;
      const taken = [0, left, above, (left + above) >> 1, paeth(left, above, corner)][filter];
      bytes[to] = data[row * (rowBytes + 1) + 1 + i] + taken;
    }
  }
  return bytes;
}

function paeth(left, above, corner) {
  const guess = left + above - corner;
  const [a, b, c] = [left, above, corner].map((each) => Math.abs(guess - each));
  if (a <= b && a <= c) return left;
  return b <= c ? above : corner;
}
