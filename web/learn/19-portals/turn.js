// A portal's tile and its exit tile: the eye's offset from the middle of the one, turned, is its
// offset from the middle of the other.

import { box, choice, drawing, fixed, knob, line, text } from '../figures/kit.js';

const kReach = 3.5; // units from the middle of the tile to the drawing's edges

export const turned = ([x, y], quarters) =>
  quarters === 0 ? [x, y] : turned([-y, x], quarters - 1);

const unitOf = ({ width, height }) => Math.min(width, height) / (2 * kReach);

const placeOf = (view, [x, y]) => [
  view.width / 2 + x * unitOf(view),
  view.height / 2 + y * unitOf(view),
];

function grid(view) {
  const lines = [];
  for (let i = -3.5; i <= 3.5; ++i) {
    lines.push(line(...placeOf(view, [i, -3.5]), ...placeOf(view, [i, 3.5]), 'class="fig-grid"'));
    lines.push(line(...placeOf(view, [-3.5, i]), ...placeOf(view, [3.5, i]), 'class="fig-grid"'));
  }
  return lines.join('');
}

// The two sides of the triangle: the one that was along x in the portal's map stays blue.
function triangle(view, offset, quarters) {
  const middle = placeOf(view, [0, 0]);
  const corner = placeOf(view, turned([offset[0], 0], quarters));
  const eye = placeOf(view, turned(offset, quarters));
  return [
    line(...middle, ...corner, 'stroke="var(--across)" stroke-width="4"'),
    line(...corner, ...eye, 'stroke="var(--along)" stroke-width="4" stroke-dasharray="9 4"'),
    line(...eye, ...middle, 'class="fig-ray"'),
  ].join('');
}

function markup(view, offset, quarters, name) {
  const [x, y] = placeOf(view, [-0.5, -0.5]);
  const unit = unitOf(view);
  const eye = placeOf(view, turned(offset, quarters));
  const [labelX, labelY] = placeOf(view, [0, 0.95]);
  return [
    grid(view),
    box(x, y, unit, unit, 'class="fig-lit"'),
    triangle(view, offset, quarters),
    text(labelX, labelY, name, 'class="halo" text-anchor="middle"'),
    knob(...eye, 'eye'),
  ].join('');
}

const limited = (value) => Math.max(-3.2, Math.min(3.2, Math.round(value * 10) / 10));
const written = ([x, y]) => `(${fixed(x, 1)}, ${fixed(y, 1)})`;
const offsetBeyond = ({ offset, turn }) => turned(offset, Number(turn));

const height = (width) => Math.min(300, width);

export default {
  scene: 'yard.json',
  view: '7.5,6.4,0.5,90,0',
  size: [480, 300],
  state: { offset: [-0.8, -2.4], turn: '1' },
  controls: [
    choice({ label: 'Turn', field: 'turn', of: { 0: 'none', 1: '90°', 2: '180°', 3: '270°' } }),
  ],
  rows: [
    [
      drawing({
        title: 'Before the portal',
        height,
        label: ({ state }) => `The eye is ${written(state.offset)} from the middle of the portal`,
        markup: ({ state }, view) => markup(view, state.offset, 0, 'portal'),
        handles: ({ state }, view) => {
          const [x, y] = placeOf(view, state.offset);
          return [
            {
              id: 'eye',
              label: 'Eye',
              x,
              y,
              value: state.offset[0],
              least: -3.2,
              greatest: 3.2,
              says: written(state.offset),
              drag: (point) => ({
                offset: [
                  limited((point.x - view.width / 2) / unitOf(view)),
                  limited((point.y - view.height / 2) / unitOf(view)),
                ],
              }),
              keys: (right, down, now) => ({
                offset: [
                  limited(now.state.offset[0] + 0.1 * right),
                  limited(now.state.offset[1] + 0.1 * down),
                ],
              }),
            },
          ];
        },
      }),
      drawing({
        title: 'As seen from beyond',
        height,
        label: ({ state }) =>
          `The eye is ${written(offsetBeyond(state))} from the middle of the exit`,
        markup: ({ state }, view) => markup(view, state.offset, Number(state.turn), 'exit'),
      }),
    ],
  ],
  numbers: { beyond: ({ state }) => written(offsetBeyond(state)) },
  says: ({ state }) =>
    `Offset ${written(state.offset)} from the portal's middle becomes ${written(offsetBeyond(state))} from the middle of the exit.`,
};
