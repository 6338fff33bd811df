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
  return [
    ...(values.length > 0 ? [{ values }] : []),
    ...removed.reverse().map((gone) => ({ path: gone, value: undefined })), // the last ones first
  ];

  function compare(one, other, at) {
    if (one === other) return;
    if (other === undefined) {
      removed.push(at);
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
    for (const key of keys) compare(one[key], other[key], [...at, key]);
    if (isList)
      for (let index = other.length; index < one.length; ++index) removed.push([...at, index]);
  }
}

const isPlain = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

// Rows of tiles are set together.
const hasTexts = (one, other) => [...one, ...other].every((part) => typeof part === 'string');
