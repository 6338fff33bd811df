// What a march costs: looks by the size of the step.

import { fixed, plot, slider } from '../figures/kit.js';

const kGreatest = 0.3;
const kLeast = 0.005;

const looksWith = (step, now) => Math.ceil(now.slice.hits[0].depth / step) + 1;
const grouped = (number) => String(number).replace(/\B(?=(\d{3})+(?!\d))/g, ' ');

export default {
  scene: 'yard-1.json',
  view: '2.2,6.9,0.5,330',
  options: { fov: 66 },
  state: { column: 240, size: 0.05 },
  controls: [
    slider({
      label: 'Step',
      field: 'size',
      from: kLeast,
      to: kGreatest,
      step: 0.005,
      opening: 0.05,
      unit: 'units',
    }),
  ],
  rows: [
    [
      plot({
        x: { label: 'step', from: 0, to: kGreatest, field: 'size', step: 0.005, unit: 'units' },
        y: { label: 'looks', from: 0, to: 400 },
        lines: [
          {
            label: 'march',
            class: 'ray',
            points: (now) =>
              Array.from({ length: 120 }, (_, index) => {
                const step = kLeast * (kGreatest / kLeast) ** (index / 119);
                return [step, now.slice.hits[0].depth / step + 1];
              }).filter(([, looks]) => looks <= 400),
          },
          {
            label: 'tiles',
            class: 'across',
            points: (now) => [
              [0, now.slice.walk.length],
              [kGreatest, now.slice.walk.length],
            ],
          },
        ],
        marks: (now) => [
          {
            x: now.state.size,
            y: Math.min(400, looksWith(now.state.size, now)),
            label: `${looksWith(now.state.size, now)} looks`,
          },
        ],
      }),
    ],
  ],
  check: (state) => ({ size: Math.max(kLeast, Math.min(kGreatest, state.size)) }),
  numbers: {
    step: (now) => String(Number(now.state.size.toFixed(3))),
    looks: (now) => String(looksWith(now.state.size, now)),
    picture: (now) => grouped(480 * looksWith(now.state.size, now)),
    middle: (now) => fixed(now.slice.hits[0].depth, 3),
  },
  says: (now) =>
    `A step of ${Number(now.state.size.toFixed(3))} units takes ${looksWith(now.state.size, now)} looks for a wall at depth ${fixed(now.slice.hits[0].depth)}.`,
};
