// By how many rows the wall's upper edge is wrong, column by column.

import { fixed, plot, slider } from '../figures/kit.js';
import { errorsOf } from './projections.js';

const worst = (now, way) => Math.max(...errorsOf(now)[way].map(([, error]) => Math.abs(error)));

export default {
  scene: 'long-wall.json',
  view: '20.5,3.2,0.5,290',
  controls: [
    slider({ label: 'Turn', eye: 'heading', from: 230, to: 310, step: 1, unit: '°' }),
    slider({
      label: 'Field of view',
      option: 'fov',
      from: 50,
      to: 120,
      step: 1,
      unit: '°',
      opening: 90,
    }),
  ],
  rows: [
    [
      plot({
        x: { label: 'column', from: 0, to: 480 },
        y: { label: 'rows', from: -10, to: 40 },
        lines: [
          { label: 'distance', class: 'ray', points: (now) => errorsOf(now).distance },
          { label: 'with cosine', class: 'across', points: (now) => errorsOf(now).cosine },
        ],
      }),
    ],
  ],
  numbers: {
    distance: (now) => fixed(worst(now, 'distance'), 1),
    cosine: (now) => fixed(worst(now, 'cosine'), 1),
  },
  says: (now) =>
    `Worst error with the distance: ${fixed(worst(now, 'distance'), 1)} rows; with distance × cosine: ${fixed(worst(now, 'cosine'), 1)} rows.`,
};
