import { fixed, mapView, numberTable, picture, slider } from '../figures/kit.js';

const kHeight = 2.2;
const kWidth = 1.8; // of the tree; wide, so that the plan shows it
const kTree = { x: 6.5, y: 3.5 };

export const lawn = {
  title: 'A tree on a lawn',
  textures: { grass: '../../textures/grass.png', brick: '../../textures/brick.png' },
  sprites: { oak: '../../sprites/oak.png' },
  blueprints: { wall: { faces: { all: 'brick', west: { texture: 'brick', light: 0.93 } } } },
  legend: { '#': 'wall' },
  maps: [
    {
      name: 'lawn',
      levels: [[...Array(7).fill(`${'.'.repeat(10)}#`)]],
      floor: { texture: 'grass' },
      sky: { low: '#f1e2c4', high: '#5f9fd4' },
      light: { multiplier: 5, darkest: 0.5 },
      haze: '#f1e2c4',
      objects: [{ sprite: 'oak', ...kTree, height: kHeight, width: kWidth }],
    },
  ],
  start: { x: 1.5, y: 4.5, heading: 0 },
};

// What the page computes itself: depth, side, and the edges in columns and rows.
export function seenAs(now) {
  const { eye, slice } = now;
  const angle = (eye.heading * Math.PI) / 180;
  const forward = [Math.cos(angle), Math.sin(angle)];
  const right = [-forward[1], forward[0]];
  const [dx, dy] = [kTree.x - eye.x, kTree.y - eye.y];
  const depth = dx * forward[0] + dy * forward[1];
  const side = dx * right[0] + dy * right[1];
  const perUnit = slice.projectionDistance / depth;
  const column = (at) => now.width / 2 + at * perUnit;
  const row = (z) => slice.horizonRow - (z - eye.z) * perUnit;
  return {
    depth,
    side,
    right,
    forward,
    left: column(side - kWidth / 2),
    end: column(side + kWidth / 2),
    head: row(kHeight),
    feet: row(0),
    wide: kWidth * perUnit,
    tall: kHeight * perUnit,
  };
}

function frame(now) {
  const { depth, left, end, head, feet } = seenAs(now);
  if (depth <= 0.05) return '';
  return `<rect x="${left.toFixed(1)}" y="${head.toFixed(1)}" width="${(end - left).toFixed(1)}" height="${(feet - head).toFixed(1)}" fill="none" stroke="var(--ray)" stroke-width="2"/>`;
}

function triangles(now, at) {
  const { eye, slice } = now;
  const { right, forward, depth } = seenAs(now);
  const half = kWidth / 2;
  const ends = [-1, 1].map((sign) => [
    kTree.x + sign * half * right[0],
    kTree.y + sign * half * right[1],
  ]);
  const lineOf = ([ax, ay], [bx, by], look) => {
    const [x1, y1] = at(ax, ay);
    const [x2, y2] = at(bx, by);
    return `<line x1="${x1.toFixed(1)}" y1="${y1.toFixed(1)}" x2="${x2.toFixed(1)}" y2="${y2.toFixed(1)}" ${look}/>`;
  };
  const from = [eye.x, eye.y];
  const slope = now.width / 2 / slice.projectionDistance;
  const plane = [-slope, slope].map((k) => [
    eye.x + forward[0] + k * right[0],
    eye.y + forward[1] + k * right[1],
  ]);
  const foot = [eye.x + depth * forward[0], eye.y + depth * forward[1]];
  const parts = [lineOf(...plane, 'stroke="var(--ink)" stroke-width="2.5"')];
  if (depth > 0) {
    parts.push(
      lineOf(from, foot, 'stroke="var(--soft)" stroke-width="1.5" stroke-dasharray="3 4"'),
      lineOf(foot, ends[0], 'stroke="var(--soft)" stroke-width="1" stroke-dasharray="3 4"'),
      ...ends.map((end) => lineOf(from, end, 'stroke="var(--ray)" stroke-width="1.5"')),
    );
  }
  parts.push(lineOf(...ends, 'stroke="var(--good)" stroke-width="7" stroke-linecap="round"'));
  return parts.join('');
}

const rowsOf = (now) => {
  const { depth, side, left, end, head, feet } = seenAs(now);
  const middle = now.source.project(kTree.x, kTree.y, kHeight, 'lawn');
  return [
    { name: 'depth', mine: depth, engine: middle?.depth ?? null },
    { name: 'side', mine: side, engine: null },
    { name: 'columns', mine: [left, end], engine: null },
    { name: 'row of the head', mine: head, engine: middle?.y ?? null },
    {
      name: 'row of the feet',
      mine: feet,
      engine: now.source.project(kTree.x, kTree.y, 0, 'lawn')?.y ?? null,
    },
  ];
};

export default {
  scene: lawn,
  view: '2.2,4.6,0.5,345',
  options: { fov: 66 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: 280, to: 420, step: 1, unit: '°' })],
  rows: [
    [
      mapView({
        title: 'From above',
        handles: ['eye', 'heading'],
        ray: false,
        lit: false,
        marks: false,
        order: false,
        objects: false,
        over: triangles,
      }),
      picture({ title: 'What the eye sees', mark: 'none', handles: [], over: frame }),
    ],
    [
      numberTable({
        title: 'The same numbers twice',
        caption: 'Units, and pixels',
        columns: [
          { head: '', value: ({ name }) => name },
          {
            head: 'This page',
            value: ({ mine }) =>
              Array.isArray(mine) ? mine.map((n) => fixed(n, 0)).join(' to ') : fixed(mine),
            class: 'number',
          },
          {
            head: 'Engine',
            value: ({ engine }) => (engine === null ? '–' : fixed(engine)),
            class: 'number',
          },
        ],
        items: rowsOf,
      }),
    ],
  ],
  numbers: {
    depth: (now) => fixed(seenAs(now).depth),
    height: () => fixed(kHeight, 1),
    rows: (now) => fixed(seenAs(now).tall, 0),
  },
  says: (now) => {
    const { depth, tall, wide } = seenAs(now);
    return depth <= 0
      ? 'The depth is not greater than 0: the tree is behind you.'
      : `Depth ${fixed(depth)}: the tree is ${fixed(wide, 0)} columns wide and ${fixed(tall, 0)} rows high.`;
  },
};
