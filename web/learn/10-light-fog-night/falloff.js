// Brightness by depth, and a picture lit with it.

import { byHandWorld } from '../by-hand.js';
import { divider, fixed, plot, slider } from '../figures/kit.js';
import { drawnIn, limit } from './lamp.js';

const raw = (depth, { strength }) => strength / depth;
const bright = (depth, state) => limit(raw(depth, state), state.darkest, 1);

// The depth from which on the rule gives less than `value`.
const reach = (value, { strength }) => strength / value;

export default {
  scene: 'yard-1.json',
  view: '1.6,6.7,0.5,345',
  options: { fov: 66 },
  size: [320, 200],
  world: byHandWorld,
  state: { depth: 6, split: 0.35 },
  controls: [
    slider({
      label: 'Intensity · multiplier',
      field: 'strength',
      from: 0.5,
      to: 10,
      step: 0.1,
      opening: 3,
    }),
    slider({ label: 'Darkest', field: 'darkest', from: 0, to: 1, step: 0.05, opening: 0.2 }),
  ],
  rows: [
    [
      plot({
        title: 'Brightness by depth',
        x: { label: 'depth, units', from: 0, to: 20, field: 'depth', unit: 'units' },
        y: { label: 'brightness', from: 0, to: 1.2 },
        lines: [
          {
            label: 'the rule',
            of: (depth, { state }) => Math.min(5, raw(Math.max(depth, 1e-3), state)),
            class: 'across',
          },
          {
            label: 'limited',
            of: (depth, { state }) => bright(Math.max(depth, 1e-3), state),
            class: 'along',
          },
        ],
      }),
      divider({
        left: { title: 'No light', options: { light: 'off', fog: 'off' } },
        right: {
          title: 'The lamp',
          draw: drawnIn(({ strength, darkest }) => ({
            light: { intensity: strength, multiplier: 1, darkest },
            fog: { on: false },
          })),
        },
      }),
    ],
  ],
  numbers: {
    strength: ({ state }) => fixed(state.strength, 1),
    depth: ({ state }) => fixed(state.depth, 1),
    raw: ({ state }) => fixed(raw(state.depth, state)),
    full: ({ state }) => fixed(reach(1, state), 1),
    dark: ({ state }) => (state.darkest === 0 ? 'no depth' : fixed(reach(state.darkest, state), 1)),
  },
  says: ({ state }) =>
    `At depth ${fixed(state.depth, 1)} the rule gives ${fixed(raw(state.depth, state))}; limited, that is ${fixed(bright(state.depth, state))}.`,
};
