import { fixed, mapView, rulers, slider } from '../figures/kit.js';

export default {
  scene: 'yard-1.json',
  view: '13.25,1.625,0.5,180',
  options: { fov: 66 },
  state: { column: 90 },
  controls: [
    slider({ label: 'Turn', eye: 'heading', from: 100, to: 260, step: 1, unit: '°' }),
    slider({ label: 'Column', field: 'column' }),
  ],
  rows: [[mapView({ handles: ['eye', 'heading'], depths: false })], [rulers({ depths: true })]],
  says: (now) => {
    const [x, y] = now.slice.ray;
    const gap = (speed) => (speed === 0 ? 'none' : fixed(1 / Math.abs(speed)));
    return `Gap between blue marks: ${gap(x)}; between red marks: ${gap(y)}.`;
  },
};
