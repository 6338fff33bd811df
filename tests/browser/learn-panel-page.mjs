// A page with nothing but the panel "Write your own", for its tests.
//
//     const files = await panelFiles({ chapters: [4] });
//     await serve({ files, headersOf: policy });      // learn/page-4.html

import { mkdtemp, readFile, readdir, rm } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

import { panelHtml, writePanelFiles } from '../../tools/learn/write-panel.mjs';

const kHome = fileURLToPath(new URL('../../', import.meta.url));
const kPolicy = "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'";
const { build } = createRequire(path.join(kHome, 'tools/package.json'))('esbuild');

// The site's policy, for all but the frame, which has its own.
export const policy = (name) =>
  name.endsWith('run.html') ? {} : { 'Content-Security-Policy': kPolicy };

const page = (panel) => `<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>Write your own</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="figures.css"><link rel="stylesheet" href="learn.css"><link rel="stylesheet" href="write.css">
<script type="module" src="../ray-caster.js"></script>
<script type="module" src="scripts/start.js"></script></head>
<body><main id="text"><h1>A chapter</h1><p><a href="#write">To the panel</a></p>
${panel}<p><a href="#end" id="after">After the panel</a></p></main></body></html>`;

const kStart = `
import { mountPanel } from './panel.js';
import { codeOf } from './share.js';
window.codeOf = codeOf;
window.violations = [];
document.addEventListener('securitypolicyviolation', (event) =>
  violations.push(event.effectiveDirective + ' ' + event.blockedURI),
);
const element = document.querySelector('.write');
window.events = [];
for (const type of ['write-run', 'write-solved'])
  element.addEventListener(type, ({ detail }) => events.push({ type, ...detail }));
window.panel = mountPanel(element);
`;

// The bundle start.js of some code beside the panel's modules, and its parts.
export async function scriptFiles(contents = kStart) {
  const { outputFiles, metafile } = await build({
    stdin: {
      contents,
      resolveDir: path.join(kHome, 'web/learn/write'),
      sourcefile: 's.js',
    },
    outdir: path.join(kHome, 'out'),
    entryNames: 'start',
    nodePaths: [path.join(kHome, 'tools/node_modules')],
    bundle: true,
    splitting: true,
    minify: true,
    format: 'esm',
    target: 'es2022',
    legalComments: 'none',
    chunkNames: '[name]-[hash]',
    metafile: true,
    write: false,
    logLevel: 'warning',
  });
  const files = {};
  for (const { path: file, text } of outputFiles) files[path.basename(file)] = text;
  return { files, outputs: metafile.outputs };
}

// { path: text } of the pages learn/page-NN.html and all that they need; views: chapter -> view.
export async function panelFiles({ chapters = [4], views = {} } = {}) {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-panel-'));
  const files = {};
  try {
    await writePanelFiles(folder);
    for (const name of ['run.html', 'export.html'])
      files[`learn/write/${name}`] = await readFile(path.join(folder, name), 'utf8');
    for (const name of await readdir(path.join(folder, 'steps')))
      files[`learn/write/steps/${name}`] = await readFile(path.join(folder, 'steps', name), 'utf8');
  } finally {
    await rm(folder, { recursive: true });
  }
  for (const [name, text] of Object.entries((await scriptFiles()).files))
    files[`learn/scripts/${name}`] = text;
  for (const name of ['figures/figures.css', 'learn.css', 'write/write.css'])
    files[`learn/${path.basename(name)}`] = await readFile(
      path.join(kHome, 'web/learn', name),
      'utf8',
    );
  const scenes = path.join(kHome, 'web/learn/scenes');
  for (const name of await readdir(scenes))
    files[`learn/scenes/${name}`] = await readFile(path.join(scenes, name), 'utf8');
  for (const chapter of chapters)
    files[`learn/page-${chapter}.html`] = page(await panelHtml({ chapter, view: views[chapter] }));
  return files;
}

// For a look: node tests/browser/learn-panel-page.mjs CHAPTER...
if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { serve } = await import('./static-server.mjs');
  const chapters = process.argv.slice(2).map(Number);
  const files = await panelFiles({ chapters });
  const { address } = await serve({ files, headersOf: policy });
  for (const chapter of chapters) console.log(`${address}learn/page-${chapter}.html`);
}
