const kOptions = { fov: 66 };
const kWalk = { scene: 'yard-3.json', view: '8.2,4.4,0.45,186,0.22', options: kOptions };
const hitOf = ({ slice }, name) => slice.hits.find(({ blueprint }) => blueprint === name);

// A gate of five cells in the lawn, and the eye before it.
const kGate = [
  ['yard', 0, 6, 6, 'o'],
  ['yard', 0, 8, 6, 'o'],
  ['yard', 0, 7, 6, '.'],
  ['yard', 1, 6, 6, 'h'],
  ['yard', 1, 7, 6, 'h'],
  ['yard', 1, 8, 6, 'h'],
];

export default {
  under: {
    ...kWalk,
    state: { column: 210 },
    answer({ slice: { runs } }) {
      const under = runs.find(({ what }) => what === 'underside');
      const gap = runs.find(({ what, first }) => what === 'sky' && first === under.last + 1);
      return gap.last + 1 - gap.first;
    },
    tolerance: 1,
  },
  arch: {
    scene: 'yard-3.json',
    view: '7.5,7.7,0.5,270',
    options: kOptions,
    state: { edits: kGate, column: 240 },
    answer({ slice, state }) {
      const [first] = slice.hits;
      if (first.level !== 1 || first.bottom !== 1) throw new Error('the gate is not open');
      return state.edits.filter(([, , , , sign]) => sign !== '.').length;
    },
  },
  bridge: {
    ...kWalk,
    state: { column: 255 },
    answer: (now) => hitOf(now, 'bridge').depth,
    digits: 2,
  },
  depths: {
    ...kWalk,
    state: { column: 255 },
    answer: (now) => hitOf(now, 'corbel').depth,
    tolerance: 0.01,
    digits: 2,
  },
};
