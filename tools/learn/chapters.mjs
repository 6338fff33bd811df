// The chapters of the tutorial: what stands in their folders, web/learn/NN-name, besides the text.
//
//     const chapters = readChapters();                    // name -> Chapter, in their order
//     await drawChapters(chapters, drawing, staged);      // figures and answers, by the engine
//     chapters.get('one-ray').figures.get('walk').html

import { readFileSync, readdirSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const kSource = 'web/learn';
const kFolder = /^(\d\d)-([a-z-]+)$/;

export class Chapter {
  name; // as in its address: one-ray
  number; // from 1
  folder; // its name: 01-one-ray
  figures = new Map(); // name -> {html, numbers, writePictures}
  exercises = new Map(); // id -> {answer, tolerance, unit, ...}

  constructor(number, name, folder) {
    this.number = number;
    this.name = name;
    this.folder = folder;
  }

  get text() {
    return readFileSync(path.join(kSource, this.folder, 'index.md'), 'utf8');
  }

  isWide(figure) {
    return new RegExp(`^::: figure ${figure} .*\\bwide\\b`, 'm').test(this.text);
  }

  // Draws the figures and computes the answers. `staged` holds the modules.
  async draw(drawing, staged) {
    const folder = path.join(staged, this.folder);
    for (const file of readdirSync(folder).sort()) {
      if (!file.endsWith('.js')) continue;
      const name = path.basename(file, '.js');
      try {
        const { default: content } = await import(pathToFileURL(path.join(folder, file)));
        if (name === 'exercises') {
          for (const [id, exercise] of Object.entries(content))
            this.exercises.set(id, { ...exercise, answer: await drawing.answer(exercise) });
        } else if (Array.isArray(content?.rows)) {
          const wide = this.isWide(name);
          this.figures.set(name, await drawing.figure(name, this.name, content, wide));
        }
      } catch (error) {
        throw new Error(`${kSource}/${this.folder}/${file}: ${error.message}`, { cause: error });
      }
    }
  }
}

export function readChapters() {
  const chapters = new Map();
  for (const folder of readdirSync(kSource).sort()) {
    const [, number, name] = kFolder.exec(folder) ?? [];
    if (name !== undefined) chapters.set(name, new Chapter(Number(number), name, folder));
  }
  return chapters;
}

export async function drawChapters(chapters, drawing, staged) {
  for (const chapter of chapters.values()) await chapter.draw(drawing, staged);
}
