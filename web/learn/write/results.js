// Shows what a run has given: checks, pixels, and the first pixel that differs.

import { showImage } from '../figures/show-image.js';
import { paint } from './code.js';
import { button, fixed, make, percent, words } from './make.js';

const kEnough = 0.999; // of the pixels compared
const kHints = ['where', 'what', 'lines'];

export const isSolved = (checks, pixels) => checks.every(({ ok }) => ok) && pixels.share >= kEnough;

// The reader's functions of the chapter with their checks and hints, and what else is wrong.
export function functionList(step, checks, hintsShown, onHint) {
  const found = new Map(checks.map((result) => [result.name, result]));
  const rows = step.newIn
    .filter(({ isYours }) => isYours)
    .map((entry) => {
      const row = checkRow(entry.name, found.get(entry.name));
      found.delete(entry.name);
      const shown = hintsShown.get(entry.name) ?? 0;
      const next = kHints[shown];
      if (next !== undefined)
        row.firstChild.append(
          button(`Hint: ${kHintTitles[next]}`, () => onHint(entry.name, shown + 1), {
            'aria-label': `Hint: ${kHintTitles[next]}, for ${entry.name}`,
          }),
        );
      row.append(...kHints.slice(0, shown).map((kind) => hint(kind, entry[kind])));
      return row;
    });
  const rest = [...found.values()];
  const wrong = rest.filter(({ ok }) => !ok).map((result) => checkRow(result.name, result));
  const right = rest.filter(({ ok }) => ok);
  if (right.length > 0)
    wrong.push(
      make(
        'li',
        { class: 'write-check write-right' },
        make('span', { class: 'write-ok', 'aria-hidden': 'true' }, '✓ '),
        'Right as before: ',
        ...right.flatMap(({ name }, index) => [index > 0 ? ', ' : '', make('code', {}, name)]),
      ),
    );
  return make('ul', { class: 'write-checks' }, ...rows, ...wrong);
}

const kHintTitles = { where: 'where', what: 'what', lines: 'the lines' };

function hint(kind, text) {
  if (kind !== 'lines') return make('p', { class: 'write-hint' }, ...words(text));
  const code = make('code');
  paint(code, text);
  return make('pre', { class: 'write-hint', tabindex: '0', 'aria-label': 'The lines' }, code);
}

function checkRow(name, result) {
  const kind = result === undefined ? 'open' : result.ok ? 'ok' : 'wrong';
  const [sign, label] = { open: ['·', ''], ok: ['✓', 'right: '], wrong: ['✗', 'wrong: '] }[kind];
  const mark = make('span', { class: `write-${kind}`, role: 'img', 'aria-label': label }, sign);
  if (kind === 'open') mark.setAttribute('aria-hidden', 'true');
  const title = make('span', {}, mark, ' ', make('code', {}, name));
  const row = make(
    'li',
    { class: 'write-check', 'data-name': name },
    make('div', { class: 'write-row' }, title),
  );
  if (kind === 'wrong') {
    row.append(make('p', { class: 'write-first' }, ...words(result.says)));
    const meaning = meaningOf(result.says);
    if (meaning !== '') row.append(make('p', { class: 'write-detail' }, ...words(meaning)));
  }
  return row;
}

// What the first wrong number of a check probably comes from.
function meaningOf(says) {
  if (/NaN/.test(says))
    return '`NaN` comes of 0 / 0, of a missing argument, or of a value that is not there.';
  if (/undefined/.test(says) && !/no function/.test(says))
    return '`undefined` comes back: is a `return` missing, or does the function end before it?';
  if (/Infinity/.test(says))
    return '`Infinity` comes of a division by zero, or of a ray that meets no block.';
  return '';
}

export function pixelReport(pixels) {
  if (pixels.all === 0)
    return [
      make(
        'p',
        {},
        'In this chapter, functions are compared, and no pixels yet: the engine draws more.',
      ),
    ];
  const { share, same, all, isEmpty } = pixels;
  const different = all - same;
  return [
    ...(isEmpty
      ? [make('p', {}, ...words('Your picture is empty: `draw` has painted nothing.'))]
      : []),
    make('p', { class: 'write-share' }, make('b', {}, percent(share)), ' of the pixels are equal'),
    make('meter', {
      min: 0,
      max: 1,
      value: share,
      low: 0.9,
      high: kEnough,
      optimum: 1,
      'aria-label': 'Equal pixels',
    }),
    make(
      'p',
      { class: 'write-detail' },
      `${all.toLocaleString('en')} pixels show what has been taught so far; ` +
        `${different.toLocaleString('en')} differ. 99.9 % are asked for.`,
    ),
  ];
}

// The first difference: { column, row, mine, engine, what, ray, walk }.
export function differenceReport(difference, onShow) {
  if (difference === null) return [];
  const { column, row, mine, engine, what, ray, walk } = difference;
  const parts = [
    make('h4', {}, 'The first pixel that differs'),
    button(`Column ${column}, row ${row}: show it`, () => onShow(column), { class: 'write-show' }),
    make('p', {}, `The engine shows ${what}.`),
    make('p', { class: 'write-colours' }, swatch(mine, 'Yours'), swatch(engine, 'The engine’s')),
  ];
  if (walk?.first != null) parts.push(make('p', { class: 'write-first' }, ...words(walk.first)));
  parts.push(
    make(
      'p',
      { class: 'write-detail' },
      `The ray: (${ray.map((part) => fixed(part, 4)).join(', ')})`,
    ),
  );
  if (walk !== null) parts.push(walkTable(walk));
  return parts;
}

function swatch(colour, title) {
  const element = make('span', { class: 'write-swatch', 'aria-hidden': 'true' });
  element.style.background = `rgb(${colour.join(' ')})`;
  const numbers = make('span', { class: 'write-numbers' }, colour.join(', '));
  return make('span', {}, element, `${title} `, numbers);
}

// Both walks side by side, as far as the engine's goes: it ends where nothing more can be seen.
function walkTable({ mine, engine }) {
  const cell = (step) =>
    step === undefined ? '–' : `${step.x}, ${step.y} at ${fixed(step.near, 4)}`;
  const rows = engine.map((tile, index) => {
    const [own, theirs] = [mine[index], tile].map(cell);
    const isSame = own === theirs;
    return make(
      'tr',
      { class: isSame ? '' : 'differs' },
      make('th', { scope: 'row' }, String(index), isSame ? '' : ' ✗'),
      make('td', {}, own),
      make('td', {}, theirs),
    );
  });
  const titles = ['', 'Yours: tile at depth', 'The engine’s'];
  return make(
    'details',
    {},
    make('summary', {}, 'Both walks along this ray'),
    make(
      'table',
      {},
      make(
        'thead',
        {},
        make('tr', {}, ...titles.map((title) => make(title === '' ? 'td' : 'th', {}, title))),
      ),
      make('tbody', {}, ...rows),
    ),
  );
}

// Equal pixels are a dim grey, different ones bright, the rest is left empty.
export function paintDifference(canvas, mine, map, mask) {
  const image = new ImageData(canvas.width, canvas.height);
  for (let pixel = 0; pixel < map.length; pixel++) {
    const at = 4 * pixel;
    if (mask[pixel] === 0) continue;
    const grey = 24 + (mine[at] + mine[at + 1] + mine[at + 2]) / 8;
    image.data.set(map[pixel] === 1 ? [255, 96, 48, 255] : [grey, grey, grey, 255], at);
  }
  showImage(canvas, image);
}
