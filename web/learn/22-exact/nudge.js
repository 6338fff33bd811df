// The eye moved by a little, and by far less: then no ray meets a corner.

import { box, choice, dot, drawing, fixed, line, mark, slider, text } from '../figures/kit.js';

const kWays = {
  45: 'south-east',
  135: 'south-west',
  225: 'north-west',
  315: 'north-east',
};
// Where the eye stands, so that its ray meets the corner at (1, 1) of the drawing's 2 x 2 tiles.
const kBegin = { 45: [0.2, 0.2], 135: [1.8, 0.2], 225: [1.8, 1.8], 315: [0.2, 1.8] };

// The ray of the moved eye: where it begins, which border it crosses first, and where.
function rayOf({ way, nudge }) {
  const angle = (Number(way) * Math.PI) / 180;
  const ray = [Math.sign(Math.cos(angle)), Math.sign(Math.sin(angle))];
  const [x, y] = kBegin[way];
  const eye = [x + nudge, y + nudge * nudge];
  const depths = [(1 - eye[0]) / ray[0], (1 - eye[1]) / ray[1]];
  const axis = depths[0] < depths[1] || (depths[0] === depths[1] && ray[0] > 0) ? 'x' : 'y';
  return { ray, eye, depths, axis };
}

function markup({ state }, { width, height }) {
  const unit = Math.min(width, height) / 2;
  const left = (width - 2 * unit) / 2;
  const at = ([x, y]) => [left + x * unit, y * unit];
  const { ray, eye, depths, axis } = rayOf(state);
  const point = (depth) => [eye[0] + depth * ray[0], eye[1] + depth * ray[1]];
  const [first, second] = [...depths].sort((a, b) => a - b);
  const middle = point((first + second) / 2);
  // The tile that it passes between the two borders: if there is no time between them, the rule's.
  const between = [
    axis === 'x' ? (ray[0] > 0 ? 1 : 0) : ray[0] > 0 ? 0 : 1,
    axis === 'y' ? (ray[1] > 0 ? 1 : 0) : ray[1] > 0 ? 0 : 1,
  ];
  const parts = [];
  for (const x of [0, 1])
    for (const y of [0, 1]) {
      const isPassed = x === between[0] && y === between[1];
      parts.push(box(...at([x, y]), unit, unit, `class="${isPassed ? 'fig-lit' : 'fig-ground'}"`));
    }
  parts.push(
    line(...at([1, 0]), ...at([1, 2]), 'class="fig-tick across"'),
    line(...at([0, 1]), ...at([2, 1]), 'class="fig-tick along"'),
    line(...at(eye), ...at(point(1.5)), 'class="fig-ray"'),
    mark(...at(point(depths[0])), 'x', 8),
    mark(...at(point(depths[1])), 'y', 8),
    dot(...at(eye), 7, 'class="fig-eye"'),
    text(
      ...at([middle[0], middle[1]]).map((n, i) => n + (i ? -10 : 10)),
      `${axis} first`,
      'class="fig-order"',
    ),
  );
  return parts.join('');
}

export default {
  scene: 'corner.json',
  view: '5,5,0.5,45',
  controls: [
    choice({ label: 'The ray goes', field: 'way', of: kWays }),
    slider({
      label: 'Move the eye east by',
      field: 'nudge',
      from: 0,
      to: 0.3,
      step: 0.01,
      opening: 0.15,
      unit: 'units',
    }),
  ],
  rows: [
    [
      drawing({
        title: 'Four tiles around a corner',
        label: ({ state }) =>
          `A ray to the ${kWays[state.way]}; it crosses the ${rayOf(state).axis} border first`,
        height: (width) => Math.min(360, width),
        markup,
      }),
    ],
  ],
  numbers: {
    east: ({ state }) => fixed(state.nudge, 2),
    south: ({ state }) => fixed(state.nudge * state.nudge, 4),
    axis: ({ state }) => rayOf(state).axis,
  },
  says: ({ state }) =>
    `The eye is ${fixed(state.nudge, 2)} further east and ${fixed(state.nudge ** 2, 4)} further south. The ray to the ${kWays[state.way]} crosses the ${rayOf(state).axis} border first.`,
};
