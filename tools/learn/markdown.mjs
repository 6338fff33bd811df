// The tutorial's Markdown: CommonMark with tables and HTML, and these additions.
//
// - `$ ... $` and `$$ ... $$`: formulas, made into MathML by Temml. \x{...} and \y{...} have the
//   colours of borders of constant x and y.
// - `::: figure NAME [wide]`, a caption, `:::`: the figure NAME.js of the chapter's folder.
// - `::: wrong TITLE`, text, `:::`: what goes wrong without what the chapter teaches.
// - `::: exercise ID`, a question, `::: answer`, the explanation, `:::`: ID is a key of the
//   chapter's exercises.js, which computes the answer.
// - `{{FIGURE.NUMBER}}`: a number of a figure, which follows the figure in the page;
//   `{{exercise.ID}}`: a computed answer.
// - A fence `reader NAME [diff]`: a function of the reader's raycaster, as it is in this chapter;
//   diff marks its new lines.
// - A fence `source FILE NAME`: the lines of a source file between `// #region NAME` and
//   `// #endregion`.
// - Any number in the text must be in the front matter's `facts`, with its source, unless it is
//   computed.

import anchor from 'markdown-it-anchor';
import { createRequire } from 'node:module';

import { colour } from './colour.mjs';
import { regionOf } from './excerpts.mjs';
import { slugOf } from '../docs/markdown.mjs';

// Eleventy's own copy.
const require = createRequire(createRequire(import.meta.url).resolve('@11ty/eleventy'));
const MarkdownIt = require('markdown-it');

// `chapterOf(env)` is the Chapter of a page, `program` has the states of the reader's raycaster,
// and `mathOf` makes formulas.
export function markdown(chapterOf, program, mathOf) {
  const parser = new MarkdownIt({ html: true, typographer: true, quotes: '“”‘’' });
  parser.use(anchor, { level: [2, 3], slugify: slugOf, tabIndex: false });
  parser.use(containers);
  parser.use(formulas);
  parser.use(numbers);
  const { escapeHtml } = parser.utils;
  const { rules } = parser.renderer;

  rules.fence = (tokens, index, options, env) => {
    const { content, info } = tokens[index];
    const [kind, ...words] = info.trim().split(/\s+/);
    if (kind === 'reader') return readerCode(words, chapterOf(env), program);
    if (kind === 'source') return sourceCode(words);
    return code(colour(content, kind), '');
  };
  rules.table_open = () => '<div class="table"><table>\n';
  rules.table_close = () => '</table></div>\n';

  rules.formula = (tokens, index) => {
    const { content, meta } = tokens[index];
    const math = mathOf.mathMl(content, meta.isBlock);
    return meta.isBlock ? `<div class="formula" tabindex="0">${math}</div>\n` : math;
  };
  rules.number = (tokens, index, options, env) => number(tokens[index].meta, chapterOf(env));

  rules.figure_open = (tokens, index, options, env) => {
    const [name, ...classes] = tokens[index].meta.words;
    const figure = chapterOf(env).figures.get(name);
    if (figure === undefined) throw new Error(`there is no figure ${name}.js in the folder.`);
    return (
      `<figure class="${['figure', ...classes].join(' ')}" id="${name}" data-figure="${name}">\n` +
      `${figure.html}\n<figcaption>\n`
    );
  };
  rules.figure_close = () => '</figcaption>\n</figure>\n';
  rules.wrong_open = (tokens, index) => {
    const title = tokens[index].meta.words.join(' ');
    return (
      `<section class="wrong"><p class="kicker">What goes wrong without it</p>\n` +
      `<h2 id="${slugOf(title)}">${escapeHtml(title)}</h2>\n`
    );
  };
  rules.wrong_close = () => '</section>\n';
  rules.exercise_open = (tokens, index, options, env) => {
    const [id] = tokens[index].meta.words;
    exerciseOf(id, chapterOf(env));
    return `<section class="exercise" id="exercise-${id}"><p class="kicker">Exercise</p>\n`;
  };
  rules.answer_open = (tokens, index, options, env) => {
    const [id] = tokens[index].meta.words;
    const { answer, tolerance = 0, unit = '' } = exerciseOf(id, chapterOf(env));
    const form =
      typeof answer === 'number'
        ? `<form class="reply" data-answer="${answer}" data-tolerance="${tolerance}">` +
          `<label>Your answer <input inputmode="decimal" autocomplete="off" size="10"></label>` +
          `${unit === '' ? '' : ` <span class="unit">${escapeHtml(unit)}</span>`}` +
          `<button>Check</button><output></output></form>\n`
        : '';
    return `${form}<details><summary>Answer</summary>\n`;
  };
  rules.answer_close = () => '</details>\n';
  rules.exercise_close = () => '</section>\n';
  return parser;
}

// Every number in the prose of these tokens that `facts` does not list: [{number, text}].
export function unlistedNumbers(tokens, facts = {}) {
  const listed = new Set(Object.keys(facts));
  const found = [];
  for (const { type, children } of tokens) {
    if (type !== 'inline') continue;
    for (const child of children) {
      if (child.type !== 'text') continue;
      for (const [written] of child.content.matchAll(/\d[\d,]*(?:\.\d+)?/g)) {
        const value = written.replace(/,$/, '');
        if (!listed.has(value)) found.push({ number: value, text: child.content.trim() });
      }
    }
  }
  return found;
}

function exerciseOf(id, chapter) {
  const exercise = chapter.exercises.get(id);
  if (exercise === undefined) throw new Error(`exercises.js has no exercise ${id}.`);
  return exercise;
}

function number({ of, name }, chapter) {
  if (of === 'exercise') {
    const { answer, unit = '', digits } = exerciseOf(name, chapter);
    const written = typeof answer === 'number' ? readable(answer, digits) : String(answer);
    return `<b class="computed">${written}${unit === '' ? '' : ` ${unit}`}</b>`;
  }
  const value = chapter.figures.get(of)?.numbers[name];
  if (value === undefined) throw new Error(`{{${of}.${name}}}: no figure here has this number.`);
  return `<output class="computed" data-number="${of}.${name}">${value}</output>`;
}

function readable(value, digits) {
  const written =
    digits === undefined ? String(Number(value.toPrecision(6))) : value.toFixed(digits);
  return written.replace('-', '−');
}

function readerCode([name, ...options], chapter, program) {
  const text = program.functionText(chapter.number, name);
  const isNew = options.includes('diff') ? program.newLines(chapter.number, name) : () => false;
  return code(colour(text, 'js', isNew), 'Your raycaster');
}

function sourceCode([file, name]) {
  const language = file.endsWith('.js') ? 'js' : 'cpp';
  const whose = file.startsWith('web/learn/') ? 'This tutorial' : 'The engine';
  return code(colour(regionOf(file, name), language), `${whose}: <code>${file}</code>`);
}

function code(html, title) {
  const head = title === '' ? '' : `<p class="code-title">${title}</p>`;
  return `<div class="code">${head}<pre tabindex="0"><code>${html}</code></pre></div>\n`;
}

// ::: blocks. They nest; `::: answer` is a part of an exercise and has no end of its own.
function containers(parser) {
  const kKinds = ['figure', 'wrong', 'exercise', 'answer'];
  const lineOf = (state, line) =>
    state.src.slice(state.bMarks[line] + state.tShift[line], state.eMarks[line]).trim();

  const rule = (state, first, last, silent) => {
    const opening = /^:::\s+(\S.*)$/.exec(lineOf(state, first));
    if (opening === null) return false;
    const [kind, ...words] = opening[1].split(/\s+/);
    if (!kKinds.includes(kind))
      throw new Error(`found ::: ${kind}, expected ${kKinds.slice(0, 3).join(', ')}.`);
    if (silent) return true;

    let depth = 1;
    let answer = null;
    let line = first;
    while (depth > 0) {
      line += 1;
      if (line >= last) throw new Error(`::: ${opening[1]} has no end; expected a line ":::".`);
      const text = lineOf(state, line);
      if (text === ':::') depth -= 1;
      else if (text === '::: answer') answer = depth === 1 ? line : answer;
      else if (text.startsWith('::: ')) depth += 1;
    }
    const inside = (name, from, to) => {
      const open = state.push(`${name}_open`, 'div', 1);
      Object.assign(open, { block: true, meta: { words }, map: [first, line] });
      const end = state.lineMax;
      state.lineMax = to;
      state.md.block.tokenize(state, from, to);
      state.lineMax = end;
    };
    inside(kind, first + 1, answer ?? line);
    if (answer !== null) {
      inside('answer', answer + 1, line);
      state.push('answer_close', 'div', -1);
    }
    state.push(`${kind}_close`, 'div', -1);
    state.line = line + 1;
    return true;
  };
  parser.block.ruler.before('fence', 'containers', rule, {
    alt: ['paragraph', 'reference', 'blockquote', 'list'],
  });
}

function formulas(parser) {
  const push = (state, content, isBlock) =>
    Object.assign(state.push('formula', 'math', 0), {
      content,
      block: isBlock,
      meta: { isBlock },
    });

  parser.inline.ruler.before('escape', 'formula', (state, silent) => {
    const match = /^\$(?!\s)((?:[^$\\]|\\.)+?)(?<!\s)\$(?!\d)/.exec(state.src.slice(state.pos));
    if (match === null) return false;
    if (!silent) push(state, match[1], false);
    state.pos += match[0].length;
    return true;
  });

  parser.block.ruler.before(
    'fence',
    'formula',
    (state, first, last, silent) => {
      const begin = state.bMarks[first] + state.tShift[first];
      if (!state.src.startsWith('$$', begin)) return false;
      const end = state.src.indexOf('$$', begin + 2);
      if (end < 0) throw new Error('a formula that begins with $$ has no end.');
      if (silent) return true;
      push(state, state.src.slice(begin + 2, end).trim(), true);
      state.line = first + state.src.slice(begin, end).split('\n').length;
      return true;
    },
    { alt: ['paragraph', 'reference', 'blockquote', 'list'] },
  );
}

function numbers(parser) {
  parser.inline.ruler.before('escape', 'number', (state, silent) => {
    const match = /^\{\{\s*([\w-]+)\.([\w-]+)\s*\}\}/.exec(state.src.slice(state.pos));
    if (match === null) return false;
    if (!silent) state.push('number', 'output', 0).meta = { of: match[1], name: match[2] };
    state.pos += match[0].length;
    return true;
  });
}
