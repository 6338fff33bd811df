// A judge: the same view by a program with a fault, and the pixels that give it away.

import { button, choice, divider, fixed } from '../figures/kit.js';
import { byHandWorld, drawWith } from '../by-hand.js';
import { draw as chapter5 } from '../by-hand/chapter-05.js';
import { draw as chapter6 } from '../by-hand/chapter-06.js';
import { draw as chapter7 } from '../by-hand/chapter-07.js';
import { draw as chapter22 } from '../by-hand/chapter-22.js';
import { draw as distance } from '../by-hand/distance-for-depth.js';
import { draw as ties } from '../by-hand/less-or-equal.js';
import { draw as letters } from '../by-hand/mirrored-letters.js';
import { draw as noDetail } from '../by-hand/no-detail.js';
import { differing, drawnBy } from './pictures.js';

const kFov = 66;
const kSame = [24, 22, 30, 255];
const kDiffers = [255, 214, 90, 255];

// Each fault with the program that it was put into.
const kFaults = {
  distance: { name: 'distance for depth', right: chapter5, wrong: distance },
  letters: { name: 'letters mirrored', right: chapter6, wrong: letters },
  detail: { name: 'no levels of detail', right: chapter7, wrong: noDetail },
  ties: { name: '<= for <', right: chapter22, wrong: ties },
};
const kViews = {
  'The yard': { x: 1.6, y: 6.7, heading: 345 },
  'The letters': { x: 6.8, y: 7.6, heading: 300 },
  'The covered walk': { x: 13.5, y: 6.5, heading: 250 },
};

const differenceIn = (now) => {
  const { right, wrong } = kFaults[now.state.fault];
  return differing(drawnBy(right, now, kFov), drawnBy(wrong, now, kFov), now.width);
};
const differenceOf = (now) => now.kept('difference', () => differenceIn(now));
const grouped = (count) => count.toLocaleString('en');
const equalShare = (now) => 100 * (1 - differenceOf(now).pixels / (now.width * now.height));

// The pixels that differ, bright on dark.
function drawDifference(picture, world, eye, state) {
  const { width, height } = picture;
  const source = { drawnWorld: world };
  const { at } = differenceIn({ width, height, source, eye, state });
  at.forEach((differs, pixel) => picture.data.set(differs ? kDiffers : kSame, 4 * pixel));
}

export default {
  world: byHandWorld,
  scene: 'yard-1.json',
  view: '1.6,6.7,0.5,345',
  options: { fov: kFov },
  state: { split: 0.5, fault: 'letters' },
  controls: [
    choice({
      label: 'The fault',
      field: 'fault',
      of: Object.fromEntries(Object.entries(kFaults).map(([key, { name }]) => [key, name])),
    }),
    ...Object.entries(kViews).map(([label, eye]) => button({ label, change: () => ({ eye }) })),
  ],
  rows: [
    [
      divider({
        left: {
          title: 'With the fault',
          draw: (picture, world, eye, state) =>
            drawWith(kFaults[state.fault].wrong, { fov: kFov })(picture, world, eye, state),
        },
        right: { title: 'Pixels that differ', draw: drawDifference },
      }),
    ],
  ],
  numbers: {
    pixels: (now) => grouped(differenceOf(now).pixels),
    equal: (now) => `${fixed(equalShare(now), 2)} %`,
    all: (now) => grouped(now.width * now.height),
  },
  says: (now) =>
    `${grouped(differenceOf(now).pixels)} of ${grouped(now.width * now.height)} pixels differ: ${fixed(equalShare(now), 2)} % are equal.`,
};
