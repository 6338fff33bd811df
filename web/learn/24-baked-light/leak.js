// Without links, light leaks below a thin wall.

import { byHandWorld } from '../by-hand.js';
import { divider, slider } from '../figures/kit.js';
import { byNodes, drawWorld, litWorld } from './tracer.js';

const kFov = 66;

export default {
  scene: 'sunlit.json',
  view: '5.4,4.4,0.6,160,-0.25',
  options: { fov: kFov, light: 'off', detail: 'off' },
  size: [320, 200],
  world: async (source) => litWorld(await byHandWorld(source), source.scene),
  state: { split: 0.3 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: 90, to: 270, step: 1, unit: '°' })],
  rows: [
    [
      divider({
        left: { title: 'Linked' },
        right: {
          title: 'Not linked',
          draw: (picture, world, eye) =>
            drawWorld(
              picture,
              world,
              eye,
              kFov,
              byNodes(world.lightOf({ linked: false }), world.map),
            ),
        },
      }),
    ],
  ],
  numbers: {},
};
