// The changes that make one value of a scene into another, where only what differs is set.
// Takes two values; gives changes. Knows no document.
//
//     differences(before, after, ['maps', 0])
//
// What is undefined in `after`, also in a list, is removed; lists grow at their end alone.

export function differences(before, after, path) {
  const values = [];
  const removed = [];
  compare(before, after, path);
  const set = values.length > 0 ? [{ together: values }] : [];
  return [...set, ...removed.reverse()]; // the last ones first

  function compare(one, other, at) {
    if (one === other) return;
    if (other === undefined) {
      removed.push({ path: at, value: undefined });
      return;
    }
    const isList = Array.isArray(one) && Array.isArray(other);
    const isObject = !isList && isPlain(one) && isPlain(other);
    const isEmpty = (isList || isObject) && Object.keys(one).length === 0;
    if ((!isList && !isObject) || isEmpty || (isList && hasTexts(one, other))) {
      if (JSON.stringify(one) !== JSON.stringify(other))
        values.push({
          path: at,
          value: isList ? other.filter((part) => part !== undefined) : other,
        });
      return;
    }
    const keys = isList ? other.keys() : new Set([...Object.keys(one), ...Object.keys(other)]);
    if (isList) {
      const gone = [...one.keys()].filter((index) => other[index] === undefined);
      if (gone.length > 0) removed.push({ path: at, removed: gone });
    }
    for (const key of keys)
      if (!isList || other[key] !== undefined) compare(one[key], other[key], [...at, key]);
  }
}

const isPlain = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

// Rows of tiles are set together.
const hasTexts = (one, other) => [...one, ...other].every((part) => typeof part === 'string');
