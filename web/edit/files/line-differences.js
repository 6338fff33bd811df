// Where two texts differ, line by line, and what two changes of one text are together. Takes texts;
// gives places, and a text.
//
//     differencesOf(one, other)       // [{one: {from, lines}, other: {from, lines}}, ...]
//     merged(base, mine, theirs)      // null if both have changed the same lines, or neighbours
//
// `from` counts lines from 1. If the texts differ in more than a comparison can hold, the part in
// between counts as one place.

const kMostPairs = 4e6; // of lines that are compared with each other

export function differencesOf(one, other) {
  const [a, b] = [one.split('\n'), other.split('\n')];
  let begin = 0;
  while (begin < a.length && begin < b.length && a[begin] === b[begin]) ++begin;
  let tail = 0;
  while (
    tail < Math.min(a.length, b.length) - begin &&
    a[a.length - 1 - tail] === b[b.length - 1 - tail]
  )
    ++tail;
  const [ours, theirs] = [a.slice(begin, a.length - tail), b.slice(begin, b.length - tail)];
  if (ours.length === 0 && theirs.length === 0) return [];
  const pairs = ours.length * theirs.length <= kMostPairs ? pairsOf(ours, theirs) : [];
  const found = [];
  let [i, j] = [0, 0];
  for (const [nextI, nextJ] of [...pairs, [ours.length, theirs.length]]) {
    if (nextI > i || nextJ > j)
      found.push({
        one: { from: begin + i + 1, lines: ours.slice(i, nextI) },
        other: { from: begin + j + 1, lines: theirs.slice(j, nextJ) },
      });
    [i, j] = [nextI + 1, nextJ + 1];
  }
  return found;
}

export function merged(base, mine, theirs) {
  const begin = ({ one }) => one.from;
  const end = ({ one }) => one.from + one.lines.length;
  const all = [...differencesOf(base, mine), ...differencesOf(base, theirs)]
    .sort((a, b) => begin(a) - begin(b) || end(a) - end(b))
    .filter((place, at, list) => at === 0 || !isSame(place, list[at - 1]));
  if (all.some((place, at) => at > 0 && begin(place) <= end(all[at - 1]))) return null;
  const lines = base.split('\n');
  for (const place of all.reverse())
    lines.splice(begin(place) - 1, place.one.lines.length, ...place.other.lines);
  return lines.join('\n');
}

// What both have done.
function isSame(place, { one, other }) {
  const said = [place.one, place.other.lines];
  return JSON.stringify(said) === JSON.stringify([one, other.lines]);
}

// The longest row of lines that both have, as pairs of places.
function pairsOf(ours, theirs) {
  const width = theirs.length + 1;
  const lengths = new Uint32Array((ours.length + 1) * width);
  for (let i = ours.length - 1; i >= 0; --i)
    for (let j = theirs.length - 1; j >= 0; --j)
      lengths[i * width + j] =
        ours[i] === theirs[j]
          ? lengths[(i + 1) * width + j + 1] + 1
          : Math.max(lengths[(i + 1) * width + j], lengths[i * width + j + 1]);
  const pairs = [];
  for (let i = 0, j = 0; i < ours.length && j < theirs.length;) {
    if (ours[i] === theirs[j]) pairs.push([i++, j++]);
    else if (lengths[(i + 1) * width + j] >= lengths[i * width + j + 1]) ++i;
    else ++j;
  }
  return pairs;
}
