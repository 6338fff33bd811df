// Plain rows of characters, taken apart: rows.js says how they are written.
//
//     const { levels, legend, colours, strays } = readRows(text);      // or lists of rows, or of levels of rows
//
// `levels` are rows of single characters, all of one length, as many on each level; `legend` is what
// its lines say, `strays` are those that say nothing.

const kSeparator = /^\s*-{3,}\s*(\w*)\s*$/;
const kLegendLine = /^\s*(\S+?)\s*=\s*(\S.*?)\s*$/;

export function readRows(rows) {
  if (typeof rows === 'string') return readText(rows);
  const lists = rows.some(Array.isArray)
    ? rows
    : rows.some((row) => /\n/.test(row))
      ? rows
      : [rows];
  const levels = lists.map((level) =>
    (Array.isArray(level) ? level : linesOf([level])[0]).map((row) => [...String(row)]),
  );
  return { levels: padded(levels), legend: {}, colours: false, strays: [] };
}

function readText(text) {
  const parts = [{ word: '', lines: [] }];
  for (const line of text.replaceAll('\r', '').split('\n')) {
    const separator = kSeparator.exec(line);
    if (separator === null) parts.at(-1).lines.push(line.trimEnd());
    else parts.push({ word: separator[1].toLowerCase(), lines: [] });
  }
  const legend = {};
  const strays = [];
  const levels = [];
  for (const { word, lines } of parts) {
    const told = lines.filter((line) => line !== '');
    if (word === 'legend') {
      for (const line of told) {
        const [, character, meaning] = kLegendLine.exec(line) ?? [];
        if (character === undefined) strays.push(line.trim());
        else legend[character] = meaning;
      }
    } else if (word === 'colours' || word === 'colors') {
      // What follows it is the first level, where nothing has come yet.
      if (told.length > 0) levels.push(lines);
    } else if (word === '' || word === 'level') {
      levels.push(lines);
    } else {
      strays.push(`--- ${word}`);
      levels.push(lines);
    }
  }
  const isEmpty = (lines) => lines.every((line) => line === '');
  while (levels.length > 1 && isEmpty(levels[0])) levels.shift();
  return {
    levels: padded(linesOf(levels).map((lines) => lines.map((line) => [...line]))),
    legend,
    colours: parts.some(({ word }) => /^colou?rs$/.test(word)),
    strays,
  };
}

// Without the indentation that all of them share, and without empty rows at the end; before the
// first row too, on the first level.
function linesOf(levels) {
  const lists = levels.map((level) => (Array.isArray(level) ? level : level.split('\n')));
  const indentation = Math.min(
    ...lists
      .flat()
      .filter((line) => line.trim() !== '')
      .map((line) => /^[ \t]*/.exec(line)[0].length),
  );
  return lists.map((lines, level) => {
    const isTold = (line) => line.trim() !== '';
    const first = level === 0 ? Math.max(0, lines.findIndex(isTold)) : 0;
    return lines
      .slice(first, lines.findLastIndex(isTold) + 1)
      .map((line) => line.slice(indentation));
  });
}

function padded(levels) {
  const width = Math.max(0, ...levels.flat().map((row) => row.length));
  const depth = Math.max(0, ...levels.map((rows) => rows.length));
  return levels.map((rows) =>
    Array.from({ length: depth }, (_, y) => {
      const row = rows[y] ?? [];
      return [...row, ...new Array(width - row.length).fill(' ')];
    }),
  );
}
