// The yard drawn at a slant: the picture hangs before the eye, and the sheet behind one of its
// columns stands on the column's ray.

import {
  at,
  box,
  dot,
  drawing,
  group,
  knob,
  line,
  path,
  polygon,
  slider,
  text,
} from '../figures/kit.js';

const kPane = 1.25; // units from the eye to the picture
const kTallest = 1.3; // units: where the sheet is cut off
const kPixels = { width: 30, height: 18 }; // of the picture on the pane
const kWindow = { left: 3, top: 2, wide: 8, deep: 6 }; // tiles

const kSlant = { aside: 0.34, down: 0.52, up: 0.84 }; // of a unit: south, south, and upwards

function frameOf(width) {
  const { left, top, wide, deep } = kWindow;
  const unit = (width - 8) / (wide + kSlant.aside * deep);
  const place = (x, y, z = 0) => [
    4 + unit * (x - left + kSlant.aside * (y - top)),
    8 + unit * (kSlant.up + kSlant.down * (y - top) - kSlant.up * z),
  ];
  return { ...kWindow, unit, place, height: 16 + unit * (kSlant.up + kSlant.down * deep) };
}

// Of the eye: the arrows ahead and right, and half of the pane's width and height.
function viewOf({ eye, slice, width, height }) {
  const angle = (eye.heading * Math.PI) / 180;
  return {
    ahead: [Math.cos(angle), Math.sin(angle)],
    right: [-Math.sin(angle), Math.cos(angle)],
    slope: width / 2 / slice.projectionDistance,
    rise: height / 2 / slice.projectionDistance,
  };
}

function onPane({ eye }, { ahead, right, slope, rise }, part, up) {
  const k = slope * part;
  return [
    eye.x + kPane * (ahead[0] + k * right[0]),
    eye.y + kPane * (ahead[1] + k * right[1]),
    eye.z + kPane * rise * up,
  ];
}

const partOf = ({ column, width }) => (2 * (column + 0.5)) / width - 1; // -1 to 1 across the pane

function markup(now, { width }) {
  const it = frameOf(width);
  const view = viewOf(now);
  return [ground(it), tiles(now, it, view), pane(now, it, view), eyeOf(now, it, view)].join('');
}

function ground({ place, left, top, wide, deep }) {
  const corners = [
    place(left, top),
    place(left + wide, top),
    place(left + wide, top + deep),
    place(left, top + deep),
  ];
  const lines = [];
  for (let x = left; x <= left + wide; ++x) lines.push([place(x, top), place(x, top + deep)]);
  for (let y = top; y <= top + deep; ++y) lines.push([place(left, y), place(left + wide, y)]);
  return (
    polygon(corners, 'fill="var(--sheet)"') +
    lines.map(([from, to]) => line(...from, ...to, 'stroke="var(--rule)"')).join('')
  );
}

// From the far tiles to the near ones, so that near blocks hide the sheet and are hidden by it.
function tiles(now, it, view) {
  const parts = [];
  const row = (y) => [...(now.cells[0][y] ?? '')];
  for (let y = it.top; y < it.top + it.deep; ++y)
    for (let x = it.left + it.wide - 1; x >= it.left; --x) {
      const index = now.slice.walk.findIndex(({ tile }) => tile[0] === x && tile[1] === y);
      const isBlock = now.blueprints.has(row(y)[x]);
      const isHit = isBlock && index >= 0;
      const face = isHit ? now.slice.hits[0]?.face : null;
      const edge = isHit ? meeting(now, it, face) : '';
      const isBehind = face === 'north' || face === 'east';
      if (isBehind) parts.push(edge);
      if (isBlock) parts.push(block(it, x, y, now.blueprints.get(row(y)[x]).name));
      else if (index >= 0) parts.push(sheet(now, it, view, index));
      if (!isBehind) parts.push(edge);
    }
  return parts.join('');
}

function block({ place }, x, y, name) {
  const fill = { wall: 'var(--roof)', window: 'var(--roof)', letters: 'var(--across)' }[name];
  const side = (points, light) =>
    polygon(points, `fill="${fill ?? 'var(--block)'}"`) +
    polygon(
      points,
      `fill="#000" fill-opacity="${light}" stroke="var(--paper)" stroke-width="0.75"`,
    );
  return (
    side([place(x, y), place(x, y + 1), place(x, y + 1, 1), place(x, y, 1)], 0.32) +
    side([place(x, y + 1), place(x + 1, y + 1), place(x + 1, y + 1, 1), place(x, y + 1, 1)], 0.16) +
    side([place(x, y, 1), place(x + 1, y, 1), place(x + 1, y + 1, 1), place(x, y + 1, 1)], 0.02)
  );
}

const pointAt = ({ eye, slice }, depth) => [
  eye.x + depth * slice.ray[0],
  eye.y + depth * slice.ray[1],
];

// The part of the sheet in one tile of the walk.
function sheet(now, { place }, { rise }, index) {
  const { slice, eye } = now;
  const from = slice.walk[index].depth;
  const to = slice.walk[index + 1]?.depth ?? from;
  const knees = [eye.z / rise, (kTallest - eye.z) / rise].filter((t) => t > from && t < to);
  const depths = [from, ...knees.sort((a, b) => a - b), to];
  const upper = (t) => Math.min(kTallest, eye.z + t * rise);
  const lower = (t) => Math.max(0, eye.z - t * rise);
  const outline = [
    ...depths.map((t) => place(...pointAt(now, t), upper(t))),
    ...depths.reverse().map((t) => place(...pointAt(now, t), lower(t))),
  ];
  return (
    line(
      ...place(...pointAt(now, from)),
      ...place(...pointAt(now, to)),
      'stroke="var(--ray)" stroke-width="3" stroke-linecap="round"',
    ) + polygon(outline, 'fill="var(--lit)" fill-opacity="0.42"')
  );
}

// Where the sheet meets a block.
function meeting(now, { place }, face) {
  const hit = now.slice.hits[0];
  if (hit === undefined || face === null) return '';
  return line(
    ...place(...hit.point, 0),
    ...place(...hit.point, hit.top),
    'stroke="var(--ray)" stroke-width="4" stroke-linecap="round"',
  );
}

// The picture itself, in few pixels, hung up at a slant.
function pane(now, { place }, view) {
  const corner = (part, up) => place(...onPane(now, view, part, up));
  const [from, toRight, toBottom] = [corner(-1, 1), corner(1, 1), corner(-1, -1)];
  const { width, height } = kPixels;
  const { data } = now.source.pixels(kPixels);
  const cell = [
    (toRight[0] - from[0]) / width,
    (toRight[1] - from[1]) / width,
    (toBottom[0] - from[0]) / height,
    (toBottom[1] - from[1]) / height,
  ];
  const dots = [];
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) {
      const pixel = 4 * (y * width + x);
      dots.push(box(x, y, 1.08, 1.08, `fill="rgb(${data.slice(pixel, pixel + 3).join(',')})"`));
    }
  const outline = [from, toRight, corner(1, -1), toBottom];
  const part = partOf(now);
  return (
    group(
      `transform="matrix(${[...cell, ...from].map((n) => n.toFixed(4)).join(' ')})" shape-rendering="crispEdges"`,
      dots,
    ) +
    polygon(outline, 'fill="none" stroke="var(--ink)" stroke-width="2" stroke-linejoin="round"') +
    line(...corner(part, 1), ...corner(part, -1), 'stroke="var(--paper)" stroke-width="6"') +
    line(...corner(part, 1), ...corner(part, -1), 'stroke="var(--ray)" stroke-width="3"')
  );
}

function eyeOf(now, { place, unit }, view) {
  const { eye } = now;
  const [x, y] = place(eye.x, eye.y, eye.z);
  const foot = place(eye.x, eye.y);
  const sights = [
    [-1, 1],
    [1, 1],
    [1, -1],
    [-1, -1],
  ].map(([part, up]) =>
    line(
      x,
      y,
      ...place(...onPane(now, view, part, up)),
      'stroke="var(--ink)" stroke-opacity="0.45"',
    ),
  );
  return (
    sights.join('') +
    line(x, y, ...foot, 'stroke="var(--ink)" stroke-width="2"') +
    path(`M${at(foot[0] - 6)} ${at(foot[1])}h12`, 'stroke="var(--ink)" stroke-width="2"') +
    dot(x, y, Math.max(6, unit / 12), 'fill="var(--ray)" stroke="var(--paper)" stroke-width="2"') +
    text(x - 12, y - 8, 'eye', 'class="halo" text-anchor="end"') +
    knob(...handlePlace(now, { place }, view), 'ray')
  );
}

const handlePlace = (now, { place }, view) => place(...onPane(now, view, partOf(now), -1));

function handles(now, { width }) {
  const it = frameOf(width);
  const view = viewOf(now);
  const [x, y] = handlePlace(now, it, view);
  const ends = [-1, 1].map((part) => it.place(...onPane(now, view, part, -1)));
  const span = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
  return [
    {
      id: 'column',
      label: 'Column',
      x,
      y,
      value: now.column,
      least: 0,
      greatest: now.width - 1,
      says: `column ${now.column} of ${now.width}`,
      drag: (point) => {
        const [dx, dy] = [point.x - ends[0][0], point.y - ends[0][1]];
        const part = (dx * span[0] + dy * span[1]) / (span[0] ** 2 + span[1] ** 2);
        return { column: Math.floor(part * now.width) };
      },
      keys: (right) => ({ column: now.state.column + right }),
    },
  ];
}

export default {
  scene: 'yard-1.json',
  view: '4.4,7.2,0.5,322',
  options: { fov: 66 },
  state: { column: 269 },
  controls: [
    slider({ label: 'Column', field: 'column' }),
    slider({ label: 'Turn', eye: 'heading', from: 290, to: 350, step: 1, unit: '°' }),
  ],
  rows: [
    [
      drawing({
        label: (now) =>
          `The yard at a slant, with the picture before the eye and the sheet behind column ${now.column}`,
        height: (width) => frameOf(width).height,
        markup,
        handles,
      }),
    ],
  ],
  says: (now) => {
    const hit = now.slice.hits[0];
    const name = hit === undefined ? 'nothing' : { letters: 'the lettered block' }[hit.blueprint];
    return `The sheet behind column ${now.column} ends at ${name ?? `a ${hit.blueprint}`}.`;
  },
};
