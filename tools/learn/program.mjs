// The reader's raycaster, for the pages: its functions in the state of a chapter, and which of
// their lines the chapter adds.

import { readFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const kFolder = path.resolve('web/learn/raycaster');

export async function readProgram() {
  const { makeStates } = await import(pathToFileURL(path.join(kFolder, 'states.js')));
  const states = makeStates(readFileSync(path.join(kFolder, 'raycaster.txt'), 'utf8'));
  return {
    states,
    functionText: (chapter, name) => states.functionText(chapter, name),
    // Which lines of a function are new in a chapter: a function of the line's index.
    newLines(chapter, name) {
      const lines = states.functionText(chapter, name).split('\n');
      const before =
        chapter > 1 && states.names(chapter - 1).includes(name)
          ? states.functionText(chapter - 1, name).split('\n')
          : [];
      const kept = commonLines(before, lines);
      return (index) => lines[index].trim() !== '' && !kept.has(index);
    },
  };
}

// The indices of lines of `after` that also stand in `before`, in the same order: their longest
// common subsequence.
function commonLines(before, after) {
  const length = Array.from({ length: before.length + 1 }, () =>
    new Array(after.length + 1).fill(0),
  );
  for (let i = before.length - 1; i >= 0; --i)
    for (let j = after.length - 1; j >= 0; --j)
      length[i][j] =
        before[i] === after[j]
          ? length[i + 1][j + 1] + 1
          : Math.max(length[i + 1][j], length[i][j + 1]);
  const common = new Set();
  for (let i = 0, j = 0; i < before.length && j < after.length;) {
    if (before[i] === after[j]) {
      common.add(j);
      i += 1;
      j += 1;
    } else if (length[i + 1][j] >= length[i][j + 1]) i += 1;
    else j += 1;
  }
  return common;
}
