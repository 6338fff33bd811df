// The file of past ratios, tests/bench/ratios.json: the time of each view divided by that of the
// limit, for each run of tools/bench --record. The newest record is the last.
//
//     {"records": [{"date": "2026-11-23", "commit": "its subject", "processor": "AMD EPYC",
//       "rounds": 25, "views": {"castle, start": {"native": 4.37, "wasm": 5.65}}}]}

export const kMostLoss = 0.1; // a view may be slower than its record by this share

const kTexts = ['date', 'commit', 'processor'];

// Reads the records. Throws an Error with file, place, what was found and what was expected.
export function readRatios(text, file) {
  const expect = (isRight, where, found, expected) => {
    if (isRight) return;
    const shown = found === undefined ? 'nothing' : JSON.stringify(found);
    throw new Error(`${file}: ${where}: found ${shown}, expected ${expected}`);
  };
  const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);

  const { records } = parse(text, file) ?? {};
  expect(Array.isArray(records), 'records', records, 'a list of records');
  records.forEach((record, index) => {
    const at = `records[${index}]`;
    expect(isObject(record), at, record, 'an object');
    for (const name of kTexts)
      expect(typeof record[name] === 'string', `${at}.${name}`, record[name], 'a text');
    expect(record.rounds > 0, `${at}.rounds`, record.rounds, 'a number above 0');
    expect(isObject(record.views), `${at}.views`, record.views, 'an object');
    for (const [title, figures] of Object.entries(record.views)) {
      const view = `${at}.views["${title}"]`;
      expect(isObject(figures), view, figures, 'an object');
      for (const [name, value] of Object.entries(figures))
        expect(
          Number.isFinite(value) && value > 0,
          `${view}["${name}"]`,
          value,
          'a number above 0',
        );
    }
  });
  return records;
}

function parse(text, file) {
  const fault = faultIn(text);
  if (fault === null) return JSON.parse(text);
  const before = text.slice(0, fault).split('\n');
  const found = fault < text.length ? JSON.stringify(text[fault]) : 'the end';
  throw new Error(
    `${file}:${before.length}:${before.at(-1).length + 1}: found ${found}, ` +
      'expected JSON as tools/bench --record writes it',
  );
}

// The index at which a text stops being valid JSON (its length, if it only ends too early); null if
// it is valid. Not every message of JSON.parse gives the index. But messages about a text that ends
// too early differ from the others, so a search over prefixes finds the first wrong character.
function faultIn(text) {
  const faultOf = (part) => {
    try {
      JSON.parse(part);
      return null;
    } catch ({ message }) {
      const position = Number(/at position (\d+)/.exec(message)?.[1] ?? -1);
      return /Unexpected end|Unterminated/.test(message) || position >= part.length
        ? 'end'
        : 'here';
    }
  };
  const fault = faultOf(text);
  if (fault === null) return null;
  if (fault === 'end') return text.length;
  let [right, wrong] = [0, text.length]; // lengths of a prefix without and with the error
  while (wrong - right > 1) {
    const middle = (right + wrong) >> 1;
    if (faultOf(text.slice(0, middle)) === 'here') wrong = middle;
    else right = middle;
  }
  return right;
}

// One line per view, so that diffs show which views changed.
export function ratiosText(records) {
  const pairs = (object) =>
    Object.entries(object)
      .map(([name, value]) => `${JSON.stringify(name)}: ${JSON.stringify(value)}`)
      .join(', ');
  const recordText = ({ views, ...about }) =>
    `    {\n      ${pairs(about)},\n      "views": {\n${Object.entries(views)
      .map(([title, figures]) => `        ${JSON.stringify(title)}: { ${pairs(figures)} }`)
      .join(',\n')}\n      }\n    }`;
  return `{\n  "records": [\n${records.map(recordText).join(',\n')}\n  ]\n}\n`;
}

// The newest record of that processor, else the newest of all.
export const recordFor = (records, processor) =>
  records.findLast((record) => record.processor === processor) ?? records.at(-1);

// The measurement in the form of a record: {title: {native, wasm}}. A run is that of bench.mjs.
export function figuresOf(runs) {
  const all = {};
  for (const { name, views } of runs) {
    for (const { title, ratio } of views) (all[title] ??= {})[name] = Number(ratio.toFixed(2));
  }
  return all;
}

// Compares with a record: {losses: [{title, figure, then, now}], unknown: titles}; `unknown` are
// views without a record. Figures that were not measured now are left out.
export function compare(record, now) {
  const losses = [];
  const unknown = [];
  for (const [title, figures] of Object.entries(now)) {
    const past = record.views[title] ?? {};
    if (Object.keys(figures).some((figure) => past[figure] === undefined)) unknown.push(title);
    for (const [figure, value] of Object.entries(figures)) {
      if (value > (1 + kMostLoss) * past[figure])
        losses.push({ title, figure, then: past[figure], now: value });
    }
  }
  return { losses, unknown };
}

// Compares a measurement with a record. Views that seem slower are measured again before they
// count: `measure(titles)`, null for all.
export function check(record, measure) {
  const now = measure(null);
  const first = compare(record, now);
  const views = Object.keys(now).length;
  if (first.losses.length === 0) return { ...first, views };
  const again = compare(record, measure([...new Set(first.losses.map(({ title }) => title))]));
  const wasLost = ({ title, figure }) =>
    first.losses.some((loss) => loss.title === title && loss.figure === figure);
  return { ...first, losses: again.losses.filter(wasLost), views };
}

// The output of --check. `processor` is that of this machine.
export function reportOf({ losses, unknown, views }, record, processor) {
  const lines = [];
  if (record.processor !== processor)
    lines.push(
      `Recorded on another processor (${record.processor}; this is ${processor}): ` +
        'ratios differ by processor, so trust large losses only.',
    );
  if (unknown.length > 0) lines.push(`Not in the record: ${unknown.join('; ')}.`);
  const since = `since ${record.date} (${record.commit})`;
  if (losses.length === 0) {
    lines.push(`None of ${views} views is more than ${kMostLoss * 100} % slower ${since}.`);
  } else {
    lines.push(
      `More than ${kMostLoss * 100} % slower ${since}, in two measurements, times the limit:`,
    );
    for (const { title, figure, then, now } of losses)
      lines.push(
        `  ${title}, ${figure}: then ${then.toFixed(2)}, now ${now.toFixed(2)} ` +
          `(+${Math.round((now / then - 1) * 100)} %)`,
      );
  }
  return lines.join('\n');
}
