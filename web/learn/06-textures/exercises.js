const sideTexel = (now) => now.slice.runs.find(({ what }) => what === 'side').texels[0];

export default {
  'north-side': {
    scene: 'yard-1.json',
    view: '8.3,4,0.5,90',
    options: { fov: 66, detail: 'off' },
    size: [481, 300], // the middle column looks exactly ahead
    answer: (now) => sideTexel(now).u,
  },
  'one-to-one': {
    scene: 'yard-1.json',
    view: '8.5,8.4,0.5,270',
    options: { fov: 66 },
    answer: (now) => now.slice.projectionDistance / 128,
    tolerance: 0.01,
    unit: 'units',
    digits: 2,
  },
  'half-block': {
    scene: 'yard-2.json',
    view: '6.5,5,0.5,270',
    options: { fov: 66, detail: 'off' },
    // The first row of texels of the half block before the eye, of 128.
    answer(now) {
      const { v, size } = now.slice.runs.find(
        ({ what, hit }) => what === 'side' && now.slice.hits[hit].blueprint === 'low',
      ).texels[0];
      return v / size[1];
    },
    tolerance: 0.001,
  },
};
