// What boxes and links cost, counted.

const kMeadow = { scene: 'yard.json', view: '13.6,8.3,3.3,220,-0.42', size: [480, 300] };

export default {
  // Letters of the text that change with walls round six by five tiles, two levels high.
  walls: {
    ...kMeadow,
    answer: () => {
      let cells = 0;
      for (let y = 0; y < 5; ++y)
        for (let x = 0; x < 6; ++x) cells += x === 0 || y === 0 || x === 5 || y === 4 ? 2 : 0;
      return cells;
    },
    tolerance: 0.5,
    digits: 0,
  },
  // The roof: each level of a solid box is all of its tiles.
  roof: { ...kMeadow, answer: () => 8 * 7, tolerance: 0.5, digits: 0 },
  // A letter of a link holds six bits, a byte of the packed text eight.
  link: { ...kMeadow, answer: () => (8000 * 6) / 8, tolerance: 0.5, unit: 'bytes', digits: 0 },
};
