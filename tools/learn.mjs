// Builds the tutorial: turns web/learn into the pages of FOLDER/learn, by Eleventy and esbuild.
//
//     node tools/learn.mjs FOLDER        // a built page; its engine draws the figures
//
// web/learn/README.md says what a chapter consists of.

import { Eleventy } from '@11ty/eleventy';
import { cp, rm } from 'node:fs/promises';
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

import { drawChapters, readChapters } from './learn/chapters.mjs';
import { Drawing } from './learn/draw.mjs';
import { Formulas } from './learn/formulas.mjs';
import { readProgram } from './learn/program.mjs';
import { writeRedirects } from './learn/redirects.mjs';
import { buildScripts, buildStyles } from './learn/scripts.mjs';
import { writeSearch } from './learn/search.mjs';
import { configure } from './learn/site.mjs';
import { stage } from './learn/stage.mjs';
import { writePanelFiles } from './learn/write-panel.mjs';

// The picture of the first page, as in web/learn/index.md.
const kOpening = {
  scene: 'yard.json',
  view: '13.6,8.3,3.3,220,-0.42',
  options: { fov: 66 },
  size: [1120, 480],
};

const [argument] = process.argv.slice(2);
if (argument === undefined)
  throw new Error('tools/learn.mjs: found no folder, expected that of a built page');
const folder = path.resolve(argument);

// Eleventy needs paths relative to the working directory.
process.chdir(fileURLToPath(new URL('..', import.meta.url)));
const output = path.join(folder, 'learn');
await rm(output, { recursive: true, force: true });
await cp('web/learn/guide', path.join(folder, 'guide'), { recursive: true });
await cp('web/learn/scenes', path.join(output, 'scenes'), { recursive: true });

const program = await readProgram();
const staged = await stage(program);
const chapters = readChapters();
const formulas = new Formulas();
const drawing = await Drawing.begin(staged, folder);
await drawChapters(chapters, drawing, staged);
const site = new Eleventy('web/learn', path.relative('.', output), {
  quietMode: true,
  config: (config) => configure(config, { chapters, program, formulas }),
});
await site.write();
for (const { figures } of chapters.values())
  for (const figure of figures.values()) figure.writePictures(output);
writeFileSync(path.join(output, 'pictures/index.png'), await drawing.picture(kOpening));
await buildScripts(staged, output, chapters);
await buildStyles(staged, output, formulas.styles);
await writePanelFiles(path.join(output, 'write'));
await writeSearch(output, chapters);
await writeRedirects(folder);
