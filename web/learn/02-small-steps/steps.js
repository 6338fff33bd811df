// A march along the ray of one column: every look is a dot on the map.

import { dot, fixed, group, mapView, slider, text, toggle } from '../figures/kit.js';

const kMostLooks = 3000;

// The looks of the march: [{x, y, depth, block}]; the last one found a block or left the map.
export function looksOf({ eye, slice, cells, blueprints, state }) {
  const looks = [];
  for (let n = 0; n < kMostLooks; ++n) {
    const depth = n * state.size;
    const x = eye.x + depth * slice.ray[0];
    const y = eye.y + depth * slice.ray[1];
    const character = [...(cells[0][Math.floor(y)] ?? '')][Math.floor(x)];
    const block = blueprints.get(character)?.name ?? null;
    looks.push({ x, y, depth, block });
    if (character === undefined || block !== null) break;
  }
  return looks;
}

const kept = (now) => now.kept('looks', () => looksOf(now));
const tileOf = ({ x, y }) => [Math.floor(x), Math.floor(y)];

// Whether the march ended in another tile than the ray's first block.
function isMissed(now) {
  const hit = now.slice.hits[0];
  const last = kept(now).at(-1);
  return hit !== undefined && String(tileOf(last)) !== String(hit.tile);
}

function over(now, at) {
  const looks = kept(now);
  const last = looks.at(-1);
  const hit = now.slice.hits[0];
  const radius = Math.max(1.6, Math.min(5, (at.unit * now.state.size) / 3));
  const parts = [];
  if (isMissed(now)) {
    const [x, y] = at(...hit.tile);
    parts.push(
      `<rect x="${x}" y="${y}" width="${at.unit}" height="${at.unit}" fill="none" stroke="var(--bad)" stroke-width="3"/>`,
      text(x + at.unit / 2, y - 7, 'jumped over', 'text-anchor="middle" class="halo strong bad"'),
    );
  }
  for (const look of looks.slice(0, -1))
    parts.push(
      dot(
        ...at(look.x, look.y),
        radius,
        'fill="var(--paper)" stroke="var(--ray)" stroke-width="1.5"',
      ),
    );
  const [x, y] = at(last.x, last.y);
  parts.push(dot(x, y, 7, 'fill="var(--ray)" stroke="var(--paper)" stroke-width="2"'));
  return group('', parts);
}

export default {
  scene: 'yard-1.json',
  view: '2.2,6.9,0.5,330',
  options: { fov: 66 },
  state: { column: 347, size: 0.3 },
  controls: [
    slider({
      label: 'Step',
      field: 'size',
      from: 0.02,
      to: 1,
      step: 0.01,
      opening: 0.3,
      unit: 'units',
    }),
    slider({ label: 'Column', field: 'column' }),
    toggle({ label: 'Tiles of the ray', field: 'tiles' }),
  ],
  rows: [
    [
      mapView({
        when: (state) => !state.tiles,
        paint: true,
        blocks: ['o', '#', '.'],
        handles: ['eye', 'heading'],
        lit: false,
        marks: false,
        over,
      }),
      mapView({
        when: (state) => state.tiles,
        handles: ['eye', 'heading'],
        marks: false,
        over,
      }),
    ],
  ],
  numbers: {
    step: (now) => fixed(now.state.size),
    looks: (now) => String(kept(now).length),
    found: (now) => (kept(now).at(-1).block === null ? 'nothing' : fixed(kept(now).at(-1).depth)),
    depth: (now) => (now.slice.hits[0] ? fixed(now.slice.hits[0].depth) : 'none'),
    enter: (now) => (now.slice.hits[0] ? fixed(now.slice.hits[0].depth, 3) : 'none'),
    leave: (now) => (now.slice.hits[0] ? fixed(now.slice.hits[0].backDepth, 3) : 'none'),
    tiles: (now) =>
      String(
        now.slice.walk.findIndex(({ tile }) => String(tile) === String(now.slice.hits[0]?.tile)) +
          1,
      ),
  },
  says: (now) => {
    const looks = kept(now);
    const last = looks.at(-1);
    const hit = now.slice.hits[0];
    const found =
      last.block === null
        ? 'and leaves the map'
        : `and finds a ${last.block} at depth ${fixed(last.depth)}`;
    const truth =
      hit === undefined ? '' : ` The ray meets a ${hit.blueprint} at depth ${fixed(hit.depth)}.`;
    return `The march looks ${looks.length} times ${found}.${truth}`;
  },
};
