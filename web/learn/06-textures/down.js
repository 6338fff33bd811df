// One slice of wall: the height, v and texel of some neighbouring rows.

import { numberTable, picture, polygon, sideView, slider } from '../figures/kit.js';

const kRows = 2; // listed above and below the picked one

// The rows around the picked one, and what they show. The wall stands from the floor to height 1.
export function rowsAround(now) {
  const { slice, row, height } = now;
  const first = Math.max(0, Math.min(row - kRows, height - 2 * kRows - 1));
  return Array.from({ length: 2 * kRows + 1 }, (_, index) => {
    const each = first + index;
    const pick = now.source.pick(now.column, each);
    const depth = slice.hits[0]?.depth ?? NaN;
    const z = slice.eye.z + (depth * (slice.horizonRow - (each + 0.5))) / slice.projectionDistance;
    return { row: each, z, texel: pick?.what === 'side' ? pick.texel.v : null };
  });
}

const at = (now) => rowsAround(now).find(({ row }) => row === now.row);
const isWall = (now) => now.pick?.what === 'side';

export default {
  scene: 'yard-1.json',
  view: '8.5,4.4,0.5,90',
  options: { fov: 66, detail: 'off' },
  size: [480, 300],
  state: { column: 240, row: 96, away: 1.6 },
  check: ({ eye, away }) => ({
    eye: { heading: 90, x: 8.5, y: 6 - away, z: Math.min(0.95, eye.z) },
  }),
  controls: [
    slider({
      label: 'Depth of the wall',
      field: 'away',
      from: 0.4,
      to: 2.8,
      step: 0.05,
      unit: 'units',
      opening: 1.6,
    }),
  ],
  rows: [
    [
      picture({ handles: ['row'], mark: 'pixel' }),
      sideView({ handles: ['eye'], depth: 3, height: 1.1, over: sight, runs: false, plane: true }),
    ],
    [
      numberTable({
        caption: 'Neighbouring rows: height z, v, and the texel that the engine takes',
        columns: [
          { head: 'Row', value: ({ row }) => String(row), class: 'number' },
          { head: 'z', value: ({ z }, _, now) => now.fixed(z, 3), class: 'number' },
          { head: 'v = 1 − z', value: ({ z }, _, now) => now.fixed(1 - z, 3), class: 'number' },
          {
            head: '128 v',
            value: ({ z }, _, now) => now.fixed(128 * (1 - z), 2),
            class: 'number',
          },
          { head: 'Engine', value: ({ texel }) => texel ?? '–', class: 'number' },
        ],
        items: rowsAround,
        current: (now) => rowsAround(now).findIndex(({ row }) => row === now.row),
      }),
    ],
  ],
  numbers: {
    row: (now) => String(now.row),
    z: (now) => now.fixed(at(now).z, 4),
    v: (now) => now.fixed(1 - at(now).z, 4),
    texel: (now) => String(at(now).texel ?? '–'),
    step: (now) => now.fixed((now.slice.hits[0]?.depth ?? NaN) / now.slice.projectionDistance, 4),
    distance: (now) => now.fixed(now.slice.projectionDistance, 2),
  },
  says: (now) =>
    isWall(now)
      ? `Row ${now.row} meets the wall at height ${now.fixed(at(now).z, 3)}: texel ${at(now).texel} from the top.`
      : `Row ${now.row} passes the wall. Drag the row onto it.`,
};

// The sight line through the middle of the row, to the wall or beyond, and the two triangles.
function sight(now, place) {
  const { slice, line, text } = now;
  const depth = slice.hits[0]?.depth ?? 3;
  const z = slice.eye.z + (depth * (slice.horizonRow - (now.row + 0.5))) / slice.projectionDistance;
  const [x1, y1] = place(0, slice.eye.z);
  const [x2, y2] = place(depth, z);
  const small = [x1 + place.plane, y1 + ((y2 - y1) * place.plane) / (x2 - x1)];
  const below = y2 < y1 ? 17 : -8; // where letters are, on the other side of the line
  return (
    polygon(
      [
        [x1, y1],
        [x2, y1],
        [x2, y2],
      ],
      'class="fig-wedge side"',
    ) +
    polygon([[x1, y1], [small[0], y1], small], 'class="fig-wedge side now"') +
    line(x1, y1, x2, y2, 'class="fig-sight"') +
    line(x2, y1, x2, y2, 'class="fig-bold"') +
    now.dot(x2, y2, 4.5, 'class="fig-edge-dot"') +
    (x2 - x1 > 70
      ? text(x1 + place.plane / 2 + 5, y1 + below, 'd', 'class="letter" text-anchor="middle"') +
        text((small[0] + x2) / 2, y1 + below, 't', 'class="letter" text-anchor="middle"')
      : '') +
    (Math.abs(y2 - y1) > 24 ? text(x2 + 8, (y1 + y2) / 2 + 4.5, 'rise') : '')
  );
}
