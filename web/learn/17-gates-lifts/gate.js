// The yard's gate at any moment: its lower edge, and the row where that edge is seen.

import { fixed, picture, plot, sideView, slider } from '../figures/kit.js';
import { blockAt, gate, kStepsPerSecond, offsetAt } from './motion.js';

const gateOf = (now) => blockAt(now, { x: 9, y: 4.5 }, 'gate');
const secondsOf = ({ state }) => state.time / kStepsPerSecond;
const hitOf = (now) => now.slice.hits.find(({ blueprint }) => blueprint === 'gate');

export default {
  scene: 'yard-6.json',
  view: '7.6,4.5,0.5,0,0.02',
  options: { fov: 60 },
  size: [480, 300],
  state: { column: 240, time: 240 },
  controls: [
    slider({
      label: 'Time',
      field: 'time',
      from: 0,
      to: 960,
      step: 4,
      says: (value) => `${fixed(value / kStepsPerSecond)} s`,
    }),
  ],
  rows: [
    [picture({ handles: ['column'] }), sideView({ handles: [], depth: 8, height: 1.5 })],
    [
      plot({
        title: 'The lower edge of the gate, by time',
        x: { label: 'seconds', from: 0, to: gate.period },
        y: { label: 'units', from: 0, to: 1 },
        lines: [{ label: 'lower edge', of: (seconds) => offsetAt(gate, seconds) }],
        marks: (now) => [{ x: secondsOf(now), y: gateOf(now)?.bottom ?? 1, label: 'now' }],
      }),
    ],
  ],
  numbers: {
    seconds: (now) => fixed(secondsOf(now)),
    bottom: (now) => fixed(gateOf(now)?.bottom ?? 1),
    row: (now) => fixed(hitOf(now)?.bottomFrontRow ?? 0, 1),
  },
  says: (now) =>
    `After ${fixed(secondsOf(now))} s the lower edge is ${fixed(gateOf(now)?.bottom ?? 1)} units up.`,
};
