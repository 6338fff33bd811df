// Properties that hold for any rows and any addresses, tried with thousands of random ones. A
// failure prints the shortest failing input found, and the seed that finds it again. tools/fuzz
// runs the same tests for longer: SLICECAST_RUNS is the number of inputs for each property.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import Ajv from 'ajv';
import fc from 'fast-check';
import { load } from '../../build/web/node/index.js';
import {
  formatOptions,
  formatView,
  kOverlays,
  parseOptions,
  parseOverlay,
  parseView,
  readView,
  wordsOf,
  writeQuery,
} from '../../web/engine/address.js';
import { sceneOfRows } from '../../web/engine/rows.js';
import { Trouble } from '../../web/engine/trouble.js';

// The same inputs in each run, unless a number of runs asks for a search.
const isSearch = process.env.SLICECAST_RUNS !== undefined;
const kRuns = isSearch ? Number(process.env.SLICECAST_RUNS) : 2000;
const kSeed = isSearch ? {} : { seed: 1 };
const kSchema = new URL('../../assets/scene.schema.json', import.meta.url);
const matchesSchema = new Ajv({ strict: true, strictTypes: false, strictRequired: false }).compile(
  JSON.parse(readFileSync(kSchema, 'utf8')),
);

function holds(property, runs = kRuns) {
  return fc.assert(property, { ...kSeed, numRuns: runs, includeErrorInReport: true });
}

// The Trouble that an action throws, or null. Other errors are faults of the program and pass on.
function troubleOf(action) {
  try {
    action();
  } catch (error) {
    if (error instanceof Trouble) return error;
    throw error;
  }
  return null;
}

// ---- Rows

const characters = fc.constantFrom(...' .,~#bsrwpmh%BSRWPMHoO123456789=+tT*i');
const anyText = fc.string({ unit: 'binary', maxLength: 12 });
const row = fc.oneof(
  { weight: 40, arbitrary: fc.array(characters, { maxLength: 12 }).map((all) => all.join('')) },
  { weight: 1, arbitrary: anyText },
);
const starts = fc.constantFrom('>', 'v', '<', '^');
const meaning = fc.oneof(
  fc.constantFrom('#c03020', '#fff', 'brick', 'sandstone 0.5', 'sand floor', 'wall.png 0.25'),
  fc.constantFrom('constructor', '__proto__', 'toString floor'),
  fc.constantFrom('brick 7', 'floor', '0.5', '#12345', 'sand floor 0.1', '../up.png', '=', 'NaN'),
  anyText,
);
const legendKey = fc.oneof(
  fc.constantFrom('x', 'y', '#', 'blank', 'sky', '>', '.', 'x y', '__proto__', 'toString', '😀'),
  anyText,
);
const legendLine = fc.tuple(legendKey, meaning).map(([key, words]) => `${key} = ${words}`);
const legendPart = fc.array(legendLine, { maxLength: 4 }).map((all) => ['--- legend', ...all]);
const separator = fc.constantFrom(
  '---',
  '--- level',
  '-----',
  '--- colours',
  '--- colors',
  '--- x',
);
const level = fc.array(row, { maxLength: 6 });

// Mostly levels with one start, now and then a legend; sometimes lines of anything.
const rowsText = fc
  .tuple(
    fc.array(row, { maxLength: 5 }),
    fc.tuple(row, starts, row).map((all) => all.join('')),
    fc.array(
      fc.oneof(
        level,
        fc.tuple(separator, level).map(([first, all]) => [first, ...all]),
      ),
      {
        maxLength: 3,
      },
    ),
    fc.option(legendPart, { nil: [] }),
    fc.constantFrom('\n', '\n', '\n', '\r\n'),
    fc.constantFrom('', '', '  ', '\t'),
  )
  .map(([above, middle, below, legend, newline, indentation]) =>
    [...above, middle, ...below.flat(), ...legend].map((line) => indentation + line).join(newline),
  );

function checkFaults(trouble, text) {
  assert.ok(trouble.faults.length > 0, 'what is refused has faults');
  const lines = text.split('\n').length;
  for (const { line, column, found, expected, message } of trouble.faults) {
    assert.ok(Number.isInteger(line) && line >= 0 && line <= lines, message);
    assert.ok(Number.isInteger(column) && column >= 0 && column <= text.length, message);
    assert.ok(found !== '' && expected !== '', message);
  }
}

test('rows are refused with faults, or make a scene that the schema accepts', () => {
  let scenes = 0;
  let refused = 0;
  holds(
    fc.property(rowsText, (text) => {
      let scene = null;
      const trouble = troubleOf(() => (scene = sceneOfRows(text)));
      if (trouble !== null) {
        ++refused;
        checkFaults(trouble, text);
      } else {
        ++scenes;
        assert.ok(matchesSchema(scene), JSON.stringify(matchesSchema.errors));
        const [map] = scene.maps;
        const widths = new Set([...map.levels, map.floor.tiles].flat().map((one) => one.length));
        assert.equal(widths.size, 1, 'all rows are of one length');
      }
    }),
  );
  assert.ok(scenes > kRuns / 20 && refused > kRuns / 20, `${scenes} scenes, ${refused} refused`);
});

test('each line of a legend has its effect or is a fault', () => {
  holds(
    fc.property(legendLine, (line) => {
      const text = (legend) => `>.\n--- legend\n${legend}`;
      const trouble = troubleOf(() => sceneOfRows(text(line)));
      if (trouble !== null) return checkFaults(trouble, text(line));
      // The key is one character or a word of the format, or the text is not one line at all.
      const [key] = line.split(/\s*=/);
      const isKnown = [...key.trim()].length === 1 || ['blank', 'sky'].includes(key.trim());
      assert.ok(isKnown || /[\r\n]/.test(line), `${JSON.stringify(line)} is lost`);
    }),
  );
});

test('a legend refuses characters that cannot mean what it says', () => {
  for (const [line, found] of [
    ['__proto__ = brick', 'the meaning of "__proto__", "brick"'],
    ['. = brick 0.5', '"." as a block'],
    ['blank = wall.png 0.25', '"blank" as a block'],
    ['\u0301 = brick', 'the character "\u0301"'],
    ['‖ = brick', 'the character "‖"'],
  ]) {
    const trouble = troubleOf(() => sceneOfRows(`>.\n--- legend\n${line}`));
    assert.deepEqual(
      trouble?.faults.map((fault) => fault.found),
      [found],
      line,
    );
  }
});

test('rows as lists never throw anything but their faults', () => {
  const lists = fc.oneof(fc.array(row), fc.array(fc.array(row)), fc.array(fc.oneof(row, level)));
  const options = fc.record(
    {
      title: fc.string(),
      colours: fc.boolean(),
      legend: fc.dictionary(legendKey, fc.oneof(meaning, fc.jsonValue({ maxDepth: 2 }))),
    },
    { requiredKeys: [] },
  );
  holds(
    fc.property(lists, options, (rows, others) => {
      const before = JSON.stringify(rows);
      troubleOf(() => sceneOfRows(rows, others));
      assert.equal(JSON.stringify(rows), before, 'the rows stay as they are');
      assert.equal({}.texture, undefined);
    }),
  );
});

test('the engine takes what rows make', async () => {
  await holds(
    fc.asyncProperty(rowsText, async (text) => {
      let scene = null;
      troubleOf(() => (scene = sceneOfRows(text, { colours: true, name: 'rows' })));
      // Files that the legend names do not exist.
      if (scene === null || JSON.stringify(scene).includes('.png"')) return;
      const loaded = await load(scene);
      assert.ok(loaded.pixels({ width: 8, height: 8 }));
      loaded.free();
    }),
    Math.min(kRuns, 300),
  );
});

// ---- Views, options, addresses

const coordinate = fc.integer({ min: -32767 * 65536, max: 32767 * 65536 }).map((n) => n / 65536);
const view = fc.record({
  x: coordinate,
  y: coordinate,
  z: coordinate,
  heading: fc.integer({ min: 0, max: 35999999 }).map((n) => n / 1e5),
  look: fc.integer({ min: -400000, max: 400000 }).map((n) => n / 1e5),
  map: fc.option(fc.string({ minLength: 1 }).map((name) => name.trim() || 'map')),
});

test('a view written and read again is the same', () => {
  holds(
    fc.property(view, (seen) => {
      const read = parseView(formatView(seen));
      for (const name of ['x', 'y', 'z'])
        assert.equal(Math.floor(65536 * read[name] + 0.5), Math.floor(65536 * seen[name] + 0.5));
      assert.equal(read.heading, seen.heading);
      assert.equal(read.look, seen.look === 0 ? 0 : seen.look);
      assert.equal(read.map, seen.map);
    }),
  );
});

const number = fc.oneof(
  fc.double({ noDefaultInfinity: false }).map(String),
  fc.constantFrom('', ' ', '0x10', '1e400', '-0', '32768', '4.5', '1_0', 'Infinity', 'NaN', '٣'),
);
const viewText = fc.oneof(
  fc.array(number, { maxLength: 7 }).map((all) => all.join(',')),
  fc.string({ unit: 'binary' }),
);

test('any text is a view with numbers in their limits, or is refused', () => {
  holds(
    fc.property(viewText, (text) => {
      let read = null;
      if (troubleOf(() => (read = parseView(text))) !== null) return;
      const { x, y, z, heading, look, map } = read;
      assert.ok([x, y, z].every((one) => Math.abs(one) <= 32767));
      assert.ok(Number.isFinite(heading) && Math.abs(look) <= 4);
      assert.ok(map === null || map === map.trim());
    }),
  );
});

test('look() takes any value or refuses it', () => {
  const key = fc.constantFrom('x', 'y', 'z', 'heading', 'look', 'map', '__proto__', 'w');
  const anyView = fc.oneof(
    fc.anything(),
    fc.dictionary(key, fc.oneof(fc.double(), fc.string(), fc.anything({ maxDepth: 1 }))),
  );
  holds(fc.property(anyView, (value) => void troubleOf(() => readView(value))));
});

const word = fc.stringMatching(/^[A-Za-z][A-Za-z0-9.-]{0,8}$/);
const inherited = fc.constantFrom('constructor', 'toString', '__proto__');
const value = fc
  .oneof({ weight: 9, arbitrary: word }, inherited)
  .filter((text) => text !== 'true' && text !== 'false');

test('options written and read again are the same', () => {
  holds(
    fc.property(fc.array(fc.tuple(word, value)), (options) => {
      assert.deepEqual(parseOptions(formatOptions(options)), options);
    }),
  );
});

test('any text is a list of options and overlays without blanks in them', () => {
  holds(
    fc.property(fc.string({ unit: 'binary' }), (text) => {
      for (const [name, set] of parseOptions(text)) assert.ok(!/[\s,;]/.test(name + set));
      const warnings = [];
      const shown = parseOverlay(text, (warning) => warnings.push(warning));
      assert.ok(shown.every((name) => kOverlays.includes(name)));
      assert.equal(shown.length + warnings.length, wordsOf(text).length);
    }),
  );
});

test('an address written is read by any browser as it was', () => {
  const parameters = fc.dictionary(word, fc.option(fc.string({ unit: 'grapheme' })));
  holds(
    fc.property(parameters, (given) => {
      const read = Object.fromEntries(new URLSearchParams(writeQuery(given)));
      const expected = Object.entries(given).filter(([, text]) => text !== null);
      assert.deepEqual(read, Object.fromEntries(expected));
    }),
  );
});
