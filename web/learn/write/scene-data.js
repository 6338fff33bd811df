// What a world is made of: a scene file and its pictures.
//
//     const { scene, images, files } = await readScene(address)
//
// `images` are decoded, for makeWorld; `files` are their bytes, for downloads.

import { decodePng } from '../decode.js';
import { filesOf } from '../raycaster/world.js';

export async function readScene(address) {
  const home = new URL(address, document.baseURI);
  const scene = await (await fetched(home)).json();
  const images = {};
  const files = {};
  await Promise.all(
    filesOf(scene).map(async (file) => {
      const bytes = new Uint8Array(await (await fetched(new URL(file, home))).arrayBuffer());
      files[file] = bytes;
      images[file] = decodePng(bytes);
    }),
  );
  return { scene, images, files };
}

async function fetched(address) {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address} cannot be loaded (${answer.status}).`);
  return answer;
}
