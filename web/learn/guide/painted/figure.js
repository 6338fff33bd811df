// A map that the reader paints, with the slice from the side and as a strip of rows.

import { mapView, mount, picture, scrub, sideView, sliceStrip } from '../../learn/figures.js';

const figure = {
  scene: 'scene.json',
  view: '1.5,4.5,0.8,0',
  size: [480, 300],
  state: { column: 240 },
  // Goes through the rows in the order in which the engine fills them.
  controls: [scrub({ of: 'runs' })],
  rows: [
    [picture(), mapView({ paint: true, level: 0, blocks: ['#', 'o', 'b', '.'] })],
    [sideView({ depth: 8 }), sliceStrip({ names: true })],
  ],
  says: (now) =>
    `This slice meets ${now.slice.hits.length} blocks and fills ${now.slice.runs.length} runs of rows.`,
};

mount(document.querySelector('#map'), figure, {
  name: 'map',
  scenes: new URL('.', import.meta.url),
});
