// Two walks along a ray that passes exactly through corners of the grid: one divides at each
// border, the other adds up gaps in 32-bit numbers.

import { box, choice, drawing, fixed, line, text } from '../figures/kit.js';

// From the middle of a tile, rays meet corners if both numbers are odd.
const kRays = { '3 : 1': [3, 1], '5 : 1': [5, 1], '5 : 3': [5, 3], '3 : 5': [3, 5] };
const kWide = 30; // tiles
const kFar = 1000; // borders, for the drift
const round = Math.fround;

// The tiles of a walk from the middle of tile (0, 0), and the corners: [{x, y, isRight}].
function walkOf([rayX, rayY], divides) {
  const tiles = [[0, 0]];
  const corners = [];
  const gaps = [round(1 / rayX), round(1 / rayY)];
  let sums = [round(0.5 / rayX), round(0.5 / rayY)];
  let [x, y] = [0, 0];
  while (x < kWide) {
    const next = divides ? [(x + 0.5) / rayX, (y + 0.5) / rayY] : sums;
    const isCorner = (x + 0.5) * rayY === (y + 0.5) * rayX;
    const acrossX = next[0] < next[1] || next[0] === next[1];
    if (isCorner) corners.push({ x: x + 1, y: y + 1, isRight: acrossX });
    if (acrossX) {
      x += 1;
      sums = [round(sums[0] + gaps[0]), sums[1]];
    } else {
      y += 1;
      sums = [sums[0], round(sums[1] + gaps[1])];
    }
    tiles.push([x, y]);
  }
  return { tiles, corners };
}

const rayOfState = (state) => kRays[state.ratio];
const wrongOnes = (walk) => walk.corners.filter(({ isRight }) => !isRight).length;

function markup(now, { width }) {
  const ray = rayOfState(now.state);
  const it = frameOf(now, width);
  return (
    strip(now, it, walkOf(ray, true), 'Quotients', it.first) +
    strip(now, it, walkOf(ray, false), 'Sums of 32 bits', it.second)
  );
}

function frameOf(now, width) {
  const [rayX, rayY] = rayOfState(now.state);
  const shown = width < 560 ? 12 : 26; // tiles from west to east
  const deep = Math.ceil((shown * rayY) / rayX) + 1;
  const unit = Math.min((width - 8) / shown, 300 / deep);
  const tall = unit * deep;
  return {
    shown,
    deep,
    unit,
    left: (width - unit * shown) / 2,
    first: 30,
    second: 30 + tall + 44,
    height: 2 * (tall + 30) + 22,
  };
}

function strip(now, { shown, deep, unit, left }, walk, title, top) {
  const [rayX, rayY] = rayOfState(now.state);
  const at = (x, y) => [left + unit * x, top + unit * y];
  const wrong = wrongOnes({ corners: walk.corners.filter(({ x }) => x < shown) });
  const parts = [
    text(
      left,
      top - 10,
      wrong === 0 ? `${title}: all corners by the rule` : `${title}: crosses break the rule`,
      `class="strong${wrong === 0 ? '' : ' bad'}"`,
    ),
    box(...at(0, 0), unit * shown, unit * deep, 'fill="var(--sheet)"'),
  ];
  const corners = new Map(walk.corners.map((corner) => [`${corner.x - 1},${corner.y}`, corner]));
  for (const [x, y] of walk.tiles) {
    if (x >= shown || y >= deep) continue;
    const isWrong = corners.get(`${x},${y}`)?.isRight === false;
    parts.push(
      box(
        ...at(x, y),
        unit,
        unit,
        isWrong ? 'fill="var(--bad)" fill-opacity="0.75"' : 'fill="var(--lit)" fill-opacity="0.8"',
      ),
    );
  }
  for (let x = 0; x <= shown; ++x)
    parts.push(line(...at(x, 0), ...at(x, deep), 'stroke="var(--rule)"'));
  for (let y = 0; y <= deep; ++y)
    parts.push(line(...at(0, y), ...at(shown, y), 'stroke="var(--rule)"'));
  const end = Math.min(shown - 0.5, ((deep - 0.5) * rayX) / rayY);
  parts.push(
    line(
      ...at(0.5, 0.5),
      ...at(0.5 + end, 0.5 + (end * rayY) / rayX),
      'stroke="var(--ray)" stroke-width="2"',
    ),
  );
  for (const { x, y, isRight } of walk.corners) {
    if (x >= shown || y >= deep) continue;
    const [px, py] = at(x, y);
    parts.push(
      isRight
        ? `<circle cx="${px}" cy="${py}" r="4" fill="var(--paper)" stroke="var(--ink)" stroke-width="1.5"/>`
        : line(px - 6, py - 6, px + 6, py + 6, 'stroke="var(--ink)" stroke-width="3"') +
            line(px - 6, py + 6, px + 6, py - 6, 'stroke="var(--ink)" stroke-width="3"'),
    );
  }
  return parts.join('');
}

// How far the sum is off after so many gaps.
function drift([rayX]) {
  const gap = round(1 / rayX);
  let sum = round(0.5 / rayX);
  for (let i = 0; i < kFar; ++i) sum = round(sum + gap);
  return Math.abs(sum - (kFar + 0.5) / rayX);
}

export default {
  scene: 'yard-1.json',
  view: '13.3,1.6,0.5,180',
  controls: [choice({ label: 'Tiles east : tiles south', field: 'ratio', of: Object.keys(kRays) })],
  rows: [
    [
      drawing({
        label: (now) =>
          `Two walks along one ray. With sums, ${wrongOnes(walkOf(rayOfState(now.state), false))} corners are passed the wrong way round.`,
        height: (width, now) => frameOf(now, width).height,
        markup,
      }),
    ],
  ],
  numbers: {
    borders: () => String(kFar),
    drift: (now) => drift(rayOfState(now.state)).toFixed(5),
  },
  says: (now) => {
    const walk = walkOf(rayOfState(now.state), false);
    return `The sums take ${wrongOnes(walk)} of ${walk.corners.length} corners the wrong way round; after ${kFar} borders they are ${fixed(drift(rayOfState(now.state)), 5)} units off.`;
  },
};
