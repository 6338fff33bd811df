// A plan: the tiles of a map from above, an eye, and a ray with the tiles that its walk has
// entered. One unit of the drawing is a tile.
//
//     putMarkup(svg, plan({rows, kinds: {'#': 'wall'}, slice: caster.trace(column), shown: 5}));

import { at, box, dot, line, text } from './lesson.js';

const kMargin = 0.15; // tiles
const kReach = 40; // of lines that end outside the drawing, tiles

export function planBox(rows) {
  return `${-kMargin} ${-kMargin} ${rows[0].length + 2 * kMargin} ${rows.length + 2 * kMargin}`;
}

// Where the walk crossed into tile i > 0: {alongX (a border of constant x), border, x, y}, and the
// engine's {distance, speed, along, depth}.
export function crossingInto({ eye, ray, walk }, index) {
  const { axis, tile, distance, speed, along, depth } = walk[index];
  const before = walk[index - 1].tile;
  const alongX = axis === 'x';
  const border = alongX ? Math.max(tile[0], before[0]) : Math.max(tile[1], before[1]);
  return {
    alongX,
    border,
    distance,
    speed,
    along,
    depth,
    x: eye.x + depth * ray[0],
    y: eye.y + depth * ray[1],
  };
}

// `kinds` maps characters of blocks to CSS classes; the first `shown` tiles of the slice are lit.
export function plan({ rows, kinds, slice, shown = slice.walk.length }) {
  const { eye, ray, walk } = slice;
  const width = rows[0].length;
  const depth = rows.length;
  const parts = [
    `<clipPath id="plan-clip">${box(-kMargin, -kMargin, width + 2 * kMargin, depth + 2 * kMargin)}</clipPath>`,
  ];

  rows.forEach((row, y) =>
    [...row].forEach((character, x) => {
      if (character in kinds) parts.push(box(x, y, 1, 1, `class="${kinds[character]}"`));
    }),
  );
  walk.slice(0, shown).forEach(({ tile: [x, y] }, index) => {
    parts.push(
      box(x, y, 1, 1, `class="lit moves" opacity="${at(0.95 - (0.6 * index) / walk.length)}"`),
    );
  });
  for (let x = 0; x <= width; ++x) parts.push(line(x, 0, x, depth, 'class="grid"'));
  for (let y = 0; y <= depth; ++y) parts.push(line(0, y, width, y, 'class="grid"'));

  // The field of view, and the ray as far as the walk is shown.
  const forward = [
    Math.cos((eye.heading * Math.PI) / 180),
    Math.sin((eye.heading * Math.PI) / 180),
  ];
  const slope = Math.tan((slice.fov * Math.PI) / 360);
  const edges = [-slope, slope].map((k) => [
    forward[0] - k * forward[1],
    forward[1] + k * forward[0],
  ]);
  for (const [x, y] of edges)
    parts.push(
      line(
        eye.x,
        eye.y,
        eye.x + kReach * x,
        eye.y + kReach * y,
        'class="view-edge" clip-path="url(#plan-clip)"',
      ),
    );
  const end = walk[Math.min(shown, walk.length) - 1].depth;
  parts.push(
    line(
      eye.x,
      eye.y,
      eye.x + kReach * ray[0],
      eye.y + kReach * ray[1],
      'class="ray-ahead" clip-path="url(#plan-clip)"',
    ),
  );
  parts.push(line(eye.x, eye.y, eye.x + end * ray[0], eye.y + end * ray[1], 'class="ray-line"'));
  for (let index = 1; index < shown; ++index) {
    const { alongX, x, y } = crossingInto(slice, index);
    parts.push(dot(x, y, 0.1, `class="${alongX ? 'across-dot' : 'along-dot'}"`));
  }
  walk
    .slice(0, shown)
    .forEach(({ tile: [x, y] }, index) =>
      parts.push(text(x + 0.1, y + 0.34, String(index + 1), 'class="order" font-size="0.3"')),
    );
  parts.push(
    dot(eye.x, eye.y, 0.2, 'class="eye"'),
    line(eye.x, eye.y, eye.x + 0.42 * forward[0], eye.y + 0.42 * forward[1], 'class="eye-ahead"'),
  );
  return parts.join('');
}
