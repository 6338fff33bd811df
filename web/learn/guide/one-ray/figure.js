// A picture and a map, linked: the column of the one is the ray of the other.

import { fixed, mapView, mount, picture } from '../../learn/figures.js';

// The first block on the ray. `now.slice` is the engine's trace of the column.
const first = (now) => now.slice.hits[0];

const figure = {
  scene: 'scene.json', // beside this file
  view: '1.5,6.4,0.5,325', // x, y, z, heading
  size: [480, 300], // pixels of the picture
  state: { column: 240 }, // how the figure opens
  rows: [[picture(), mapView({ handles: ['eye', 'heading'] })]],
  says: (now) =>
    `Column ${now.column} meets the ${first(now).blueprint} at depth ${fixed(first(now).depth)}.`,
};

mount(document.querySelector('#ray'), figure, {
  name: 'ray', // the parameter in the address that keeps the figure's state
  scenes: new URL('.', import.meta.url), // the folder of the scene
});
