// Splits plain rows of characters into levels and legend; rows.js describes how they are written.
//
//     const { levels, size, legend, colours, strays } = readRows(text);
//     const tiles = padded(levels);
//
// readRows also takes a list of rows, or a list of levels of rows; a row may be a list of numbers
// from 0 to 9. If it finds something else, it returns {wrong}, the name of that. `levels` are rows
// as texts of any length; `size` is {width, depth} of the largest. padded() makes rows of single
// characters, all of one length, as many on each level. `legend` holds the legend's lines;
// `strays` are lines that mean nothing.
//
// Rows may come from strangers: readRows takes time linear in the text. Only padded() can take
// more.

import { signsOf } from './signs.js';

// For trimmed lines. Neither pattern backtracks more the longer a line is.
const kSeparator = /^-{3,}\s*(\w*)$/;
const kLegendLine = /^(\S+?)\s*=\s*(\S.*)$/s;

export function readRows(rows) {
  if (typeof rows === 'string') return readText(rows);
  const typed = withRowsAsText(rows);
  const strange = typed.flat().filter((row) => typeof row !== 'string');
  if (strange.length > 0) return { wrong: nameOf(strange[0]) };
  const lists = typed.some((row) => Array.isArray(row) || /\n/.test(row)) ? typed : [typed];
  const levels = lists.map((level) => (Array.isArray(level) ? level : linesOf([level])[0]));
  return { levels, size: sizeOf(levels), legend: {}, colours: false, strays: [] };
}

const isRowOfNumbers = (row) =>
  Array.isArray(row) &&
  row.length > 0 &&
  row.every((one) => Number.isInteger(one) && one >= 0 && one <= 9);

// Rows, or levels of rows, in which rows of numbers are texts: [1, 0, 1] is "101".
function withRowsAsText(rows) {
  const textOf = (row) => (isRowOfNumbers(row) ? row.join('') : row);
  const isLevel = (row) => Array.isArray(row) && !isRowOfNumbers(row);
  return Array.isArray(rows)
    ? rows.map((row) => (isLevel(row) ? row.map(textOf) : textOf(row)))
    : [rows];
}

const nameOf = (value) =>
  typeof value === 'object' && value !== null ? 'an object' : String(value);

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
    const filled = lines.filter((line) => line !== '');
    if (word === 'legend') {
      for (const line of filled) {
        const [, character, meaning] = kLegendLine.exec(line.trim()) ?? [];
        if (character === undefined) strays.push(line.trim());
        else legend[character] = meaning;
      }
    } else if (word === 'colours' || word === 'colors') {
      // Rows that follow it are a level.
      if (filled.length > 0) levels.push(lines);
    } else if (word === '' || word === 'level') {
      levels.push(lines);
    } else {
      strays.push(`--- ${word}`);
      levels.push(lines);
    }
  }
  const first = levels.findIndex((lines) => lines.some((line) => line !== ''));
  const rows = linesOf(levels.slice(first));
  return {
    levels: rows,
    size: sizeOf(rows),
    legend,
    colours: parts.some(({ word }) => /^colou?rs$/.test(word)),
    strays,
  };
}

// Removes the indentation that all rows share, empty rows at the end of each level, and those
// before the first row of the first level.
function linesOf(levels) {
  const lists = levels.map((level) => (Array.isArray(level) ? level : level.split('\n')));
  const isFilled = (line) => line.trim() !== '';
  const indentation = lists
    .flat()
    .filter(isFilled)
    .reduce((least, line) => Math.min(least, /^[ \t]*/.exec(line)[0].length), Infinity);
  return lists.map((lines, level) => {
    const first = level === 0 ? Math.max(0, lines.findIndex(isFilled)) : 0;
    return lines
      .slice(first, lines.findLastIndex(isFilled) + 1)
      .map((line) => line.slice(indentation));
  });
}

// Counts code units, of which some signs take several: the sizes are upper bounds.
function sizeOf(levels) {
  const greatest = (numbers) => numbers.reduce((most, one) => Math.max(most, one), 0);
  return {
    width: greatest(levels.flat().map((row) => row.length)),
    depth: greatest(levels.map((rows) => rows.length)),
  };
}

export function padded(levels) {
  const characters = levels.map((rows) => rows.map(signsOf));
  const { width, depth } = sizeOf(characters);
  return characters.map((rows) =>
    Array.from({ length: depth }, (_, y) => {
      const row = rows[y] ?? [];
      return [...row, ...new Array(width - row.length).fill(' ')];
    }),
  );
}
