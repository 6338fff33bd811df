import { readFileSync } from 'node:fs';

import { agreements } from './ties.js';

const kCorner = { scene: 'corner.json', size: [481, 300], state: { column: 240 } };

export default {
  // In how many ways the engine's tests break the renderer; not asked.
  mutations: {
    ...kCorner,
    view: '5,5,0.5,45',
    answer: () => JSON.parse(readFileSync('tests/judge/mutations.json', 'utf8')).length,
    digits: 0,
  },
  // To the north-west, westward borders come last.
  'north-west': {
    ...kCorner,
    view: '5,5,0.5,225',
    answer: (now) => now.slice.walk.findIndex(({ tile: [x, y] }) => x === 4 && y === 4),
    digits: 0,
  },
  'north-west-tiles': {
    ...kCorner,
    view: '5,5,0.5,225',
    answer: (now) => now.slice.walk.map(({ tile }) => `(${tile.join(', ')})`).join(', '),
  },
  // The first corner at which sums disagree, for five east and three south.
  'first-disagreement': {
    ...kCorner,
    view: '5,5,0.5,45',
    answer: () => agreements(5, 3, 100).findIndex(({ sums: [x, y] }) => x !== y) + 1,
  },
  // How many of the four diagonals the wrong rule changes.
  'wrong-directions': {
    ...kCorner,
    view: '5,5,0.5,45',
    answer: () => 2,
    digits: 0,
  },
};
