import { divider, fixed, slider } from '../figures/kit.js';

export default {
  scene: 'yard-1.json',
  view: '2.2,6.9,0.5,330',
  options: { fov: 66 },
  state: { split: 0.35, size: 0.3 },
  controls: [
    slider({
      label: 'Step',
      field: 'size',
      from: 0.01,
      to: 1,
      step: 0.01,
      opening: 0.3,
      unit: 'units',
    }),
    slider({ label: 'Turn', eye: 'heading', from: 280, to: 400, step: 1, unit: '°' }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Exact' },
        right: {
          title: (state) => `Steps of ${fixed(state.size)}`,
          options: (state) => ({
            method: 'classic',
            'classic.march': 'on',
            'classic.step': state.size,
          }),
        },
        mark: 'none',
      }),
    ],
  ],
};
