// What a strict compiler says of a few lines that use the built declarations.
//
//     complaints(`import type { View } from './shapes.js'; const view: View = {...};`)      // [] if all is well

import path from 'node:path';
import { fileURLToPath } from 'node:url';
import ts from 'typescript';

const kPage = fileURLToPath(new URL('../../build/web/', import.meta.url));
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

// The lines stand, as it were, in a file of the page's folder.
export function complaints(lines) {
  const file = path.join(kPage, 'test-lines.ts');
  const host = ts.createCompilerHost(kOptions);
  const { getSourceFile, fileExists, readFile } = host;
  host.getSourceFile = (name, ...more) =>
    name === file
      ? ts.createSourceFile(name, lines, kOptions.target)
      : getSourceFile(name, ...more);
  host.fileExists = (name) => name === file || fileExists(name);
  host.readFile = (name) => (name === file ? lines : readFile(name));
  const program = ts.createProgram([file], kOptions, host);
  return ts.getPreEmitDiagnostics(program).map(({ messageText, start, file: at }) => {
    const line =
      at === undefined
        ? ''
        : `${path.basename(at.fileName)}:${at.getLineAndCharacterOfPosition(start).line + 1}: `;
    return `${line}${ts.flattenDiagnosticMessageText(messageText, ' ')}`;
  });
}
