// A corridor whose end leads to its beginning.

import { fixed, mapView, picture } from '../figures/kit.js';

export default {
  scene: 'corridor.json',
  view: '1.2,1.3,0.5,0.5,0',
  options: { fov: 60 },
  size: [480, 300],
  state: { column: 240 },
  controls: [],
  rows: [
    [
      picture({ title: 'The picture', handles: ['column'] }),
      mapView({
        title: 'The corridor',
        handles: ['eye', 'heading'],
        depths: false,
        order: false,
        marks: false,
      }),
    ],
  ],
  numbers: {
    limit: (now) => String(now.source.scene.portalLimit),
    portals: (now) => String(now.slice.portals.length),
  },
  says: ({ slice }) => {
    const { portals } = slice;
    if (portals.length === 0) return 'This slice passes no portal.';
    const last = portals.at(-1);
    const many = portals.length === 1 ? 'one portal' : `${portals.length} portals`;
    return `This slice passes ${many}, the last one at depth ${fixed(last.depth, 1)}.`;
  },
};
