import { box, dot, drawing, fixed, line, path, picture, slider, text } from '../figures/kit.js';
import { groundOf, kHalfWidth } from './body.js';

const kSteps = 120; // a second
const kFrom = 8.2; // x at the left edge; the body walks west
const kTo = 1;
const kTop = 3.3;
const kTall = 0.72;
const kRow = 1; // y of the tiles of the stair

// The height of the feet: the highest tile that the body touches.
function feetOf(now) {
  const ground = groundOf(now);
  const { x } = now.eye;
  const touched = [];
  for (let tile = Math.floor(x - kHalfWidth); tile < x + kHalfWidth; ++tile)
    touched.push(ground(tile, kRow));
  return Math.max(...touched);
}

function profile(now, { width, height }) {
  const ground = groundOf(now);
  const unit = Math.min((width - 40) / (kFrom - kTo), (height - 34) / kTop);
  const floor = height - 26;
  const px = (x) => 34 + unit * (kFrom - x);
  const py = (z) => floor - unit * z;
  const { x, z } = now.eye;
  const feet = feetOf(now);
  const parts = [box(px(kFrom), floor, unit * (kFrom - kTo), 26, 'class="fig-earth"')];
  for (let tile = Math.floor(kFrom) - 1; tile >= kTo; --tile) {
    const top = ground(tile, kRow);
    if (top > 0) parts.push(box(px(tile + 1), py(top), unit, unit * top, 'class="fig-solid seen"'));
    if (top > 0)
      parts.push(text(px(tile + 0.5), py(top) + 17, fixed(top, 1), 'text-anchor="middle"'));
  }
  parts.push(
    box(
      px(x + kHalfWidth),
      py(feet + kTall),
      2 * kHalfWidth * unit,
      kTall * unit,
      'fill="var(--across)" fill-opacity="0.2" stroke="var(--across)" stroke-width="2"',
    ),
    line(px(x) + 4, py(z), px(x) + 46, py(z), 'stroke="var(--ray)" stroke-width="2"'),
    path(`M${(px(x) + 54).toFixed(1)} ${py(z).toFixed(1)}l-9 -5v10z`, 'fill="var(--ray)"'),
    dot(px(x), py(z), 6, 'class="fig-eye"'),
  );
  for (let level = 0; level <= 3; ++level)
    parts.push(text(28, py(level) + 4, String(level), 'class="soft" text-anchor="end"'));
  return parts.join('');
}

export default {
  scene: 'yard-2.json',
  view: '7.7,1.5,0.5,180,0.15',
  options: { fov: 66 },
  input: { forward: 1 },
  state: { time: 100 },
  controls: [
    slider({
      label: 'Time',
      field: 'time',
      from: 0,
      to: 240,
      step: 2,
      says: (steps) => `${fixed(steps / kSteps)} s`,
    }),
  ],
  rows: [
    [
      picture({ title: 'What the walker sees', mark: 'none', handles: [] }),
      drawing({
        title: 'The stair from the side',
        height: (width) => Math.round(Math.min(320, width * 0.5 + 30)),
        label: (now) =>
          `The body stands at height ${fixed(feetOf(now))}, its eye is at ${fixed(now.eye.z)}`,
        markup: profile,
      }),
    ],
  ],
  numbers: { eye: (now) => fixed(now.eye.z), feet: (now) => fixed(feetOf(now)) },
  says: (now) => {
    const feet = feetOf(now);
    const lag = feet + 0.5 - now.eye.z;
    const where = `The feet are at ${fixed(feet)}, the eye at ${fixed(now.eye.z)}.`;
    return lag > 0.02 ? `${where} It still has ${fixed(lag)} to rise.` : where;
  },
};
