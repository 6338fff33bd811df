// Turns the table into TypeScript declarations: shapes for pages and Node alike, the element's
// module, and the module for Node.
//
//     const files = declarations(table);
//     // {'shapes.d.ts': text, 'ray-caster.d.ts': text, 'node/index.d.ts': text}

export function declarations(table) {
  const shapes = [
    ...table.types,
    {
      name: 'ErrorCode',
      type: table.errorCodes.map((code) => `'${code}'`).join(' | '),
      description: 'What can go wrong.',
    },
  ];
  return {
    'shapes.d.ts': `// The objects that <ray-caster> and slicecast/node take and return.\n\n${shapes.map(shape).join('\n')}`,
    'ray-caster.d.ts': element(
      table,
      shapes.map(({ name }) => name),
    ),
    'node/index.d.ts': node(
      table.node,
      shapes.map(({ name }) => name),
    ),
  };
}

function shape({ name, type, extends: base, fields, description }) {
  if (fields === undefined) return `${comment(description)}export type ${name} = ${type};\n`;
  return `${comment(description)}export interface ${name}${base ? ` extends ${base}` : ''} {\n${fields
    .map((field) =>
      indented(
        `${comment(field.description)}${field.name}${field.optional ? '?' : ''}: ${field.type};`,
      ),
    )
    .join('\n')}\n}\n`;
}

function element(table, names) {
  const members = [
    ...table.attributes.map(
      ({ name, type, description }) => `${comment(description)}${name}: ${type};`,
    ),
    ...table.properties.map(
      ({ name, type, readonly, description }) =>
        `${comment(description)}${readonly ? 'readonly ' : ''}${name}: ${type};`,
    ),
    ...table.statics.map(
      ({ name, type, description }) => `${comment(description)}static readonly ${name}: ${type};`,
    ),
    ...table.methods.map(method),
  ];
  const events = table.events.map(
    ({ name, detail, description }) => `${comment(description)}${name}: CustomEvent<${detail}>;`,
  );
  const own = table.events.map(({ name }) => `'${name}'`).join(' | ');
  const handlers = table.events.map(
    ({ name, detail, description }) =>
      `${comment(description)}on${name}?: (event: CustomEvent<${detail}>) => void;`,
  );
  const { className } = table;
  return `${importOf(names, './shapes.js', members.join(' ') + events.join(' ') + table.exports.map(({ type }) => type).join(' '))}
export * from './shapes.js';

/** Its own events. */
export type ${className}EventName = ${own};

/** The events of <${table.tag}>, and those of every element. */
export interface ${className}EventMap extends Omit<HTMLElementEventMap, ${className}EventName> {
${events.map(indented).join('\n')}
}

${comment(table.description)}export class ${className} extends HTMLElement {
${members.map(indented).join('\n')}
${['addEventListener', 'removeEventListener'].map((name) => listener(name, className)).join('\n')}
}

/** What JSX may write in the tag to hear its events, besides those of every element. */
export interface ${className}EventAttributes {
${handlers.map(indented).join('\n')}
}

/** What JSX may write in the tag, besides what every element takes. */
export interface ${className}Attributes {
${table.attributes.map(({ name, type, default: standard }) => `  ${name}?: ${type}${standard === null ? ' | boolean' : ''};`).join('\n')}
}

${table.exports
  .filter(({ kind }) => kind === 'constant')
  .map(({ name, type, description }) => `${comment(description)}export const ${name}: ${type};\n`)
  .join('\n')}
declare global {
  interface HTMLElementTagNameMap {
    '${table.tag}': ${className};
  }
}
`;
}

function listener(name, className) {
  const options =
    name === 'addEventListener'
      ? 'boolean | AddEventListenerOptions'
      : 'boolean | EventListenerOptions';
  return `  ${name}<K extends keyof ${className}EventMap>(type: K, listener: (this: ${className}, event: ${className}EventMap[K]) => unknown, options?: ${options}): void;
  ${name}(type: string, listener: EventListenerOrEventListenerObject, options?: ${options}): void;`;
}

function node(api, names) {
  const members = [
    ...api.properties.map(
      ({ name, type, description }) => `${comment(description)}readonly ${name}: ${type};`,
    ),
    ...api.methods.map(method),
  ];
  const types = api.types.map(shape);
  const functions = api.functions.map(
    (one) =>
      `${comment(one.description)}export function ${one.name}(${parameters(one.parameters)}): ${one.returns.type};\n`,
  );
  const ofError = api.error.properties.map(
    ({ name, type, description }) => `${comment(description)}readonly ${name}: ${type};`,
  );
  return `${importOf(names, '../shapes.js', [...members, ...types, ...functions, ...ofError].join(' '))}
export * from '../shapes.js';

${functions.join('\n')}
${types.join('\n')}
/** A scene that is loaded. */
export interface Scene {
${members.map(indented).join('\n')}
}

${comment(api.error.description)}export class ${api.error.name} extends Error {
${ofError.map(indented).join('\n')}
}
`;
}

function method({ name, parameters: all, returns, overloads, description }) {
  if (overloads === undefined)
    return `${comment(description)}${name}(${parameters(all)}): ${returns.type};`;
  return overloads
    .map((one) => `${comment(description)}${name}(${parameters(one.parameters)}): ${one.returns};`)
    .join('\n');
}

function parameters(all) {
  return all
    .map(
      ({ name, type, optional, default: standard }) =>
        `${name}${optional || standard !== undefined ? '?' : ''}: ${type}`,
    )
    .join(', ');
}

// Imports only what the text uses, because strict compilers reject unused imports.
function importOf(names, from, text) {
  const used = names.filter((name) => new RegExp(`\\b${name}\\b`).test(text));
  return `import type { ${used.join(', ')} } from '${from}';\n`;
}

function comment(text) {
  return `/** ${text} */\n`;
}

function indented(text) {
  return text.replace(/^(?=.)/gm, '  ');
}
