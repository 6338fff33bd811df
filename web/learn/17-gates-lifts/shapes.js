// The three shapes of a motion over one period.

import { fixed, plot } from '../figures/kit.js';
import { partAt, shapes } from './motion.js';

const of = (shape) => (at) => shapes[shape](partAt(at, 1));

export default {
  scene: 'yard-6.json',
  view: '8.5,4.5,0.5,0,0.1',
  size: [480, 300],
  state: { at: 0.15 },
  controls: [],
  rows: [
    [
      plot({
        title: 'One period',
        x: { label: 'part of the period', from: 0, to: 1, field: 'at' },
        y: { label: 'way', from: 0, to: 1 },
        lines: [
          { label: 'even', of: of('even'), class: 'across' },
          { label: 'smooth', of: of('smooth'), class: 'along' },
          { label: 'stop-and-go', of: of('stop-and-go') },
        ],
      }),
    ],
  ],
  numbers: {},
  says: ({ state }) => {
    const [even, smooth, rests] = Object.keys(shapes).map((shape) => fixed(of(shape)(state.at)));
    return `At ${fixed(state.at)} of the period, even has gone ${even} of the way, smooth ${smooth}, stop-and-go ${rests}.`;
  },
};
