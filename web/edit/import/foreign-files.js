// Reads the files that a foreign map names: tilesets, pictures, templates, levels. Names are
// relative to the file that names them, and stay within the folder that `readFile` is for. A name
// that leaves it, or that is an address, is refused before readFile is called.
//
//     const files = filesOf(readFile);
//     const name = files.resolve('maps/town.tmx', '../tiles/wall.tsx', place);    // tiles/wall.tsx
//     const bytes = await files.read(name, place);            // each file is read once

import { ImportError, quoted } from './import-error.js';
import { kMostAllFileBytes, kMostFileBytes, kMostFiles } from './import-limits.js';

// As in scenes: what an address would read otherwise is no part of a name.
// eslint-disable-next-line no-control-regex
const kUnfit = /[\\:?#%*"<>|\u0000-\u001f\u007f-\u009f]/;
const kMostLength = 1000; // characters

export function filesOf(readFile) {
  const known = new Map(); // name -> promise of bytes
  let total = 0;

  function resolve(from, reference, place) {
    const fits =
      typeof reference === 'string' &&
      reference.length > 0 &&
      reference.length <= kMostLength &&
      !reference.startsWith('/') &&
      !kUnfit.test(reference);
    if (!fits)
      throw new ImportError(
        from,
        place,
        `the file name ${quoted(reference)}`,
        'one relative to this file, with forward slashes, such as "tiles/walls.png"',
      );
    const parts = from.split('/').slice(0, -1);
    for (const part of reference.split('/')) {
      if (part === '' || part === '.') continue;
      if (part !== '..') parts.push(part);
      else if (parts.pop() === undefined)
        throw new ImportError(
          from,
          place,
          `the file name ${quoted(reference)}, which leaves the map's folder`,
          'a file in this folder or below it',
        );
    }
    return parts.join('/');
  }

  async function readOnce(name, from, place) {
    if (known.size > kMostFiles)
      throw new ImportError(from, place, 'one more file', `at most ${kMostFiles} files`);
    let bytes;
    try {
      bytes = await readFile(name);
    } catch (error) {
      const missing = new ImportError(from, place, error.message, 'a file to read');
      missing.message = `${from} needs ${quoted(name)}: ${error.message}`;
      throw missing;
    }
    if (!(bytes instanceof Uint8Array))
      throw new ImportError(from, place, `no bytes of ${quoted(name)}`, 'a file to read');
    total += bytes.length;
    if (bytes.length > kMostFileBytes || total > kMostAllFileBytes)
      throw new ImportError(
        name,
        '',
        `${bytes.length} bytes`,
        `at most ${kMostFileBytes}, and ${kMostAllFileBytes} in all files`,
      );
    return bytes;
  }

  function read(name, from, place) {
    if (!known.has(name)) known.set(name, readOnce(name, from, place));
    return known.get(name);
  }

  return { resolve, read };
}
