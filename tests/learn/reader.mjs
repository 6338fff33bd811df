// What the tests of the reader's raycaster share: scenes with their decoded pictures, worlds, the
// engine's pictures, and the reader's.

import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { createRequire } from 'node:module';

import { load } from '../../build/web/node/index.js';
import { faultyText, program } from '../../web/learn/raycaster/faults.js';
import { engineOptions, makeStates } from '../../web/learn/raycaster/states.js';
import { filesOf, makeEye, makePicture, makeWorld } from '../../web/learn/raycaster/world.js';

const { decode } = createRequire(new URL('../../tools/package.json', import.meta.url))('fast-png');
export const root = new URL('../..', import.meta.url).pathname;
const kScenes = join(root, 'web/learn/scenes');

export const states = makeStates(
  await readFile(join(root, 'web/learn/raycaster/raycaster.txt'), 'utf8'),
);
export const faultyStates = (name, chapter) => faultyText(states, name, chapter);
export { program };

const pictures = new Map();

// A picture's RGBA bytes.
async function readPicture(path) {
  if (!pictures.has(path)) {
    const { width, height, channels, data, palette } = decode(await readFile(path));
    const rgba = new Uint8ClampedArray(4 * width * height);
    for (let i = 0; i < width * height; i++) {
      const given = palette
        ? palette[data[i]]
        : Array.from(data.subarray(i * channels, (i + 1) * channels));
      const [red, green, blue, alpha = 255] =
        given.length <= 2 ? [given[0], given[0], given[0], given[1]] : given;
      rgba.set([red, green, blue, alpha], 4 * i);
    }
    pictures.set(path, { width, height, data: rgba });
  }
  return pictures.get(path);
}

// A scene of the tutorial, or of tests/learn/scenes: the engine's, and the world of the reader.
export async function openScene(name, folder = kScenes) {
  const text = JSON.parse(await readFile(join(folder, name), 'utf8'));
  // The built page has the pictures elsewhere.
  const base = join(root, 'assets/scenes/x');
  const scene = JSON.parse(JSON.stringify(text).replaceAll('../../', '../'));
  const images = {};
  for (const file of filesOf(scene))
    images[file] = await readPicture(join(root, 'assets/scenes', file));
  const engine = await load(scene, { base });
  return { name, scene, engine, world: makeWorld(scene, images) };
}

export function optionsOf({ engine }, chapter, fov) {
  for (const [name, value] of Object.entries(engineOptions(chapter)))
    engine.set(name, value ? 'on' : 'off');
  engine.set('fov', fov);
}

// Both see the view: the engine's picture, and what the reader's program needs.
export function lookAt(opened, view, { chapter = 22, fov = 66, size }) {
  const { engine, world } = opened;
  optionsOf(opened, chapter, fov);
  engine.look(view);
  const eye = makeEye(world, engine.currentView, fov);
  return { eye, size, picture: engine.pixels(size) };
}

export function drawn(functions, world, eye, { width, height }) {
  const picture = makePicture(width, height);
  functions.draw(picture, world, eye);
  return { width, height, data: picture.pixels };
}
