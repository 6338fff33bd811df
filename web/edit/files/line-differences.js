// Where two texts differ, line by line. Takes texts; gives places.
//
//     differencesOf(one, other)       // [{one: {from, lines}, other: {from, lines}}, ...]
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
