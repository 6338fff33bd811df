// Lets figures draw with the reader's raycaster, in the state of a chapter or with a fault in it.
// tools/learn.mjs makes a module of each state and of each fault:
//
//     import { draw } from '../by-hand/chapter-04.js';         // the program after chapter 4
//     import { draw as wrong } from '../by-hand/mirrored.js';  // with the fault of this name
//     import { byHandWorld, drawWith } from '../by-hand.js';
//
//     export default {
//       world: byHandWorld,
//       rows: [[divider({ right: { title: 'Mirrored', draw: drawWith(wrong) } })]],
//       ...
//     };

import { decodePng } from './decode.js';
import { filesOf, makeEye, makePicture, makeWorld } from './raycaster/world.js';

const worlds = new Map(); // of this page, by scene: the promise of each

// The world that the program draws, of the scene of a figure's source.
export function byHandWorld(source) {
  const key = JSON.stringify(source.scene);
  if (!worlds.has(key)) worlds.set(key, readWorld(source));
  return worlds.get(key);
}

// A picture of the kit's divider, drawn by a program.
export function drawWith(draw, { fov = 60 } = {}) {
  return (picture, world, eye, state) => {
    const drawn = makePicture(picture.width, picture.height);
    world.seconds = (state?.time ?? 0) / 120;
    draw(drawn, world, makeEye(world, eye, state?.fov ?? fov));
    picture.data.set(drawn.pixels);
    // A program with a fault may leave holes; the page would shine through.
    for (let i = 3; i < picture.data.length; i += 4) picture.data[i] = 255;
  };
}

async function readWorld(source) {
  const images = {};
  await Promise.all(
    filesOf(source.scene).map(async (file) => {
      images[file] = decodePng(await readBytes(source.address(file)));
    }),
  );
  return makeWorld(source.scene, images);
}

// Under Node, when the site is built, addresses are those of files.
async function readBytes(address) {
  if (!String(address).startsWith('file:')) {
    const answer = await fetch(address);
    if (!answer.ok) throw new Error(`${address}: ${answer.status}`);
    return new Uint8Array(await answer.arrayBuffer());
  }
  const { readFile } = await import('node:fs/promises');
  return readFile(new URL(address));
}
