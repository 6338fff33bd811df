// The answers of this chapter's exercises.

const place = { scene: 'yard-1.json', view: '2.2,6.9,0.5,330', options: { fov: 66 } };

export default {
  'largest-step': {
    ...place,
    state: { column: 347 },
    answer: ({ slice }) => slice.hits[0].backDepth - slice.hits[0].depth,
    tolerance: 0.006,
    unit: 'units',
    digits: 2,
  },
  enter: {
    ...place,
    state: { column: 347 },
    answer: ({ slice }) => slice.hits[0].depth,
    digits: 3,
  },
  leave: {
    ...place,
    state: { column: 347 },
    answer: ({ slice }) => slice.hits[0].backDepth,
    digits: 3,
  },
  middle: {
    ...place,
    state: { column: 240 },
    answer: ({ slice }) => slice.hits[0].depth,
    digits: 3,
  },
  'at-least': { ...place, answer: () => 4.8 - 0.3, tolerance: 0.001, unit: 'units', digits: 1 },
  looks: {
    ...place,
    state: { column: 240 },
    answer: ({ slice }) => Math.ceil(slice.hits[0].depth / 0.01) + 1,
    tolerance: 1,
  },
};
