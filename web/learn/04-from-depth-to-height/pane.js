// Eye, pane and wall from the side: the lines to the wall's edges, and where they pass the pane.

import {
  box,
  dot,
  drawing,
  fixed,
  knob,
  line,
  path,
  picture,
  polygon,
  slider,
  text,
} from '../figures/kit.js';

const kWall = 1; // y of the wall's face, units
const kNearest = 1.6;
const kFarthest = 7.5;
const kPane = 1; // depth at which the pane is drawn, units
const kHeights = [0.05, 1.4]; // of the eye

function frameOf(width) {
  const unitX = (width - 62) / (kFarthest + 0.35);
  const unitZ = Math.min(190, Math.max(120, width * 0.24));
  const place = (t, z) => [34 + unitX * t, 30 + unitZ * (1.5 - z)];
  return { unitX, unitZ, place, height: Math.round(30 + unitZ * 1.5 + 62) };
}

function momentOf({ slice, eye }) {
  const hit = slice.hits[0];
  const onPane = (z) => eye.z + ((z - eye.z) * kPane) / hit.depth;
  return { hit, t: hit.depth, top: onPane(1), bottom: onPane(0) };
}

function markup(now, { width }) {
  const { place } = frameOf(width);
  const { eye, slice } = now;
  const { hit, t, top, bottom } = momentOf(now);
  const from = place(0, eye.z);
  const [wallX, wallTop] = place(t, 1);
  const [, wallBottom] = place(t, 0);
  const [paneX] = place(kPane, 0);
  const ground = place(0, 0)[1];
  const end = width - 8;
  const above = Math.round(slice.horizonRow - hit.topFrontRow);
  return [
    // Ground and horizon.
    box(0, ground, end, 10, 'fill="var(--block)"'),
    line(from[0], from[1], end, from[1], 'stroke="var(--soft)" stroke-dasharray="3 5"'),
    text(end, from[1] - 7, 'horizon', 'class="soft halo" text-anchor="end"'),
    // The two triangles above the eye's height, or below it.
    polygon([from, [wallX, from[1]], [wallX, wallTop]], 'fill="var(--lit)" fill-opacity="0.25"'),
    polygon([from, [paneX, from[1]], place(kPane, top)], 'fill="var(--lit)" fill-opacity="0.75"'),
    // The wall.
    box(wallX, wallTop, 16, wallBottom - wallTop, 'fill="var(--roof)"'),
    // The pane.
    line(paneX, place(0, 1.42)[1], paneX, ground, 'stroke="var(--ink)" stroke-width="2"'),
    text(paneX, place(0, 1.42)[1] - 6, 'pane', 'text-anchor="middle"'),
    line(...place(kPane, top), ...place(kPane, bottom), 'stroke="var(--roof)" stroke-width="7"'),
    // The lines to the edges.
    line(...from, wallX, wallTop, 'stroke="var(--ray)" stroke-width="2.5"'),
    line(...from, wallX, wallBottom, 'stroke="var(--ray)" stroke-width="2.5"'),
    dot(...place(kPane, top), 5, 'fill="var(--ray)" stroke="var(--paper)" stroke-width="1.5"'),
    dot(...place(kPane, bottom), 5, 'fill="var(--ray)" stroke="var(--paper)" stroke-width="1.5"'),
    // Lengths.
    length(from[0], paneX, ground + 24, 'd'),
    length(from[0], wallX, ground + 48, `t = ${fixed(t)}`),
    text(
      paneX + 9,
      (from[1] + place(kPane, top)[1]) / 2 + 5,
      `${above} rows`,
      'class="halo strong" text-anchor="start"',
    ),
    text(
      Math.min(wallX + 22, width - 4),
      (wallTop + from[1]) / 2 + 5,
      wallX > width - 80 ? '' : `${fixed(1 - eye.z)} units`,
      'class="halo strong" text-anchor="start"',
    ),
    line(...from, from[0], ground, 'stroke="var(--ink)" stroke-width="2"'),
    knob(...from, 'eye'),
    knob(wallX + 8, ground - 12, 'ray'),
  ].join('');
}

function length(from, to, y, name) {
  return (
    path(
      `M${from} ${y - 5}v10M${from} ${y}H${to}M${to} ${y - 5}v10`,
      'stroke="var(--ink)" stroke-width="1.5"',
    ) +
    box(
      (from + to) / 2 - 4 * name.length - 4,
      y - 8,
      8 * name.length + 8,
      16,
      'fill="var(--paper)"',
    ) +
    text((from + to) / 2, y + 4, name, 'class="strong" text-anchor="middle"')
  );
}

const clampTo = (least, most, value) => Math.max(least, Math.min(most, value));
const awayBy = (t) => ({ eye: { y: kWall + clampTo(kNearest, kFarthest, t) } });
const liftedTo = (z) => ({ eye: { z: clampTo(...kHeights, z) } });

function handles(now, { width }) {
  const { unitX, unitZ, place } = frameOf(width);
  const { eye } = now;
  const t = eye.y - kWall;
  const [wallX, ground] = place(t, 0);
  return [
    {
      id: 'eye',
      label: 'Height of the eye',
      axis: 'y',
      x: place(0, 0)[0],
      y: place(0, eye.z)[1],
      value: Number(eye.z.toFixed(2)),
      least: kHeights[0],
      greatest: kHeights[1],
      says: `${fixed(eye.z)} units`,
      drag: ({ y }) => liftedTo(1.5 - (y - 30) / unitZ),
      keys: (right, down) => liftedTo(now.state.eye.z + 0.02 * (right - down)),
    },
    {
      id: 'wall',
      label: 'Depth of the wall',
      axis: 'x',
      x: wallX + 8,
      y: ground - 12,
      value: Number(t.toFixed(2)),
      least: kNearest,
      greatest: kFarthest,
      says: `${fixed(t)} units`,
      drag: ({ x }) => awayBy((x - 42) / unitX),
      keys: (right) => awayBy(now.state.eye.y - kWall + 0.05 * right),
    },
  ];
}

// Where the wall begins and ends in the picture.
function over(now) {
  const { topFrontRow: top, bottomFrontRow: bottom } = now.slice.hits[0];
  const edge = (row) =>
    line(0, row, now.width, row, 'stroke="#fff" stroke-width="4" stroke-opacity="0.85"') +
    line(0, row, now.width, row, 'stroke="#b8431f" stroke-width="2"');
  return edge(top) + edge(bottom);
}

export default {
  scene: 'long-wall.json',
  view: '20.5,5,0.5,270',
  options: { fov: 66 },
  controls: [
    slider({
      label: 'Depth of the wall',
      eye: 'y',
      from: kWall + kNearest,
      to: kWall + kFarthest,
      step: 0.05,
      says: (value) => `${fixed(value - kWall)} units`,
    }),
    slider({
      label: 'Height of the eye',
      eye: 'z',
      from: kHeights[0],
      to: kHeights[1],
      step: 0.05,
      unit: 'units',
    }),
  ],
  rows: [
    [
      drawing({
        share: 1.2,
        label: (now) =>
          `From the side: the eye at height ${fixed(now.eye.z)}, a wall one unit high at depth ${fixed(momentOf(now).t)}`,
        height: (width) => frameOf(width).height,
        markup,
        handles,
      }),
      picture({ handles: [], mark: 'none', over }),
    ],
  ],
  says: (now) => {
    const { hit, t } = momentOf(now);
    return `At depth ${fixed(t)} the wall covers ${fixed(hit.bottomFrontRow - hit.topFrontRow, 1)} rows: from ${fixed(hit.topFrontRow, 1)} to ${fixed(hit.bottomFrontRow, 1)}.`;
  },
};
