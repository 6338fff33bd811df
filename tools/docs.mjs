// Builds the documentation: turns web/docs/*.md into the pages of FOLDER/docs, by Eleventy.
//
//     node tools/docs.mjs FOLDER        // a built page; its engine draws the pictures

import { Eleventy } from '@11ty/eleventy';
import { rm } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

import { configure } from './docs/site.mjs';

const [argument] = process.argv.slice(2);
if (argument === undefined)
  throw new Error('tools/docs.mjs: found no folder, expected that of a built page');
const folder = path.resolve(argument);

// Eleventy needs paths relative to the working directory.
process.chdir(fileURLToPath(new URL('..', import.meta.url)));
const output = path.relative('.', path.join(folder, 'docs'));
await rm(output, { recursive: true, force: true });
const site = new Eleventy('web/docs', output, {
  quietMode: true,
  config: (config) => configure(config, folder),
});
await site.write();
