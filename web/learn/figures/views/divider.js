// Two pictures of the same eye, one over the other, with a divider to drag.

import { line, knob } from '../markup.js';
import { marks } from './picture.js';

export function divider({
  left = {},
  right,
  mark = 'none',
  title,
  share = 1,
  over,
  ...others
} = {}) {
  return {
    kind: 'divider',
    title,
    share,
    left,
    right,
    ...others,
    markup: (now) => marks(now, mark) + (over?.(now) ?? ''),
    knobs: (now, { width, height }) => {
      const x = now.state.split * width;
      return (
        line(x, 0, x, height, 'class="fig-split edge"') +
        line(x, 0, x, height, 'class="fig-split"') +
        knob(x, height / 2, 'turn', 11, 'x')
      );
    },
    handles: (now, { width, height }) => [
      {
        id: 'split',
        label: 'Divider',
        axis: 'x',
        x: now.state.split * width,
        y: height / 2,
        value: Math.round(100 * now.state.split),
        least: 0,
        greatest: 100,
        says: `${Math.round(100 * now.state.split)} percent: ${titles({ left, right }, now).join(', ')}`,
        drag: ({ x }) => ({ split: x / width }),
        keys: (right_) => ({ split: Math.round(100 * now.state.split + right_) / 100 }),
      },
    ],
    labels: (now) => titles({ left, right }, now),
    point:
      mark === 'slice'
        ? (now, { x }, { width }) => ({ column: Math.floor((x * now.width) / width) })
        : undefined,
  };
}

const valueOf = (of, state) => (typeof of === 'function' ? of(state) : of);

function titles({ left, right }, { state }) {
  return [left, right].map(
    (side, index) =>
      valueOf(side.title, state) ??
      valueOf(side.oldWay, state) ??
      (index === 0 ? 'exact' : 'other'),
  );
}

// What each side shows: {options} of the engine, or {draw}.
export function sidesOf({ left, right }, { state, source }) {
  return [left, right].map(({ options, oldWay, draw }) => {
    if (draw) return { draw };
    const name = valueOf(oldWay, state);
    if (name == null) return { options: valueOf(options, state) ?? null };
    const way = source.oldWays.find((each) => each.name === name);
    if (way === undefined) throw new Error(`divider: there is no old way "${name}"`);
    return { options: { ...way.options, method: 'classic' } };
  });
}
