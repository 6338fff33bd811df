// The lettered block from above, with the direction in which u grows on each side.

import { line, mapView, path, picture, text } from '../figures/kit.js';

const kMiddle = [8.5, 6.5];
const kGap = 0.2; // tiles between a side and its arrow

// From the left to the right, as seen from outside.
const kArrows = {
  south: [
    [8, 7 + kGap],
    [9, 7 + kGap],
  ],
  east: [
    [9 + kGap, 7],
    [9 + kGap, 6],
  ],
  north: [
    [9, 6 - kGap],
    [8, 6 - kGap],
  ],
  west: [
    [8 - kGap, 6],
    [8 - kGap, 7],
  ],
};
const kNames = { south: [0, 1], east: [1, 0], north: [0, -1], west: [-1, 0] };

function headingTo([x, y], eye) {
  return (Math.atan2(y - eye.y, x - eye.x) * 180) / Math.PI;
}

// The side that the eye sees at the smallest angle.
function facing({ eye }) {
  const [x, y] = [eye.x - kMiddle[0], eye.y - kMiddle[1]];
  if (Math.abs(x) > Math.abs(y)) return x > 0 ? 'east' : 'west';
  return y > 0 ? 'south' : 'north';
}

function arrows(now, at) {
  const seen = facing(now);
  return Object.entries(kArrows)
    .map(([face, [from, to]]) => {
      const [x1, y1] = at(...from);
      const [x2, y2] = at(...to);
      const length = Math.hypot(x2 - x1, y2 - y1);
      const [dx, dy] = [(x2 - x1) / length, (y2 - y1) / length];
      const kind = face === 'south' || face === 'north' ? 'along' : 'across';
      const faint = face === seen ? '' : ' opacity="0.5"';
      const [nx, ny] = kNames[face];
      const head = `M${x2} ${y2}L${x2 - 10 * dx - 6 * dy} ${y2 - 10 * dy + 6 * dx}L${x2 - 10 * dx + 6 * dy} ${y2 - 10 * dy - 6 * dx}Z`;
      return (
        line(x1, y1, x2 - 6 * dx, y2 - 6 * dy, `class="fig-tick ${kind}"${faint}`) +
        path(head, `class="fig-mark ${kind}"${faint}`) +
        text(
          x1 + 15 * nx - 7 * dx,
          y1 + 15 * ny - 7 * dy + 4.5,
          '0',
          'class="soft" text-anchor="middle"',
        ) +
        text(
          x2 + 15 * nx + 7 * dx,
          y2 + 15 * ny + 7 * dy + 4.5,
          '1',
          'class="soft" text-anchor="middle"',
        )
      );
    })
    .join('');
}

const kRule = {
  south: 'u is the fraction of x',
  north: 'u is 1 minus the fraction of x',
  west: 'u is the fraction of y',
  east: 'u is 1 minus the fraction of y',
};

export default {
  scene: 'yard-1.json',
  view: '9.1,4.9,0.5,110.6',
  options: { fov: 66 },
  size: [360, 320],
  // The eye always looks at the block.
  check: ({ eye }) => ({ eye: { heading: headingTo(kMiddle, eye) } }),
  rows: [
    [
      mapView({
        window: [6, 4, 5, 5],
        handles: ['eye'],
        ray: false,
        lit: false,
        over: arrows,
        tallest: 360,
        label: (now) =>
          `The block from above. You stand at its ${facing(now)} side: ${kRule[facing(now)]}.`,
      }),
      picture({ handles: [], mark: 'none' }),
    ],
  ],
  says: (now) => `You look at the ${facing(now)} side: ${kRule[facing(now)]}.`,
};
