// More nodes, fewer nodes, and none: a ray for each pixel, with and without lift.

import { byHandWorld } from '../by-hand.js';
import { choice, divider, slider } from '../figures/kit.js';
import { byNodes, bySunRays, drawWorld, litWorld } from './tracer.js';

const kFov = 66;
const kLift = 16 / 65536;
const kWays = {
  tile: 'nodes at tiles',
  quarter: 'nodes at quarters',
  pixel: 'a ray for each pixel',
  flat: 'the same, no lift',
};

const litBy = (world, way) =>
  way === 'pixel' || way === 'flat'
    ? bySunRays(world.lightOf(), way === 'pixel' ? kLift : 0)
    : byNodes(world.lightOf({ squares: way === 'tile' ? 1 : 4 }), world.map);

export default {
  scene: 'sunlit.json',
  view: '10.8,7.8,1.2,225,-0.1',
  options: { fov: kFov, light: 'off', detail: 'off' },
  size: [320, 200],
  world: async (source) => litWorld(await byHandWorld(source), source.scene),
  state: { split: 0.35, way: 'flat' },
  controls: [
    choice({ label: 'Right', field: 'way', of: kWays }),
    slider({ label: 'Turn', eye: 'heading', from: 90, to: 320, step: 1, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Nodes at half units' },
        right: {
          title: ({ way }) => kWays[way],
          draw: (picture, world, eye, { way }) =>
            drawWorld(picture, world, eye, kFov, litBy(world, way)),
        },
      }),
    ],
  ],
  numbers: {},
};
