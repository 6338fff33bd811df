// The scene that is edited. Its text is the document; the value is what the text says.
// Takes edits of the text; gives text, value, where rows stand, and what each edit changed.
// Knows no tool, no view and no engine, and keeps no history.
//
//     const scene = new SceneDocument(text);
//     const undoing = scene.apply([{ offset, length, content }]);   // in the order of the text
//     scene.edits({ path: ['start', 'x'], value: 2.5 })             // such edits; see json-text.js
//     scene.edits({ map: 0, cells: [{ layer: 1, x: 3, y: 4, sign: '#' }] })
//     scene.edits({ text: '...' })                                  // another text as a whole
//     scene.edits({ path: ['sprites', 'oak'], name: 'elm' })        // another key
//     scene.edits({ together: [change, ...] })                      // that touch different places
//     scene.edits({ path: ['maps', 0, 'objects'], removed: [2, 3] })  // of a list
//     scene.rows(0, 1)                                              // of a layer, as texts
//     scene.listen(({ cells, isWhole, edits, undoing }) => ...)
//
// A layer is the number of a level, 'floor' or 'ceiling'. Levels that are filled or repeated have
// rows, too, but none in the text: cellChanges() of cells.js writes them out first. While the text
// is no JSON, `mistake` says where, and the value is the last good one.

import { findNodeAtLocation, parseTree, printParseErrorCode } from 'jsonc-parser';
import { signsOf } from '../engine/signs.js';
import { editsToBecome, editsToRemove, editsToRename, editsToSet } from './json-text.js';
import { levelsOf } from './levels.js';

const kStrict = { disallowComments: true, allowTrailingComma: false };
const kEscapes = /["\\\u0000-\u001f]/; // eslint-disable-line no-control-regex -- JSON's own

export class SceneDocument {
  #text;
  #tree;
  #value;
  #rows = []; // {map, layer, entry, y, node} of each row of tiles, in the text's order
  #layers = new Map(); // 'map layer' -> those of one layer
  #listeners = [];

  mistake = null; // {offset, length, message}

  constructor(text) {
    this.#text = text;
    this.#read();
    if (this.#value === undefined) throw new SyntaxError(this.mistake.message);
  }

  get text() {
    return this.#text;
  }

  get value() {
    return this.#value;
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  // The rows of a layer; none if it has none of its own.
  rows(map, layer) {
    const written = this.#layers.get(`${map} ${layer}`);
    return written?.map(({ node }) => node.value) ?? this.#levelsOf(map)[layer]?.rows ?? [];
  }

  // The keys of an object, in the order of the text; JavaScript lists whole numbers first.
  keys(path) {
    const node = findNodeAtLocation(this.#tree, path);
    return node?.type === 'object' ? node.children.map(({ children }) => children[0].value) : [];
  }

  // What stands in a cell: '.' also where there is no row.
  sign(map, layer, x, y) {
    const written = this.#layers.get(`${map} ${layer}`);
    const row = written?.[y]?.node.value ?? this.#levelsOf(map)[layer]?.rows[y];
    return row === undefined ? '.' : (signsOf(row)[x] ?? '.');
  }

  // The edits that make a change.
  edits(change) {
    if (change.cells !== undefined) return this.#cellEdits(change);
    if (change.text !== undefined) return editsToBecome(this.#text, change.text);
    if (change.removed !== undefined)
      return editsToRemove(this.#text, this.#tree, change.path, change.removed);
    if (change.together !== undefined)
      return change.together
        .flatMap((one) => this.edits(one))
        .sort((one, other) => one.offset - other.offset);
    if (change.name !== undefined) return editsToRename(this.#tree, change.path, change.name);
    return editsToSet(this.#text, this.#tree, change.path, change.value, change);
  }

  // Returns the edits that undo these.
  apply(edits) {
    const undoing = [];
    const parts = [];
    let at = 0;
    let moved = 0;
    for (const { offset, length, content } of edits) {
      parts.push(this.#text.slice(at, offset), content);
      undoing.push({
        offset: offset + moved,
        length: content.length,
        content: this.#text.slice(offset, offset + length),
      });
      moved += content.length - length;
      at = offset + length;
    }
    parts.push(this.#text.slice(at));
    const cells = this.#takeCells(edits);
    this.#text = parts.join('');
    if (cells === null) this.#read();
    const change = { cells: cells ?? [], isWhole: cells === null, edits, undoing };
    for (const listener of this.#listeners) listener(change);
    return undoing;
  }

  #read() {
    const errors = [];
    const tree = parseTree(this.#text, errors, kStrict);
    if (errors.length > 0 || tree === undefined) {
      const { offset, length, error } = errors[0] ?? { offset: 0, length: 0, error: 0 };
      this.mistake = { offset, length, message: printParseErrorCode(error) };
      return;
    }
    this.mistake = null;
    this.#tree = tree;
    this.#value = JSON.parse(this.#text);
    this.#findRows();
  }

  // Also of a scene with faults.
  #levelsOf(map) {
    return levelsOf(this.#value.maps?.[map] ?? {});
  }

  #findRows() {
    this.#rows = [];
    this.#layers.clear();
    const maps = member(this.#tree, 'maps')?.children ?? [];
    maps.forEach((map, index) => {
      const entries = member(map, 'levels')?.children ?? [];
      const layers = this.#levelsOf(index)
        .map(({ entry, isWritten }, level) => [
          level,
          isWritten ? entries[entry] : undefined,
          entry,
        ])
        .concat([
          ['floor', member(member(map, 'floor'), 'tiles')],
          ['ceiling', member(member(map, 'ceiling'), 'tiles')],
        ]);
      for (const [layer, node, entry] of layers) {
        if (node?.type !== 'array') continue;
        if (!node.children.every(({ type }) => type === 'string')) continue;
        const rows = node.children.map((row, y) => ({ map: index, layer, entry, y, node: row }));
        this.#layers.set(`${index} ${layer}`, rows);
        this.#rows.push(...rows);
      }
    });
    this.#rows.sort((one, other) => one.node.offset - other.node.offset);
  }

  // The row whose text, between the quotes, holds that range.
  #rowAt(offset, length) {
    let low = 0;
    let high = this.#rows.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.#rows[middle].node.offset < offset) low = middle + 1;
      else high = middle;
    }
    const row = this.#rows[low - 1];
    if (row === undefined) return null;
    return offset + length < row.node.offset + row.node.length ? row : null;
  }

  // If the edits change nothing but cells, and no place in the text, takes them over and returns
  // the cells; else null. So a stroke over a large map costs no reading.
  #takeCells(edits) {
    if (this.mistake !== null) return null;
    const rows = [];
    for (const { offset, length, content } of edits) {
      const row = this.#rowAt(offset, length);
      const isPlain =
        row !== null &&
        content.length === length &&
        row.node.length === row.node.value.length + 2 &&
        !kEscapes.test(content);
      if (!isPlain) return null;
      rows.push(row);
    }
    const cells = [];
    const changed = new Map(); // row -> its text
    edits.forEach(({ offset, content }, index) => {
      const row = rows[index];
      const before = changed.get(row) ?? row.node.value;
      const at = offset - row.node.offset - 1;
      changed.set(row, before.slice(0, at) + content + before.slice(at + content.length));
    });
    for (const [{ map, layer, y, node }, text] of changed) {
      const before = signsOf(node.value);
      const after = signsOf(text);
      if (before.length !== after.length) return null;
      after.forEach((sign, x) => {
        if (sign !== before[x]) cells.push({ map, layer, x, y, sign });
      });
    }
    for (const [{ map, layer, entry, y, node }, text] of changed) {
      node.value = text;
      this.#rowsOfValue(map, layer, entry)[y] = text;
    }
    return cells;
  }

  #rowsOfValue(map, layer, entry) {
    const { levels, floor, ceiling } = this.#value.maps[map];
    if (layer === 'floor') return floor.tiles;
    return layer === 'ceiling' ? ceiling.tiles : levels[entry];
  }

  // Each row's changed signs, as one edit for each run of neighbours.
  #cellEdits({ map, cells }) {
    const byRow = new Map();
    for (const { layer, x, y, sign } of cells) {
      const row = this.#layers.get(`${map} ${layer}`)?.[y];
      if (row === undefined) continue; // a scene with faults, or a level that is not written
      if (!byRow.has(row)) byRow.set(row, new Map());
      byRow.get(row).set(x, sign);
    }
    const edits = [];
    for (const [{ node }, signs] of byRow) {
      const isPlain = node.length === node.value.length + 2;
      const before = signsOf(node.value);
      const places = []; // of each sign in the text
      let at = node.offset + 1;
      for (const sign of before) {
        places.push(at);
        at += isPlain ? sign.length : JSON.stringify(sign).length - 2;
      }
      places.push(at);
      if (!isPlain && at !== node.offset + node.length - 1) {
        // Escapes that are not needed: the row is written anew.
        const after = before.map((sign, x) => signs.get(x) ?? sign).join('');
        edits.push({ offset: node.offset, length: node.length, content: JSON.stringify(after) });
        continue;
      }
      let last = null;
      for (const x of [...signs.keys()].sort((one, other) => one - other)) {
        if (before[x] === undefined || before[x] === signs.get(x)) continue;
        const content = JSON.stringify(signs.get(x)).slice(1, -1);
        if (last?.offset + last?.length === places[x]) {
          last.length += places[x + 1] - places[x];
          last.content += content;
        } else {
          last = { offset: places[x], length: places[x + 1] - places[x], content };
          edits.push(last);
        }
      }
    }
    return edits.sort((one, other) => one.offset - other.offset);
  }
}

function member(node, key) {
  if (node?.type !== 'object') return undefined;
  return node.children.find(({ children }) => children[0].value === key)?.children[1];
}
