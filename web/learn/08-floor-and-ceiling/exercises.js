const kWest = {
  scene: 'yard-1.json',
  view: '13.5,6.5,0.5,180',
  options: { fov: 66 },
  size: [480, 300],
};

export default {
  'edge-row': {
    ...kWest,
    answer: (now) => now.source.project(10, 6.5, 0).y,
    tolerance: 1,
    unit: '',
    digits: 2,
  },
  'row-depth': {
    ...kWest,
    answer: (now) =>
      now.slice.runs.find(({ what }) => what === 'floor').texels.find(({ row }) => row === 299)
        .depth,
    tolerance: 0.01,
    unit: 'units',
    digits: 3,
  },
  'half-floor': {
    ...kWest,
    answer: (now) => (now.slice.projectionDistance * now.eye.z) / (now.height / 4),
    tolerance: 0.02,
    unit: 'units',
    digits: 2,
  },
};
