// The panel "Write your own", for the build: web/learn/write/README.md.

import { mkdir, writeFile } from 'node:fs/promises';
import path from 'node:path';

import { colour } from './colour.mjs';
import { readProgram } from './program.mjs';
import { buildExportPage, buildRunPage } from './run-page.mjs';
import { engineOptions, functionsOf, sceneOf } from '../../web/learn/raycaster/states.js';

const kMoves = 17; // the chapter of gates and lifts
const kMovedSeconds = 1.5; // then they are on their way

const escape = (text) =>
  text
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;');

// The panel as it stands in the page: readable without JavaScript. What is left out of `scene`,
// `view` and `options` comes from the chapter's state.
export async function panelHtml({ chapter, scene, view = '', options = '', seconds }) {
  const { states } = await readProgram();
  const data = {
    chapter,
    scene: scene ?? `scenes/${sceneOf(chapter)}`,
    view,
    seconds: seconds ?? (chapter === kMoves ? kMovedSeconds : 0),
    options: `${optionsText(engineOptions(chapter))} ${options}`.trim(),
  };
  const attributes = Object.entries(data).map(
    ([key, value]) => `data-${key}="${escape(String(value))}"`,
  );
  return (
    `<section class="write" id="write" ${attributes.join(' ')} aria-labelledby="write-title">\n` +
    `<h2 id="write-title">Write your own</h2>\n${task(states.newIn(chapter))}\n` +
    `<div class="write-bench"><div class="write-code"><div class="write-host">` +
    `<pre class="write-program" tabindex="0" aria-label="The program at the start of this chapter"><code>` +
    `${colour(partOf(states, chapter), 'js')}</code></pre></div></div></div>\n</section>\n`
  );
}

// What stands there until the panel is mounted: the functions that are new or changed, as the
// reader finds them. The whole program would be half of the page.
function partOf(states, chapter) {
  const names = states.newIn(chapter).map(({ name }) => name);
  const functions = functionsOf(states.start(chapter));
  const shown = functions.filter(({ name }) => names.includes(name));
  return (shown.length > 0 ? shown : functions.slice(0, 1)).map(({ text }) => text).join('\n\n');
}

// { textures: true, detail: false } as the attribute has it.
function optionsText(options) {
  return Object.entries(options)
    .map(([name, value]) => `${name}=${value === true ? 'on' : value === false ? 'off' : value}`)
    .join(' ');
}

function task(entries) {
  const list = (chosen) => {
    const names = chosen.map(({ name }) => `<code>${name}</code>`);
    return names.length < 2
      ? names.join('')
      : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`;
  };
  const yours = entries.filter(({ isYours }) => isYours);
  const given = entries.filter(({ isYours }) => !isYours);
  const sentences = [
    yours.length === 0
      ? 'This chapter asks for no new code. Break a function of yours, and see it caught.'
      : `Yours to write: ${list(yours)}. In this program ${yours.length === 1 ? 'it is' : 'they are'} wrong on purpose.`,
    given.length === 0 ? '' : `${list(given)} ${given.length === 1 ? 'is' : 'are'} given.`,
  ];
  return `<p class="write-task">${sentences.filter(Boolean).join(' ')}</p>`;
}

// What a panel needs to know about a chapter.
export function stepOf(states, chapter) {
  const names = states.names(chapter);
  const before = chapter === 1 ? [] : states.names(chapter - 1);
  return {
    chapter,
    start: states.start(chapter),
    answer: states.answer(chapter),
    names,
    newIn: states.newIn(chapter),
    dropped: before.filter((name) => !names.includes(name)),
  };
}

// Writes run.html, export.html and the steps into a folder.
export async function writePanelFiles(folder) {
  const { states } = await readProgram();
  await mkdir(path.join(folder, 'steps'), { recursive: true });
  await writeFile(path.join(folder, 'run.html'), await buildRunPage());
  await writeFile(path.join(folder, 'export.html'), await buildExportPage());
  for (let chapter = 1; chapter <= states.chapters; ++chapter) {
    const file = `${String(chapter).padStart(2, '0')}.json`;
    await writeFile(path.join(folder, 'steps', file), JSON.stringify(stepOf(states, chapter)));
  }
}
