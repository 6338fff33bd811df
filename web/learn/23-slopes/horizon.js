// The key idea from the side: the ramp's plane, continued to the eye, and its own horizon.

import {
  clamp,
  dot,
  drawing,
  fixed,
  group,
  knob,
  line,
  picture,
  polygon,
  slider,
  text,
  box,
} from '../figures/kit.js';
import { kFoot, kFov, kHead, kRise, planeOf } from './plane.js';

const kLongest = 8.4; // units
const kLowest = -1.75;
const kHighest = 2.5;
const kLeft = 40;
const kPlane = 70; // pixels from the eye to the picture plane, which is drawn much too large

function frame(now, { width, height }) {
  const unitX = (width - kLeft - 12) / kLongest;
  const unitZ = (height - 20) / (kHighest - kLowest);
  const place = (depth, z) => [kLeft + unitX * depth, 10 + unitZ * (kHighest - z)];
  return { unitX, unitZ, place };
}

const side = drawing({
  title: 'The same column from the side',
  share: 3,
  label: (now) =>
    `From the side: the ramp’s plane, continued to the eye, is ${fixed(Math.abs(planeOf(now).above))} units ${planeOf(now).above < 0 ? 'below' : 'above'} it.`,
  height: () => 330,
  markup(now, box_) {
    const { width, height, id } = box_;
    const { place } = frame(now, box_);
    const plane = planeOf(now);
    const { z } = now.eye;
    const rise = kRise * plane.along; // per unit of depth
    const [near, far] = [kFoot, kHead].map((x) => plane.depthOf(x));
    const eye = place(0, z);
    const under = place(0, z + plane.above);
    const end = place(kLongest, z + plane.above + rise * kLongest);
    const isMet = plane.along > 0.02;
    const top = (depth) => place(depth, z + plane.above + rise * depth);
    const planeX = kLeft + kPlane;
    const onPlane = (place_) => eye[1] + ((place_[1] - eye[1]) * kPlane) / (place_[0] - kLeft);
    const parallel = place(kLongest, z + rise * kLongest);
    const depth = plane.depthAt(now.row + 0.5);
    const isOnRamp = isMet && depth > near && depth < far;
    const spot = isOnRamp ? top(depth) : null;
    const [, ground] = place(0, 0);
    const [labelX, labelY] = place(1.2, z + plane.above + rise * 1.2);
    const label = [labelX + 8, clamp(labelY + 22, ground + 18, height - 8)];
    return (
      `<clipPath id="${id}-clip">${box(kLeft - 14, 0, width - kLeft + 14, height)}</clipPath>` +
      group(`clip-path="url(#${id}-clip)"`, [
        box(kLeft, ground, width, height - ground, 'class="fig-earth"'),
        isMet
          ? polygon(
              [
                place(near, 0),
                top(far),
                place(far + 2 / plane.along, 1),
                place(far + 2 / plane.along, 0),
              ],
              'class="fig-solid seen"',
            ) + line(...top(near), ...top(far), 'class="fig-surface roof"')
          : '',
        line(...under, ...end, 'stroke="var(--roof)" stroke-width="2" stroke-dasharray="8 6"'),
        line(...eye, ...place(kLongest, z), 'stroke="var(--soft)" stroke-width="1.5"'),
        line(...eye, ...parallel, 'class="fig-bold ray"'),
        line(planeX, 0, planeX, height, 'class="fig-axis"'),
        spot === null ? '' : line(...eye, ...spot, 'class="fig-sight"'),
        dot(planeX, eye[1], 4, 'class="fig-edge-dot"'),
        dot(planeX, onPlane(parallel), 4, 'class="fig-edge-dot"'),
        line(eye[0] - 8, eye[1], under[0] - 8, under[1], 'class="fig-measure"'),
        spot === null ? '' : dot(...spot, 5, 'class="fig-edge-dot"'),
      ]) +
      text(kLeft - 14, (eye[1] + under[1]) / 2 + 5, 'P', 'class="letter" text-anchor="end"') +
      text(
        planeX + 9,
        clamp(onPlane(parallel) - 9, 14, height - 6),
        'own horizon',
        'class="ray halo"',
      ) +
      text(width - 6, eye[1] + 17, 'horizon', 'class="soft halo" text-anchor="end"') +
      text(...label, 'the plane, continued', 'class="soft"') +
      knob(...eye, 'eye', 11, 'y')
    );
  },
  handles(now, box_) {
    const { place, unitZ } = frame(now, box_);
    const [x, y] = place(0, now.eye.z);
    const even = (z) => clamp(Math.round(20 * z) / 20, 0.2, 1.8);
    return [
      {
        id: 'height',
        label: 'Height of the eye',
        axis: 'y',
        x,
        y,
        value: now.eye.z,
        least: 0.2,
        greatest: 1.8,
        unit: 0.05,
        says: `${fixed(now.eye.z)} units`,
        drag: (point) => ({ eye: { z: even(kHighest - (point.y - 10) / unitZ) } }),
        keys: (right, down) => ({ eye: { z: even(now.state.eye.z + 0.05 * (right || -down)) } }),
      },
    ];
  },
});

const kTrue = 'stroke="var(--ink)" stroke-opacity="0.75" stroke-width="1.5"';
const marksOf = (now) => {
  const { own, horizon } = planeOf(now);
  return (
    line(0, horizon, now.width, horizon, kTrue) +
    line(now.column - 26, own, now.column + 27, own, 'class="fig-bold ray"')
  );
};

export default {
  scene: 'ramps.json',
  view: '1.5,4.5,0.5,0',
  options: { fov: kFov },
  size: [480, 300],
  state: { column: 240, row: 158 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: -60, to: 60, step: 1, unit: '°' })],
  rows: [
    [
      picture({ handles: ['row'], mark: 'pixel', over: marksOf, share: 3, title: 'One column' }),
      side,
    ],
  ],
  numbers: {
    rise: () => fixed(kRise, 1),
    along: (now) => fixed(planeOf(now).along),
    distance: (now) => fixed(planeOf(now).distance, 1),
    shift: (now) => fixed(planeOf(now).shift, 1),
    horizon: (now) => fixed(planeOf(now).horizon, 0),
    own: (now) => fixed(planeOf(now).own, 1),
    above: (now) => fixed(planeOf(now).above),
  },
  says(now) {
    const { shift, above, own } = planeOf(now);
    return `P = ${fixed(above)}: where the eye is, the plane lies ${fixed(Math.abs(above))} units ${above < 0 ? 'below' : 'above'} it. Its horizon is ${fixed(Math.abs(shift), 1)} rows ${shift < 0 ? 'below' : 'above'} the true one, in row ${fixed(own, 1)}.`;
  },
};
