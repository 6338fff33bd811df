import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard-2.json',
  view: '11.6,2.6,0.8,150,0.2',
  options: { fov: 66, detail: 'off' },
  state: { split: 0.28 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: 130, to: 220, step: 1, unit: '°' })],
  rows: [
    [
      divider({
        left: { title: 'Tile by tile' },
        right: { title: 'Sorted by middles', oldWay: "Painter's order" },
      }),
    ],
  ],
  numbers: {},
  says: () => 'On the right whole things are painted, the one with the farthest middle first.',
};
