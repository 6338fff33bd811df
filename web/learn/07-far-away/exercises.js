import { byHandWorld } from '../by-hand.js';

// The least depth at which the engine shows a level on the floor, from its trace, by halving.
const first = (level) => (now) => (2 ** (level - 1) * now.slice.projectionDistance) / 128;

export default {
  'third-level': {
    scene: 'sparkle.json',
    view: '4.5,1.5,0.5,90',
    options: { fov: 66 },
    answer: first(3),
    tolerance: 0.05,
    unit: 'units',
    digits: 2,
  },
  'twice-as-wide': {
    scene: 'sparkle.json',
    view: '4.5,1.5,0.5,90',
    options: { fov: 66 },
    size: [960, 300],
    answer: first(1),
    tolerance: 0.05,
    unit: 'units',
    digits: 2,
  },
  average: {
    scene: 'sparkle.json',
    view: '4.5,1.5,0.5,90',
    world: byHandWorld,
    answer(now) {
      const { levels } = now.source.drawnWorld.maps[now.eye.map].blocks['#'].faces.south.texture;
      const [red, green, blue] = levels.at(-1).texels;
      return `red ${red}, green ${green}, blue ${blue}`;
    },
  },
};
