// The pictures of the document, decoded once: for icons of blocks, and mean colours in the plan.
// Takes the scene's texture entries; gives images and colours. Changes nothing.
//
//     const pictures = new Pictures(scene, (file) => bytes, 0);
//     pictures.imageOf('brick')            // an ImageBitmap of its first frame, or null until then
//     pictures.meanOf('brick')             // '#a0887c', or null until then
//     pictures.listen(() => ...)           // another one has come

import { pictureOf } from './files/shipped.js';

export class Pictures {
  #scene;
  #readFile;
  #known = new Map(); // what the scene says of a texture, as text -> {image, mean}
  #listeners = [];
  #isDue = false; // to tell them

  constructor(scene, readFile) {
    this.#scene = scene;
    this.#readFile = readFile;
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  imageOf(name) {
    return this.#entryOf(pictureOf(this.#scene.value, 'textures', name))?.image ?? null;
  }

  spriteOf(name) {
    return this.#entryOf(pictureOf(this.#scene.value, 'sprites', name))?.image ?? null;
  }

  meanOf(name) {
    return this.#entryOf(pictureOf(this.#scene.value, 'textures', name))?.mean ?? null;
  }

  // Of a file that the scene need not name.
  ofFile(file, { frames = 1, views = 1 } = {}) {
    return this.#entryOf({ file, frames, views })?.image ?? null;
  }

  #entryOf(said) {
    if (said === undefined) return null;
    const key = JSON.stringify(said);
    const known = this.#known.get(key);
    if (known !== undefined) return known;
    const entry = { image: null, mean: null };
    this.#known.set(key, entry);
    this.#bring(said, entry).catch(() => {}); // the engine reports pictures that are none
    return entry;
  }

  async #bring(said, entry) {
    const { file, frames = 1, views = 1 } = typeof said === 'string' ? { file: said } : said;
    if (file.startsWith('#')) {
      entry.image = await createImageBitmap(plain(file));
      entry.mean = file.slice(0, 7);
    } else {
      const bytes = await this.#readFile(file);
      if (bytes === null) return;
      const whole = await createImageBitmap(new Blob([bytes]));
      const width = Math.floor(whole.width / frames);
      const height = Math.floor(whole.height / views);
      entry.image = await createImageBitmap(whole, 0, 0, width, height);
      entry.mean = meanOf(entry.image);
    }
    this.#tell();
  }

  // Once a frame: many come at a time, and everything is painted anew.
  #tell() {
    if (this.#isDue) return;
    this.#isDue = true;
    requestAnimationFrame(() => {
      this.#isDue = false;
      for (const listener of this.#listeners) listener();
    });
  }
}

function plain(colour) {
  const canvas = new OffscreenCanvas(8, 8);
  const context = canvas.getContext('2d');
  context.fillStyle = colour;
  context.fillRect(0, 0, 8, 8);
  return canvas;
}

function meanOf(image) {
  const canvas = new OffscreenCanvas(1, 1);
  const context = canvas.getContext('2d');
  context.imageSmoothingQuality = 'high';
  const small = new OffscreenCanvas(8, 8);
  small.getContext('2d').drawImage(image, 0, 0, 8, 8);
  context.drawImage(small, 0, 0, 1, 1);
  const [red, green, blue, alpha] = context.getImageData(0, 0, 1, 1).data;
  if (alpha < 32) return null;
  return `#${[red, green, blue].map((part) => part.toString(16).padStart(2, '0')).join('')}`;
}
