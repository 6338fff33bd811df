// Takes the reader's program of one chapter into the next, which changes functions of its own.
//
//     carry(text, { start, newIn, dropped })
//
// gives the start of the next chapter with the reader's functions wherever the chapter leaves them
// as they were, and with whatever else the reader has added. `dropped` are the names of functions
// that the chapter no longer has.

import { functionsOf } from '../raycaster/states.js';

export function carry(text, { start, newIn, dropped }) {
  const fresh = new Set(newIn.map(({ name }) => name));
  const mine = functionsOf(text);
  let whole = start;
  for (const { name, text: ours } of functionsOf(start)) {
    const own = mine.find((each) => each.name === name);
    if (own !== undefined && !fresh.has(name)) whole = whole.replace(ours, () => own.text);
  }

  const known = new Set([...functionsOf(start).map(({ name }) => name), ...dropped]);
  const added = mine.filter(({ name }) => !known.has(name)).map((each) => each.text);
  let outside = text;
  for (const each of mine) outside = outside.replace(each.text, () => '');
  const starts = new Set(start.split('\n'));
  const lines = outside
    .split('\n')
    .filter((line) => line.trim() !== '' && !line.startsWith('//') && !starts.has(line));
  const before = lines.length > 0 ? `${lines.join('\n')}\n\n` : '';
  const after = added.map((each) => `\n${each}\n`).join('');
  return `${before}${whole}${after}`;
}
