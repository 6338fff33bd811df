// Draws the figures of the tutorial under Node, and computes the answers of its exercises, with the
// engine of a built page.

import { encode } from 'fast-png';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const kWidths = [1120, 680]; // CSS pixels: of wide figures, and of figures in the text
const kExerciseSize = [480, 300];

// `staged` is the folder with the modules of web/learn, `builtPage` that of the page.
export class Drawing {
  #kit;
  #load;
  #scenes;

  static async begin(staged, builtPage) {
    const drawing = new Drawing();
    const moduleAt = (...names) => import(pathToFileURL(path.join(...names)));
    drawing.#kit = {
      ...(await moduleAt(staged, 'figures/draw.js')),
      ...(await moduleAt(staged, 'figures/source.js')),
    };
    drawing.#load = (await moduleAt(builtPage, 'node/index.js')).load;
    drawing.#scenes = path.join(builtPage, 'learn/scenes');
    return drawing;
  }

  // {html, numbers, writePictures(output)} of a figure; `name` is unique in its chapter.
  async figure(name, chapter, figure, wide) {
    return this.#withSource(figure, async (source) => {
      await this.#kit.prepare(figure, source);
      const { html, posters, numbers } = this.#kit.drawStatic(figure, source, {
        name,
        wide,
        widths: kWidths,
        poster: (part) => `pictures/${chapter}-${part}.png`,
      });
      return {
        html,
        numbers,
        writePictures(output) {
          mkdirSync(path.join(output, 'pictures'), { recursive: true });
          for (const poster of posters) {
            const file = path.join(output, 'pictures', `${chapter}-${poster.name}.png`);
            writeFileSync(file, encodePng(poster.pixels));
          }
        },
      };
    });
  }

  // A figure's picture alone, as the bytes of a PNG file.
  async picture(figure) {
    return this.#withSource(figure, (source) => {
      this.#kit.openingNow({ rows: [], ...figure }, source);
      return encodePng(source.pixels());
    });
  }

  // The answer of an exercise, as a number or a text.
  async answer(exercise) {
    return this.#withSource({ size: kExerciseSize, ...exercise }, async (source) => {
      await this.#kit.prepare(exercise, source);
      return exercise.answer(this.#kit.openingNow({ rows: [], ...exercise }, source));
    });
  }

  async #withSource({ scene, size = kExerciseSize }, use) {
    const isFile = typeof scene === 'string';
    const json = isFile ? JSON.parse(readFileSync(path.join(this.#scenes, scene), 'utf8')) : scene;
    const base = pathToFileURL(`${this.#scenes}/`);
    const running = await this.#load(isFile ? path.join(this.#scenes, scene) : scene, {
      base: this.#scenes,
    });
    if (running.warnings.length > 0)
      throw new Error(`its scene has warnings: ${JSON.stringify(running.warnings, null, 2)}`);
    const address = (file) => new URL(file, base).href;
    const result = await use(this.#kit.nodeSource(running, { scene: json, size, address }));
    running.free();
    return result;
  }
}

function encodePng({ width, height, data }) {
  const colours = new Uint8Array(width * height * 3);
  for (let pixel = 0; pixel < width * height; ++pixel)
    colours.set(data.subarray(4 * pixel, 4 * pixel + 3), 3 * pixel);
  const image = { width, height, data: colours, channels: 3, depth: 8 };
  return encode(image, { zlib: { level: 9 } });
}
