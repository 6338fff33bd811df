// What an author of a chapter reads when something is wrong with it: each fault stops the build,
// and its message names the page and what was expected.

import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { test } from 'node:test';
import { regionOf } from '../../tools/learn/excerpts.mjs';
import { Formulas } from '../../tools/learn/formulas.mjs';
import { configure } from '../../tools/learn/site.mjs';

const kPage = 'web/learn/01-one-ray/index.md';
const kChapter = {
  name: 'one-ray',
  number: 1,
  figures: new Map([['pane', { html: '<p>A figure.</p>', numbers: { depth: '3.20' } }]]),
  exercises: new Map([['middle', { answer: 2.5, tolerance: 0.01, unit: 'units' }]]),
};
const kFrontMatter = {
  title: 'One ray',
  question: '?',
  minutes: 10,
  needs: [],
  new: [],
  write: {},
};

// What tools/learn/site.mjs gives Eleventy: its parser and its collection of chapters.
function site(chapters = new Map([['one-ray', kChapter]])) {
  const given = {};
  const config = new Proxy(
    { ignores: new Set() },
    {
      get: (known, name) =>
        known[name] ??
        ((key, value) => {
          if (name === 'setLibrary') given.parser = value;
          if (name === 'addCollection') given.chapters = value;
          if (key === 'panel') given.panel = value;
        }),
    },
  );
  const program = { functionText: () => 'function cast() {}', newLines: () => () => false };
  configure(config, { chapters, program, formulas: new Formulas() });
  return given;
}

const render = (text, data = {}) =>
  site().parser.render(text, { ...kFrontMatter, ...data, page: { inputPath: kPage } });
const refused = (text, expected, data) =>
  assert.throws(
    () => render(text, data),
    ({ message }) => {
      assert.ok(message.startsWith(`${kPage}: `), message);
      assert.ok(message.includes(expected), message);
      return true;
    },
  );

test('a chapter without faults is built', () => {
  const html = render(
    [
      'At {{pane.depth}} it stops: $t = 4$, `7` and 12.',
      '::: figure pane',
      'A caption.',
      ':::',
      '::: exercise middle',
      'Which?',
      '::: answer',
      'It is {{exercise.middle}}.',
      ':::',
    ].join('\n'),
    { facts: { 12: 'the columns' } },
  );
  assert.match(html, /data-number="pane\.depth">3\.20</);
  assert.match(html, /<figure class="figure" id="pane"/);
  assert.match(html, /data-answer="2\.5" data-tolerance="0\.01"/);
  assert.match(html, /<b class="computed">2\.5 units<\/b>/);
});

test('a number in the text is computed or has a source', () => {
  refused('It has 12 columns and 1,000 rows.', '12 in "It has 12 columns', {
    facts: { '1,000': 'x' },
  });
});

test('figures, numbers and exercises that a text names exist', () => {
  refused('::: figure plane\n:::', 'there is no figure plane.js in the folder');
  refused('{{pane.width}}', '{{pane.width}}: no figure here has this number');
  refused('::: exercise last\n::: answer\n:::', 'exercises.js has no exercise last');
  refused('{{exercise.last}}', 'exercises.js has no exercise last');
});

test('blocks are known, and end', () => {
  refused('::: figur pane\n:::', 'found ::: figur, expected figure, wrong, exercise');
  refused('::: figure pane\nA caption.', '::: figure pane has no end; expected a line ":::"');
  refused('$$\nx = 1', 'a formula that begins with $$ has no end');
});

test('a chapter has a panel unless its front matter says that it has none', async () => {
  const { panel } = site();
  const write = { scene: 'yard-1.json', view: '4.5,6.2,0.5,290' };
  assert.match(await panel({ chapter: { number: 1 }, write }), /^<section class="write"/);
  assert.equal(await panel({ chapter: { number: 23 }, write: false }), '');
});

test('two places of a page do not have one name', () => {
  refused('## Pane\n\n::: figure pane\n:::', 'two headings or figures have the id "pane"');
});

test('a formula that cannot be read is refused', () => {
  refused('$\\frac{1}{$', 'index.md: ');
});

test('an excerpt says whose code it is', () => {
  const titleOf = (file, name) =>
    /class="code-title">([^:]+):/.exec(render(`\`\`\`source ${file} ${name}\n\`\`\``))[1];
  assert.equal(titleOf('src/render/spans/sloped_plane.cpp', 'own-horizon'), 'The engine');
  assert.equal(titleOf('web/learn/23-slopes/by-hand.js', 'row'), 'This tutorial');
});

test('an excerpt is found once, and ends', (t) => {
  const folder = mkdtempSync(path.join(os.tmpdir(), 'regions-'));
  t.after(() => rmSync(folder, { recursive: true }));
  const file = path.join(folder, 'walk.cpp');
  const put = (lines) => writeFileSync(file, lines.join('\n'));
  put(['  // #region step', '  a();', '    b();', '  // #endregion']);
  assert.equal(regionOf(file, 'step'), 'a();\n  b();');
  assert.throws(() => regionOf(file, 'stop'), /walk\.cpp: found 0 regions "stop", expected one/);
  put(['// #region step', 'a();']);
  assert.throws(() => regionOf(file, 'step'), /the region "step" has no \/\/ #endregion/);
  put(['// #region step', '// #endregion', '// #region step', '// #endregion']);
  assert.throws(() => regionOf(file, 'step'), /found 2 regions "step", expected one/);
});

test('the front matter is whole, and needs only chapters that exist', () => {
  const pagesOf = (data) => ({
    getAll: () => [{ inputPath: kPage, data: { ...data, page: { inputPath: kPage } } }],
  });
  const { chapters } = site();
  assert.equal(chapters(pagesOf(kFrontMatter)).length, 1);
  const { question, ...rest } = kFrontMatter;
  assert.equal(question, '?');
  assert.throws(() => chapters(pagesOf(rest)), /index\.md: its front matter has no "question"/);
  assert.throws(
    () => chapters(pagesOf({ ...kFrontMatter, needs: ['two-rays'] })),
    /it needs the chapter "two-rays", which does not exist/,
  );
});
