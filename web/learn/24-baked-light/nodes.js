// Samples, nodes, and the light between them.

import {
  box,
  choice,
  clamp,
  dot,
  drawing,
  fixed,
  hex,
  knob,
  line,
  numberTable,
  text,
} from '../figures/kit.js';
import { kUnit } from './light.js';
import { lightOf } from './rays.js';

const kWindow = { x: 8, y: 4, size: 2 }; // tiles of the floor, in the low block's shadow
const kCells = 24; // of a tile's side, in the drawing of what lies between

const kRound = [
  [0, 0],
  [1, 0],
  [1, 1],
  [0, 1],
];

const faceOf = (x, y) => ({ box: null, x: Math.floor(x), y: Math.floor(y) });
const placeOf = (value) => Math.min(kUnit - 1, Math.floor((value - Math.floor(value)) * kUnit));
const grey = (light) => hex([light, light, light].map((c) => Math.min(255, c)));

function between(now) {
  const [x, y] = now.state.at;
  return now.kept('between', () => lightOf(now).between(faceOf(x, y), placeOf(x), placeOf(y)));
}

// Squares of light: [x, y, side, brightness].
function cells(now) {
  const light = lightOf(now);
  const { x: left, y: top, size } = kWindow;
  const isBetween = now.state.show === 'between';
  const count = isBetween ? kCells : 4;
  const list = [];
  for (let row = 0; row < size * count; ++row)
    for (let column = 0; column < size * count; ++column) {
      const [x, y] = [left + (column + 0.5) / count, top + (row + 0.5) / count];
      const face = faceOf(x, y);
      const area = light.areaOf(face);
      const quarter = light.quarter(face, area, column % 4, row % 4);
      const value = isBetween
        ? light.at(face, placeOf(x), placeOf(y))[1]
        : (quarter?.light[1] ?? null);
      const isCovered = light.isInside([x, y, 0.0002].map((each) => each * kUnit));
      list.push([column / count, row / count, 1 / count, isCovered ? null : value]);
    }
  return list;
}

// A node as the first square round it has it that has a sample of its own beside it; null: none.
function nodeAt(light, a, b) {
  for (const [east, south] of kRound) {
    const [column, row] = [a - east, b - south];
    if (Math.min(column, row) < 0 || Math.max(column, row) >= 2 * kWindow.size) continue;
    const face = faceOf(kWindow.x + column / 2, kWindow.y + row / 2);
    const area = light.areaOf(face);
    const square = [column % 2, row % 2];
    if (light.quarter(face, area, 2 * square[0] + east, 2 * square[1] + south) === null) continue;
    return light.node(face, area, square, [east, south])[1];
  }
  return null;
}

// The nodes of the window, on half units: [x, y, brightness].
function nodes(now) {
  const light = lightOf(now);
  const { size } = kWindow;
  const list = [];
  for (let b = 0; b <= 2 * size; ++b)
    for (let a = 0; a <= 2 * size; ++a) {
      const value = nodeAt(light, a, b);
      if (value !== null) list.push([a / 2, b / 2, value]);
    }
  return list;
}

const unitOf = ({ width }) => Math.min(width - 40, 460) / kWindow.size;
const leftOf = (size) => (size.width - kWindow.size * unitOf(size)) / 2;

function draw(now, size) {
  const unit = unitOf(size);
  const left = leftOf(size);
  const place = (x, y) => [left + unit * x, 20 + unit * y];
  const [x, y] = now.state.at;
  const [fromX, fromY] = [x - kWindow.x, y - kWindow.y];
  const corner = [Math.floor(fromX * 2) / 2, Math.floor(fromY * 2) / 2];
  const parts = cells(now).map(([column, row, side, value]) => {
    const [px, py] = place(column, row);
    const edge = unit * side + (now.state.show === 'between' ? 0.6 : 0);
    return box(
      px,
      py,
      edge,
      edge,
      value === null ? 'fill="var(--block)"' : `fill="${grey(value)}"`,
    );
  });
  for (let i = 0; i <= kWindow.size; ++i)
    parts.push(
      line(...place(i, 0), ...place(i, kWindow.size), 'class="fig-axis"'),
      line(...place(0, i), ...place(kWindow.size, i), 'class="fig-axis"'),
      text(place(i, 0)[0], 14, `x = ${kWindow.x + i}`, 'class="soft" text-anchor="middle"'),
    );
  parts.push(
    box(...place(...corner), unit / 2, unit / 2, 'fill="none" class="fig-outline now"'),
    ...nodes(now).map(([a, b, value]) =>
      dot(...place(a, b), 6, `fill="${grey(value)}" stroke="var(--across)" stroke-width="2.5"`),
    ),
    knob(...place(fromX, fromY), 'ray', 9),
  );
  return parts.join('');
}

function handles(now, size) {
  const unit = unitOf(size);
  const left = leftOf(size);
  const [x, y] = now.state.at;
  const even = (value, from) =>
    clamp(Math.round(value * 32) / 32, from + 0.03125, from + kWindow.size - 0.03125);
  return [
    {
      id: 'point',
      label: 'Point of the floor',
      x: left + unit * (x - kWindow.x),
      y: 20 + unit * (y - kWindow.y),
      value: x,
      least: kWindow.x,
      greatest: kWindow.x + kWindow.size,
      unit: 0.03125,
      says: `${fixed(x)}, ${fixed(y)}`,
      drag: (point) => ({
        at: [
          even(kWindow.x + (point.x - left) / unit, kWindow.x),
          even(kWindow.y + (point.y - 20) / unit, kWindow.y),
        ],
      }),
      keys: (right, down) => {
        const [atX, atY] = now.state.at;
        return { at: [even(atX + right / 32, kWindow.x), even(atY + down / 32, kWindow.y)] };
      },
    },
  ];
}

const kNames = ['north-west', 'north-east', 'south-west', 'south-east'];
const lightAt = (now) => {
  const [x, y] = now.state.at;
  return lightOf(now).at(faceOf(x, y), placeOf(x), placeOf(y))[1];
};

export default {
  scene: 'sunlit.json',
  view: '11.2,11.2,4.6,245,-0.42',
  options: { fov: 66 },
  state: { at: [8.65625, 4.15625], show: 'samples' },
  controls: [
    choice({
      label: 'Show',
      field: 'show',
      of: { samples: 'the samples', between: 'the light between nodes' },
    }),
  ],
  rows: [
    [
      drawing({
        title: 'Four tiles of the floor, from above',
        share: 3,
        label: (now) =>
          `The light at ${now.state.at.map((value) => fixed(value)).join(', ')} is ${lightAt(now)} of 256.`,
        height: (width) => Math.min(width - 40, 460) + 34,
        markup: draw,
        handles,
      }),
      numberTable({
        share: 2,
        caption: 'The point’s four nodes, in green',
        columns: [
          { head: 'node', value: (item, index) => kNames[index] },
          { head: 'light', class: 'number', value: ([light]) => String(light) },
          { head: 'weight', class: 'number', value: ([, weight]) => String(weight) },
        ],
        items(now) {
          const { nodes: list, weights } = between(now);
          return list.map((node, index) => [node[1], weights[index]]);
        },
      }),
    ],
  ],
  numbers: {
    east: (now) => String(between(now).share[0]),
    south: (now) => String(between(now).share[1]),
    light: (now) => String(lightAt(now)),
  },
  says(now) {
    const [east, south] = between(now).share;
    return `The point is ${east} of 128 steps to the east of its western nodes and ${south} to the south of its northern ones. Its light in green is ${lightAt(now)} of 256.`;
  },
};
