// The patch of wall behind one pixel: how many texels it covers.

import { byHandWorld } from '../by-hand.js';
import {
  box,
  distanceOf,
  dot,
  drawing,
  fixed,
  hex,
  knob,
  line,
  path,
  polygon,
  text,
} from '../figures/kit.js';
import { imageAddress, meanOf, texelAt, textureOf } from './bitmap.js';
import { levelAt } from './detail.js';

const kTexels = 24; // shown across
const kFar = 32; // units
const kCorner = [58, 22]; // the texel in the upper left corner of the part that is shown

let kept = null;

function part(now) {
  const level = textureOf(now, '#').levels[0];
  if (kept?.level !== level) {
    const texels = new Uint8Array(4 * kTexels * kTexels);
    for (let row = 0; row < kTexels; ++row)
      for (let column = 0; column < kTexels; ++column)
        texels.set(
          texelAt(level, kCorner[0] + column, kCorner[1] + row),
          4 * (row * kTexels + column),
        );
    kept = { level, shown: { width: kTexels, height: kTexels, texels } };
  }
  return kept;
}

const distance = (now) => distanceOf(66, now.width);
const side = (now) => (now.state.depth * 128) / distance(now);
const levelOf = (now) => levelAt(now.state.depth, 128, distance(now), 7);
const kAim = [12.35, 10.4]; // where the middle of the pixel hits, in texels of the part

const plan = drawing({
  title: 'From above',
  label: (now) =>
    `One pixel seen from above: its rays spread until they meet the wall at depth ${fixed(now.state.depth, 1)}.`,
  height: () => 300,
  markup(now, { width, height }) {
    const middle = height / 2 - 10;
    const place = (depth) => 30 + ((width - 60) * depth) / kFar;
    const wall = place(now.state.depth);
    // A pixel is drawn much too wide, or its rays could not be told apart.
    const spread = (x) => ((x - 30) * 0.19) / 2;
    const plane = 30 + 42;
    return (
      polygon(
        [
          [30, middle],
          [wall, middle - spread(wall)],
          [wall, middle + spread(wall)],
        ],
        'class="fig-wedge side"',
      ) +
      line(30, middle, wall, middle - spread(wall), 'class="fig-sight"') +
      line(30, middle, wall, middle + spread(wall), 'class="fig-sight"') +
      line(plane, middle - 70, plane, middle + 70, 'class="fig-axis"') +
      line(plane, middle - spread(plane), plane, middle + spread(plane), 'class="fig-bold"') +
      text(plane, middle + 88, 'one pixel', 'text-anchor="middle"') +
      box(wall, 20, 9, height - 60, 'class="fig-solid seen"') +
      line(wall, middle - spread(wall), wall, middle + spread(wall), 'class="fig-bold"') +
      dot(30, middle, 8, 'class="fig-eye"') +
      line(30, height - 32, width - 20, height - 32, 'class="fig-measure"') +
      [0, 8, 16, 24, 32]
        .map(
          (depth) =>
            line(place(depth), height - 32, place(depth), height - 27, 'class="fig-measure"') +
            text(place(depth), height - 12, String(depth), 'class="soft" text-anchor="middle"'),
        )
        .join('') +
      text(width - 4, height - 40, 'depth, units', 'class="soft" text-anchor="end"') +
      knob(wall, height - 32, 'ray')
    );
  },
  handles(now, { width, height }) {
    const depthAt = (x) =>
      Math.round(Math.max(0.5, Math.min(kFar, ((x - 30) * kFar) / (width - 60))) * 10) / 10;
    return [
      {
        id: 'depth',
        label: 'Depth of the wall',
        axis: 'x',
        x: 30 + ((width - 60) * now.state.depth) / kFar,
        y: height - 32,
        value: now.state.depth,
        least: 0.5,
        greatest: kFar,
        says: `${fixed(now.state.depth, 1)} units`,
        drag: ({ x }) => ({ depth: depthAt(x) }),
        keys: (right, down) => ({
          depth: Math.max(
            0.5,
            Math.min(kFar, Math.round(10 * now.state.depth + (right || -down)) / 10),
          ),
        }),
      },
    ];
  },
});

const patch = drawing({
  title: 'The bricks, and what the pixel covers',
  label: (now) =>
    `A part of the texture with a square of ${fixed(side(now), 1)} texels a side, which one pixel covers.`,
  height: (width) => Math.min(width, 300) + 44,
  markup(now, { width }) {
    const { level, shown } = part(now);
    const tall = Math.min(width, 300);
    const unit = tall / kTexels;
    const left = (width - tall) / 2;
    const reach = side(now);
    const [x, y] = [left + unit * (kAim[0] - reach / 2), unit * (kAim[1] - reach / 2)];
    const [column, row] = kAim.map(Math.floor);
    const one = texelAt(shown, column, row);
    const mean = meanOf(
      level,
      kCorner[0] + kAim[0] - reach / 2,
      kCorner[1] + kAim[1] - reach / 2,
      reach,
    );
    let grid = '';
    for (let index = 0; index <= kTexels; ++index)
      grid += `M${(left + unit * index).toFixed(2)} 0V${tall}M${left} ${(unit * index).toFixed(2)}H${left + tall}`;
    const swatches = [
      ['That texel', one, left],
      ['The mean of all', mean, left + tall / 2],
    ];
    return (
      `<image href="${imageAddress(shown)}" x="${left}" y="0" width="${tall}" height="${tall}" preserveAspectRatio="none" class="fig-texture"/>` +
      path(grid, 'class="fig-texel-grid"') +
      box(x, y, unit * reach, unit * reach, 'class="fig-pixel edge"') +
      box(x, y, unit * reach, unit * reach, 'class="fig-pixel"') +
      dot(left + unit * kAim[0], unit * kAim[1], 3.5, 'class="fig-edge-dot"') +
      swatches
        .map(
          ([name, colour, from]) =>
            box(from, tall + 14, 24, 24, `class="fig-outline" fill="${hex(colour)}"`) +
            text(from + 31, tall + 31, name),
        )
        .join('')
    );
  },
});

export default {
  scene: 'sparkle.json',
  view: '4.5,1.5,0.5,90',
  options: { fov: 66 },
  world: byHandWorld,
  state: { depth: 14 },
  rows: [[plan, patch]],
  numbers: {
    depth: (now) => fixed(now.state.depth, 1),
    texels: (now) => fixed(side(now), 1),
    area: (now) =>
      side(now) < 1 ? 'less than one' : String(Math.max(1, Math.round(side(now) ** 2))),
    level: (now) => String(levelOf(now)),
    wide: (now) => String(2 ** levelOf(now)),
  },
  says: (now) =>
    `At depth ${fixed(now.state.depth, 1)} one pixel is ${fixed(side(now), 2)} texels wide${side(now) > 1 ? `, and covers ${fixed(side(now) ** 2, 1)} of them` : ': less than one'}.`,
};
