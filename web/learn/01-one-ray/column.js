import { compass, fixed, mapView, picture, slider } from '../figures/kit.js';

export default {
  scene: 'yard-1.json',
  view: '1.6,6.7,0.5,345',
  options: { fov: 66 },
  state: { column: 318 },
  controls: [
    slider({ label: 'Column', field: 'column' }),
    slider({ label: 'Turn', eye: 'heading', from: 0, to: 359, step: 1, unit: '°' }),
  ],
  rows: [
    [
      picture({ handles: ['column'] }),
      mapView({ handles: ['eye', 'heading'], lit: false, marks: false, column: true }),
    ],
  ],
  numbers: { column: (now) => String(now.column) },
  says: (now) => {
    const hit = now.slice.hits[0];
    const [x, y] = now.slice.ray;
    const towards = compass((Math.atan2(y, x) * 180) / Math.PI);
    if (hit === undefined) return `Column ${now.column} looks ${towards} and out of the yard.`;
    const name = hit.blueprint === 'letters' ? 'the lettered block' : `a ${hit.blueprint}`;
    return `Column ${now.column} looks ${towards}. Its line ends after ${fixed(hit.rawDepth)} units, at ${name}.`;
  },
};
