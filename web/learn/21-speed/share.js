// Amdahl's law: how much faster the whole becomes if a share of it becomes faster.

import { fixed, plot, slider } from '../figures/kit.js';

const gain = (share, factor) => 1 / (1 - share + share / factor);

export default {
  scene: 'corner.json',
  view: '5,5,0.5,45',
  controls: [
    slider({
      label: 'The part takes',
      field: 'share',
      from: 0,
      to: 1,
      step: 0.01,
      opening: 0.7,
      says: (value) => `${fixed(100 * value, 0)} %`,
    }),
    slider({
      label: 'It becomes',
      field: 'factor',
      from: 1,
      to: 20,
      step: 0.5,
      opening: 3,
      says: (value) => `${fixed(value, 1)} times as fast`,
    }),
  ],
  rows: [
    [
      plot({
        title: 'How many times as fast the whole frame is',
        x: { label: 'share of the time', from: 0, to: 1, field: 'share' },
        y: { label: 'gain', from: 1, to: 6 },
        lines: [
          {
            label: 'your part',
            class: 'across',
            of: (share, now) => gain(share, now.state.factor),
          },
          {
            label: 'at most',
            class: 'along',
            of: (share) => gain(share, Infinity),
          },
        ],
      }),
    ],
  ],
  numbers: {
    share: (now) => `${fixed(100 * now.state.share, 0)} %`,
    factor: (now) => fixed(now.state.factor, 1),
    gain: (now) => fixed(gain(now.state.share, now.state.factor), 2),
    most: (now) => fixed(gain(now.state.share, Infinity), 2),
  },
  says: ({ state: { share, factor } }) =>
    `The frame becomes ${fixed(gain(share, factor), 2)} times as fast, and could at most become ${fixed(gain(share, Infinity), 2)} times as fast.`,
};
