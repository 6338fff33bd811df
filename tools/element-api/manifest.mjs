// Turns the table into a custom elements manifest, which editors use to complete the tag:
// custom-elements.json, schema 1.0.
//
//     const manifest = customElementsManifest(table);

export function customElementsManifest(table) {
  const { className, tag, module: path } = table;
  const here = { name: className, module: path };
  return {
    schemaVersion: '1.0.0',
    modules: [
      {
        kind: 'javascript-module',
        path,
        declarations: [
          {
            kind: 'class',
            customElement: true,
            name: className,
            tagName: tag,
            superclass: { name: 'HTMLElement' },
            description: table.description,
            attributes: table.attributes.map((row) => ({ ...typed(row), fieldName: row.name })),
            members: [
              ...table.attributes.map((row) => ({
                kind: 'field',
                ...typed(row),
                attribute: row.name,
                reflects: true,
              })),
              ...table.properties.map((row) => ({
                kind: 'field',
                ...typed(row),
                readonly: row.readonly === true,
              })),
              ...table.statics.map(({ name, type, description }) => ({
                kind: 'field',
                name,
                static: true,
                readonly: true,
                type: { text: type },
                description,
              })),
              ...table.methods.map(method),
            ],
            events: table.events.map(({ name, detail, description }) => ({
              name,
              type: { text: `CustomEvent<${detail}>` },
              description,
            })),
            slots: table.slots.map(({ name, description }) => ({ name, description })),
            cssParts: table.cssParts.map(({ name, description }) => ({ name, description })),
            cssProperties: table.cssProperties.map(
              ({ name, syntax, default: standard, description }) => ({
                name,
                syntax,
                default: standard,
                description,
              }),
            ),
          },
          ...table.exports
            .filter(({ kind }) => kind === 'constant')
            .map(({ name, type, description }) => ({
              kind: 'variable',
              name,
              type: { text: type },
              description,
            })),
        ],
        exports: [
          ...table.exports.map(({ name }) => ({
            kind: 'js',
            name,
            declaration: { name, module: path },
          })),
          { kind: 'custom-element-definition', name: tag, declaration: here },
        ],
      },
    ],
  };
}

function typed({ name, type, default: standard, description }) {
  return { name, type: { text: type }, default: JSON.stringify(standard), description };
}

function method({ name, parameters, returns, description }) {
  return {
    kind: 'method',
    name,
    description,
    parameters: parameters.map(({ optional, default: standard, type, ...row }) => ({
      ...row,
      type: { text: type },
      ...(optional ? { optional } : {}),
      ...(standard === undefined ? {} : { default: JSON.stringify(standard) }),
    })),
    return: {
      type: { text: returns.type },
      ...(returns.description ? { description: returns.description } : {}),
    },
  };
}
