const hall = {
  scene: 'yard.json',
  view: '1.4,4.8,0.5,357,-0.06,hall',
  options: { fov: 60 },
  digits: 0,
};

const blockOf = ({ hits }) => hits.find(({ blueprint }) => blueprint === 'letters');

// The row where the floor shows the top of the lettered block, from the engine's numbers.
function reflectedRow({ slice, eye }) {
  const { depth, top } = blockOf(slice);
  return slice.horizonRow + (slice.projectionDistance * (top + eye.z)) / depth;
}

export default {
  meet: {
    scene: 'yard-7.json',
    view: '5.5,7.6,0.5,325,0',
    answer: () => (4 * 0.5) / (0.5 + 1),
    tolerance: 0.02,
    unit: 'units',
    digits: 2,
  },
  row: { ...hall, answer: reflectedRow, tolerance: 2 },
  'row-top': { ...hall, answer: ({ slice }) => blockOf(slice).topFrontRow },
  'row-horizon': { ...hall, answer: ({ slice }) => slice.horizonRow },
  'row-above': { ...hall, answer: ({ slice }) => slice.horizonRow - blockOf(slice).topFrontRow },
  lost: {
    scene: 'slab.json',
    view: '3,4,1.8,2,-0.5',
    answer: () => 'The underside of a bridge',
  },
};
