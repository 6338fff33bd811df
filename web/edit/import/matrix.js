// Reads maps that people paste from programs and courses into a draft: numbers in the brackets of
// any language, rows of numbers, csv, and rows of characters.
//
//     readMatrix('int map[2][3] = {{1,1,1},\n{1,0,1}};', 'map.c')          // a draft
//
// Several matrices of one size, also those within another one, are levels, the lowest first. It
// reads only numbers, texts and brackets, so it runs nothing.

import { startDraft } from './draft.js';
import { ImportError, quoted } from './import-error.js';
import { kMostLayers, kMostNesting, kMostSide } from './import-limits.js';
import { titleOf } from './titles.js';
import { signsOf } from '../../engine/signs.js';

const kMostText = 2 ** 22; // characters: more than people paste
const kMostKinds = 512; // of numbers or characters; a matrix of heights or random text has more
// For the numbers and characters that stand for no texture of their own, the commonest first.
const kTextures = [
  'stone-blocks-worn',
  'brick-weathered',
  'planks-wall',
  'sandstone',
  'stone-rubble',
  'timber-frame',
  'metal-plates',
  'hedge',
  'plaster-warm',
  'brick-mossy',
  'marble-dark',
  'stone-blocks-dark',
  'bookshelf',
  'rock',
];
const kEmpty = new Set(['', '0', '-1', '.', ' ', '_', '-', ',']);
const kHeadings = { N: 270, E: 0, S: 90, W: 180, '^': 270, '>': 0, v: 90, '<': 180 };
const kStarts = new Set([...Object.keys(kHeadings), '@', 'P', 'p']);

export function readMatrix(text, file) {
  if (text.length > kMostText)
    throw new ImportError(
      file,
      '',
      `${text.length} characters`,
      `at most ${kMostText} of a matrix`,
    );
  const code = withoutComments(text);
  const found = matricesIn(code, file) ?? rowsIn(text, file);
  if (found === null)
    throw new ImportError(file, '', quoted(text.trim().slice(0, 60)), 'rows of a map');
  const { format, levels } = found;
  const width = levels.flat().reduce((most, row) => Math.max(most, row.length), 0);
  const depth = levels.reduce((most, rows) => Math.max(most, rows.length), 0);
  const draft = startDraft(file, format, titleOf(new Map(), file));
  if (levels.length > kMostLayers)
    throw new ImportError(file, '', `${levels.length} levels`, `at most ${kMostLayers}`);
  const map = {
    name: draft.title,
    width,
    depth,
    background: null,
    floor: 'flagstones',
    comment: '',
    cells: [],
    objects: [],
  };
  for (const rows of levels) {
    const level = draft.layers.length;
    draft.room(`level ${level}`, width, depth);
    const layer = draft.layer({
      name: levels.length === 1 ? 'map' : `level ${level}`,
      use: 'level',
      level,
    });
    const cells = new Uint32Array(width * depth);
    let short = 0;
    for (let y = 0; y < depth; ++y) {
      const row = rows[y] ?? [];
      if (row.length < width) short += 1;
      row.forEach((value, x) => {
        cells[y * width + x] = draft.kind(value, () => ({
          name: value,
          size: null,
        }));
      });
    }
    if (short > 0) draft.note(`level ${level}`, `${short} short rows are filled up with nothing`);
    if (draft.kinds.length > kMostKinds)
      throw new ImportError(
        file,
        '',
        `${draft.kinds.length} different numbers or characters`,
        `at most ${kMostKinds}`,
      );
    map.cells[layer] = cells;
  }
  draft.map(map);
  giveMeanings(draft, map, format);
  return draft;
}

// Nought and the usual signs are empty; without any of them, the commonest thing inside is.
function giveMeanings(draft, map, format) {
  const counts = draft.kinds.map(() => 0);
  const inside = draft.kinds.map(() => 0);
  for (const cells of map.cells)
    cells.forEach((kind, index) => {
      if (kind === 0) return;
      counts[kind - 1] += 1;
      const [x, y] = [index % map.width, Math.floor(index / map.width)];
      if (x > 0 && y > 0 && x < map.width - 1 && y < map.depth - 1) inside[kind - 1] += 1;
    });
  const isStart = ({ name }, index) =>
    format === 'characters' && kStarts.has(name) && counts[index] === 1;
  const start = draft.kinds.findIndex(isStart);
  const hasEmpty = draft.kinds.some(({ name }) => kEmpty.has(name));
  const commonest = inside.indexOf(inside.reduce((most, one) => Math.max(most, one), 0));
  const order = draft.kinds.map((_, index) => index).sort((a, b) => counts[b] - counts[a]);
  let next = 0;
  const give = (kind) => {
    kind.show = kTextures[next % kTextures.length];
    next += 1;
  };
  const unseen = [];
  for (const index of order) {
    const kind = draft.kinds[index];
    if (kEmpty.has(kind.name) || (!hasEmpty && index === commonest && inside[index] > 0)) {
      kind.use = 'empty';
      unseen.push(kind);
    } else if (index === start) {
      kind.use = 'start';
      kind.heading = kHeadings[kind.name] ?? 0;
      unseen.push(kind);
    } else {
      give(kind);
    }
  }
  for (const kind of unseen) give(kind); // a dialog may make blocks of them
}

// ---- Brackets

// Each pattern here takes time linear in the text. `#` is a wall more often than a comment.
function withoutComments(text) {
  return text.replaceAll(/\/\*[^]*?(?:\*\/|$)|\/\/.*|--.*/g, ' ');
}

const kToken =
  /[[{(]|[\]})]|"[^"\n]*"|'[^'\n]*'|[-+]?(?:0x[\da-f]+|\d+(?:\.\d+)?)|\n|[^\s\d"'[\](){}+-]+|./gi;

// Finds the lists of lists of numbers, or of texts, in code; null if there are none.
function matricesIn(code, file) {
  const found = [];
  const open = [{ values: [], rows: [], lines: [[]], isPlain: true }];
  for (const [token] of code.matchAll(kToken)) {
    const top = open.at(-1);
    if (/^[[{(]$/.test(token)) {
      if (open.length > kMostNesting)
        throw new ImportError(file, '', 'brackets within brackets', `at most ${kMostNesting} deep`);
      open.push({ values: [], rows: [], lines: [[]], isPlain: true });
    } else if (/^[\]})]$/.test(token)) {
      if (open.length === 1) continue;
      open.pop();
      close(top, open.at(-1), found);
    } else if (token === '\n') {
      if (top.lines.at(-1).length > 0) top.lines.push([]);
    } else if (/^["']/.test(token)) {
      add(top, { text: token.slice(1, -1) });
    } else if (/\d$|^0x/i.test(token)) {
      add(top, { number: String(Number(token)) });
    } else if (/[^\s,;+-]/.test(token)) {
      top.isPlain = false; // a word: what is around it is no row
    }
  }
  while (open.length > 1) {
    const top = open.pop();
    close(top, open.at(-1), found);
  }
  // Rows without a bracket around all of them; plain numbers are not code.
  const [whole] = open;
  if (found.length === 0 && (whole.rows.length > 1 || isTexts(whole.values)))
    close(whole, { rows: [] }, found);
  if (found.length === 0) return null;
  const [first] = [...found].sort((a, b) => b.rows.length - a.rows.length);
  const sizeOf = ({ rows }) => `${rows.length}`;
  return {
    format: first.format,
    levels: found.filter((one) => sizeOf(one) === sizeOf(first)).map(({ rows }) => rows),
  };
}

function add(group, value) {
  group.values.push(value);
  group.lines.at(-1).push(value);
}

const isNumbers = (values) =>
  values.length > 0 && values.every(({ number }) => number !== undefined);
const isTexts = (values) =>
  values.length > 0 && values.every(({ text }) => text !== undefined && text.length > 0);

// A closed bracket is a row of the one around it, a matrix, or neither.
function close(group, outer, found) {
  const { values, rows, lines, isPlain } = group;
  if (rows.length > 0) {
    found.push({ format: group.hasSigns ? 'characters' : 'numbers', rows });
    return;
  }
  const filled = lines.filter((line) => line.length > 0);
  if (isTexts(values) && values.length > 1) {
    const isOfCharacters = values.every(({ text }) => signsOf(text).length > 1);
    if (isOfCharacters)
      found.push({ format: 'characters', rows: values.map(({ text }) => signsOf(text)) });
    else {
      // A row of single characters: ['#', '.', '#']
      outer.rows.push(values.map(({ text }) => text));
      outer.hasSigns = true;
    }
  } else if (isNumbers(values) && isPlain) {
    const isFlat = filled.length > 2 && filled.every((line) => line.length === filled[0].length);
    if (isFlat && filled[0].length > 1)
      found.push({
        format: 'numbers',
        rows: filled.map((line) => line.map(({ number }) => number)),
      });
    else if (values.length > 1) outer.rows.push(values.map(({ number }) => number));
  }
}

// ---- Rows without brackets

function rowsIn(text, file) {
  const blocks = text
    .replaceAll('\r', '')
    .split(/\n[ \t]*\n/)
    .map((block) => block.split('\n').filter((line) => line.trim() !== ''))
    .filter((lines) => lines.length > 0);
  if (blocks.length === 0) return null;
  for (const lines of blocks)
    if (lines.length > kMostSide)
      throw new ImportError(file, '', `${lines.length} rows`, `at most ${kMostSide}`);
  const lines = blocks.flat();
  const isNumeric = lines.every((line) => /^[\s\d.,;+-]+$/.test(line) && /\d/.test(line));
  const isSeparated = lines.some((line) => /\d[\s,;]+[-+]?\d/.test(line));
  if (isNumeric && isSeparated)
    return { format: 'numbers', levels: blocks.map((rows) => rows.map(numbersIn)) };
  const cells = blocks.map((rows) => rows.map(cellsIn));
  const count = cells[0][0].length;
  if (count > 1 && cells.flat().every((row) => row.length === count && row.every(isCell)))
    return { format: 'characters', levels: cells };
  const indentation = lines.reduce(
    (least, line) => Math.min(least, /^[ \t]*/.exec(line)[0].length),
    Infinity,
  );
  return {
    format: 'characters',
    levels: blocks.map((rows) => rows.map((row) => signsOf(row.slice(indentation).trimEnd()))),
  };
}

function numbersIn(line) {
  return [...line.matchAll(/[-+]?\d+(?:\.\d+)?/g)].map(([number]) => String(Number(number)));
}

// `1 0 N 1`: what stands between blanks or commas.
function cellsIn(line) {
  return line.split(/[\s,;]+/).filter((cell) => cell !== '');
}

const isCell = (cell) => signsOf(cell).length === 1 || /^\d{1,3}$/.test(cell);
