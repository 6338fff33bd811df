// The depth of a row by similar triangles.

import {
  clamp,
  distanceOf,
  dot,
  drawing,
  fixed,
  knob,
  line,
  picture,
  polygon,
  text,
} from '../figures/kit.js';

const kFov = 66;
const kLeft = 34; // pixels: where the eye is
const kPlane = 96; // pixels from the eye to the picture plane, which is drawn much too large
const kLongest = 7; // units
const kTop = 176;

const below = ({ row, height }) => row + 0.5 - height / 2;
const depthOf = (now) => (now.eye.z * distanceOf(kFov, now.width)) / below(now);

function frame(now, { width, height }) {
  const floor = height - 58;
  const unitX = (width - kLeft - 26) / kLongest;
  const unitZ = (floor - 24) / 0.95;
  const place = (depth, z) => [kLeft + unitX * depth, floor - unitZ * z];
  const eye = place(0, now.eye.z);
  const foot = place(depthOf(now), 0);
  const share = kPlane / (foot[0] - kLeft);
  const onPlane = [kLeft + kPlane, eye[1] + (foot[1] - eye[1]) * share];
  return { floor, unitX, unitZ, eye, foot, onPlane };
}

const side = drawing({
  title: 'The same row from the side',
  label: (now) =>
    `The sight line of row ${now.row} meets the floor at depth ${fixed(depthOf(now))}.`,
  height: () => 300,
  markup(now, box) {
    const { floor, eye, foot, onPlane } = frame(now, box);
    const [planeX] = onPlane;
    const isShort = foot[0] < planeX;
    return (
      polygon([eye, [foot[0], eye[1]], foot], 'class="fig-wedge floor"') +
      (isShort ? '' : polygon([eye, [planeX, eye[1]], onPlane], 'class="fig-wedge side now"')) +
      line(0, floor, box.width, floor, 'class="fig-surface floor"') +
      line(...eye, box.width, eye[1], 'class="fig-horizon"') +
      line(planeX, eye[1] - 40, planeX, floor, 'class="fig-axis"') +
      line(...eye, ...foot, 'class="fig-sight"') +
      line(kLeft, eye[1], kLeft, floor, 'class="fig-measure"') +
      text(kLeft - 9, (eye[1] + floor) / 2 + 4, 'z', 'class="letter" text-anchor="end"') +
      text(kLeft + kPlane / 2, eye[1] - 8, 'd', 'class="letter" text-anchor="middle"') +
      (isShort
        ? ''
        : line(planeX, eye[1], ...onPlane, 'class="fig-bold"') +
          text(planeX + 8, (eye[1] + onPlane[1]) / 2 + 4.5, `${fixed(below(now), 1)} rows`)) +
      line(kLeft, floor + 20, foot[0], floor + 20, 'class="fig-measure"') +
      text(
        (kLeft + foot[0]) / 2,
        floor + 38,
        `t = ${fixed(depthOf(now))}`,
        'text-anchor="middle"',
      ) +
      text(box.width - 4, eye[1] - 8, 'horizon', 'class="soft" text-anchor="end"') +
      dot(...foot, 4.5, 'class="fig-edge-dot"') +
      knob(...eye, 'eye') +
      knob(foot[0], floor, 'ray')
    );
  },
  handles(now, box) {
    const { floor, unitX, unitZ, eye, foot } = frame(now, box);
    return [
      {
        id: 'eye',
        label: 'Height of the eye',
        axis: 'y',
        x: eye[0],
        y: eye[1],
        value: now.eye.z,
        least: 0.1,
        greatest: 0.9,
        says: `${fixed(now.eye.z)} units`,
        drag: ({ y }) => ({
          eye: { z: clamp(Math.round((100 * (floor - y)) / unitZ) / 100, 0.1, 0.9) },
        }),
        keys: (right, down) => ({
          eye: {
            z: clamp(Math.round(100 * (now.state.eye.z + 0.02 * (right || -down))) / 100, 0.1, 0.9),
          },
        }),
      },
      {
        id: 'foot',
        label: 'Point of the floor',
        axis: 'x',
        x: foot[0],
        y: floor,
        value: now.row,
        least: kTop,
        greatest: now.height - 1,
        says: `row ${now.row}, depth ${fixed(depthOf(now))}`,
        drag({ x }) {
          const depth = clamp((x - kLeft) / unitX, 0.2, kLongest);
          return {
            row: Math.round(
              (now.eye.z * distanceOf(kFov, now.width)) / depth + now.height / 2 - 0.5,
            ),
          };
        },
        keys: (right, down) => ({ row: now.state.row - (right || -down) }),
      },
    ];
  },
});

export default {
  scene: 'long-wall.json',
  view: '20.5,7.6,0.5,270',
  options: { fov: kFov },
  size: [480, 300],
  state: { row: 196 },
  // Rows whose point would be outside the drawing.
  check({ row, eye }) {
    const top = Math.max(kTop, Math.ceil((eye.z * distanceOf(kFov, 480)) / kLongest + 149.5));
    return row < top ? { row: top } : {};
  },
  rows: [[picture({ handles: ['row'], mark: 'row', title: 'One row of the picture' }), side]],
  numbers: {
    below: (now) => fixed(below(now), 1),
    z: (now) => fixed(now.eye.z),
    distance: (now) => fixed(distanceOf(kFov, now.width), 1),
    depth: (now) => fixed(depthOf(now)),
  },
  says: (now) =>
    `t = ${fixed(distanceOf(kFov, now.width), 1)} · ${fixed(now.eye.z)} ÷ ${fixed(below(now), 1)} = ${fixed(depthOf(now))}. The picture plane is drawn much too large, so that its triangle can be seen.`,
};
