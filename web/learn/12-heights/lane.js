// A lane with three pillars whose heights change in quarters of a unit.

const kLevels = 3;
const kMap = 'lane';
export const kPillars = [
  { x: 3, texture: 'brick', name: 'first', signs: 'abcd' },
  { x: 6, texture: 'sandstone', name: 'second', signs: 'efgh' },
  { x: 9, texture: 'window', name: 'third', signs: 'ijkl' },
];

const faces = (texture) => ({
  all: texture,
  north: { texture, light: 0.72 },
  west: { texture, light: 0.93 },
});

export const laneScene = {
  title: 'A lane with three pillars',
  textures: {
    brick: '../../textures/brick.png',
    window: '../../textures/window-brick.png',
    sandstone: '../../textures/sandstone.png',
    grass: '../../textures/grass.png',
  },
  blueprints: Object.fromEntries(
    kPillars.flatMap(({ texture, name }) =>
      [1, 2, 3, 4].map((quarters) => [
        `${name}-${quarters}`,
        { top: quarters / 4, faces: faces(texture) },
      ]),
    ),
  ),
  legend: Object.fromEntries(
    kPillars.flatMap(({ name, signs }) =>
      [...signs].map((sign, index) => [sign, `${name}-${index + 1}`]),
    ),
  ),
  maps: [
    {
      name: kMap,
      levels: Array.from({ length: kLevels }, () => Array(3).fill('.'.repeat(12))),
      floor: { texture: 'grass' },
      sky: { low: '#f1e2c4', high: '#5f9fd4' },
      light: { multiplier: 5, darkest: 0.5 },
      haze: '#f1e2c4',
    },
  ],
  start: { x: 0.5, y: 1.5, heading: 0 },
};

// The cells for three heights in quarters of a unit.
export function laneEdits(heights) {
  return kPillars.flatMap(({ x, signs }, index) =>
    Array.from({ length: kLevels }, (_, level) => {
      const quarters = Math.max(0, Math.min(4, heights[index] - 4 * level));
      return [kMap, level, x, 1, quarters === 0 ? '.' : signs[quarters - 1]];
    }),
  );
}
