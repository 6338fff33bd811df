// Messages about words that nobody knows, and about other values that a method cannot take:
//
//     unknown('option', 'fvo', ['fov', 'fog'])
//       // "Unknown option 'fvo'. Did you mean 'fov'?"
//     unknown('control', 'stop', ['play', 'reset'])
//       // "Unknown control 'stop'. Expected play or reset."

const kFewNames = 8; // if no name is near, up to so many are listed

export function unknown(what, word, names) {
  const near = nearestName(word, names);
  const all =
    names.length > kFewNames
      ? ''
      : ` Expected ${names.join(', ').replace(/, (?=[^,]*$)/, ' or ')}.`;
  return `Unknown ${what} '${word}'.${near === null ? all : ` Did you mean '${near}'?`}`;
}

// The name that was probably meant: at most a third of its letters are wrong, missing or swapped
// with their neighbour. null if there is none.
export function nearestName(word, names) {
  let least = Math.max(1, Math.floor(word.length / 3)) + 1;
  let nearest = null;
  for (const name of names) {
    const changes = changesBetween(word.toLowerCase(), name.toLowerCase());
    if (changes >= least || changes >= name.length) continue;
    least = changes;
    nearest = name;
  }
  return nearest;
}

// How many letters to change, add, remove or swap with their neighbour, as in
// src/base/nearest_name.cpp.
function changesBetween(one, other) {
  let twoBefore = [];
  let before = [];
  let row = Array.from({ length: other.length + 1 }, (_, at) => at);
  for (let i = 1; i <= one.length; ++i) {
    [twoBefore, before, row] = [before, row, [i]];
    for (let j = 1; j <= other.length; ++j) {
      row[j] = Math.min(
        before[j] + 1,
        row[j - 1] + 1,
        before[j - 1] + (one[i - 1] === other[j - 1] ? 0 : 1),
      );
      if (i > 1 && j > 1 && one[i - 1] === other[j - 2] && one[i - 2] === other[j - 1])
        row[j] = Math.min(row[j], twoBefore[j - 2] + 1);
    }
  }
  return row[other.length];
}

// The error of a method that was called with something else.
export function misread(method, found, expected) {
  return new RangeError(`${method}: found ${found}, expected ${expected}.`);
}
