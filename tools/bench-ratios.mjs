// The file of past ratios, tests/bench/ratios.json: what each view took, times the limit, whenever
// tools/bench --record was run. The newest record is the last.
//
//     {"records": [{"date": "2026-11-23", "commit": "its subject", "processor": "AMD EPYC",
//       "rounds": 150, "views": {"castle, start": {"native": 4.37, "native 4K": 1.82,
//                                                  "wasm": 5.65, "wasm 4K": 2.2}}}]}

export const kMostLoss = 0.1; // a view may take this part more than its record says

const kTexts = ['date', 'commit', 'processor'];

// The records of such a text. Throws an Error that says which file, where, what was found and what
// was expected.
export function readRatios(text, file) {
  const expect = (isRight, where, found, expected) => {
    if (isRight) return;
    const shown = found === undefined ? 'nothing' : JSON.stringify(found);
    throw new Error(`${file}: ${where}: found ${shown}, expected ${expected}`);
  };
  const isObject = (value) => value !== null && typeof value === 'object' && !Array.isArray(value);

  const { records } = parse(text, file) ?? {};
  expect(Array.isArray(records) && records.length > 0, 'records', records, 'a list of records');
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

// Where a text stops being JSON: the index of a character, or its length; null where it never does.
// Not every message of JSON.parse says so; but those about a text that only ends too early differ
// from the others, which finds the first character that is wrong.
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
  let [right, wrong] = [0, text.length]; // characters without the fault, and with it
  while (wrong - right > 1) {
    const middle = (right + wrong) >> 1;
    if (faultOf(text.slice(0, middle)) === 'here') wrong = middle;
    else right = middle;
  }
  return right;
}

// A line for each view, so that a change of one is seen as a change of one.
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

// The newest record of that processor, else the newest at all.
export const recordFor = (records, processor) =>
  records.findLast((record) => record.processor === processor) ?? records.at(-1);

// What was measured, as a record holds it: {title: {native, 'native 4K' ...}}. A run is what
// slicecast-bench prints, with `name`, the build's.
export function figuresOf(runs) {
  const all = {};
  const rounded = (number) => Number(number.toFixed(2));
  for (const { name, views } of runs) {
    for (const { title, ratio, large } of views)
      Object.assign((all[title] ??= {}), {
        [name]: rounded(ratio),
        [`${name} 4K`]: rounded(large.ratio),
      });
  }
  return all;
}

// What has been lost since a record, and what it does not tell of: {losses: [{title, figure, then,
// now}], unknown: titles}. Figures that were not measured now are left out.
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

// Compares what `measure` gives with a record. Where something seems lost, the builds concerned are
// measured once more before it counts: `measure(names, isAgain)` takes the builds' names, or null
// for all of them. All views are, for a view that is measured alone has the caches for itself.
export function check(record, measure) {
  const now = measure(null, false);
  const views = Object.keys(now).length;
  const first = compare(record, now);
  if (first.losses.length === 0) return { ...first, views };
  const wasLost = ({ title, figure }) =>
    first.losses.some((loss) => loss.title === title && loss.figure === figure);
  const builds = [...new Set(first.losses.map(({ figure }) => figure.split(' ')[0]))];
  const again = compare(record, measure(builds, true));
  return { ...first, losses: again.losses.filter(wasLost), views };
}

// What --check prints. `processor` is this machine's.
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
    lines.push(`None of ${views} views has lost more than ${kMostLoss * 100} % ${since}.`);
  } else {
    lines.push(
      `Lost more than ${kMostLoss * 100} % ${since}, in two measurements, times the limit:`,
    );
    for (const { title, figure, then, now } of losses)
      lines.push(
        `  ${title}, ${figure}: then ${then.toFixed(2)}, now ${now.toFixed(2)} ` +
          `(+${Math.round((now / then - 1) * 100)} %)`,
      );
  }
  return lines.join('\n');
}
