// A door of the yard: both maps, the eye in each, and the picture.

import { dot, fixed, mapView, picture } from '../figures/kit.js';

const beyondOf = (now) => now.eyes[1] ?? null;

function eyeBeyond(now, at) {
  const beyond = beyondOf(now);
  return beyond === null ? '' : dot(...at(beyond.x, beyond.y), 8, 'class="fig-eye mirrored"');
}

export default {
  scene: 'yard.json',
  view: '7.5,6.4,0.5,86,0',
  options: { fov: 60 },
  size: [480, 300],
  state: { column: 270 },
  controls: [],
  rows: [
    [
      picture({ title: 'The picture', handles: ['column'], share: 4 }),
      mapView({
        title: 'The yard',
        map: 'yard',
        handles: ['eye', 'heading'],
        window: [5, 4, 5, 5],
        share: 3,
      }),
      mapView({
        title: 'The hall, and the eye beyond',
        map: 'hall',
        window: [0, 0, 17, 9],
        depths: false,
        share: 5,
        over: eyeBeyond,
      }),
    ],
  ],
  numbers: {
    x: (now) => fixed(beyondOf(now)?.x ?? now.eye.x),
    y: (now) => fixed(beyondOf(now)?.y ?? now.eye.y),
  },
  says: (now) => {
    const beyond = beyondOf(now);
    if (beyond === null) return 'This slice passes no portal. Choose another column, or turn.';
    return `The eye is at ${fixed(now.eye.x)}, ${fixed(now.eye.y)} in the yard. Beyond the portal it is at ${fixed(beyond.x)}, ${fixed(beyond.y)} in the hall.`;
  },
};
