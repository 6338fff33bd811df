// The faulty scenes that broken/cases.txt lists, with the faults expected of each.
//
//     for (const { name, bytes, verdict, faults } of brokenScenes()) ...

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

// Image names are relative to it.
export const brokenScenesFolder = join(dirname(fileURLToPath(import.meta.url)), 'broken');

export function brokenScenes() {
  const lines = readFileSync(join(brokenScenesFolder, 'cases.txt'), 'utf8')
    .split('\n')
    .filter((line) => !line.startsWith('#'));
  const cases = lines.join('\n').trim().split(/\n\n+/);
  return cases.map((text) => readCase(text));
}

function readCase(text) {
  const [, name, file, verdict] = /^(\S+): (\S+), (.*)/.exec(text);
  let bytes = readFileSync(join(brokenScenesFolder, file));
  for (const [, from, to] of text.matchAll(/((?:^-.*\n)+)((?:^\+.*\n)+)/gm)) {
    const pieces = bytes.toString().split(inner(from));
    assert.equal(pieces.length, 2, `${name}: does not stand exactly once in the file:\n${from}`);
    bytes = Buffer.from(pieces.join(inner(to)));
  }
  const faults = text.split('\n').filter((line) => /^\d/.test(line));
  return { name, bytes, verdict, faults };
}

// The lines of a change without the signs before them.
const inner = (lines) => lines.slice(0, -1).replaceAll(/^[-+] ?/gm, '');
