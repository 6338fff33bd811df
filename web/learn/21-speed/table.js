// Fast and wrong: directions from a table of sines.

import { choice, divider, fixed } from '../figures/kit.js';

const kSines = { method: 'classic', 'classic.projection': 'equalAnglesCorrected' };
const withTable = ({ entries }) => ({ ...kSines, 'classic.sineSteps': entries });

// The share of pixels that the table changes.
const changedShare = (now) =>
  now.kept('changed', () => {
    const exact = pixelsWith(now.source, kSines);
    const other = pixelsWith(now.source, withTable(now.state));
    let count = 0;
    for (let i = 0; i < exact.length; i += 4)
      if ([0, 1, 2].some((channel) => Math.abs(exact[i + channel] - other[i + channel]) > 1))
        count += 1;
    return count / (exact.length / 4);
  });

function pixelsWith(source, options) {
  const before = Object.keys(options).map((name) => [name, source.get(name)]);
  for (const [name, value] of Object.entries(options)) source.set(name, value);
  const pixels = source.pixels().data.slice();
  for (const [name, value] of before) source.set(name, value);
  return pixels;
}

const percent = (share) => `${fixed(100 * share, share < 0.1 ? 1 : 0)}\u00a0%`;

export default {
  scene: 'yard.json',
  view: '7.4,7.5,0.5,235,0.12',
  options: { fov: 66 },
  state: { split: 0.5 },
  controls: [
    choice({
      label: 'Entries of the table',
      field: 'entries',
      of: { 360: 'one per degree', 3600: 'ten per degree', 36000: 'a hundred per degree' },
    }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Sines', options: kSines },
        right: { title: 'A table of sines', options: withTable },
      }),
    ],
  ],
  numbers: { changed: (now) => percent(changedShare(now)) },
  says: (now) => `The table changes ${percent(changedShare(now))} of the pixels.`,
};
