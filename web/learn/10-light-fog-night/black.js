// A lamp with a lower limit, and without one.

import { byHandWorld } from '../by-hand.js';
import { divider, slider } from '../figures/kit.js';
import { drawnIn } from './lamp.js';

const kNight = {
  sky: { low: [26, 33, 58, 255], high: [6, 8, 20, 255], slope: 0.8 },
  haze: [26, 33, 58, 255],
  fog: { on: false },
};

export default {
  scene: 'long-wall.json',
  view: '2.5,3,0.5,338',
  options: { fov: 66 },
  size: [320, 200],
  state: { split: 0.4 },
  world: byHandWorld,
  controls: [
    slider({
      label: 'Intensity · multiplier',
      field: 'strength',
      from: 0.1,
      to: 4,
      step: 0.1,
      opening: 1.5,
    }),
    slider({ label: 'Turn', eye: 'heading', from: 0, to: 360, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: {
          title: 'Darkest 0.2',
          draw: drawnIn(({ strength }) => ({
            ...kNight,
            light: { intensity: strength, multiplier: 1, darkest: 0.2 },
          })),
        },
        right: {
          title: 'No darkest',
          draw: drawnIn(({ strength }) => ({
            ...kNight,
            light: { intensity: strength, multiplier: 1, darkest: 0 },
          })),
        },
      }),
    ],
  ],
  says: ({ state }) =>
    `Without the limit a wall at depth 10 has ${Math.round(100 * Math.min(1, state.strength / 10))} percent of its brightness.`,
};
