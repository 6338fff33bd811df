// The shipped sprites that can stand for objects: their usual height in units, and their frames.
//
//     Object.hasOwn(kShippedSprites, 'oak')

export const kShippedSprites = {
  birch: { height: 3 },
  bush: { height: 0.5 },
  chandelier: { height: 0.9 },
  column: { height: 3 },
  'crate-stack': { height: 0.5 },
  cypress: { height: 3.2 },
  'flower-bush': { height: 0.5 },
  fountain: { height: 1.1, frames: 6, rate: 8 },
  lantern: { height: 0.42, frames: 8, rate: 6 },
  'market-stall': { height: 0.9 },
  moonflower: { height: 0.46, frames: 8, rate: 6 },
  oak: { height: 3.2 },
  pine: { height: 2.8 },
  shell: { height: 0.42, frames: 8, rate: 6 },
  'standing-barrel': { height: 0.35 },
  statue: { height: 1.2 },
  'street-lamp': { height: 1.5 },
};
