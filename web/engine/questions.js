// Answers the questions that figures of lessons ask about a running engine: rays, pixels, points
// and cells, as plain data. Answers describe the moment after the last step. web/element/api.json
// describes each answer.
//
//     const questions = new Questions(module, session, mapNames);       // engine.questions
//     questions.hits(320, 200, { first: 0, last: 319 });
//
// Bad arguments throw a RangeError that says what was found and what is expected.

import { withBytes } from './module-memory.js';
import { misread, unknown } from './nearest-name.js';
import { readCast, readColumns, readHits, readPacked, readPick, readTrace } from './read-packed.js';

const kColumnsAtOnce = 16; // a few hundred KB of the module's memory
const kMostColumns = 8192; // as the engine's pictures
const kCoordinateLimit = 32767; // src/base/coordinate.h
const kMostMarks = 16384; // src/overlay/marks.h
const kColour = /^#[0-9a-f]{6}$/i;

const searches = new WeakMap(); // module -> the session of its latest search for mistakes

export class Questions {
  #module;
  #session;
  #mapNames;

  constructor(module, session, mapNames) {
    this.#module = module;
    this.#session = session;
    this.#mapNames = mapNames;
  }

  // The hits of one column of a picture of this size, or null if there is no such column. For a
  // list of columns, or {first, last}, an array with the answer for each.
  hits(width, height, columns) {
    return this.#ofColumns('hits', readHits, width, height, columns);
  }

  // The traces of columns, in the same form.
  trace(width, height, columns) {
    return this.#ofColumns('trace', readTrace, width, height, columns);
  }

  // The trace of the whole picture.
  traceFrame(width, height) {
    return this.#json('traceFrame', width, height);
  }

  // What a ray from {map, x, y, z, heading} meets: units and degrees, the eye's map without `map`,
  // a ray without a height without `z`.
  cast(from) {
    if (typeof from !== 'object' || from === null)
      throw misread('cast', from, 'an object with x, y, heading and, if wanted, map and z');
    // A view is accepted too; its look is ignored.
    const { map, x, y, z = null, heading, look: _, ...others } = from;
    for (const name of Object.keys(others))
      throw new RangeError(`cast: ${unknown('field', name, ['map', 'x', 'y', 'z', 'heading'])}`);
    for (const [name, value] of Object.entries({ x, y, heading, z: z ?? 0 })) {
      const limit = name === 'heading' ? Number.MAX_VALUE : kCoordinateLimit;
      if (typeof value !== 'number' || !(Math.abs(value) <= limit))
        throw misread(
          'cast',
          `${name} ${value}`,
          name === 'heading' ? 'degrees' : `a number from -${limit} to ${limit}`,
        );
    }
    return this.#packed(
      readPacked,
      'cast',
      readCast,
      this.#mapIndex('cast', map),
      x,
      y,
      z ?? NaN,
      heading,
    );
  }

  // The probable mistakes in a scene that take too long for loading: {warnings, spares}, where
  // spares are what nothing uses. Null once `isWanted` returns false, or another search began. The
  // scene is read aside, in slices, by what `load` gives.
  async findMistakes(source, isWanted, load) {
    const module = this.#module;
    const session = module._slicecast_create();
    const isLatest = () => searches.get(module) === session && isWanted();
    searches.set(module, session);
    const searching = { __proto__: module, _slicecast_next: module._slicecast_nextMistakes };
    const loading = load(searching, session, isLatest);
    try {
      const names = await loading.readNames(source);
      if (names === null) return null;
      await loading.supplyFiles(names.files, source);
      return isLatest() ? await loading.start() : null;
    } finally {
      if (searches.get(module) === session) module._slicecast_nextMistakes(0);
      module._slicecast_free(session);
    }
  }

  // What a pixel shows; null outside the picture.
  pick(width, height, column, row) {
    for (const [name, value] of Object.entries({ column, row })) {
      if (typeof value !== 'number') throw misread('pick', `${name} ${value}`, 'a number');
    }
    const isInside = column >= 0 && column < width && row >= 0 && row < height;
    return isInside
      ? this.#packed(
          readPacked,
          'pick',
          readPick,
          width,
          height,
          Math.floor(column),
          Math.floor(row),
        )
      : null;
  }

  // Where a point (units) appears in the picture: {x, y} in pixels, {depth} in units. Null for a
  // point in another map than the eye's, or not in front of the eye.
  project(width, height, x, y, z, map) {
    for (const [name, value] of Object.entries({ x, y, z })) {
      if (!Number.isFinite(value)) throw misread('project', `${name} ${value}`, 'a number');
    }
    const index = this.#mapIndex('project', map);
    const at = this.#call('project', index, x, y, z, width, height);
    if (at === 0) return null;
    const [left, top, depth] = this.#numbers(at);
    return { x: left, y: top, depth };
  }

  // The rows of a map's level, or of all levels: [level][y], each row a text.
  cells(map, level) {
    const levels = this.#json('cells', this.#mapIndex('cells', map));
    if (level === undefined) return levels;
    if (!Number.isInteger(level) || levels[level] === undefined)
      throw misread('cells', `level ${level}`, `a whole number from 0 to ${levels.length - 1}`);
    return levels[level];
  }

  // Whether the classic options, as they are, show in one of many views: {share, view}; look()
  // takes the view. Null behind the last one.
  tryOldWay(number) {
    const at = this.#call('tryOldWay', number);
    if (at === 0) return null;
    const [share, map, x, y, z, heading, look, flying] = this.#numbers(at);
    const view = { map: this.#mapNames[map], x, y, z, heading, look, flying: flying === 1 };
    return { share, view };
  }

  // The blocks of the map's legend, with their characters.
  blueprints(map) {
    return this.#json('blueprints', this.#mapIndex('blueprints', map));
  }

  // Puts the blocks of legend characters into cells, all or none: [{level, x, y, character}]; "."
  // empties a cell.
  setCells(map, changes) {
    const characters = new Map(); // -> their numbers
    const cells = new Int32Array(4 * changes.length);
    changes.forEach(({ level, x, y, character }, index) => {
      for (const [name, value] of Object.entries({ level, x, y })) {
        if (!Number.isInteger(value))
          throw misread('setCell', `${name} ${value}`, 'a whole number');
      }
      if (typeof character !== 'string' || character.includes('\0'))
        throw misread('setCell', String(character), "a character of the map's legend");
      if (!characters.has(character)) characters.set(character, characters.size);
      cells.set([level, x, y, characters.get(character)], 4 * index);
    });
    const index = this.#mapIndex('setCell', map);
    const signs = new TextEncoder().encode([...characters.keys(), ''].join('\0'));
    const refusal = withBytes(this.#module, new Uint8Array(cells.buffer), (at) =>
      withBytes(this.#module, signs, (signsAt) =>
        this.#text(this.#call('setCells', index, at, changes.length, signsAt)),
      ),
    );
    if (refusal !== '') throw new RangeError(`setCell: ${refusal}.`);
  }

  // Draws lines over the picture from now on: [{map, from: [x, y, z], to: [x, y, z], colour}], the
  // colour as '#rrggbb'.
  mark(lines) {
    const numbers = Float64Array.from(
      lines.flatMap(({ map, from, to, colour = '#ffffff' }, index) => {
        const wrong = (what, found, wanted) =>
          misread('mark', `${what} ${found} in line ${index}`, wanted);
        for (const [name, point] of Object.entries({ from, to })) {
          if (point?.length !== 3 || !point.every((value) => Math.abs(value) <= kCoordinateLimit))
            throw wrong(name, String(point), 'three numbers: x, y and z');
        }
        if (!kColour.test(colour)) throw wrong('colour', String(colour), 'a colour as #c03020');
        return [this.#mapIndex('mark', map), ...from, ...to, parseInt(colour.slice(1), 16)];
      }),
    );
    if (lines.length > kMostMarks)
      throw misread('mark', `${lines.length} lines`, `at most ${kMostMarks}`);
    withBytes(this.#module, new Uint8Array(numbers.buffer), (at) =>
      this.#call('mark', at, lines.length),
    );
  }

  // The number of a map by its name; of the eye's map if none is named.
  #mapIndex(method, name) {
    if (name === undefined || name === null) return this.#numbers(this.#call('view'))[0];
    const index = this.#mapNames.indexOf(name);
    if (index < 0)
      throw new RangeError(`${method}: ${unknown('map', String(name), this.#mapNames)}`);
    return index;
  }

  #ofColumns(method, read, width, height, columns) {
    const exists = (column) => Number.isInteger(column) && column >= 0 && column < width;
    const asked = columnList(method, columns);
    const valid = asked.filter(exists);
    const answers = [];
    for (let i = 0; i < valid.length; i += kColumnsAtOnce) {
      const part = Int32Array.from(valid.slice(i, i + kColumnsAtOnce));
      withBytes(this.#module, new Uint8Array(part.buffer), (at) => {
        const columnsRead = this.#packed(readColumns, method, read, width, height, at, part.length);
        answers.push(...(columnsRead ?? []));
      });
    }
    let next = 0;
    const all = asked.map((column) => (exists(column) ? (answers[next++] ?? null) : null));
    return typeof columns === 'object' && columns !== null ? all : all[0];
  }

  #call(name, ...words) {
    return this.#module[`_slicecast_${name}`](this.#session, ...words);
  }

  // The numbers from an address to the end of the memory; valid until the memory grows.
  #numbers(at) {
    return new Float64Array(this.#module.HEAPU8.buffer, at);
  }

  #text(at) {
    return this.#module.UTF8ToString(at);
  }

  #json(name, ...words) {
    return JSON.parse(this.#text(this.#call(name, ...words)));
  }

  #packed(readAll, name, read, ...words) {
    const at = this.#call(name, ...words);
    if (at === 0) return null;
    const texts = this.#json('texts');
    return readAll(this.#numbers(at), texts, read);
  }
}

// The columns as a list; one column is a list of one.
function columnList(method, columns) {
  if (typeof columns !== 'object' || columns === null) return [columns];
  const isList = Array.isArray(columns);
  const { first, last } = isList ? { first: 1, last: columns.length } : columns;
  if (
    ![first, last].every(Number.isInteger) ||
    last - first >= kMostColumns ||
    (!isList && last < first)
  )
    throw misread(
      method,
      isList ? `${last} columns` : `columns from ${first} to ${last}`,
      `a column, a list of columns, or { first, last } with whole numbers, both included, with at most ${kMostColumns} columns`,
    );
  return isList ? columns : Array.from({ length: last - first + 1 }, (_, index) => first + index);
}
