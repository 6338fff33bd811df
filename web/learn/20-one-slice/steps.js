// The same slice, step by step: the tiles of its walk, then its runs, with the lines of code that
// make them.

import {
  codeView,
  fixed,
  mapView,
  picture,
  scrub,
  sideView,
  sliceStrip,
  textureView,
} from '../figures/kit.js';
import { kEye, kOptions } from './pixel.js';

const kCode = `for (const tile of walkGrid(...)) {
  // the border between two tiles
  drawBorder(slice, before, tile);
  // what stands in the tile
  drawObject(slice, object);
  // what lies flat in it
  drawPlane(slice, plane, ...);
  if (!slice.open.includes(1)) return;
  before = tile;
}
fillRows(slice, ..., skyColour);`;
const kBorder = [2, 3];
const kObject = [4, 5];
const kPlane = [6, 7];

// The run of the step; before the first one, the run of the picked row.
const runOf = (now) => (now.step?.of === 'run' ? now.slice.runs[now.step.index] : now.run);

export default {
  scene: 'yard.json',
  view: kEye,
  options: kOptions,
  state: { column: 250, row: 170, step: 22 },
  controls: [scrub({ of: 'both' }), scrub({ of: 'frame' })],
  rows: [
    [
      picture({ title: 'The picture, and one slice', handles: ['column'] }),
      codeView({
        title: 'A slice, in short',
        code: kCode,
        lines: {
          start: [1],
          x: [1],
          y: [1],
          side: kBorder,
          object: kObject,
          roof: kPlane,
          underside: kPlane,
          floor: kPlane,
          ceiling: kPlane,
          sky: [11],
          haze: [11],
        },
      }),
    ],
    [mapView({ map: 'hall', title: 'The hall' }), mapView({ map: 'yard', title: 'The yard' })],
    [sideView({ title: 'The slice from the side', share: 2 })],
    [
      sliceStrip({ title: 'Rows filled, in order', names: true }),
      textureView({ title: 'The texture of the run', run: runOf, tallest: 240 }),
    ],
  ],
  numbers: {
    tiles: (now) => String(now.slice.walk.length),
    runs: (now) => String(now.slice.runs.filter(({ layer }) => !layer).length),
    layers: (now) => String(now.slice.runs.filter(({ layer }) => layer).length),
    rows: (now) => String(now.height),
    portalDepth: (now) =>
      now.slice.portals.length > 0 ? fixed(now.slice.portals[0].depth, 3) : '–',
  },
  says: (now) =>
    now.step === null
      ? `The slice is done: ${now.slice.walk.length} tiles, ${now.slice.runs.length} runs.`
      : now.step.of === 'walk'
        ? `Tile ${now.step.index + 1} of ${now.slice.walk.length}; no run is filled yet.`
        : `Run ${now.step.index + 1} of ${now.slice.runs.length}.`,
};
