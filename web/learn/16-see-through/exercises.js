import { over } from './blending.js';
import { panesAtEye } from './joined.js';

const kScene = { scene: 'panes.json', options: { fov: 60 } };
const farPane = () => over(40, 128, 200);

export default {
  'far-pane': { ...kScene, view: '1.1,3.5,0.7,0,0', answer: farPane, tolerance: 0.5 },
  'two-panes': {
    ...kScene,
    view: '1.1,3.5,0.7,0,0',
    answer: () => over(240, 64, farPane()),
    tolerance: 0.5,
  },
  'how-many': {
    ...kScene,
    view: '1.1,3.5,0.7,0,0',
    answer() {
      let panes = 0;
      for (let left = 1; left >= 0.1; left *= 153 / 255) panes += 1;
      return panes;
    },
    unit: 'panes',
  },
  'six-panes': {
    ...kScene,
    view: '1.5,4.5,0.5,0,0',
    answer: (now) => panesAtEye(now).length,
    unit: 'panes',
  },
  'two-left': {
    ...kScene,
    view: '1.5,2.5,0.5,0,0',
    answer: (now) => panesAtEye(now).length,
    unit: 'panes',
  },
};
