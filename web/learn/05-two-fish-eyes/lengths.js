// The eye before a wall, from above: the ray of one column is longer than it reaches forward.

import {
  box,
  dot,
  drawing,
  fixed,
  knob,
  line,
  numberTable,
  path,
  picture,
  polygon,
  slider,
  text,
} from '../figures/kit.js';

const kWall = 1; // y of the wall's face

function frameOf(now, width) {
  const depth = now.eye.y - kWall;
  const reach = (depth * now.width) / 2 / now.slice.projectionDistance; // units to either side
  const unit = Math.min((width - 40) / (2 * reach), 100);
  const wall = 58;
  const eye = wall + unit * depth;
  return { unit, wall, eye, middle: width / 2, reach, depth, height: Math.round(eye + 40) };
}

const slopeOfColumn = (now) => (now.column + 0.5 - now.width / 2) / now.slice.projectionDistance;
const lengthsOf = (now) => {
  const { depth, rawDepth } = now.slice.hits[0];
  return { depth, distance: rawDepth };
};
const rowsOf = (now, length) => now.slice.projectionDistance / length;

function markup(now, { width }) {
  const { unit, wall, eye, middle, reach, depth } = frameOf(now, width);
  const k = slopeOfColumn(now);
  const x = middle + unit * depth * k;
  const { distance } = lengthsOf(now);
  const onArc = depth / distance; // of the ray: where it is as long as the depth
  const isLeft = k < 0;
  const radius = unit * depth;
  return [
    polygon(
      [
        [middle, eye],
        [middle - unit * reach, wall],
        [middle + unit * reach, wall],
      ],
      'fill="var(--sheet)"',
    ),
    box(0, wall - 14, width, 14, 'fill="var(--roof)"'),
    // Points that are as far away as the wall straight ahead.
    path(
      `M${middle - radius * Math.sin(0.95)} ${eye - radius * Math.cos(0.95)}A${radius} ${radius} 0 0 1 ${middle + radius * Math.sin(0.95)} ${eye - radius * Math.cos(0.95)}`,
      'fill="none" stroke="var(--soft)" stroke-dasharray="4 5"',
    ),
    // The depth: forward only.
    line(middle, eye, middle, wall, 'stroke="var(--ink)" stroke-width="3"'),
    line(middle, wall, x, wall, 'stroke="var(--ink)" stroke-width="1.5" stroke-dasharray="4 4"'),
    line(middle, eye, x, wall, 'stroke="var(--ray)" stroke-width="3"'),
    dot(
      middle + (x - middle) * onArc,
      eye + (wall - eye) * onArc,
      4,
      'fill="var(--paper)" stroke="var(--ray)" stroke-width="2"',
    ),
    text(
      middle + (isLeft ? 8 : -8),
      (eye + wall) / 2 + 24,
      `depth ${fixed(depth)}`,
      `class="halo strong" text-anchor="${isLeft ? 'start' : 'end'}"`,
    ),
    text(
      (middle + x) / 2 + (isLeft ? -10 : 10),
      (eye + wall) / 2 + 34,
      `distance ${fixed(distance)}`,
      `class="halo ray" text-anchor="${isLeft ? 'end' : 'start'}"`,
    ),
    text(middle, 34, 'the wall, from above', 'text-anchor="middle" class="soft"'),
    dot(middle, eye, 8, 'fill="var(--ink)" stroke="var(--paper)" stroke-width="2"'),
    knob(x, wall, 'ray'),
  ].join('');
}

function handles(now, { width }) {
  const { unit, wall, middle, depth } = frameOf(now, width);
  return [
    {
      id: 'column',
      label: 'Column',
      axis: 'x',
      x: middle + unit * depth * slopeOfColumn(now),
      y: wall,
      value: now.column,
      least: 0,
      greatest: now.width - 1,
      says: `column ${now.column} of ${now.width}`,
      drag: ({ x }) => ({
        column: Math.floor(
          ((x - middle) / unit / depth) * now.slice.projectionDistance + now.width / 2,
        ),
      }),
      keys: (right) => ({ column: now.state.column + right }),
    },
  ];
}

export default {
  scene: 'long-wall.json',
  view: '20.5,3.2,0.5,270',
  options: { fov: 90 },
  state: { column: 420 },
  controls: [slider({ label: 'Column', field: 'column' })],
  rows: [
    [
      drawing({
        label: (now) =>
          `From above: the wall is at depth ${fixed(lengthsOf(now).depth)}, and ${fixed(lengthsOf(now).distance)} away along the ray`,
        height: (width, now) => frameOf(now, width).height,
        markup,
        handles,
      }),
      picture({ handles: ['column'] }),
    ],
    [
      numberTable({
        caption: 'One column, two lengths',
        items: (now) => {
          const { depth, distance } = lengthsOf(now);
          return [
            { name: 'depth', length: depth },
            { name: 'distance', length: distance },
          ];
        },
        columns: [
          { head: 'Divide by', value: ({ name }) => name },
          { head: 'Length', value: ({ length }) => fixed(length), class: 'number' },
          {
            head: 'Rows',
            value: ({ length }, index, now) => fixed(rowsOf(now, length), 1),
            class: 'number',
          },
        ],
      }),
    ],
  ],
  numbers: {
    column: (now) => String(now.column),
    depth: (now) => fixed(lengthsOf(now).depth),
    distance: (now) => fixed(lengthsOf(now).distance),
    rows: (now) => fixed(rowsOf(now, lengthsOf(now).depth), 1),
    short: (now) => fixed(rowsOf(now, lengthsOf(now).distance), 1),
  },
  says: (now) => {
    const { depth, distance } = lengthsOf(now);
    return `Column ${now.column}: the distance is ${fixed(distance / depth, 3)} times the depth.`;
  },
};
