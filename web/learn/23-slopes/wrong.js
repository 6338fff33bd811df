// Three mistakes with the horizon of a slope.

import { choice, divider, slider } from '../figures/kit.js';
import { byHandWorld } from '../by-hand.js';
import { drawRamps, rampsOf } from './by-hand.js';
import { kFov } from './plane.js';

export const kMistakes = {
  middle: 'one horizon for all columns',
  flat: 'texture by the true horizon',
  sign: 'the sign of P',
};

export default {
  scene: 'ramps.json',
  view: '2.4,6.4,0.8,320',
  options: { fov: kFov, detail: 'off' },
  size: [320, 200],
  world: async (source) => rampsOf(await byHandWorld(source), source.scene),
  state: { split: 0.3, mistake: 'middle' },
  controls: [
    choice({ label: 'Mistake', field: 'mistake', of: kMistakes }),
    slider({ label: 'Turn', eye: 'heading', from: -180, to: 180, step: 1, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Right', draw: (...given) => drawRamps(...given.slice(0, 3)) },
        right: {
          title: ({ mistake }) => kMistakes[mistake],
          draw: (picture, world, eye, { mistake }) => drawRamps(picture, world, eye, mistake),
        },
      }),
    ],
  ],
  numbers: {},
};
