// The errors of a strict compiler in a few lines that use the built declarations.
//
//     complaints(`import type { View } from './shapes.js'; const view: View = {...};`)
//                                                            // [] without errors
//     complaints(`<ray-caster keys="some" />`, 'react')      // JSX of that library

import path from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

const kPage = fileURLToPath(new URL('../../build/web/', import.meta.url));
const kPackages = fileURLToPath(new URL('../node_modules/', import.meta.url));
const kJsx = {
  react: { jsx: ts.JsxEmit.ReactJSX, jsxImportSource: 'react' },
  preact: { jsx: ts.JsxEmit.ReactJSX, jsxImportSource: 'preact' },
  solid: { jsx: ts.JsxEmit.Preserve, jsxImportSource: 'solid-js' },
};
// The page's folder has no packages.
const kPaths = {
  react: [`${kPackages}@types/react/index.d.ts`],
  'react/*': [`${kPackages}@types/react/*.d.ts`],
  preact: [`${kPackages}preact/src/index.d.ts`],
  'preact/jsx-runtime': [`${kPackages}preact/jsx-runtime/src/index.d.ts`],
  'solid-js': [`${kPackages}solid-js/types/index.d.ts`],
  'solid-js/jsx-runtime': [`${kPackages}solid-js/types/jsx.d.ts`],
};
const kOptions = {
  strict: true,
  noEmit: true,
  noUnusedLocals: true,
  exactOptionalPropertyTypes: true,
  target: ts.ScriptTarget.ES2022,
  lib: ['lib.es2022.d.ts', 'lib.dom.d.ts', 'lib.dom.iterable.d.ts'],
  module: ts.ModuleKind.NodeNext,
  moduleResolution: ts.ModuleResolutionKind.NodeNext,
  types: [],
};

// Compiles the lines as a file in the page's folder.
export function complaints(lines, library = null) {
  const file = path.join(kPage, library === null ? 'test-lines.ts' : 'test-lines.tsx');
  const options =
    library === null
      ? kOptions
      : { ...kOptions, ...kJsx[library], paths: kPaths, skipLibCheck: false };
  const host = ts.createCompilerHost(options);
  const { getSourceFile, fileExists, readFile } = host;
  host.getSourceFile = (name, ...more) =>
    name === file
      ? ts.createSourceFile(name, lines, kOptions.target)
      : getSourceFile(name, ...more);
  host.fileExists = (name) => name === file || fileExists(name);
  host.readFile = (name) => (name === file ? lines : readFile(name));
  const program = ts.createProgram([file], options, host);
  return ts.getPreEmitDiagnostics(program).map(({ messageText, start, file: at }) => {
    const line =
      at === undefined
        ? ''
        : `${path.basename(at.fileName)}:${at.getLineAndCharacterOfPosition(start).line + 1}: `;
    return `${line}${ts.flattenDiagnosticMessageText(messageText, ' ')}`;
  });
}
