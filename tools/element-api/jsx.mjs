// The element in JSX: a module of type declarations for each library whose JSX has its own table of
// elements. Importing one imports the element.
//
//     const files = jsxDeclarations(table);      // {'jsx/react.d.ts': text, ...}

// All of these libraries set properties of the element and listen to events as `on` and the event's
// name: onready.
const kLibraries = {
  react: { attributes: 'HTMLAttributes', reference: 'RefAttributes' },
  preact: { attributes: 'JSX.HTMLAttributes', reference: null },
  'solid-js': { attributes: 'JSX.HTMLAttributes', reference: null, prefix: 'on:' },
};

export function jsxDeclarations(table) {
  return Object.fromEntries(
    Object.entries(kLibraries).map(([library, settings]) => [
      `jsx/${library}.d.ts`,
      declarations(table, library, settings),
    ]),
  );
}

function declarations({ tag, className }, library, { attributes, reference, prefix }) {
  const [imported] = attributes.split('.');
  const names = [imported, ...(reference === null ? [] : [reference])];
  const own = [
    `${className}Attributes`,
    `${className}EventAttributes`,
    ...(prefix === undefined
      ? []
      : [
          `{ [Name in ${className}EventName as \`${prefix}\${Name}\`]?: (event: ${className}EventMap[Name]) => void }`,
        ]),
  ];
  const imports = [
    className,
    `${className}Attributes`,
    `${className}EventAttributes`,
    ...(prefix === undefined ? [] : [`${className}EventMap`, `${className}EventName`]),
  ];
  const rest = `Omit<${attributes}<${className}>, keyof (${own.join(' & ')})>`;
  const all = [...own, rest, ...(reference === null ? [] : [`${reference}<${className}>`])];
  return `import type { ${names.join(', ')} } from '${library}';
import type { ${imports.join(', ')} } from '../ray-caster.js';

export * from '../ray-caster.js';

declare module '${library}' {
  namespace JSX {
    interface IntrinsicElements {
      '${tag}': ${all.join(' &\n        ')};
    }
  }
}
`;
}
