// Reads the cells of a tile layer of Tiled, in all its encodings: lists of numbers, csv, and base64
// without compression or with zlib, gzip or zstd.
//
//     const gids = await readCells(layer.data, layer, count, fault);      // Uint32Array
//
// `fault(found, expected)` returns the error with the place. Sizes are checked before memory is
// taken.

import { quoted } from './import-error.js';
import { inflate } from './inflate.js';

export async function readCells(data, { encoding, compression }, count, fault) {
  if (Array.isArray(data) || encoding === 'csv') return readNumbers(data, count, fault);
  if (encoding !== 'base64')
    throw fault(`cells in the encoding ${quoted(encoding)}`, 'csv, base64 or a list of numbers');
  if (typeof data !== 'string') throw fault('no cells', 'a text in base64');
  const size = count * 4;
  const packed = bytesOfBase64(data, fault);
  const bytes = await unpack(packed, compression, size, fault);
  if (bytes.length !== size)
    throw fault(`${bytes.length} bytes of cells`, `${size}, 4 for each of ${count} tiles`);
  const view = new DataView(bytes.buffer, bytes.byteOffset, size);
  const cells = new Uint32Array(count);
  for (let index = 0; index < count; ++index) cells[index] = view.getUint32(index * 4, true);
  return cells;
}

async function unpack(packed, compression, size, fault) {
  if (compression === undefined || compression === '') return packed;
  if (!['zlib', 'gzip', 'zstd'].includes(compression))
    throw fault(`cells packed by ${quoted(compression)}`, 'zlib, gzip, zstd or nothing');
  try {
    return await inflate(packed, compression, size);
  } catch (error) {
    throw fault(`cells packed by ${compression} with ${error.message}`, `${size} bytes of cells`);
  }
}

function readNumbers(data, count, fault) {
  const list = typeof data === 'string' ? data.split(',') : data;
  if (!Array.isArray(list)) throw fault('no cells', 'a list of numbers');
  const found = list.length === 1 && String(list[0]).trim() === '' ? 0 : list.length;
  if (found !== count) throw fault(`${found} cells`, `${count}, as the size says`);
  const cells = new Uint32Array(count);
  for (let index = 0; index < count; ++index) {
    const number = Number(list[index]);
    if (!Number.isInteger(number) || number < 0 || number >= 2 ** 32)
      throw fault(`the cell ${quoted(list[index])}`, 'a whole number from 0 to 4294967295');
    cells[index] = number;
  }
  return cells;
}

function bytesOfBase64(text, fault) {
  let binary;
  try {
    binary = atob(text.replaceAll(/\s/g, ''));
  } catch {
    throw fault('cells that are no base64', 'a text in base64');
  }
  const bytes = new Uint8Array(binary.length);
  for (let index = 0; index < bytes.length; ++index) bytes[index] = binary.charCodeAt(index);
  return bytes;
}
