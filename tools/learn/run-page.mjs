// The pages of the reader's own program that consist of one file each.
//
//     await buildRunPage()        // run.html: the frame in which programs run
//     await buildExportPage()     // export.html: a download without its program and its world
//
// Both return the text of the page.

import { build } from 'esbuild';
import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const kPackages = fileURLToPath(new URL('../node_modules', import.meta.url));
const kFolder = fileURLToPath(new URL('../../web/learn/write/', import.meta.url));

// A module and all that it imports, as one script.
async function scriptOf(name, define = {}) {
  const { outputFiles } = await build({
    absWorkingDir: kFolder,
    entryPoints: [name],
    bundle: true,
    write: false,
    minify: true,
    format: 'iife',
    target: 'es2022',
    charset: 'utf8',
    legalComments: 'none',
    define,
    nodePaths: [kPackages],
    logLevel: 'warning',
  });
  // As in modules: strict functions do not tell who called them. Without a line of its own, since
  // frame.js tells the program's lines from those of the script around it.
  return `'use strict';${outputFiles[0].text.trim()}`;
}

// Texts inside a script must not end it.
const insideScript = (text) => text.replaceAll('</', '<\\/').replaceAll('<!--', '<\\!--');

export async function buildRunPage() {
  const prelude = await scriptOf('worker.js');
  const script = insideScript(await scriptOf('frame.js', { PRELUDE: JSON.stringify(prelude) }));
  const hash = createHash('sha256').update(script).digest('base64');
  const policy = `default-src 'none'; script-src 'sha256-${hash}' blob:; worker-src blob:`;
  return (
    `<!doctype html><html lang="en"><meta charset="utf-8">` +
    `<meta http-equiv="Content-Security-Policy" content="${policy}">` +
    `<title>Where your program runs</title><script>${script}</script></html>\n`
  );
}

export async function buildExportPage() {
  const page = await readFile(`${kFolder}export.html`, 'utf8');
  const player = insideScript(await scriptOf('export-player.js'));
  return page.replace('/* PLAYER */', () => player);
}
