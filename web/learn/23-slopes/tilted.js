// The horizons of all columns: together they are one straight line, which tilts.

import { button, fixed, line, mapView, picture, slider } from '../figures/kit.js';
import { kFov, planeOf } from './plane.js';

const kTrue = 'stroke="var(--ink)" stroke-opacity="0.75" stroke-width="1.5" stroke-dasharray="8 6"';

function horizons(now) {
  const first = planeOf(now, -0.5).own;
  const last = planeOf(now, now.width - 0.5).own;
  const { horizon } = planeOf(now);
  return (
    line(0, horizon, now.width, horizon, kTrue) +
    line(0, first, now.width, last, 'class="fig-bold ray"')
  );
}

export default {
  scene: 'ramps.json',
  view: '2.2,6.6,0.8,320',
  options: { fov: kFov },
  size: [480, 300],
  state: { column: 300 },
  controls: [
    slider({ label: 'Turn', eye: 'heading', from: -180, to: 180, step: 1, unit: '°' }),
    button({
      label: 'Up the ramp',
      change: () => ({ eye: { x: 2.2, y: 4.5, z: 0.5, heading: 0 } }),
    }),
    button({
      label: 'Across it',
      change: () => ({ eye: { x: 5, y: 7.5, z: 0.8, heading: 270 } }),
    }),
    button({
      label: 'Down from the platform',
      change: () => ({ eye: { x: 7.4, y: 4.5, z: 1.5, heading: 180 } }),
    }),
  ],
  rows: [
    [
      picture({ handles: ['column', 'turn'], over: horizons, share: 3 }),
      mapView({ handles: ['heading'], lit: false, order: false, marks: false, share: 2 }),
    ],
  ],
  numbers: {
    left: (now) => fixed(planeOf(now, 0).shift, 0),
    right: (now) => fixed(planeOf(now, now.width - 1).shift, 0),
  },
  says(now) {
    const [left, right] = [0, now.width - 1].map((column) => planeOf(now, column).shift);
    const way = (shift) => `${fixed(Math.abs(shift), 0)} rows ${shift < 0 ? 'down' : 'up'}`;
    return `In the leftmost column the horizon is moved by ${way(left)}, in the rightmost one by ${way(right)}.`;
  },
};
