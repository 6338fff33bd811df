// The worlds that this browser keeps, by name. Takes and gives {text, pictures, base}: the text,
// the world's own pictures (file -> bytes), and what is known of its file (saving.js).
//
//     await readWorld('castle')                     // or null
//     await writeWorld('castle', { text, pictures, base });    // throws if none is kept
//     await forgetWorld('castle');
//     await keepOpened('yard', world)               // of a file; the query that opens it
//
// Names: a shipped scene's; 'template NAME'; 'link HASH'; 'file NAME', also for scenes that were
// dropped onto the play page; 'served ID' for that of tools/play.

import { del, get, set } from 'idb-keyval';

const keyOf = (name) => `slicecast edit ${name}`;

export async function readWorld(name) {
  try {
    return (await get(keyOf(name))) ?? null;
  } catch {
    return null; // private windows keep nothing
  }
}

export function writeWorld(name, world) {
  return set(keyOf(name), { ...world, savedAt: Date.now() });
}

export async function forgetWorld(name) {
  await del(keyOf(name)).catch(() => {});
}

// Nothing that is kept under that name gets lost, unless it is in its file, too.
export async function keepOpened(wanted, world) {
  let name = wanted;
  for (let count = 2; !isFree(await readWorld(`file ${name}`), world); ++count)
    name = `${wanted} ${count}`;
  await writeWorld(`file ${name}`, world);
  return `?file=${encodeURIComponent(name)}`;
}

const isFree = (kept, world) =>
  kept === null || kept.base?.isSaved === true || contentOf(kept) === contentOf(world);

const contentOf = ({ text, pictures = [] }) =>
  JSON.stringify([text, [...pictures].map(([name, { length }]) => [name, length])]);
