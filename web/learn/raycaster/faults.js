// Named wrong ways, for the sections "what goes wrong without it": text replacements in a state.

import { asBody } from './states.js';

export const faults = {};

// The answer of a chapter with a fault in it. Throws if a text that it replaces does not occur
// exactly once.
export function faultyText(states, name, chapter = faults[name]?.chapter) {
  const fault = faults[name];
  if (!fault) throw new Error(`There is no fault ${name}.`);
  return fault.change.reduce((text, [find, put]) => {
    if (text.split(find).length !== 2)
      throw new Error(`${name}: in chapter ${chapter} this does not occur once: ${find}`);
    return text.replace(find, () => put);
  }, states.answer(chapter));
}

// A program's functions, for tests under Node.
export function program(text) {
  return new Function(asBody(text))();
}
