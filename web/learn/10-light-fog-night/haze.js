// The weight of the haze by depth, and a picture with it.

import { byHandWorld } from '../by-hand.js';
import { divider, fixed, plot, slider } from '../figures/kit.js';
import { drawnIn, limit } from './lamp.js';

const weight = (depth, { start, end }) =>
  Math.floor(255 * limit((depth - start) / (end - start), 0, 1) + 0.5);

export default {
  scene: 'yard-2.json',
  view: '9.4,4.5,0.5,192,0.1',
  options: { fov: 66 },
  size: [320, 200],
  world: byHandWorld,
  state: { depth: 6, split: 0.4 },
  check: ({ start, end }) => (end <= start + 0.5 ? { end: start + 0.5 } : {}),
  controls: [
    slider({
      label: 'Start',
      field: 'start',
      from: 0,
      to: 15,
      step: 0.5,
      opening: 2,
      unit: 'units',
    }),
    slider({ label: 'End', field: 'end', from: 1, to: 45, step: 0.5, opening: 10, unit: 'units' }),
  ],
  rows: [
    [
      plot({
        title: 'The weight of the haze by depth',
        x: { label: 'depth, units', from: 0, to: 20, field: 'depth', unit: 'units' },
        y: { label: 'weight', from: 0, to: 280, digits: 0 },
        lines: [{ label: 'haze', of: (depth, { state }) => weight(depth, state), class: 'along' }],
      }),
      divider({
        left: { title: 'No fog', options: { fog: 'off' } },
        right: {
          title: 'Fog',
          draw: drawnIn(({ start, end }) => ({ fog: { on: true, start, end } })),
        },
      }),
    ],
  ],
  numbers: {
    start: ({ state }) => fixed(state.start, 1),
    end: ({ state }) => fixed(state.end, 1),
    depth: ({ state }) => fixed(state.depth, 1),
    weight: ({ state }) => String(weight(state.depth, state)),
  },
  says: ({ state }) =>
    `At depth ${fixed(state.depth, 1)} the haze has the weight ${weight(state.depth, state)}, and the wall ${255 - weight(state.depth, state)}.`,
};
