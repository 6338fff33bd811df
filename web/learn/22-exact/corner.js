// The eye at a corner: two borders at one depth, and the rule that says which comes first.

import { button, fixed, mapView, numberTable, picture, rulers, slider } from '../figures/kit.js';
import { tiesIn } from './ties.js';

const kDirections = { 'south-east': 45, 'south-west': 135, 'north-west': 225, 'north-east': 315 };

const first = (now) => tiesIn(now.slice)[0];

export default {
  scene: 'corner.json',
  view: '5,5,0.5,45',
  size: [481, 300],
  state: { column: 240 },
  controls: [
    ...Object.entries(kDirections).map(([name, heading]) =>
      button({
        label: `Look ${name}`,
        change: () => ({ eye: { x: 5, y: 5, heading }, column: 240 }),
      }),
    ),
    slider({ label: 'Turn', eye: 'heading', from: 0, to: 359, step: 1, unit: '°' }),
    slider({ label: 'Slice', field: 'column' }),
  ],
  rows: [
    [
      picture({ mark: 'slice', handles: ['column'] }),
      mapView({ handles: ['eye', 'heading'], order: true, fov: false }),
    ],
    [rulers({ depths: true })],
    [numberTable({ of: 'walk' })],
  ],
  numbers: {
    ties: (now) => String(tiesIn(now.slice).length),
    depth: (now) => (first(now) ? fixed(first(now).depth, 4) : '–'),
    axis: (now) => first(now)?.axis ?? '–',
    block: (now) => now.slice.hits[0]?.blueprint ?? '–',
    tile: (now) => now.slice.hits[0]?.tile.join(', ') ?? '–',
  },
  says(now) {
    const ties = tiesIn(now.slice);
    if (ties.length === 0) return 'No two borders are at the same depth.';
    return `The ray meets ${ties.length === 1 ? 'one corner' : `${ties.length} corners`} exactly. Each time it crosses the ${ties[0].axis} border first.`;
  },
};
