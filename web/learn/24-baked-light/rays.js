// A sample of the floor, and the rays that it sends out.

import {
  box,
  clamp,
  dot,
  drawing,
  fixed,
  hex,
  knob,
  line,
  panel,
  picture,
  swatch,
} from '../figures/kit.js';
import { boxesOf, held, kUnit, Light } from './light.js';

const kLift = 16 / kUnit;
const kReach = 3; // units that rays to the sky are long

export const lightOf = (now, options = {}) =>
  now.kept(`light ${JSON.stringify(options)}`, () => {
    const [map] = now.source.scene.maps;
    const { width, depth } = now.map(map.name);
    return new Light(boxesOf(now.source.scene), map.baked, { ...options, width, depth });
  });

// The sample: where it is, and its light.
export function sampleOf(now) {
  return now.kept('sample', () => {
    const [x, y] = now.state.at;
    const light = lightOf(now);
    const point = [x, y, kLift].map((value) => Math.floor(value * kUnit));
    const face = { box: null, x: Math.floor(x), y: Math.floor(y) };
    const isInside = light.isInside(point);
    return { point, isInside, parts: light.sample(point, light.areaOf(face), 0) };
  });
}

// The drawing shows the court, and half a unit of the walls round it.
const kFrom = 0.5;
const kTiles = [11, 8];
const unitOf = ({ width }) => width / kTiles[0];

const kSun = 'stroke="var(--ray)" stroke-width="4"';
const kSky = 'stroke="var(--across)" stroke-width="2"';
const kLamp = 'stroke="var(--ink)" stroke-width="3"';
const kBlocked = 'stroke="var(--soft)" stroke-width="1.5" stroke-dasharray="4 4"';

function plan(now, size) {
  const unit = unitOf(size);
  const { parts } = sampleOf(now);
  const place = (x, y) => [unit * (x - kFrom), unit * (y - kFrom)];
  const boxes = boxesOf(now.source.scene).map(({ low, high, cell }) => {
    const [left, top] = place(low[0] / kUnit, low[1] / kUnit);
    const [right, bottom] = place(high[0] / kUnit, high[1] / kUnit);
    const look =
      cell[2] > 0
        ? 'fill="none" stroke="var(--soft)" stroke-dasharray="3 4"'
        : 'fill="var(--block)" stroke="var(--soft)"';
    return box(left, top, right - left, bottom - top, look);
  });
  const [x, y] = now.state.at;
  const ray = ({ way, meets }, kind, length) => {
    const share = Math.min(meets, length);
    const end = place(x + (way[0] / kUnit) * share, y + (way[1] / kUnit) * share);
    const isFree = meets === Infinity;
    return (
      line(...place(x, y), ...end, isFree ? kind : kBlocked) +
      (isFree ? '' : dot(...end, 4, 'class="fig-edge-dot"'))
    );
  };
  return (
    box(0, 0, size.width, size.height, 'class="fig-ground"') +
    boxes.join('') +
    parts.sky.rays.map((each) => ray(each, kSky, 1)).join('') +
    parts.lamps.map((each) => (each.isNear ? ray(each, kLamp, 1) : '')).join('') +
    ray(parts.sun, kSun, 12) +
    knob(...place(x, y), 'eye')
  );
}

function handles(now, size) {
  const unit = unitOf(size);
  const { width, depth } = now.map(now.eye.map);
  const [x, y] = now.state.at;
  const even = (value, most) => clamp(Math.round(value * 16) / 16, 1.0625, most - 1.0625);
  return [
    {
      id: 'sample',
      label: 'Sample',
      x: unit * (x - kFrom),
      y: unit * (y - kFrom),
      value: x,
      least: 1,
      greatest: width - 1,
      unit: 0.0625,
      says: `${fixed(x)}, ${fixed(y)}`,
      drag: (point) => ({
        at: [even(kFrom + point.x / unit, width), even(kFrom + point.y / unit, depth)],
      }),
      keys: (right, down) => {
        const [atX, atY] = now.state.at;
        return { at: [even(atX + right / 16, width), even(atY + down / 16, depth)] };
      },
    },
  ];
}

const colour = (channels) => hex(held(channels));
const written = (channels) => channels.join(', ');

function sum(now) {
  const { parts, isInside } = sampleOf(now);
  if (isInside) return '<p>This point is inside a block: its sample does not count.</p>';
  const { sun, sky, lamps } = parts;
  const rows = [
    ['Sun', sun.meets === Infinity ? `free, ${sun.n} of 256` : 'blocked', sun.light],
    ['Sky', `${sky.free} of 8 rays free`, sky.light],
    ...lamps.map(({ isNear, meets, light }) => [
      'Lamp',
      !isNear ? 'too far away' : meets === Infinity ? 'free' : 'blocked',
      light,
    ]),
    ['Sum', '', parts.sum],
  ];
  return (
    '<table class="fig-table"><thead><tr><th>from</th><th>rays</th><th>red, green, blue</th></tr></thead><tbody>' +
    rows
      .map(
        ([name, says, light]) =>
          `<tr><td>${name}</td><td>${says}</td><td class="number">${swatch(colour(light))} ${written(light)}</td></tr>`,
      )
      .join('') +
    '</tbody></table>'
  );
}

const spot = (now) => {
  const [x, y] = now.state.at;
  const at = now.source.project(x, y, 0);
  if (at === null) return '';
  return (
    dot(at.x, at.y, 7, 'fill="none" stroke="var(--ink)" stroke-width="4"') +
    dot(at.x, at.y, 7, 'fill="none" stroke="var(--lit)" stroke-width="2.5"')
  );
};

export default {
  scene: 'sunlit.json',
  view: '11.2,11.2,4.6,245,-0.42',
  options: { fov: 66, light: 'off' },
  size: [400, 300],
  state: { at: [8.1875, 6.25] },
  rows: [
    [
      picture({ handles: [], mark: 'none', over: spot, share: 1, title: 'The court' }),
      drawing({
        title: 'The sample and its rays, from above',
        share: 1,
        label: (now) => {
          const { sun, sky } = sampleOf(now).parts;
          return `From above: the ray to the sun is ${sun.meets === Infinity ? 'free' : 'blocked'}, and so many of the eight to the sky are free: ${sky.free}.`;
        },
        height: (width) => Math.round((width * kTiles[1]) / kTiles[0]),
        markup: plan,
        handles,
      }),
    ],
    [panel({ title: 'What the sample adds up', markup: sum })],
  ],
  numbers: {
    n: (now) => String(sampleOf(now).parts.sun.n),
    free: (now) => String(sampleOf(now).parts.sky.free),
    reach: () => String(kReach),
    sun: (now) => (sampleOf(now).parts.sun.meets === Infinity ? 'free' : 'blocked'),
    red: (now) => String(sampleOf(now).parts.sum[0]),
  },
  says(now) {
    const { parts, isInside } = sampleOf(now);
    if (isInside) return 'The sample lies inside a block, so it does not count.';
    return `The sun is ${parts.sun.meets === Infinity ? 'free' : 'hidden'}, and of the rays to the sky ${parts.sky.free} of 8 are free.`;
  },
};
