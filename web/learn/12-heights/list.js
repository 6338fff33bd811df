import { box, drawing, fixed, line, numberTable, picture, slider, text } from '../figures/kit.js';

const kTall = 320;
const kColours = ['--across', '--along', '--ray', '--link', '--good', '--soft'];

const rowsSeen = (hit) => hit.filled.reduce((sum, { first, last }) => sum + last + 1 - first, 0);

// The rows of a hit's side within the picture.
function rowsOf({ topFrontRow, bottomFrontRow }, height) {
  const within = (row) => Math.max(0, Math.min(height, Math.round(row)));
  return [within(topFrontRow), within(bottomFrontRow)];
}

const coveredBy = (hit, height) => {
  const [first, last] = rowsOf(hit, height);
  return last - first;
};

const paintedOf = (now) => Math.min(now.state.painted, now.slice.hits.length);

function strip(now, { width }) {
  const { hits } = now.slice;
  const scale = (kTall - 12) / now.height;
  const left = 8;
  const wide = Math.min(120, width * 0.3);
  const parts = [box(left, 6, wide, kTall - 12, 'fill="var(--sheet)" stroke="var(--rule)"')];
  const first = hits.length - paintedOf(now);
  const labels = [];
  for (let index = hits.length - 1; index >= first; --index) {
    const [top, bottom] = rowsOf(hits[index], now.height);
    const isNewest = index === first;
    const y = 6 + scale * top;
    parts.push(
      box(left, y, wide, scale * (bottom - top), 'fill="var(--paper)"'),
      box(
        left,
        y,
        wide,
        scale * (bottom - top),
        `fill="var(${kColours[index % kColours.length]})" fill-opacity="0.45" stroke="var(--ink)" stroke-width="${isNewest ? 2.5 : 1}"`,
      ),
    );
    labels.push({ index, top, bottom });
  }
  // Numbers of what is visible now: the rows that no nearer block has covered yet.
  const taken = [];
  for (const { index, top, bottom } of labels.reverse()) {
    let best = null;
    let begin = top;
    for (const [from, to] of [...taken].sort((a, b) => a[0] - b[0]).concat([[bottom, bottom]])) {
      const end = Math.min(from, bottom);
      if (end - begin > (best?.[1] ?? 0) - (best?.[0] ?? 0)) best = [begin, end];
      begin = Math.max(begin, to);
    }
    taken.push([top, bottom]);
    if (best === null || scale * (best[1] - best[0]) < 15) continue;
    const middle = 6 + (scale * (best[0] + best[1])) / 2;
    parts.push(
      text(left + wide / 2, middle + 5, String(index + 1), 'class="halo" text-anchor="middle"'),
      text(left + wide + 12, middle + 5, hits[index].blueprint, ''),
    );
  }
  const horizon = 6 + scale * now.slice.horizonRow;
  parts.push(line(left - 6, horizon, left + wide + 6, horizon, 'class="fig-horizon"'));
  return parts.join('');
}

export default {
  scene: 'yard-2.json',
  view: '9.4,4.5,0.35,192,0.08',
  options: { fov: 66 },
  state: { column: 240, painted: 6 },
  controls: [
    slider({
      label: 'Painted so far',
      field: 'painted',
      from: 0,
      to: 12,
      says: (value, now) => `${paintedOf(now)} of ${now.slice.hits.length} blocks`,
    }),
    slider({ label: 'Slice', field: 'column' }),
  ],
  rows: [
    [
      picture({ title: 'The finished picture', handles: ['column'] }),
      drawing({
        title: 'The slice, painted from far to near',
        height: kTall,
        label: (now) =>
          `${paintedOf(now)} of ${now.slice.hits.length} blocks are painted, the farthest first`,
        markup: strip,
      }),
    ],
    [
      numberTable({
        title: 'The hit list, nearest first',
        caption: 'The last column: rows seen, of all rows of the side',
        columns: [
          { head: '', value: (hit, index) => String(index + 1), class: 'number' },
          { head: 'Block', value: ({ blueprint }) => blueprint },
          { head: 'Depth', value: ({ depth }) => fixed(depth), class: 'number' },
          {
            head: 'Heights',
            value: ({ bottom, top }) => `${fixed(bottom)}–${fixed(top)}`,
            class: 'number',
          },
          {
            head: 'Seen',
            value: (hit, index, now) => `${rowsSeen(hit)}/${coveredBy(hit, now.height)}`,
            class: 'number',
          },
        ],
        items: (now) => now.slice.hits,
        current: (now) => (paintedOf(now) === 0 ? -1 : now.slice.hits.length - paintedOf(now)),
      }),
    ],
  ],
  numbers: {
    painted: (now) =>
      String(now.slice.hits.reduce((sum, hit) => sum + coveredBy(hit, now.height), 0)),
    visible: (now) => String(now.slice.hits.reduce((sum, hit) => sum + rowsSeen(hit), 0)),
  },
  says: (now) => {
    const count = paintedOf(now);
    const { hits } = now.slice;
    if (count === 0) return 'Nothing is painted yet.';
    const { blueprint, depth } = hits[hits.length - count];
    return `Painted last: block ${hits.length - count + 1}, ${blueprint}, at depth ${fixed(depth)}.`;
  },
};
