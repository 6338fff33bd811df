const kYard = { scene: 'yard-2.json', options: { fov: 66 }, input: { forward: 1 } };

export default {
  stop: {
    ...kYard,
    view: '8.6,3.5,0.5,0',
    state: { time: 240 },
    answer: (now) => Number(now.eye.x.toFixed(3)),
    tolerance: 0.01,
    digits: 1,
  },
  climb: {
    ...kYard,
    view: '7.7,1.5,0.5,180',
    state: { time: 250 },
    answer: (now) => Number(now.eye.z.toFixed(1)),
    tolerance: 0.01,
    digits: 1,
  },
  frame: {
    ...kYard,
    view: '7.7,1.5,0.5,180',
    answer: () => 3 / 144,
    tolerance: 0.0005,
    unit: 'units',
    digits: 4,
  },
};
