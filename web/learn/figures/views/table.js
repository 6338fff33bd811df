// A list of the trace as a table, with the page's own arithmetic beside the engine's numbers.

import { crossing } from '../geometry.js';
import { escape, fixed } from '../markup.js';
import { panel } from './own.js';

export function numberTable({
  of = 'walk',
  columns,
  items,
  current,
  caption,
  limit = 200,
  ...others
} = {}) {
  const table = columns ? { columns, items, current: current ?? (() => -1) } : kTables[of];
  return panel({
    ...others,
    markup: (now) => {
      const list = table.items(now).slice(0, limit);
      const marked = (current ?? table.current)(now);
      const title = caption ?? others.title ?? '';
      const about = typeof title === 'string' && title !== '' ? escape(title) : 'Numbers';
      const head = table.columns
        .map(({ head: name, class: kind = '' }) =>
          name === '' ? '<td></td>' : `<th scope="col" class="${kind}">${name}</th>`,
        )
        .join('');
      const body = list.map((item, index) => {
        const isNow = Array.isArray(marked) ? marked.includes(index) : index === marked;
        const cells = table.columns
          .map(
            ({ value, class: kind = '' }) => `<td class="${kind}">${value(item, index, now)}</td>`,
          )
          .join('');
        return `<tr${isNow ? ' class="now" aria-current="step"' : ''}>${cells}</tr>`;
      });
      const itsCaption = caption ? `<caption>${escape(caption)}</caption>` : '';
      return `<div class="fig-scroll" tabindex="0" role="region" aria-label="${about}"><table class="fig-table">${itsCaption}<thead><tr>${head}</tr></thead><tbody>${body.join('')}</tbody></table></div>`;
    },
  });
}

// Without the zeros at its end, if nothing is rounded away.
const short = (number, digits) => {
  const isWhole = Number(number.toFixed(digits)) === number;
  const written = isWhole ? String(number).replace('-', '−') : fixed(number, digits);
  return number < 0 ? `(${written})` : written;
};

// `=`: the page's own number is the engine's in every bit, and not only in the digits shown.
const agreed = (own, engine) => `${own === engine ? '= ' : ''}${fixed(engine, 6)}`;

const named = ({ axis, border }) =>
  `<span class="${axis === 'x' ? 'across' : 'along'}">${axis === 'x' ? '▲' : '▼'} ${axis} = ${border}</span>`;

const kTables = {
  walk: {
    items: ({ slice, tiles, eyes }) =>
      tiles.slice(1).map((_, index) => ({ place: index + 2, ...crossing(slice, index + 1, eyes) })),
    current: ({ step, tiles }) => (step?.of === 'walk' ? tiles.length - 2 : -1),
    columns: [
      { head: 'Tile', value: ({ place }) => String(place), class: 'number' },
      { head: 'Border', value: named },
      {
        head: '(border − eye) ÷ ray',
        value: ({ border, eye, ray }) => `(${border} − ${short(eye, 3)}) ÷ ${short(ray, 4)}`,
      },
      { head: 'Depth', value: ({ quotient }) => fixed(quotient, 6), class: 'number' },
      { head: 'Engine', value: ({ quotient, depth }) => agreed(quotient, depth), class: 'number' },
    ],
  },
  runs: {
    items: ({ runs }) => runs,
    current: ({ step, runs }) => (step?.of === 'run' ? runs.length - 1 : -1),
    columns: [
      { head: 'Run', value: (_, index) => String(index + 1), class: 'number' },
      {
        head: 'Shows',
        value: (run, _, now) =>
          `<svg class="fig-swatch" viewBox="0 0 16 16" width="16" height="16" aria-hidden="true"><rect width="16" height="16" class="fig-run-swatch ${run.what}"/></svg> ${escape(now.blockName(now.slice, run))}${run.layer ? ', seen through' : ''}`,
      },
      { head: 'Face', value: ({ face }) => face ?? '', class: '' },
      { head: 'First row', value: ({ first }) => String(first), class: 'number' },
      { head: 'Last row', value: ({ last }) => String(last), class: 'number' },
    ],
  },
  hits: {
    items: ({ slice }) => slice.hits,
    current: ({ run }) => run?.hit ?? -1,
    columns: [
      { head: 'Block', value: ({ blueprint }) => escape(blueprint) },
      {
        head: 'Tile',
        value: ({ tile, level }) => `${tile.join(', ')}${level > 0 ? `, level ${level}` : ''}`,
      },
      { head: 'Face', value: ({ face }) => face ?? 'your own tile' },
      { head: 'Depth', value: ({ depth }) => fixed(depth), class: 'number' },
      { head: 'Back', value: ({ backDepth }) => fixed(backDepth ?? Infinity), class: 'number' },
      { head: 'Bottom', value: ({ bottom }) => fixed(bottom), class: 'number' },
      { head: 'Top', value: ({ top }) => fixed(top), class: 'number' },
      { head: 'Rows', value: rowsOf },
    ],
  },
};

function rowsOf(hit, index, { slice, runs }) {
  const all = slice.runs.filter((run) => run.hit === index);
  const shown = runs.filter((run) => run.hit === index);
  if (shown.length === 0) return all.length === 0 ? 'none' : '…';
  return shown.map(({ what, first, last }) => `${what} ${first}–${last}`).join(', ');
}
