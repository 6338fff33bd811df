// A body on ramps: it follows a gentle one, and slides down a steep one.

import {
  box,
  button,
  dot,
  drawing,
  fixed,
  line,
  picture,
  polygon,
  slider,
  text,
} from '../figures/kit.js';

const kSteps = 120; // a second
const kFrom = 2.6;
const kTo = 10.6;
const kHighest = 1.9;
const kTall = 0.72; // of a body
const kHalfWidth = 0.2;

const kWays = {
  walk: { input: { forward: 1 }, eye: { x: 3, y: 4.5, z: 0.5, heading: 0 } },
  stay: { input: {}, eye: { x: 5, y: 4.5, z: 1.1, heading: 0 } },
  slide: { input: {}, eye: { x: 8.4, y: 4.5, z: 1.3, heading: 0 } },
};

// The profile of the ramps along y = 4.5, as corners.
const kProfile = [
  [4, 0],
  [6, 1],
  [8, 1],
  [9, 0],
];

const heightAt = (x) => Math.max(0, Math.min(1, (x - 4) / 2, 9 - x));

const begin = (way) => ({ way, eye: kWays[way].eye, time: way === 'walk' ? 90 : 0 });

function profile(now, { width, height }) {
  const unit = Math.min((width - 24) / (kTo - kFrom), (height - 40) / kHighest);
  const ground = height - 26;
  const place = (x, z) => [12 + unit * (x - kFrom), ground - unit * z];
  const { x, z } = now.eye;
  // The body stands on the highest point that it touches; the eye follows a little later
  const feet = Math.max(heightAt(x - kHalfWidth), heightAt(x + kHalfWidth));
  const [left, head] = place(x - kHalfWidth, feet + kTall);
  return (
    box(0, ground, width, 26, 'class="fig-earth"') +
    polygon(
      kProfile.map((at) => place(...at)),
      'class="fig-solid seen"',
    ) +
    text(place(5, 0)[0], ground + 18, 'rise 0.5', 'class="soft" text-anchor="middle"') +
    text(place(8.5, 0)[0], ground + 18, 'rise 1', 'class="soft" text-anchor="middle"') +
    box(
      left,
      head,
      2 * kHalfWidth * unit,
      kTall * unit,
      'fill="var(--across)" fill-opacity="0.2" stroke="var(--across)" stroke-width="2"',
    ) +
    line(
      ...place(x, z),
      place(x, z)[0] + 34,
      place(x, z)[1],
      'stroke="var(--ray)" stroke-width="2"',
    ) +
    dot(...place(x, z), 6, 'class="fig-eye"')
  );
}

export default {
  scene: 'ramps.json',
  view: '3,4.5,0.5,0',
  options: { fov: 66 },
  input: ({ way }) => kWays[way].input,
  state: { way: 'walk', time: 90 },
  controls: [
    button({ label: 'Walk up', change: () => begin('walk') }),
    button({ label: 'Stand on the gentle ramp', change: () => begin('stay') }),
    button({ label: 'Stand on the steep ramp', change: () => begin('slide') }),
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
      picture({ title: 'What the walker sees', mark: 'none', handles: [], share: 2 }),
      drawing({
        title: 'From the side',
        share: 3,
        height: (width) => Math.round(Math.min(300, width * 0.25 + 44)),
        label: (now) => `The body from the side, its eye at height ${fixed(now.eye.z)}.`,
        markup: profile,
      }),
    ],
  ],
  numbers: {},
  says(now) {
    const { x, z } = now.eye;
    return `After ${fixed(now.state.time / kSteps)} s the body is at x = ${fixed(x)}, its eye at height ${fixed(z)}.`;
  },
};
