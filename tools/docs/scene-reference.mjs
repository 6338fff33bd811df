// Makes the reference of scenes from their JSON Schema: a table for each kind of object, with a row
// for each key. The examples come from the shipped scenes.

import { readFileSync, readdirSync } from 'node:fs';

import { keyExamples } from './schema-examples.mjs';
import { objectKinds } from './schema-kinds.mjs';

const kSchema = 'assets/scene.schema.json';
const kScenes = 'assets/scenes';
// These have every key.
const kAlsoExamples = ['tests/scene/everything.json', 'tests/scene/named-places.json'];
// The guide's sections that explain a kind.
const kGuide = {
  scene: 'scenes.md#a-first-scene',
  texture: 'scenes.md#textures-that-move',
  sprite: 'scenes.md#objects',
  motion: 'scenes.md#movers',
  blueprint: 'scenes.md#blocks-and-heights',
  face: 'scenes.md#light-on-faces',
  faces: 'scenes.md#light-on-faces',
  gate: 'scenes.md#gates',
  water: 'scenes.md#water',
  map: 'scenes.md#levels',
  floor: 'scenes.md#floor-and-ceiling',
  ceiling: 'scenes.md#floor-and-ceiling',
  object: 'scenes.md#objects',
  objectMotion: 'scenes.md#objects-that-move',
  sown: 'scenes.md#sowing',
  portal: 'scenes.md#portals',
  to: 'scenes.md#portals',
  sky: 'scenes.md#sky',
  light: 'scenes.md#light',
  fog: 'scenes.md#fog-and-haze',
};

export function sceneReference() {
  const schema = JSON.parse(readFileSync(kSchema, 'utf8'));
  const kinds = objectKinds(schema);
  const files = readdirSync(kScenes)
    .filter((name) => name.endsWith('.json') && name !== 'index.json')
    .map((name) => `${kScenes}/${name}`);
  const read = (file) => JSON.parse(readFileSync(file, 'utf8'));
  const examples = keyExamples(schema, files.map(read), kAlsoExamples.map(read));
  return kinds.map((kind) => section(kind, kinds, examples)).join('\n');
}

function section({ id, title, description, keys }, kinds, examples) {
  // Every object may have a comment and data; one row for all is enough.
  const listed = keys.filter(({ name }) => !['comment', 'data'].includes(name) || id === 'scene');
  const rows = listed.map((key) => row(id, key, kinds, examples.get(`${id}.${key.name}`)));
  const guide = kGuide[id]?.replace('.md', '.html');
  const heads = ['Key', 'Takes', 'Default', 'Example', 'What it does'];
  return `<h2 id="${id}">${text(title)}</h2>
<p>${marked(description)}${guide ? ` <a href="${guide}">In the guide, with a picture.</a>` : ''}</p>
<table class="reference keys">
<thead><tr>${heads.map((head) => `<th scope="col">${head}</th>`).join('')}</tr></thead>
<tbody>
${rows.join('\n')}
</tbody>
</table>`;
}

function row(id, { name, node, required, description, standard }, kinds, example) {
  const cells = [
    ['Takes', takes(node, kinds)],
    [
      'Default',
      required
        ? '<strong>required</strong>'
        : standard === undefined
          ? '<span class="none">none</span>'
          : code(JSON.stringify(standard)),
    ],
    ['Example', example === undefined ? '<span class="none">none</span>' : code(example)],
    ['What it does', marked(description)],
  ];
  return `<tr id="${id}-${name.replace('$', '')}"><th scope="row">${code(name)}</th>${cells.map(([label, html]) => `<td data-label="${label}">${html}</td>`).join('')}</tr>`;
}

// ---- Types in words

function takes(node, kinds) {
  const kind = kinds.find(({ nodes }) => nodes.includes(node));
  const object = kind && `an object: <a href="#${kind.id}">${text(kind.title)}</a>`;
  if (node.enum) return node.enum.map((value) => code(JSON.stringify(value))).join(' ');
  if (node.said) return node.said;
  if (node.variants)
    return [...new Set(node.variants.map((each) => takes(each, kinds)))].join(', or ');
  switch (node.type) {
    case 'boolean':
      return `${code('true')} or ${code('false')}`;
    case 'integer':
      return `a whole number, ${range(node)}`;
    case 'number':
      return `a number, ${range(node)}`;
    case 'string':
      return node.maxLength === undefined ? 'text' : `text, up to ${node.maxLength} characters`;
    case 'array':
      return `a list${length(node)}, each ${takes(node.items, kinds)}`;
    case 'object':
      return object ?? `names, each with ${takes(node.values, kinds)}`;
    default:
      throw new Error(`${kSchema}: a node without a type that the reference can tell`);
  }
}

function length({ minItems, maxItems }) {
  if (maxItems === undefined) return minItems === undefined ? '' : ` of at least ${minItems}`;
  return minItems === maxItems ? ` of ${maxItems}` : ` of ${minItems ?? 0} to ${maxItems}`;
}

function range({ minimum, exclusiveMinimum, maximum }) {
  const least =
    exclusiveMinimum === undefined
      ? `${rounded(minimum)} to `
      : `above ${exclusiveMinimum}, up to `;
  return least + rounded(maximum);
}

function rounded(value) {
  return Number.isInteger(value) ? value : Number(value.toPrecision(3));
}

// ---- HTML

function text(plain) {
  return String(plain).replace(
    /[&<>]/g,
    (character) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;' })[character],
  );
}

function code(plain) {
  return `<code>${text(plain)}</code>`;
}

// Marks up quoted words of a description as code: they are keys and values.
function marked(plain) {
  return text(plain).replaceAll(/"([^"]+)"/g, (_, word) => code(word));
}
