// One slice through a block of glass: which runs close rows, and which are layers.

import { picture, scrub, sideView, sliceStrip } from '../figures/kit.js';

const layersOf = (now) => now.slice.runs.filter(({ layer }) => layer);
const opaqueOf = (now) => now.slice.runs.filter(({ layer }) => !layer);

function says(now) {
  const shown = now.runs.filter(({ layer }) => layer).length;
  const atRow = layersOf(now).filter(({ first, last }) => first <= now.row && now.row <= last);
  const panes = ['no pane', 'one pane', 'two panes', 'three panes', 'four panes'];
  const through = panes[atRow.length] ?? `${atRow.length} panes`;
  const far = now.state.step === null ? '' : ` So far ${shown} layers are on the list.`;
  return `In row ${now.row} you look through ${through}.${far}`;
}

export default {
  scene: 'yard-5.json',
  view: '10.6,2.5,1.5,250,0',
  options: { fov: 60 },
  size: [480, 300],
  state: { column: 200, row: 140 },
  controls: [scrub({ of: 'runs' })],
  rows: [
    [picture({ handles: ['column', 'row'] }), sliceStrip({ names: true, pick: true })],
    [sideView({ runs: true, depth: 4, height: 2.4 })],
  ],
  numbers: {
    opaque: (now) => String(opaqueOf(now).length),
    layers: (now) => String(layersOf(now).length),
  },
  says,
};
