// Turns the table into a page: fills the gaps of page.html.
//
//     const html = documentation({errorCodes, version, options, scenes});
//
// `options` is the engine's list; `scenes` is the index of the shipped scenes.

import { readFileSync } from 'node:fs';

import * as snippets from './examples.mjs';
import { table } from './table.mjs';

const template = readFileSync(new URL('page.html', import.meta.url), 'utf8');

// The names of shapes that types may mention.
const known = new Set([...table.types, ...table.node.types].map(({ name }) => name));

export function documentation({ errorCodes, version, options, scenes }) {
  const gaps = {
    description: text(table.description),
    version,
    apiVersion: table.apiVersion,
    opening: snippets.opening,
    begin: snippet(snippets.begin),
    bundler: snippet(snippets.bundler),
    ownScene: snippet(snippets.ownScene),
    plugin: snippet(snippets.plugin),
    vite: snippet(snippets.vite),
    home: snippet(snippets.home),
    jsx: snippet(snippets.jsx),
    iframe: snippet(snippets.iframe),
    messages: snippet(snippets.messages),
    examples: snippets.live.map(example).join('\n'),
    attributes: rows(
      'attribute',
      ['Attribute', 'Takes', 'Default', 'What it does'],
      table.attributes.map((row) => [
        row.name,
        type(row),
        standard(row.default),
        text(row.description),
      ]),
    ),
    properties: rows(
      'property',
      ['Property', 'Type', 'What it tells'],
      [
        ...table.properties,
        ...table.statics.map((row) => ({ ...row, name: `${table.className}.${row.name}` })),
      ].map((row) => [row.name, type(row), text(row.description)]),
    ),
    methods: rows('method', ['Method', 'Gives', 'What it does'], table.methods.map(method)),
    events: rows(
      'event',
      ['Event', 'Detail', 'What has happened'],
      table.events.map((row) => [row.name, typeText(row.detail), text(row.description)]),
    ),
    slots: table.slots.map(({ description }) => `<p>${text(description)}</p>`).join('\n'),
    ownRows: article(snippets.ownRows),
    objectScene: article(snippets.objectScene),
    inline: article(snippets.inline),
    shipped: rows(
      'shipped',
      ['Scene', 'Tour', 'What it is'],
      scenes.map(({ file, about, tour }) => [
        file.replace(/\.json$/, ''),
        tour ? 'yes' : '',
        text(about),
      ]),
    ),
    rows: rows(
      'rows',
      ['Characters', 'What stands there'],
      table.rows.map((row) => [
        {
          id: null,
          html: row.characters
            .split(' ')
            .map((character) => code(character))
            .join(' '),
        },
        text(row.description),
      ]),
    ),
    cssParts: rows(
      'part',
      ['Part', 'What it is'],
      table.cssParts.map((row) => [row.name, text(row.description)]),
    ),
    cssProperties: rows(
      'css',
      ['Custom property', 'Default', 'What it colours'],
      table.cssProperties.map((row) => [row.name, colour(row.default), text(row.description)]),
    ),
    options: rows(
      'option',
      ['Option', 'Takes', 'Default', 'What it does'],
      options.map((row) => [
        row.name,
        takes(row),
        standard(row.standard),
        sentence(row.description),
      ]),
    ),
    errors: rows(
      'error',
      ['Code', 'What has happened', 'What to do'],
      Object.entries(errorCodes).map(([code, { title, means, remedy }]) => [
        code,
        `<strong>${text(title)}.</strong> ${text(means)}`,
        text(remedy),
      ]),
    ),
    shapes: table.types.map(shape).join('\n'),
    exports: rows(
      'export',
      ['Name', 'Type', 'What it is'],
      table.exports.map((row) => [row.name, typeText(row.type), text(row.description)]),
    ),
    nodeExample: snippet(snippets.node),
    nodeFunctions: rows(
      'node',
      ['Function', 'Gives', 'What it does'],
      table.node.functions.map(method),
    ),
    nodeScene:
      rows(
        'scene',
        ['Member', 'Gives', 'What it does'],
        [
          ...table.node.properties.map((row) => [
            row.name,
            typeText(row.type),
            text(row.description),
          ]),
          ...table.node.methods.map(method),
        ],
      ) + table.node.types.map(shape).join('\n'),
  };
  return template.replace(/\{\{(\w+)\}\}/g, (_, name) => {
    if (!Object.hasOwn(gaps, name))
      throw new Error(`tools/element-api/page.html names a gap that nothing fills: ${name}`);
    return gaps[name];
  });
}

// ---- Cells

function text(plain) {
  return String(plain).replace(
    /[&<>"]/g,
    (character) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[character],
  );
}

function sentence(plain) {
  return text(`${plain[0].toUpperCase()}${plain.slice(1)}.`);
}

function code(plain, attributes = '') {
  return `<code${attributes}>${text(plain)}</code>`;
}

function type(row) {
  return row.values === undefined
    ? typeText(row.type)
    : row.values.map((value) => code(value)).join(' ');
}

function typeText(plain) {
  return code(plain, ' class="type"').replace(/\b[A-Z]\w+\b/g, (name) =>
    known.has(name) ? `<a href="#shape-${name}">${name}</a>` : name,
  );
}

function standard(value) {
  if (value === '' || value === null || value === undefined || value === false)
    return '<span class="none">none</span>';
  return code(value);
}

function colour(value) {
  return `<span class="colour"><svg viewBox="0 0 1 1" aria-hidden="true"><path fill="${text(value)}" d="M0 0h1v1H0z"/></svg>${code(value)}</span>`;
}

// What an option takes.
function takes({ kind, least, greatest, choices }) {
  const range = `${least} to ${greatest}`;
  return {
    onOff: () => `${code('on')} ${code('off')}`,
    number: () => range,
    wholeNumber: () => `whole, ${range}`,
    ownOrNumber: () => `${code('map')} or ${range}`,
    ownOrColour: () => `${code('map')} or ${code('#rrggbb')}`,
    choice: () => choices.map((word) => code(word)).join(' '),
  }[kind]();
}

function method({ name, parameters, returns, needsScene, description }) {
  const list = parameters
    .map(
      (row) =>
        `${row.name}${row.default === undefined ? (row.optional ? '?' : '') : ` = ${JSON.stringify(row.default)}`}`,
    )
    .join(', ');
  const described = parameters.filter((row) => row.description);
  return [
    {
      id: name,
      html: `${code(`${name}(${list})`)}${needsScene ? ' <span class="mark" title="needs a scene">needs a scene</span>' : ''}`,
    },
    typeText(returns.type) + (returns.description ? `<br>${text(returns.description)}` : ''),
    text(description) +
      (described.length === 0
        ? ''
        : `<dl>${described.map((row) => `<dt>${code(row.name)} ${typeText(row.type)}</dt><dd>${text(row.description)}</dd>`).join('')}</dl>`),
  ];
}

// ---- Blocks

// The first cell of a row is a name, or {id, html}; the id is null where nothing leads there.
function rows(kind, titles, all) {
  const body = all.map(([head, ...cells]) => {
    const { id, html } = typeof head === 'string' ? { id: head, html: code(head) } : head;
    const others = cells
      .map((cell, index) => `<td data-label="${text(titles[index + 1])}">${cell}</td>`)
      .join('');
    return `<tr${id === null ? '' : ` id="${kind}-${text(id)}"`}><th scope="row">${html}</th>${others}</tr>`;
  });
  const heads = titles.map((title) => `<th scope="col">${text(title)}</th>`).join('');
  return `<table class="reference ${kind}">\n<thead><tr>${heads}</tr></thead>\n<tbody>\n${body.join('\n')}\n</tbody>\n</table>`;
}

function shape({ name, type: alias, extends: base, fields, description }) {
  const lines =
    fields === undefined
      ? `<p>${typeText(alias)}</p>`
      : `<dl>${fields.map((field) => `<dt>${code(field.name + (field.optional ? '?' : ''))} ${typeText(field.type)}</dt><dd>${text(field.description)}</dd>`).join('')}</dl>`;
  return `<details class="shape" id="shape-${name}"><summary>${code(name)} ${text(description)}</summary>${base ? `<p>All of ${typeText(base)}, and:</p>` : ''}${lines}</details>`;
}

function snippet(source) {
  return `<div class="snippet"><pre tabindex="0"><code>${text(source)}</code></pre></div>`;
}

function article(source) {
  return `<article class="example">\n${source}\n${snippet(source)}\n</article>`;
}

function example({ title, text: about, code: source }) {
  return `<article class="example">\n<h3>${text(title)}</h3>\n<p>${text(about)}</p>\n${source}\n${snippet(source)}\n</article>`;
}
