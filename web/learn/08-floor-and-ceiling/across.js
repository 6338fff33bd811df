// A row of the picture, and the line across the floor that it shows.

import { distanceOf, dot, fixed, line, mapView, picture } from '../figures/kit.js';

const kEvery = 40; // pixels between two marks on the line
const kTop = 158; // no row above shows much of the floor: its line is far outside the map

const depthOf = ({ eye, row, width, height }) =>
  (eye.z * distanceOf(66, width)) / (row + 0.5 - (height / 2 + eye.look * height));

function floorLine(now, at) {
  const { eye, width } = now;
  const angle = (eye.heading * Math.PI) / 180;
  const [fx, fy] = [Math.cos(angle), Math.sin(angle)];
  const depth = depthOf(now);
  const point = (column) => {
    const aside = ((column + 0.5 - width / 2) / distanceOf(66, width)) * depth;
    return at(eye.x + depth * fx - aside * fy, eye.y + depth * fy + aside * fx);
  };
  const marks = [];
  for (let column = 0; column < width; column += kEvery)
    marks.push(dot(...point(column), 2.5, 'class="fig-edge-dot"'));
  marks.push(dot(...point(width - 1), 2.5, 'class="fig-edge-dot"'));
  return line(...point(0), ...point(width - 1), 'class="fig-bold ray"') + marks.join('');
}

export default {
  scene: 'long-wall.json',
  view: '20.5,7.6,0.5,270',
  options: { fov: 66 },
  size: [480, 300],
  state: { row: 196 },
  check: ({ row }) => (row < kTop ? { row: kTop } : {}),
  rows: [
    [
      picture({ handles: ['row', 'turn'], mark: 'row', title: 'One row of the picture' }),
      mapView({
        title: 'The same row on the floor',
        window: [14, 0, 13, 9],
        handles: ['eye'],
        ray: false,
        lit: false,
        over: floorLine,
        tallest: 330,
        label: (now) =>
          `The floor from above: the row is a straight line at depth ${fixed(depthOf(now))}.`,
      }),
    ],
  ],
  numbers: { depth: (now) => fixed(depthOf(now)) },
  says: (now) =>
    `Row ${now.row} shows the floor at depth ${fixed(depthOf(now))}. A mark is drawn for every fortieth pixel.`,
};
