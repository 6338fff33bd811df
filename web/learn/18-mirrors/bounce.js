// A ray that bounces off the floor, and the same ray unfolded: a line from the mirrored eye.

import { box, dot, drawing, fixed, knob, line, polygon, text } from '../figures/kit.js';

const kDepth = 5; // of the wall, units
const kLimits = { least: 0.15, greatest: 1.6 };

const meetOf = ({ eyeHeight, point }) => (kDepth * eyeHeight) / (eyeHeight + point);

function scaleOf({ width, height }) {
  const unit = Math.min((width - 96) / kDepth, (height - 24) / 3.5);
  const left = 44;
  return { unit, at: (depth, z) => [left + depth * unit, height / 2 - z * unit] };
}

const kept = (value) => Math.min(kLimits.greatest, Math.max(kLimits.least, value));

function handle(field, label, depth) {
  return ({ state }, view) => {
    const { at, unit } = scaleOf(view);
    const [x, y] = at(depth, state[field]);
    return {
      id: field,
      label,
      x,
      y,
      value: state[field],
      ...kLimits,
      says: `${fixed(state[field])} units`,
      axis: 'y',
      drag: (point) => ({ [field]: kept((view.height / 2 - point.y) / unit) }),
      keys: (right, down, now) => ({ [field]: kept(now.state[field] - 0.05 * down) }),
    };
  };
}

const handles = [
  handle('eyeHeight', 'Height of the eye', 0),
  handle('point', 'Height of the point on the wall', kDepth),
];

function markup({ state }, view) {
  const { at, unit } = scaleOf(view);
  const { eyeHeight, point } = state;
  const meet = meetOf(state);
  const label = (depth, z, words, [right, down], attributes = '') => {
    const [x, y] = at(depth, z);
    return text(x + right, y + down, words, attributes);
  };
  const triangle = (z) =>
    polygon([at(0, 0), at(meet, 0), at(0, z)], 'fill="var(--lit)" opacity="0.45"');
  const [wallX, wallY] = at(kDepth, 1.7);
  const wall = (y, opacity) =>
    box(wallX, y, 12, 1.7 * unit, `fill="var(--stone)" opacity="${opacity}"`);
  return [
    wall(wallY, 1),
    wall(wallY + 1.7 * unit, 0.35),
    triangle(eyeHeight),
    triangle(-eyeHeight),
    line(...at(-0.3, 0), ...at(kDepth, 0), 'class="fig-axis" stroke-width="3"'),
    line(...at(0, -eyeHeight), ...at(kDepth, point), 'class="fig-sight" stroke-dasharray="5 5"'),
    line(...at(0, eyeHeight), ...at(meet, 0), 'class="fig-ray"'),
    line(...at(meet, 0), ...at(kDepth, point), 'class="fig-ray"'),
    knob(...at(0, eyeHeight), 'eye'),
    knob(...at(kDepth, point), 'ray'),
    dot(...at(0, -eyeHeight), 8, 'class="fig-eye mirrored"'),
    label(0, eyeHeight / 2, 'z', [-18, 4]),
    label(0, -eyeHeight / 2, 'z', [-18, 4]),
    label(kDepth, point / 2, 'p', [20, 4]),
    label(meet, 0, `t = ${fixed(meet)}`, [6, 18]),
    label(kDepth, 0, 'mirror', [-8, 18], 'text-anchor="end"'),
    label(0, -eyeHeight, 'mirrored eye', [16, 18]),
  ].join('');
}

export default {
  scene: 'yard-7.json',
  view: '5.5,7.6,0.5,325,0',
  size: [480, 300],
  state: { eyeHeight: 0.8, point: 1.2 },
  controls: [],
  rows: [
    [
      drawing({
        title: 'From the side',
        height: (width) => Math.min(400, width * 0.72),
        label: ({ state }) => `The ray meets the mirror at depth ${fixed(meetOf(state))}`,
        markup,
        handles: (now, view) => handles.map((make) => make(now, view)),
      }),
    ],
  ],
  numbers: { meet: ({ state }) => fixed(meetOf(state)) },
  says: ({ state }) =>
    `The ray falls from ${fixed(state.eyeHeight)} to the floor at depth ${fixed(meetOf(state))}, then rises to ${fixed(state.point)}.`,
};
