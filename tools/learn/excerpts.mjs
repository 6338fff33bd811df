// Parts of source files, found by name.

import { readFileSync } from 'node:fs';

const kEnd = /^\s*\/\/ #endregion\b/;

// The lines between `// #region NAME` and `// #endregion` of a file of this repository, without
// their common indentation. Regions do not nest.
export function regionOf(file, name) {
  const lines = readFileSync(file, 'utf8').split('\n');
  const begins = lines.flatMap((line, index) =>
    /^\s*\/\/ #region (\S+)\s*$/.exec(line)?.[1] === name ? [index] : [],
  );
  if (begins.length !== 1)
    throw new Error(`${file}: found ${begins.length} regions "${name}", expected one.`);
  const first = begins[0] + 1;
  const length = lines.slice(first).findIndex((line) => kEnd.test(line));
  if (length < 0) throw new Error(`${file}: the region "${name}" has no // #endregion.`);
  const part = lines.slice(first, first + length);
  const indent = Math.min(
    ...part.filter((line) => line.trim() !== '').map((line) => /^\s*/.exec(line)[0].length),
  );
  return part.map((line) => line.slice(indent)).join('\n');
}
