// Looking up: the horizon moves, and the picture plane slides.

import { picture, sideView } from '../figures/kit.js';

export default {
  scene: 'yard-2.json',
  view: '7.4,7.5,0.5,235,0.2',
  options: { fov: 66 },
  size: [480, 300],
  state: { column: 170 },
  check: ({ eye }) => ({ eye: { look: Math.max(-0.6, Math.min(0.9, eye.look)) } }),
  rows: [
    [
      picture({ handles: ['look', 'column'], mark: 'slice', over: horizon, title: 'The picture' }),
      sideView({ handles: ['look'], title: 'The slice from the side', depth: 6, height: 2.8 }),
    ],
  ],
  numbers: {
    look: (now) => now.fixed(now.eye.look),
    moved: (now) =>
      `${now.fixed(Math.abs(now.eye.look * now.height), 0)} rows ${now.eye.look < 0 ? 'up' : 'down'}`,
    height: (now) => String(now.height),
    horizon: (now) => now.fixed(now.slice.horizonRow, 0),
  },
  says(now) {
    const { look } = now.eye;
    const way = look === 0 ? 'straight ahead' : look > 0 ? 'up' : 'down';
    return `You look ${way}: look is ${now.fixed(look)}, and the horizon is in row ${now.fixed(now.slice.horizonRow, 0)}.`;
  },
};

function horizon(now) {
  const row = now.slice.horizonRow;
  return row < 0 || row > now.height ? '' : now.line(0, row, now.width, row, 'class="fig-horizon"');
}
