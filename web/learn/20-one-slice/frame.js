// The whole frame, column by column, with what each column needs.

import { choice, fixed, picture, plot, scrub } from '../figures/kit.js';

const kOf = {
  tiles: { label: 'Tiles', of: ({ tiles }) => tiles },
  layers: { label: 'Rows of layers', of: ({ layers }) => layers },
  side: { label: 'Rows of sides', of: ({ rows }) => rows.side },
  floor: { label: 'Rows of floor', of: ({ rows }) => rows.floor },
};

const grouped = (count) => count.toLocaleString('en');
const totals = (now) => now.source.traceFrame().totals;

export default {
  scene: 'yard.json',
  view: '9.4,4.5,0.5,192,0.1',
  options: { fov: 66 },
  state: { columns: 300, column: 299, of: 'tiles' },
  controls: [
    scrub({ of: 'frame' }),
    choice({
      label: 'Count',
      field: 'of',
      of: Object.fromEntries(Object.entries(kOf).map(([name, { label }]) => [name, label])),
    }),
  ],
  rows: [
    [picture({ mark: 'slice' })],
    [
      plot({
        title: 'What each column needs',
        x: { label: 'column', from: 0, to: 480, field: 'column' },
        y: { label: 'count', from: 0, to: (now) => (now.state.of === 'tiles' ? 30 : now.height) },
        lines: [
          {
            label: 'this frame',
            class: 'across',
            points: (now) =>
              kOf[now.state.of]
                .of(now.source.traceFrame().columns)
                .slice(0, now.state.columns ?? now.width)
                .map((count, column) => [column, count]),
          },
        ],
      }),
    ],
  ],
  numbers: {
    tiles: (now) => grouped(totals(now).tilesWalked),
    spans: (now) => grouped(totals(now).spansDrawn),
    rows: (now) => grouped(totals(now).rowsFilled),
    pixels: (now) => grouped(now.width * now.height),
    each: (now) => fixed(totals(now).tilesWalked / now.width, 1),
    behind: (now) => String(totals(now).walksBehindPortals),
  },
  says: (now) => {
    const drawn = now.state.columns ?? now.width;
    const column = Math.max(0, drawn - 1);
    const { tiles } = now.source.traceFrame().columns;
    return `${drawn} of ${now.width} columns. The last one walked ${tiles[column]} tiles.`;
  },
};
