// The hall from the eye and from the mirrored eye.

import { fixed, picture, sideView, sliceStrip } from '../figures/kit.js';

export default {
  scene: 'yard.json',
  view: '1.4,4.8,0.5,357,-0.06,hall',
  options: { fov: 60, mirrors: 2 },
  size: [480, 300],
  state: { column: 240, row: 220 },
  controls: [],
  rows: [
    [picture({ handles: ['column', 'row'], share: 3 }), sliceStrip({ pick: true, share: 2 })],
    [sideView({ mirror: true, handles: ['eye'], depth: 8, height: 2.2 })],
  ],
  numbers: {},
  says: (now) =>
    `The eye is ${fixed(now.eye.z)} units above the floor, the mirrored eye ${fixed(now.eye.z)} below it.`,
};
