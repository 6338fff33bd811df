// Two panes before a wall: what each does to the light that comes through.

import { box, drawing, line, slider, text, toggle } from '../figures/kit.js';
import { layOver } from './blending.js';

const kWall = [222, 205, 170];
const kBlue = [40, 96, 190];
const kAmber = [236, 158, 40];
const kHeight = 190;
const kMiddle = 'text-anchor="middle"';
const kBeam = { top: 66, height: 60 };

// The panes from far to near, and the colours after each.
function lightOf({ blue, amber, swapped }, other = false) {
  const panes = [
    { name: 'blue', colour: kBlue, alpha: blue },
    { name: 'amber', colour: kAmber, alpha: amber },
  ];
  if (swapped !== other) panes.reverse();
  const colours = [kWall];
  for (const { colour, alpha } of panes) colours.push(layOver(colour, alpha, colours.at(-1)));
  return { panes, colours };
}

const rgb = (colour) => `rgb(${colour.join(',')})`;
const written = (colour) => colour.join(', ');

function markup({ state }, { width }) {
  const { panes, colours } = lightOf(state);
  const wall = Math.max(30, width * 0.08);
  const part = (width - wall) / 3;
  const middle = kBeam.top + kBeam.height / 2;
  const parts = [box(0, 30, wall, 132, `fill="${rgb(kWall)}"`), text(0, 20, 'wall')];
  colours.forEach((colour, i) => {
    const left = wall + i * part;
    parts.push(
      box(left, kBeam.top, part, kBeam.height, `fill="${rgb(colour)}"`),
      text(left + part / 2, kBeam.top + kBeam.height + 24, written(colour), kMiddle),
    );
  });
  panes.forEach(({ name, colour, alpha }, i) => {
    const x = wall + (i + 1) * part;
    parts.push(
      box(x - 6, 30, 12, 132, `fill="${rgb(colour)}" fill-opacity="${alpha / 255}"`),
      line(x - 6, 30, x - 6, 162, 'class="fig-axis"'),
      line(x + 6, 30, x + 6, 162, 'class="fig-axis"'),
      text(x, 20, `${name} ${alpha}`, kMiddle),
    );
  });
  parts.push(
    line(wall + 8, middle, width - 16, middle, 'class="fig-ray"'),
    text(width, 20, 'eye', 'text-anchor="end"'),
    text(width / 2, kHeight - 6, 'red, green, blue of the light', `class="soft" ${kMiddle}`),
  );
  return parts.join('');
}

const resultOf = (state, other) => lightOf(state, other).colours.at(-1);

export default {
  scene: 'yard-5.json',
  view: '10.6,2.5,1.5,250,0',
  size: [480, 300],
  state: { blue: 150, amber: 150, swapped: false },
  controls: [
    slider({ label: 'Alpha of the blue pane', field: 'blue', from: 0, to: 255, step: 1 }),
    slider({ label: 'Alpha of the amber pane', field: 'amber', from: 0, to: 255, step: 1 }),
    toggle({ label: 'Swap the panes', field: 'swapped' }),
  ],
  rows: [
    [
      drawing({
        title: 'Light from the wall to the eye',
        height: () => kHeight,
        label: ({ state }) => `The light arrives as ${written(resultOf(state))}`,
        markup,
      }),
    ],
  ],
  numbers: {
    result: ({ state }) => written(resultOf(state)),
    other: ({ state }) => written(resultOf(state, true)),
  },
  says: ({ state }) => {
    const { panes, colours } = lightOf(state);
    return `The ${panes.at(-1).name} pane is in front: the eye gets ${written(colours.at(-1))}. Swapped, it would get ${written(resultOf(state, true))}.`;
  },
};
