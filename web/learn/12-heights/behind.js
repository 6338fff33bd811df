import { picture, sideView, slider, sliceStrip } from '../figures/kit.js';

export const seenHits = (slice) =>
  new Set(slice.runs.map(({ hit }) => hit).filter((hit) => hit !== null));

export default {
  scene: 'yard-2.json',
  view: '9.4,4.5,0.35,192,0.08',
  options: { fov: 66 },
  state: { column: 240 },
  controls: [
    slider({ label: 'Slice', field: 'column' }),
    slider({ label: 'Eye', eye: 'z', from: 0.1, to: 0.5, step: 0.05, unit: 'units' }),
  ],
  rows: [
    [
      picture({ title: 'The picture, and one slice', handles: ['column'] }),
      sliceStrip({ title: 'The rows of the slice', pick: false }),
    ],
    [sideView({ title: 'The same slice from the side', handles: ['eye'] })],
  ],
  numbers: {
    hits: (now) => String(now.slice.hits.length),
    seen: (now) => String(seenHits(now.slice).size),
  },
  says: ({ slice }) =>
    `The ray passes ${slice.hits.length} blocks, and ${seenHits(slice).size} of them are seen.`,
};
