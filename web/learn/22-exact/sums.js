// Depths as sums and depths as quotients, at corners that a ray meets exactly.

import { choice, escape, fixed, numberTable, slider } from '../figures/kit.js';
import { agreements } from './ties.js';

const kCorners = 100;
const kBits = { double: (number) => number, single: Math.fround };

const listOf = (now) =>
  now.kept('corners', () =>
    agreements(now.state.right, now.state.down, kCorners, kBits[now.state.bits]),
  );
const missed = (now, way) =>
  listOf(now).filter((corner) => corner[way][0] !== corner[way][1]).length;
const firstMissed = (now, way) =>
  listOf(now).findIndex((corner) => corner[way][0] !== corner[way][1]) + 1;
const sign = ([x, y]) => escape(x === y ? '=' : x < y ? '<' : '>');

// A tiny number as digits and a power of ten.
function apart(difference) {
  if (difference === 0) return '0';
  const [digits, power] = difference.toExponential(1).replaceAll('-', '−').split('e');
  return `${digits} · 10<sup>${power}</sup>`;
}

export default {
  scene: 'corner.json',
  view: '5,5,0.5,45',
  controls: [
    slider({ label: 'East', field: 'right', from: 1, to: 480, opening: 240 }),
    slider({ label: 'South', field: 'down', from: 1, to: 480, opening: 80 }),
    choice({ label: 'Numbers of', field: 'bits', of: { double: '64 bits', single: '32 bits' } }),
  ],
  rows: [
    [
      numberTable({
        title: 'The first corners',
        caption: 'The x and the y border of each corner',
        items: (now) => listOf(now).slice(0, 8),
        columns: [
          { head: 'Corner', value: (corner, index) => String(index + 1), class: 'number' },
          { head: 'Sums', value: ({ sums }) => sign(sums) },
          { head: 'Quotients', value: ({ quotients }) => sign(quotients) },
          { head: 'Off by', value: ({ sums: [x, y] }) => apart(x - y), class: 'number' },
          { head: 'Depth', value: ({ quotients }) => fixed(quotients[0], 4), class: 'number' },
        ],
      }),
    ],
  ],
  numbers: {
    corners: () => String(kCorners),
    sums: (now) => String(missed(now, 'sums')),
    quotients: (now) => String(missed(now, 'quotients')),
    first: (now) => String(firstMissed(now, 'sums') || '–'),
  },
  says: (now) =>
    `Of ${kCorners} corners, sums get ${missed(now, 'sums')} wrong, quotients ${missed(now, 'quotients')}.`,
};
