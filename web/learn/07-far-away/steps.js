// The width of a pixel in texels, and of the texels of the level that is taken.

import { distanceOf, fixed, plot } from '../figures/kit.js';
import { levelAt } from './detail.js';

const distance = (now) => distanceOf(66, now.width);
const patch = (depth, now) => (depth * 128) / distance(now);
const texel = (depth, now) => 2 ** levelAt(depth, 128, distance(now), 7);

// The corners of the steps.
function stairs(now) {
  const points = [[0, 1]];
  for (let level = 0; level < 5; ++level) {
    const depth = (2 ** level * distance(now)) / 128;
    points.push([depth, 2 ** level], [depth, 2 ** (level + 1)]);
  }
  return points;
}

export default {
  scene: 'sparkle.json',
  view: '4.5,1.5,0.5,90',
  options: { fov: 66 },
  state: { depth: 14 },
  rows: [
    [
      plot({
        x: { label: 'depth, units', from: 0, to: 30, field: 'depth', unit: 'units' },
        y: { label: 'texels', from: 0, to: 16 },
        marks: ({ state }) => [
          {
            x: state.depth,
            y: texel(state.depth, { width: 480 }),
            label: String(texel(state.depth, { width: 480 })),
          },
        ],
        lines: [
          { label: 'the level', points: stairs, class: 'along' },
          { label: 'one pixel', of: patch, class: 'across' },
        ],
      }),
    ],
  ],
  numbers: {
    distance: (now) => fixed(distance(now), 1),
    first: (now) => fixed(distance(now) / 128),
  },
  says: (now) =>
    `Depth ${fixed(now.state.depth, 1)}: a pixel is ${fixed(patch(now.state.depth, now))} texels wide, and level ${levelAt(now.state.depth, 128, distance(now), 7)} has texels that are ${texel(now.state.depth, now)} wide.`,
};
