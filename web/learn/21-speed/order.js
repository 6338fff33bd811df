// The order in which pixels are written, and the cache that they go through.

import { box, choice, drawing, fixed, mark, slider, text, toggle } from '../figures/kit.js';
import { Cache, addresses, kSets, kWays, missesEachPixel, pitchOf, setsOfColumn } from './cache.js';

const kHeight = 300;
const kLately = 300; // touches that are shown in colour
const kFoot = 30; // CSS pixels below a drawing
const kOrders = { columns: 'by columns', rows: 'by rows', strip: 'by strips of 16' };

const pictureOf = ({ state: { order, width, padded } }) => ({
  order,
  width: Number(width),
  height: kHeight,
  isPadded: padded,
});

// The cache after so many writes, with the latest touches.
const momentOf = (now) =>
  now.kept('moment', () => {
    const cache = new Cache();
    const latest = [];
    let count = 0;
    for (const address of addresses(pictureOf(now))) {
      if (count >= now.state.writes) break;
      count += 1;
      latest.push({ address, ...cache.touch(address) });
      if (latest.length > kLately) latest.shift();
    }
    return { cache, latest };
  });

// The picture as it lies in memory, with the latest writes: each in its row and column.
function memory(now, { width, height }) {
  const picture = pictureOf(now);
  const pitch = pitchOf(picture.width, picture.isPadded);
  const tall = height - kFoot;
  const across = width / (pitch / 4);
  const down = tall / kHeight;
  const { latest } = momentOf(now);
  const parts = [box(0, 0, picture.width * across, tall, 'class="fig-ground"')];
  if (picture.isPadded)
    parts.push(box(picture.width * across, 0, 16 * across, tall, 'class="fig-open-line"'));
  for (const { address, isHit } of latest) {
    const y = Math.floor(address / pitch);
    const x = (address % pitch) / 4;
    if (y >= kHeight) continue;
    const wide = Math.max(isHit ? 3 : 6, across);
    parts.push(box(x * across, y * down, wide, Math.max(down, 1), classOf(isHit)));
  }
  const misses = latest.filter(({ isHit }) => !isHit).length;
  parts.push(
    mark(7, tall + 15, 'x', 6),
    text(18, tall + 20, `${latest.length - misses} found their line`),
    mark(width / 2 + 7, tall + 15, 'y', 6),
    text(width / 2 + 18, tall + 20, `${misses} waited`),
  );
  return parts.join('');
}

// The sets side by side, their lines above each other, the one used last on top.
function sets(now, { width, height }) {
  const { cache, latest } = momentOf(now);
  const wide = width / kSets;
  const tall = (height - kFoot) / kWays;
  const touched = new Map(latest.map(({ line, isHit }) => [line, isHit]));
  const parts = [];
  cache.sets.forEach((lines, set) => {
    for (let way = 0; way < kWays; ++way) {
      const line = lines[way];
      const isHit = touched.get(line);
      const look =
        line === undefined
          ? 'class="fig-ground"'
          : isHit === undefined
            ? 'class="fig-open-line"'
            : classOf(isHit);
      const y = (kWays - 1 - way) * tall;
      parts.push(box(set * wide + 0.5, y + 0.5, wide - 1, tall - 1, look));
    }
  });
  const used = cache.sets.filter((lines) => lines.length > 0).length;
  parts.push(text(0, height - 6, `${used} of ${kSets} sets in use, ${kWays} lines each`));
  return parts.join('');
}

const classOf = (isHit) => `fill="var(--${isHit ? 'across' : 'along'})"`;

export default {
  scene: 'corner.json',
  view: '5,5,0.5,45',
  state: { writes: 600 },
  controls: [
    choice({ label: 'Write', field: 'order', of: kOrders }),
    choice({ label: 'Width', field: 'width', of: ['480', '512', '1280'] }),
    toggle({ label: '16 unused pixels after each row', field: 'padded' }),
    slider({ label: 'Writes', field: 'writes', from: 0, to: 12000, step: 10 }),
  ],
  rows: [
    [
      drawing({
        title: 'The picture in memory',
        label: (now) => `The latest ${kLately} writes ${kOrders[now.state.order]}`,
        height: (width) => Math.round(width * 0.6),
        markup: memory,
      }),
      drawing({
        title: 'The cache',
        label: (now) => `${momentOf(now).cache.misses} misses so far`,
        height: (width) => Math.round(width * 0.6),
        markup: sets,
      }),
    ],
  ],
  numbers: {
    misses: (now) => fixed(100 * missesEachPixel(pictureOf(now)), 0),
    sets: (now) => String(setsOfColumn(Number(now.state.width), now.state.padded)),
    columns: (now) => fixed(100 * missesOf(now, 'columns', false), 0),
    padded: (now) => fixed(100 * missesOf(now, 'columns', true), 0),
    rows: (now) => fixed(100 * missesOf(now, 'rows', false), 0),
    strip: (now) => fixed(100 * missesOf(now, 'strip', false), 0),
  },
  says: (now) =>
    `Of 100 pixels, ${fixed(100 * missesEachPixel(pictureOf(now)), 0)} have to wait for memory: the picture is written ${kOrders[now.state.order]}. A column uses ${setsOfColumn(Number(now.state.width), now.state.padded)} of the ${kSets} sets.`,
};

const missesOf = (now, order, isPadded) =>
  missesEachPixel({ order, width: 480, height: kHeight, isPadded });
