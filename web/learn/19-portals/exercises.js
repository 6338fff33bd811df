const tower = { scene: 'yard.json', view: '2.6,4.6,0.5,268,0', tolerance: 0.05, digits: 1 };

const corridor = {
  scene: 'corridor.json',
  view: '1.2,1.3,0.5,0.5,0',
  tolerance: 0.1,
  unit: 'units',
  digits: 1,
};

const depthsOf = ({ slice }) => slice.objects.map(({ depth }) => depth);

export default {
  beyond: { ...tower, answer: (now) => now.eyes[1].x },
  'beyond-y': { ...tower, answer: (now) => now.eyes[1].y },
  first: { ...corridor, answer: (now) => now.slice.portals[0].depth },
  last: { ...corridor, answer: (now) => now.slice.portals[15].depth },
  apart: {
    scene: 'corridor.json',
    view: '1.2,1.5,0.5,0,0',
    state: { column: 250 },
    answer: (now) => {
      const [first, second] = depthsOf(now);
      return second - first;
    },
    tolerance: 0.01,
    unit: 'units',
    digits: 0,
  },
};
