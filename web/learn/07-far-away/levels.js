// All sizes of one texture, and the one that a depth shows.

import { byHandWorld } from '../by-hand.js';
import { box, distanceOf, drawing, fixed, slider, text } from '../figures/kit.js';
import { imageAddress, textureOf } from './bitmap.js';
import { levelAt } from './detail.js';

const kScene = { fov: 66 };

const chosen = (now) => levelAt(now.state.depth, 128, distanceOf(kScene.fov, now.width), 7);

// The images side by side, each drawn as large as fits: texels become squares.
const family = drawing({
  title: 'Each texel is the mean of four texels of the image before',
  label: (now) =>
    `The texture in eight sizes, from 128 texels a side to one. Level ${chosen(now)} is marked.`,
  height: (width) => Math.ceil(8 / perRow(width)) * (sideOf(width) + 50),
  markup(now, { width }) {
    const levels = textureOf(now, 'L').levels;
    const side = sideOf(width);
    const across = perRow(width);
    const gap = (width - across * side) / across;
    return levels
      .map((level, index) => {
        const x = gap / 2 + (index % across) * (side + gap);
        const y = 6 + Math.floor(index / across) * (side + 50);
        const isChosen = index === chosen(now);
        return (
          `<image href="${imageAddress(level)}" x="${x}" y="${y}" width="${side}" height="${side}" class="fig-texture"/>` +
          box(x, y, side, side, `class="fig-outline${isChosen ? ' now' : ''}"`) +
          text(
            x + side / 2,
            y + side + 18,
            `level ${index}`,
            `text-anchor="middle"${isChosen ? ' class="strong"' : ''}`,
          ) +
          text(
            x + side / 2,
            y + side + 35,
            `${level.width} × ${level.height}`,
            'class="soft" text-anchor="middle"',
          )
        );
      })
      .join('');
  },
});

const perRow = (width) => (width < 640 ? 4 : 8);
const sideOf = (width) => Math.floor(Math.min(128, width / perRow(width) - 10));

export default {
  scene: 'sparkle.json',
  view: '4.5,1.5,0.5,90',
  options: kScene,
  world: byHandWorld,
  state: { depth: 14 },
  controls: [
    slider({
      label: 'Depth of the wall',
      field: 'depth',
      from: 0.5,
      to: 200,
      step: 0.5,
      unit: 'units',
    }),
  ],
  rows: [[family]],
  numbers: {
    all: () => String([0, 1, 2, 3, 4, 5, 6, 7].reduce((sum, level) => sum + 4 ** level, 0)),
    more: () =>
      fixed((100 * [0, 1, 2, 3, 4, 5, 6].reduce((sum, level) => sum + 4 ** level, 0)) / 4 ** 7, 1),
  },
  says: (now) =>
    `At depth ${fixed(now.state.depth, 1)} a pixel is ${fixed((now.state.depth * 128) / distanceOf(kScene.fov, now.width), 1)} texels wide: level ${chosen(now)}, whose texels are ${2 ** chosen(now)} wide.`,
};
