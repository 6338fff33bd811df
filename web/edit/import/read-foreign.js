// Reads a map from elsewhere: Tiled (TMX, TMJ), LDtk, or a matrix pasted as text. What the file's
// text looks like decides, its name only helps. Runs in pages and under Node, and reaches no file
// but through `readFile`.
//
//     const proposal = await readForeign({ name: 'town.tmx', bytes, readFile });
//     const { scene, pictures, notTaken } = await makeScene(proposal);
//
// `name` may have folders; readFile(name) gives the bytes of a file relative to where `name` is
// relative to, and is never given a name that leaves there. What cannot be taken at all is an
// ImportError.

import { filesOf } from './foreign-files.js';
import { ImportError } from './import-error.js';
import { kMostFileBytes } from './import-limits.js';
import { readLdtk } from './ldtk.js';
import { readMatrix } from './matrix.js';
import { propose } from './propose.js';
import { readTiled } from './tiled.js';
import { parseJson, parseTiled, textOfBytes } from './tiled-text.js';
import { looksLikeXml } from './tiled-xml.js';

export async function readForeign({ name, bytes, readFile = noFile }) {
  if (bytes.length > kMostFileBytes)
    throw new ImportError(name, '', `${bytes.length} bytes`, `at most ${kMostFileBytes}`);
  const files = filesOf(readFile);
  const draft = await readDraft(name, bytes, files).catch((error) => {
    if (error instanceof ImportError) throw error;
    // A value of another kind than the format has, somewhere.
    const wrong = new ImportError(name, '', `what no such file holds: ${error.message}`, 'a map');
    throw Object.assign(wrong, { cause: error });
  });
  const proposal = propose(draft);
  const used = new Set(proposal.kinds.flatMap(({ parts }) => parts.map(({ picture }) => picture)));
  for (const [index, picture] of proposal.pictures.entries()) {
    if (!used.has(index)) continue;
    // Without its picture a tile still has its place, so the map is taken.
    try {
      picture.bytes = await files.read(picture.file, picture.from, '');
    } catch (error) {
      draft.note(`picture "${picture.file}"`, `${error.found}; its tiles get plain colours`);
    }
  }
  return { ...proposal, notTaken: draft.lists().notTaken };
}

async function readDraft(name, bytes, files) {
  const text = textOfBytes(bytes, name);
  if (looksLikeXml(text)) return readTiled(parseTiled(bytes, name, ['map']), name, files);
  const isNamedJson = /\.(json|tmj|ldtk|tsj|tj)$/i.test(name);
  if (isNamedJson || /^\s*\{\s*"[^"\n]{0,80}"\s*:/.test(text)) {
    const value = parseJson(text, name);
    if (Reflect.has(value, 'defs') || Reflect.has(value, '__header__'))
      return readLdtk(value, name, files);
    return readTiled(value, name, files);
  }
  return readMatrix(text, name);
}

async function noFile(name) {
  throw new Error(`${name} is not at hand`);
}
