// A ride on the lift: what the eye sees, and how high it is.

import { fixed, picture, plot, slider } from '../figures/kit.js';
import { kStepsPerSecond, offsetAt } from './motion.js';

const kRest = 0.25; // the lift's top at its lowest
const kEye = 0.5; // above the feet
const lift = { period: 12, shape: 'stop-and-go', to: 1 };

export default {
  scene: 'yard-6.json',
  view: '13.5,6.5,0.75,215,0',
  options: { fov: 66 },
  size: [480, 300],
  state: { time: 480 },
  controls: [
    slider({
      label: 'Time',
      field: 'time',
      from: 0,
      to: 1440,
      step: 8,
      says: (value) => `${fixed(value / kStepsPerSecond)} s`,
    }),
  ],
  rows: [
    [
      picture({ mark: 'none', handles: [] }),
      plot({
        title: 'Height of the eye',
        x: { label: 'seconds', from: 0, to: lift.period },
        y: { label: 'units', from: 0, to: 2 },
        lines: [
          { label: 'top of the lift', of: (seconds) => kRest + offsetAt(lift, seconds) },
          {
            label: 'eye',
            of: (seconds) => kRest + kEye + offsetAt(lift, seconds),
            class: 'across',
          },
        ],
        marks: (now) => [{ x: now.state.time / kStepsPerSecond, y: now.eye.z, label: 'now' }],
      }),
    ],
  ],
  numbers: { eye: (now) => fixed(now.eye.z) },
  says: (now) =>
    `After ${fixed(now.state.time / kStepsPerSecond)} s the eye is ${fixed(now.eye.z)} units up.`,
};
