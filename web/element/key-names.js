// The names of keys, one by one, from the engine's list of them.

const kOfTwoWords = /^(Page|Number) /;

// "A D, Page Up" names three keys.
export function splitKeys(names) {
  return names
    .split(', ')
    .flatMap((group) => (kOfTwoWords.test(group) ? [group] : group.split(' ')));
}
