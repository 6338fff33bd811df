// Plain rows of characters, taken apart: rows.js says how they are written.
//
//     const { levels, size, legend, colours, strays } = readRows(text);      // or lists of rows, or of levels of rows
//     const tiles = padded(levels);
//
// `levels` are rows as texts, of any length; `size` is what the longest need: {width, depth}. Padded
// they are rows of single characters, all of one length, as many on each level. `legend` is what its
// lines say, `strays` are those that say nothing.
//
// Whoever writes rows may be a stranger: all of this takes a time that grows as the text does, but
// for padding, which must be asked for.

// Of lines without blanks at their ends; none of them is tried in more ways the longer a line is.
const kSeparator = /^-{3,}\s*(\w*)$/;
const kLegendLine = /^(\S+?)\s*=\s*(\S.*)$/s;

export function readRows(rows) {
  if (typeof rows === 'string') return readText(rows);
  const lists = rows.some(Array.isArray)
    ? rows
    : rows.some((row) => /\n/.test(row))
      ? rows
      : [rows];
  const levels = lists.map((level) =>
    (Array.isArray(level) ? level : linesOf([level])[0]).map(String),
  );
  return { levels, size: sizeOf(levels), legend: {}, colours: false, strays: [] };
}

function readText(text) {
  const parts = [{ word: '', lines: [] }];
  for (const line of text.replaceAll('\r', '').split('\n')) {
    const separator = kSeparator.exec(line.trim());
    if (separator === null) parts.at(-1).lines.push(line.trimEnd());
    else parts.push({ word: separator[1].toLowerCase(), lines: [] });
  }
  const legend = Object.create(null); // even __proto__ is a key like others
  const strays = [];
  const levels = [];
  for (const { word, lines } of parts) {
    const told = lines.filter((line) => line !== '');
    if (word === 'legend') {
      for (const line of told) {
        const [, character, meaning] = kLegendLine.exec(line.trim()) ?? [];
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
  const first = levels.findIndex((lines) => lines.some((line) => line !== ''));
  const told = linesOf(levels.slice(first));
  return {
    levels: told,
    size: sizeOf(told),
    legend,
    colours: parts.some(({ word }) => /^colou?rs$/.test(word)),
    strays,
  };
}

// Without the indentation that all of them share, and without empty rows at the end; before the
// first row too, on the first level.
function linesOf(levels) {
  const lists = levels.map((level) => (Array.isArray(level) ? level : level.split('\n')));
  const isTold = (line) => line.trim() !== '';
  const indentation = lists
    .flat()
    .filter(isTold)
    .reduce((least, line) => Math.min(least, /^[ \t]*/.exec(line)[0].length), Infinity);
  return lists.map((lines, level) => {
    const first = level === 0 ? Math.max(0, lines.findIndex(isTold)) : 0;
    return lines
      .slice(first, lines.findLastIndex(isTold) + 1)
      .map((line) => line.slice(indentation));
  });
}

// As many characters as a text has at most: a few take two places in it.
function sizeOf(levels) {
  const greatest = (numbers) => numbers.reduce((most, one) => Math.max(most, one), 0);
  return {
    width: greatest(levels.flat().map((row) => row.length)),
    depth: greatest(levels.map((rows) => rows.length)),
  };
}

export function padded(levels) {
  const characters = levels.map((rows) => rows.map((row) => [...row]));
  const { width, depth } = sizeOf(characters);
  return characters.map((rows) =>
    Array.from({ length: depth }, (_, y) => {
      const row = rows[y] ?? [];
      return [...row, ...new Array(width - row.length).fill(' ')];
    }),
  );
}
