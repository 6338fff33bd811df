// Eye and picture from straight above, for a picture of eight columns: how far the picture is away,
// and how far to the side a column looks.

import {
  box,
  degrees,
  dot,
  drawing,
  fixed,
  knob,
  line,
  path,
  polygon,
  slider,
  text,
} from '../figures/kit.js';

const kMargin = 44; // pixels at either side of the pane
const kAbove = 108; // pixels above the pane
const kBelow = 40; // below the eye
const kLeastAngle = 60; // degrees: the eye is farthest away

const tangentOf = (fov) => Math.tan((fov * Math.PI) / 360);

// In pixels of the drawing: one column of the pane is `unit` wide.
function frameOf(now, width) {
  const unit = Math.min((width - 2 * kMargin) / now.width, 46);
  const half = (unit * now.width) / 2;
  const middle = width / 2;
  const pane = kAbove;
  const height = Math.round(kAbove + half / tangentOf(kLeastAngle) + kBelow);
  const distance = half / tangentOf(now.slice.fov);
  return { unit, half, middle, pane, distance, eye: pane + distance, height };
}

const sideOf = ({ column, width }) => column + 0.5 - width / 2;
const kOne = 0.4; // of the way to the pane: where the drawing shows one unit forward
const kTall = 36; // pixels: the boxes of the columns

function markup(now, { width }) {
  const it = frameOf(now, width);
  const { unit, half, middle, pane, distance, eye } = it;
  const side = sideOf(now) * unit;
  const parts = [];
  // The field of view.
  parts.push(
    polygon(
      [
        [middle, eye],
        [middle - half, pane],
        [middle + half, pane],
      ],
      'fill="var(--sheet)" stroke="var(--soft)" stroke-width="1"',
    ),
  );
  // The triangle of eye, middle and column.
  parts.push(
    polygon(
      [
        [middle, eye],
        [middle, pane],
        [middle + side, pane],
      ],
      'fill="var(--lit)" fill-opacity="0.45"',
    ),
    line(middle, eye, middle, pane, 'stroke="var(--ink)" stroke-dasharray="5 4"'),
  );
  // The pane and its columns.
  for (let column = 0; column < now.width; ++column) {
    const x = middle - half + column * unit;
    const isChosen = column === now.column;
    parts.push(
      box(
        x,
        pane - kTall,
        unit,
        kTall,
        `fill="${isChosen ? 'var(--lit)' : 'var(--paper)'}" stroke="var(--ink)"`,
      ),
      text(
        x + unit / 2,
        pane - 17,
        String(column),
        `text-anchor="middle" class="strong${isChosen ? ' on-lit' : ''}"`,
      ),
    );
  }
  // The ray goes on behind the pane.
  const reach = (pane - 22) / distance;
  parts.push(
    line(
      middle,
      eye,
      middle + side,
      pane,
      'stroke="var(--ray)" stroke-width="3" stroke-linecap="round"',
    ),
    line(
      middle + side * (kTall / distance + 1),
      pane - kTall,
      middle + side * (1 + reach),
      pane - distance * reach,
      'stroke="var(--ray)" stroke-width="2" stroke-dasharray="7 5"',
    ),
  );
  parts.push(labels(now, it, side));
  parts.push(
    dot(middle, eye, 8, 'fill="var(--ray)" stroke="var(--paper)" stroke-width="2"'),
    text(middle, eye + 26, 'eye', 'text-anchor="middle"'),
    knob(middle + side, pane, 'ray'),
    knob(middle + half, pane, 'across', 9),
  );
  return parts.join('');
}

function labels(now, { middle, pane, distance, eye }, side) {
  const left = side < 0;
  const beside = left ? 10 : -10;
  const anchor = left ? 'start' : 'end';
  const angle = (now.slice.fov * Math.PI) / 360;
  const radius = Math.min(44, distance * 0.4);
  const arcX = middle - radius * Math.sin(angle);
  const arcY = eye - radius * Math.cos(angle);
  return (
    // Half of the field of view, on the left.
    path(
      `M${middle} ${eye - radius}A${radius} ${radius} 0 0 0 ${arcX.toFixed(2)} ${arcY.toFixed(2)}`,
      'fill="none" stroke="var(--ink)" stroke-width="1.5"',
    ) +
    text(
      middle - 26 * Math.tan(angle) - 12,
      eye - 12,
      `fov / 2 = ${degrees(now.slice.fov / 2, now.slice.fov % 2 ? 1 : 0)}`,
      'class="halo" text-anchor="end"',
    ) +
    text(
      middle + beside,
      pane + distance * 0.3,
      `d = ${fixed(now.slice.projectionDistance)}`,
      `class="halo strong" text-anchor="${anchor}"`,
    ) +
    // The small triangle: one unit forward, k to the side.
    line(
      middle,
      eye - distance * kOne,
      middle + side * kOne,
      eye - distance * kOne,
      'stroke="var(--ink)" stroke-width="2"',
    ) +
    text(
      middle + (left ? 8 : -8),
      eye - distance * kOne + 5,
      '1 forward',
      `class="halo" text-anchor="${anchor}"`,
    ) +
    text(
      middle + side * kOne + (left ? -14 : 14),
      eye - distance * kOne + 5,
      `k = ${fixed(sideOf(now) / now.slice.projectionDistance, 3)}`,
      `class="halo ray" text-anchor="${left ? 'end' : 'start'}"`,
    ) +
    // From the middle to the column.
    path(
      `M${middle} ${pane - kTall - 8}v-8h${side.toFixed(2)}v8`,
      'fill="none" stroke="var(--ink)" stroke-width="1.5"',
    ) +
    text(
      middle + (left ? 8 : -8),
      pane - kTall - 8,
      `${now.column} + ½ − ${now.width / 2} = ${fixed(sideOf(now), 1)}`,
      `class="halo strong" text-anchor="${anchor}"`,
    )
  );
}

function handles(now, { width }) {
  const { unit, half, middle, pane } = frameOf(now, width);
  const fov = now.slice.fov;
  return [
    {
      id: 'column',
      label: 'Column',
      axis: 'x',
      x: middle + sideOf(now) * unit,
      y: pane,
      value: now.column,
      least: 0,
      greatest: now.width - 1,
      says: `column ${now.column} of ${now.width}`,
      drag: ({ x }) => ({ column: Math.floor((x - middle + half) / unit) }),
      keys: (right) => ({ column: now.state.column + right }),
    },
    {
      id: 'fov',
      label: 'Field of view',
      axis: 'x',
      x: middle + half,
      y: pane,
      value: fov,
      least: kLeastAngle,
      greatest: 120,
      says: `${fov} degrees`,
      // To the right, the angle grows.
      drag: ({ x }, _, start) => ({
        fov: Math.max(
          kLeastAngle,
          Math.min(120, Math.round(start.state.fov + (x - start.point.x) / 3)),
        ),
      }),
      keys: (right) => ({ fov: Math.max(kLeastAngle, Math.min(120, now.state.fov + right)) }),
    },
  ];
}

export default {
  scene: 'yard-1.json',
  view: '1.6,6.7,0.5,345',
  size: [8, 5],
  state: { column: 6 },
  controls: [
    slider({ label: 'Column', field: 'column' }),
    slider({
      label: 'Field of view',
      option: 'fov',
      from: kLeastAngle,
      to: 120,
      unit: '°',
      opening: 66,
    }),
  ],
  rows: [
    [
      drawing({
        label: (now) =>
          `Eye and picture from above: column ${now.column} is ${fixed(sideOf(now), 1)} columns from the middle, and the picture ${fixed(now.slice.projectionDistance)} columns from the eye`,
        height: (width, now) => frameOf(now, width).height,
        markup,
        handles,
      }),
    ],
  ],
  numbers: {
    column: (now) => String(now.column),
    side: (now) => fixed(sideOf(now), 1),
    distance: (now) => fixed(now.slice.projectionDistance),
    k: (now) => fixed(sideOf(now) / now.slice.projectionDistance, 3),
  },
  says: (now) =>
    `k = ${fixed(sideOf(now), 1)} ÷ ${fixed(now.slice.projectionDistance)} = ${fixed(sideOf(now) / now.slice.projectionDistance, 3)}`,
};
