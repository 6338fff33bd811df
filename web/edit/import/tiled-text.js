// The text of a file of Tiled, XML or JSON, as an object in the shape of the JSON files.
//
//     const set = parseTiled(bytes, 'walls.tsx', ['tileset']);    // refuses other kinds of files
//     const value = parseJson(text, 'a.ldtk')                      // refuses what is no object

import { ImportError, quoted } from './import-error.js';
import { kMostXmlBytes } from './import-limits.js';
import { looksLikeXml, tiledOfXml } from './tiled-xml.js';

export function parseTiled(bytes, file, kinds) {
  const text = textOfBytes(bytes, file);
  if (!looksLikeXml(text)) {
    const value = parseJson(text, file);
    if (value.type !== undefined && !kinds.includes(value.type))
      throw new ImportError(file, '', `a ${quoted(value.type)}`, `a ${kinds.join(' or ')}`);
    return value;
  }
  if (bytes.length > kMostXmlBytes)
    throw new ImportError(file, '', `${bytes.length} bytes`, `at most ${kMostXmlBytes} of XML`);
  const value = tiledOfXml(text, file);
  if (!kinds.includes(value.type))
    throw new ImportError(file, '', `<${value.type}>`, `<${kinds.join('> or <')}>`);
  return value;
}

export function textOfBytes(bytes, file) {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new ImportError(file, '', 'bytes that are no text in UTF-8', 'a map as text');
  }
}

export function parseJson(text, file) {
  let value;
  try {
    value = JSON.parse(text);
  } catch (error) {
    throw new ImportError(file, '', `JSON that cannot be read: ${error.message}`, 'JSON');
  }
  if (typeof value === 'object' && value !== null && !Array.isArray(value)) return value;
  throw new ImportError(file, '', quoted(value), 'an object in JSON');
}
