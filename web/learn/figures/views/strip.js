// The rows of the slice as a strip, filled by runs in their order.

import { blockName, clamp } from '../geometry.js';
import { at, box, kCharacter, knob, line, path, text } from '../markup.js';
import { drawing } from './own.js';

const kLabel = 20; // a label's height
const kTop = 6;

export function sliceStrip({
  names = true,
  rows = true,
  pick = true,
  tall = 300,
  title,
  ...others
} = {}) {
  const rowAt = ({ y }, now) => ({
    row: clamp(Math.floor(((y - kTop) * now.height) / tall), 0, now.height - 1),
  });
  return drawing({
    title,
    height: tall + 2 * kTop,
    ...others,
    label:
      others.label ??
      ((now) =>
        `The ${now.height} rows of column ${now.column}, filled by ${now.runs.length} runs.`),
    markup: (now, { width, id }) =>
      draw(now, width, { id: `${id}-hatch`, names, rows, pick, tall }),
    handles: (now, { width }) =>
      pick
        ? [
            {
              id: 'row',
              label: 'Row',
              axis: 'y',
              x: stripOf(width, names, pick).left - 13,
              y: yOf(now, now.row + 0.5, tall),
              value: now.row,
              least: 0,
              greatest: now.height - 1,
              says: `row ${now.row}, ${now.run === null ? 'open' : blockName(now.slice, now.run)}`,
              drag: (point) => rowAt(point, now),
              keys: (right, down) => ({ row: now.state.row + (down || right) }),
            },
          ]
        : [],
    click: pick ? rowAt : undefined,
  });
}

const yOf = ({ height }, row, tall) => kTop + (tall * row) / height;

function stripOf(width, names, pick) {
  const left = pick ? 28 : 2;
  return { left, wide: names ? clamp(width * 0.22, 40, 110) : width - left - 2 };
}

function draw(now, width, { id, names, rows, pick, tall }) {
  const { slice, runs } = now;
  const { left, wide } = stripOf(width, names, pick);
  const y = (row) => yOf(now, row, tall);
  const parts = [
    `<pattern id="${id}" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="8" height="8" class="fig-open"/><rect width="2" height="8" class="fig-open-line"/></pattern>`,
    `<pattern id="${id}-glass" width="10" height="10" patternUnits="userSpaceOnUse" patternTransform="rotate(-45)"><rect width="4" height="10" class="fig-glass"/></pattern>`,
    box(left, kTop, wide, tall, `fill="url(#${id})"`),
  ];
  const current = now.step?.of === 'run' ? now.step.index : -1;
  const labels = [];
  runs.forEach((run, index) => {
    labels.push({ run, index, middle: (y(run.first) + y(run.last + 1)) / 2 });
  });
  // Layers lie over what closes the rows, the nearest one on top.
  const over = runs.filter(({ layer }) => layer).reverse();
  for (const run of [...runs.filter(({ layer }) => !layer), ...over]) {
    const inset = run.layer ? wide * 0.3 : 0;
    parts.push(
      box(
        left + inset,
        y(run.first),
        wide - inset,
        y(run.last + 1) - y(run.first),
        run.layer ? `class="fig-run" fill="url(#${id}-glass)"` : `class="fig-run ${run.what}"`,
      ),
    );
  }
  if (current >= 0) {
    const run = runs[current];
    parts.push(
      box(left, y(run.first), wide, y(run.last + 1) - y(run.first), 'class="fig-run newest"'),
    );
  }
  labels.sort((a, b) => a.middle - b.middle);
  if (names) parts.push(named(now, labels, { left, wide, width, rows, tall, current }));
  else
    for (const { run, index, middle } of labels)
      if (y(run.last + 1) - y(run.first) >= 15)
        parts.push(
          text(
            left + wide / 2,
            middle + 4.5,
            String(index + 1),
            'class="fig-run-number on-run" text-anchor="middle"',
          ),
        );
  parts.push(
    line(
      left - 6,
      y(slice.horizonRow),
      left + wide + 6,
      y(slice.horizonRow),
      'class="fig-horizon"',
    ),
  );
  if (pick) {
    const middle = y(now.row + 0.5);
    parts.push(
      path(`M${left} ${at(middle)}H${at(left + wide)}`, 'class="fig-row-line edge"'),
      path(`M${left} ${at(middle)}H${at(left + wide)}`, 'class="fig-row-line"'),
      knob(left - 13, middle, 'ray', 8, 'y'),
    );
  }
  return parts.join('');
}

function named(now, all, { left, wide, width, rows, tall, current }) {
  // Where there is no room for all labels, the smallest runs go without.
  const most = Math.floor(tall / kLabel);
  const kept = new Set(
    [...all].sort((a, b) => b.run.last - b.run.first - (a.run.last - a.run.first)).slice(0, most),
  );
  const labels = all.filter((label) => kept.has(label) || label.index === current);
  spread(labels, kLabel, kTop, tall);
  const right = left + wide;
  return labels
    .map(({ run, index, middle, y }) => {
      const range = run.first === run.last ? `${run.first}` : `${run.first}–${run.last}`;
      const number = String(index + 1);
      const nameAt = right + 26 + number.length * kCharacter + 6;
      const room = width - nameAt - (rows ? range.length * kCharacter + 8 : 0);
      const weight = index === current ? ' now' : '';
      return (
        path(`M${at(right)} ${at(middle)}h6L${at(right + 20)} ${at(y)}`, 'class="fig-leader"') +
        text(right + 24, y + 4.5, number, 'class="fig-run-number"') +
        text(nameAt, y + 4.5, cut(blockName(now.slice, run), room), `class="fig-name${weight}"`) +
        (rows ? text(width, y + 4.5, range, 'class="soft" text-anchor="end"') : '')
      );
    })
    .join('');
}

// A name that fits; of "wall, side" the last word is kept.
function cut(name, room) {
  if (name.length * kCharacter <= room) return name;
  const short = name.split(', ').at(-1);
  if (short.length * kCharacter <= room) return short;
  return room < 3 * kCharacter ? '' : `${short.slice(0, Math.floor(room / kCharacter) - 1)}…`;
}

// Labels beside their rows, pushed apart so that they do not touch.
export function spread(labels, gap, from, tall) {
  let lowest = from + gap / 2;
  for (const label of labels) {
    label.y = Math.max(label.middle, lowest);
    lowest = label.y + gap;
  }
  let highest = from + tall - gap / 2;
  for (const label of [...labels].reverse()) {
    label.y = Math.min(label.y, highest);
    highest = label.y - gap;
  }
}
