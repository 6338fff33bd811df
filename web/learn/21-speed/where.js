// How often each kind of work is done for a frame, and what share of the time each takes if one
// tile costs as much as so many pixels.

import { fixed, panel, picture, slider } from '../figures/kit.js';

// The kinds of work: how often, and the field with the cost of one.
const kKinds = [
  { name: 'walking tiles', of: ({ totals }) => totals.tilesWalked, cost: ({ tile }) => tile },
  { name: 'setting up runs', of: ({ totals }) => totals.spansDrawn, cost: ({ run }) => run },
  { name: 'filling rows', of: ({ totals }) => totals.rowsFilled, cost: () => 1 },
];

const partsOf = (now) =>
  now.kept('parts', () => {
    const frame = now.source.traceFrame();
    const parts = kKinds.map(({ name, of, cost }) => {
      const count = of(frame);
      return { name, count, time: count * cost(now.state) };
    });
    const sum = parts.reduce((total, { time }) => total + time, 0);
    return parts.map((part) => ({ ...part, share: part.time / sum }));
  });

const percent = (share) => `${fixed(100 * share, 0)}\u00a0%`;

function table(now) {
  const rows = partsOf(now).map(
    ({ name, count, share }) =>
      `<tr><th scope="row">${name}</th><td class="number">${count}</td>` +
      `<td><svg viewBox="0 0 100 16" width="100" height="16" aria-hidden="true">` +
      `<rect class="fig-lit" width="${fixed(100 * share, 1)}" height="16"/></svg></td>` +
      `<td class="number">${percent(share)}</td></tr>`,
  );
  return (
    `<table><thead><tr><th scope="col">Work</th><th scope="col" class="number">Times</th>` +
    `<th scope="col" colspan="2">Share of the time</th></tr></thead>` +
    `<tbody>${rows.join('')}</tbody></table>`
  );
}

const grouped = (count) => count.toLocaleString('en');

export default {
  scene: 'yard.json',
  view: '9.4,4.5,0.5,192,0.1',
  options: { fov: 66 },
  controls: [
    slider({ label: 'A tile costs', field: 'tile', from: 1, to: 60, opening: 12, unit: 'rows' }),
    slider({ label: 'A run costs', field: 'run', from: 1, to: 200, opening: 40, unit: 'rows' }),
    slider({ label: 'Turn', eye: 'heading', from: 0, to: 359, unit: '°' }),
  ],
  rows: [
    [picture({ mark: 'none', handles: ['turn'] }), panel({ title: 'The frame', markup: table })],
  ],
  numbers: {
    pixels: (now) => grouped(now.width * now.height),
    tiles: (now) => grouped(partsOf(now)[0].count),
    runs: (now) => grouped(partsOf(now)[1].count),
    rows: (now) => grouped(partsOf(now)[2].count),
    rowsEachTile: (now) => fixed(partsOf(now)[2].count / partsOf(now)[0].count, 0),
    tileShare: (now) => percent(partsOf(now)[0].share),
    rowShare: (now) => percent(partsOf(now)[2].share),
  },
  says(now) {
    const greatest = partsOf(now).reduce((a, b) => (b.share > a.share ? b : a));
    return `Most of the time, ${percent(greatest.share)}, goes into ${greatest.name}.`;
  },
};
