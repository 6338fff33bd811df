// All four sides of the lettered block with the same fraction.

import { divider, slider } from '../figures/kit.js';

export default {
  scene: 'yard-1.json',
  view: '9.9,5,0.5,134',
  options: { fov: 66, detail: 'off' },
  size: [480, 300],
  state: { around: -47 },
  controls: [
    slider({
      label: 'Walk around the block',
      field: 'around',
      from: -180,
      to: 180,
      step: 1,
      unit: '°',
    }),
  ],
  check({ around }) {
    const angle = (around * Math.PI) / 180;
    const [x, y] = [8.5 + 2.05 * Math.cos(angle), 6.5 + 2.05 * Math.sin(angle)];
    return { eye: { x, y: Math.min(y, 7.9), heading: around + 180 } };
  },
  rows: [
    [
      divider({
        left: { title: 'Exact' },
        right: { title: 'No 1 minus', oldWay: 'Mirrored letters' },
      }),
    ],
  ],
  says(now) {
    const kind =
      (now.pick?.face ?? '') === ''
        ? ''
        : ` The middle of the picture shows its ${now.pick.face} side.`;
    return `You stand ${now.compass(now.state.around)} of the block.${kind}`;
  },
};
