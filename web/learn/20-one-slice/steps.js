// The same slice, step by step: the tiles of its walk, then its runs, with the lines of code that
// make them.

import {
  choice,
  codeView,
  fixed,
  mapView,
  numberTable,
  scrub,
  sliceStrip,
  slider,
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

export default {
  scene: 'yard.json',
  view: kEye,
  options: kOptions,
  state: { column: 250, row: 170, step: 20, list: 'runs' },
  controls: [
    scrub({ of: 'both' }),
    slider({ label: 'Slice', field: 'column' }),
    choice({ label: 'List', field: 'list', of: { walk: 'tiles', runs: 'runs' } }),
  ],
  rows: [
    [
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
      sliceStrip({ names: true }),
    ],
    [mapView({ map: 'hall', title: 'The hall' }), mapView({ map: 'yard', title: 'The yard' })],
    [
      numberTable({ of: 'walk', when: ({ list }) => list === 'walk' }),
      numberTable({ of: 'runs', when: ({ list }) => list === 'runs' }),
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
        ? `Tile ${now.step.index + 1} of ${now.slice.walk.length}.`
        : `Run ${now.step.index + 1} of ${now.slice.runs.length}: ${now.step.kind}.`,
};
