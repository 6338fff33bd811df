const kStart = {
  scene: 'yard-2.json',
  view: '7.4,7.5,0.5,215',
  options: { fov: 66 },
  size: [480, 300],
};
const towerRow = (now) => now.source.project(3, 6, 2.5).y;

export default {
  'horizon-row': {
    ...kStart,
    view: '7.4,7.5,0.5,235,-0.1',
    answer: (now) => now.slice.horizonRow,
    tolerance: 0.5,
  },
  'tower-row': { ...kStart, answer: towerRow, digits: 1 },
  tower: { ...kStart, answer: (now) => -towerRow(now) / now.height, tolerance: 0.01, digits: 3 },
  steepest: {
    ...kStart,
    answer: (now) => (now.slice.horizonRow - 0.5) / now.slice.projectionDistance,
    tolerance: 0.01,
    digits: 3,
  },
};
