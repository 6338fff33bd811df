// The answers of this chapter's exercises, asked of the engine.

export default {
  'edge-column': {
    scene: 'yard-1.json',
    view: '7.5,7.5,0.5,270',
    options: { fov: 90 },
    answer: (now) => Math.floor(now.source.project(8, 3, 0.5).x),
  },
  'to-the-west': {
    scene: 'yard-1.json',
    view: '7.5,4.5,0.5,90',
    options: { fov: 90 },
    state: { column: 0 },
    answer: (now) => now.slice.ray[0],
    tolerance: 0.003,
    digits: 3,
  },
  wider: {
    scene: 'yard-1.json',
    view: '7.5,4.5,0.5,90',
    answer: (now) => (2 * Math.atan(now.width / 2 / 480) * 180) / Math.PI,
    tolerance: 0.2,
    unit: 'degrees',
    digits: 2,
  },
};
