// The answers of this chapter's exercises, by the engine's own walk.

export default {
  'third-border': {
    scene: 'yard-1.json',
    // This heading's cosine is 0.8, its sine -0.6; the middle of 481 columns looks straight ahead.
    view: '2.25,6.5,0.5,323.13010235',
    size: [481, 300],
    state: { column: 240 },
    answer: ({ slice }) => slice.walk[3].depth,
    tolerance: 0.01,
    unit: 'units',
    digits: 4,
  },
  'how-many': {
    scene: 'yard-1.json',
    view: '13.25,1.625,0.5,180',
    options: { fov: 66 },
    state: { column: 90 },
    answer: ({ slice }) =>
      slice.walk.findIndex(({ tile }) => String(tile) === String(slice.hits[0].tile)),
  },
  steepest: {
    scene: 'yard-1.json',
    view: '13.25,1.625,0.5,180',
    options: { fov: 66 },
    state: { column: 90 },
    answer: ({ slice }) => 1 / Math.abs(slice.ray[1]),
    tolerance: 0.02,
    unit: 'units',
    digits: 2,
  },
};
