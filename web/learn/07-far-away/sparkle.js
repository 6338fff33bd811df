// A walk over cobbles with levels of detail and without them. Few pixels, so that each can be seen.

import { divider, slider } from '../figures/kit.js';

const kScene = {
  title: 'Cobbles',
  textures: {
    cobbles: '../../textures/cobbles.png',
    brick: '../../textures/brick.png',
    sandstone: '../../textures/sandstone.png',
  },
  blueprints: {
    wall: {
      faces: {
        all: 'brick',
        east: { texture: 'brick', light: 0.85 },
        north: { texture: 'brick', light: 0.72 },
      },
    },
    pillar: {
      faces: {
        all: 'sandstone',
        east: { texture: 'sandstone', light: 0.85 },
        north: { texture: 'sandstone', light: 0.72 },
      },
    },
  },
  legend: { '#': 'wall', o: 'pillar' },
  maps: [
    {
      name: 'street',
      levels: [
        Array.from({ length: 10 }, () => [
          '#.........#',
          '#.........#',
          '#o.......o#',
          '#.........#',
        ]).flat(),
      ],
      floor: 'cobbles',
      sky: { low: '#f1e2c4', high: '#5f9fd4' },
      light: { on: false },
      haze: '#f1e2c4',
    },
  ],
  start: { x: 5.5, y: 1.5, heading: 90 },
};

export default {
  scene: kScene,
  view: '5.5,1.5,0.85,90,-0.16',
  options: { fov: 66 },
  size: [280, 140],
  controls: [
    slider({
      label: 'Step forward',
      eye: 'y',
      from: 1.5,
      to: 3.5,
      step: 0.02,
      says: (value, now) => `${now.fixed(value - 1.5)} units`,
    }),
  ],
  rows: [
    [
      divider({
        left: { title: 'A mean' },
        right: { title: 'One texel', options: { detail: 'off' } },
      }),
    ],
  ],
  says: (now) => `You have walked ${now.fixed(now.state.eye.y - 1.5)} units.`,
};
