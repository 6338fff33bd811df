// One block in the air, seen from the west.

const faces = {
  all: 'brick',
  north: { texture: 'brick', light: 0.72 },
  west: { texture: 'brick', light: 0.93 },
  top: 'flagstones',
  bottom: 'beams',
};

export const blockScene = {
  title: 'One block in the air',
  textures: {
    brick: '../../textures/brick.png',
    flagstones: '../../textures/flagstones.png',
    beams: '../../textures/ceiling-beams.png',
    grass: '../../textures/grass.png',
  },
  blueprints: { block: { bottom: 0.5, faces } },
  legend: { '#': 'block' },
  maps: [
    {
      name: 'air',
      levels: [['......', '...#..', '......']],
      floor: { texture: 'grass' },
      sky: { low: '#f1e2c4', high: '#5f9fd4' },
      light: { multiplier: 5, darkest: 0.5 },
      haze: '#f1e2c4',
    },
  ],
  start: { x: 1, y: 1.5, heading: 0 },
};

export const kOpening = { scene: blockScene, view: '1,1.5,1.8,0,-0.35', options: { fov: 66 } };
