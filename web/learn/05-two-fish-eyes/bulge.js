import { choice, divider, slider } from '../figures/kit.js';

const kNames = {
  equalAngles: 'Distance, equal angles',
  equalAnglesCorrected: 'Distance × cosine, equal angles',
};

export default {
  scene: 'long-wall.json',
  view: '20.5,3.2,0.5,270',
  options: (state) => ({ fov: state.fov }),
  state: { split: 0.5 },
  controls: [
    choice({ label: 'On the right', field: 'way', of: kNames }),
    slider({ label: 'Turn', eye: 'heading', from: 230, to: 310, step: 1, unit: '°' }),
    slider({
      label: 'Field of view',
      option: 'fov',
      from: 50,
      to: 120,
      step: 1,
      unit: '°',
      opening: 100,
    }),
  ],
  rows: [
    [
      divider({
        left: { title: 'Depth, flat pane' },
        right: {
          title: (state) => kNames[state.way],
          options: (state) => ({ method: 'classic', 'classic.projection': state.way }),
        },
        mark: 'none',
      }),
    ],
  ],
};
