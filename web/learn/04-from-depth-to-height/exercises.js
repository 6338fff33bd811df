// The answers of this chapter's exercises, of one column of the engine's picture.

const column = {
  scene: 'long-wall.json',
  view: '20.5,5.2,0.32,270',
  options: { fov: 66 },
  state: { column: 240 },
};

export default {
  'top-row': { ...column, answer: ({ slice }) => slice.hits[0].topFrontRow, digits: 1 },
  'bottom-row': { ...column, answer: ({ slice }) => slice.hits[0].bottomFrontRow, digits: 1 },
  'eye-height': {
    ...column,
    answer: ({ slice: { eye } }) => eye.z,
    tolerance: 0.006,
    unit: 'units',
    digits: 2,
  },
  'how-far': {
    ...column,
    answer: ({ slice }) => slice.hits[0].depth,
    tolerance: 0.02,
    unit: 'units',
    digits: 2,
  },
  'fills-picture': {
    ...column,
    answer: ({ slice, height }) => slice.projectionDistance / height,
    tolerance: 0.01,
    unit: 'units',
    digits: 2,
  },
};
