// The same orders, measured on the reader's machine.

import { button, fixed, panel } from '../figures/kit.js';

const kWidth = 1280;
const kHeight = 720;
const kRounds = 9;
const kStrip = 16;

// Four ways to write the same picture; each returns nothing and fills `pixels`.
const kWays = {
  plain: { name: 'by columns', pad: 0, write: byColumns },
  padded: { name: 'by columns, rows 16 pixels longer', pad: 16, write: byColumns },
  strips: { name: 'by strips of 16 columns', pad: 0, write: byStrips },
  rows: { name: 'by rows', pad: 0, write: byRows },
};

function byColumns(pixels, pitch) {
  for (let x = 0; x < kWidth; ++x)
    for (let y = 0; y < kHeight; ++y) pixels[y * pitch + x] = 0xff000000 | (x ^ y);
}

function byRows(pixels, pitch) {
  for (let y = 0; y < kHeight; ++y)
    for (let x = 0; x < kWidth; ++x) pixels[y * pitch + x] = 0xff000000 | (x ^ y);
}

const kColumn = 16 * (Math.ceil(kHeight / 16) | 1);
const strip = new Uint32Array(kStrip * kColumn);

function byStrips(pixels, pitch) {
  for (let first = 0; first < kWidth; first += kStrip) {
    for (let c = 0; c < kStrip; ++c)
      for (let y = 0; y < kHeight; ++y) strip[c * kColumn + y] = 0xff000000 | ((first + c) ^ y);
    for (let y = 0; y < kHeight; ++y)
      for (let c = 0; c < kStrip; ++c) pixels[y * pitch + first + c] = strip[c * kColumn + y];
  }
}

// Nanoseconds per pixel: the median of some rounds, in which the ways take turns.
function measure() {
  const names = Object.keys(kWays);
  const times = Object.fromEntries(names.map((name) => [name, []]));
  const pixels = new Uint32Array((kWidth + 16) * kHeight);
  for (let round = -1; round < kRounds; ++round)
    for (const name of names) {
      const { pad, write } = kWays[name];
      const begin = performance.now();
      write(pixels, kWidth + pad);
      if (round >= 0) times[name].push(performance.now() - begin);
    }
  return Object.fromEntries(
    names.map((name) => {
      const sorted = times[name].sort((a, b) => a - b);
      return [name, (sorted[kRounds >> 1] * 1e6) / (kWidth * kHeight)];
    }),
  );
}

function bars({ state }) {
  const longest = Math.max(...Object.keys(kWays).map((name) => state[name]), 1e-9);
  const rows = Object.entries(kWays).map(([name, way]) => {
    const time = state[name];
    const result =
      time > 0
        ? `<td><svg viewBox="0 0 120 16" width="120" height="16" aria-hidden="true">` +
          `<rect class="fig-lit" width="${fixed((120 * time) / longest, 1)}" height="16"/></svg></td>` +
          `<td class="number">${fixed(time)} ns</td><td class="number">${fixed(time / state.rows, 1)}</td>`
        : '<td></td><td class="number">–</td><td class="number">–</td>';
    return `<tr><th scope="row">${way.name}</th>${result}</tr>`;
  });
  return (
    `<table><thead><tr><th scope="col">Order</th><th scope="col" colspan="2">For a pixel</th>` +
    `<th scope="col" class="number">Times rows</th></tr></thead><tbody>${rows.join('')}</tbody></table>`
  );
}

export default {
  scene: 'corner.json',
  view: '5,5,0.5,45',
  state: Object.fromEntries(Object.keys(kWays).map((name) => [name, 0])),
  controls: [button({ label: 'Measure on this machine', change: measure })],
  rows: [
    [panel({ title: `A picture of ${kWidth} × ${kHeight} pixels, four times`, markup: bars })],
  ],
  says: ({ state }) =>
    state.rows > 0
      ? `On this machine, writing by columns takes ${fixed(state.plain / state.rows, 1)} times as long as writing by rows.`
      : 'Nothing is measured yet. It takes about a second.',
};
