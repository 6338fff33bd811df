// Decompresses data whose size is known: zlib, gzip, zstd. Whatever the data claim, at most a
// little more than that size is ever made.
//
//     const bytes = await inflate(packed, 'gzip', 4 * width * height);     // throws an Error
//
// What it throws says what is wrong with the data; the caller adds the place.

import { Gunzip, Unzlib } from 'fflate';

const kPiece = 4096; // bytes at a time: these make at most four million

export async function inflate(bytes, compression, size) {
  if (compression === 'zstd') return inflateZstd(bytes, size);
  const result = new Uint8Array(size);
  let length = 0;
  const stream = new (compression === 'gzip' ? Gunzip : Unzlib)((piece) => {
    if (length + piece.length > size) throw new Error(`more than ${size} bytes of data`);
    result.set(piece, length);
    length += piece.length;
  });
  for (let at = 0; at < bytes.length; at += kPiece)
    stream.push(bytes.subarray(at, at + kPiece), at + kPiece >= bytes.length);
  if (length !== size) throw new Error(`${length} bytes of data instead of ${size}`);
  return result;
}

// Few maps need it, so it loads when one does. It writes into memory of the given size only.
async function inflateZstd(bytes, size) {
  const { ZSTDDecoder } = await import('zstddec');
  const decoder = new ZSTDDecoder();
  await decoder.init();
  const result = decoder.decode(bytes, size);
  if (result.length !== size) throw new Error(`zstd data that do not make ${size} bytes`);
  return result;
}
