// Two pictures of one eye with a divider: the engine's, and an old way of drawing.

import { choice, divider, mount, slider } from '../../learn/figures.js';

// The engine's names for old ways; see `oldWays` of <ray-caster>.
const ways = ['Fish eye', 'Half a fish eye', 'Big pixels'];

const figure = {
  scene: 'scene.json',
  view: '10,2.6,0.5,270',
  options: { fov: 90 }, // of the engine
  size: [480, 300],
  state: { old: ways[0] }, // a field of our own, which the choice below changes
  controls: [
    choice({ label: 'Old way', field: 'old', oldWays: ways }),
    slider({ label: 'Turn', eye: 'heading', from: 180, to: 360, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Exact' },
        right: { title: (state) => state.old, oldWay: (state) => state.old },
      }),
    ],
  ],
};

mount(document.querySelector('#ways'), figure, {
  name: 'ways',
  scenes: new URL('.', import.meta.url),
});
