// The documentation's Markdown: CommonMark with tables and HTML, and these additions.
//
// - Headings get ids as on code hosts, so that links work in both places.
// - A link to another page names its source, `scenes.md#gates`; the built page has .html instead.
// - A fence ```json picture=NAME alt="..."``` is drawn as a scene, beside the code: see
//   pictures.mjs.
// - A fence ```json opens=NAME``` is a scene too, but is not drawn.
// - The comment <!-- scene-reference --> on a line of its own becomes the table of all scene keys.
// - A fence ```pictures```, a fence with frames="..." and the comment <!-- other-pictures --> show
//   shipped pictures: see catalogue.mjs.

import anchor from 'markdown-it-anchor';
import { createRequire } from 'node:module';

import { sceneReference } from './scene-reference.mjs';

// Eleventy's own copy.
const require = createRequire(createRequire(import.meta.url).resolve('@11ty/eleventy'));
const MarkdownIt = require('markdown-it');

export function markdown(pictures, catalogue) {
  const parser = new MarkdownIt({ html: true });
  parser.use(anchor, { level: [2, 3], slugify: slugOf, tabIndex: false });
  const { escapeHtml } = parser.utils;
  const { rules } = parser.renderer;

  parser.core.ruler.push('links', ({ tokens }) => {
    for (const token of tokens.flatMap(({ children }) => children ?? [])) {
      if (token.type !== 'link_open') continue;
      token.attrSet('href', token.attrGet('href').replace(/^([\w-]+)\.md(?=#|$)/, '$1.html'));
    }
  });

  rules.fence = (tokens, index) => {
    const { content, info } = tokens[index];
    const settings = settingsOf(info);
    if (info.startsWith('pictures')) return catalogue.list(settings, content);
    // A block without a language is a drawing and gets no copy button.
    const kind = info === '' ? 'snippet drawing' : 'snippet';
    const snippet = `<div class="${kind}"><pre tabindex="0"><code>${escapeHtml(content)}</code></pre></div>\n`;
    if (settings.picture !== undefined)
      return `<figure class="scene">\n${pictures.add(settings, content, escapeHtml)}${snippet}</figure>\n`;
    if (settings.opens === undefined) return snippet;
    const { part, link } = pictures.addUnseen(settings, content);
    const { frames } = settings;
    if (frames === undefined) return `${snippet}<p class="opens">${link}</p>\n`;
    const words = escapeHtml(String(frames));
    return `${catalogue.sheets(frames, part)}<p>${words} ${link}</p>\n${snippet}`;
  };

  rules.html_block = (tokens, index) =>
    tokens[index].content
      .replace('<!-- scene-reference -->', () => sceneReference())
      .replace('<!-- other-pictures -->', () => catalogue.others());

  // On phones the rows of a wide table are stacked, each cell under the title of its column.
  parser.core.ruler.push('tables', ({ tokens }) => {
    for (const [index, { type }] of tokens.entries()) {
      if (type !== 'table_open') continue;
      const rest = tokens.slice(index);
      const inside = rest.slice(
        0,
        rest.findIndex((each) => each.type === 'table_close'),
      );
      const titles = inside.flatMap((each, at) =>
        each.type === 'th_open' ? [inside[at + 1].content] : [],
      );
      tokens[index].meta = { columns: titles.length };
      let column = 0;
      for (const token of inside) {
        if (token.type === 'tr_open') column = 0;
        if (token.type === 'td_open') token.attrSet('data-label', titles[column++]);
      }
    }
  });
  rules.table_open = (tokens, index) =>
    `<div class="table${tokens[index].meta.columns > 2 ? ' wide' : ''}"><table>\n`;
  rules.table_close = () => '</table></div>\n';
  return parser;
}

export function slugOf(title) {
  return title
    .trim()
    .toLowerCase()
    .replaceAll(/[^\p{Letter}\p{Number}\s_-]/gu, '')
    .replaceAll(/\s/g, '-');
}

// Reads the settings after a fence's language: `name=word`, `name="some words"` or a name alone.
function settingsOf(info) {
  return Object.fromEntries(
    [...info.matchAll(/([\w-]+)(?:=(?:"([^"]*)"|(\S+)))?/g)]
      .slice(1)
      .map(([, name, words, word]) => [name, words ?? word ?? true]),
  );
}
