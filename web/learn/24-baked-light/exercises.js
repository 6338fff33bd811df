import { lightOf } from './rays.js';

const kCourt = { scene: 'sunlit.json', view: '8.5,7.2,0.5,250', size: [480, 300] };

export default {
  // The share of the sun's light on the floor, in 256ths, for a sun thirty degrees high.
  noon: {
    ...kCourt,
    answer: (now) =>
      Math.floor((256 * lightOf(now).sun[2]) / Math.hypot(...lightOf(now).sun) + 0.5),
    tolerance: 1,
    digits: 0,
  },
  // How long the shadow of the pillar is.
  shadow: {
    ...kCourt,
    answer: (now) => {
      const [x, y, z] = lightOf(now).sun;
      return (2 * Math.hypot(x, y)) / z;
    },
    tolerance: 0.02,
    unit: 'units',
    digits: 2,
  },
  // Sky with five of eight rays free, of an ambient channel of 120.
  sky: {
    ...kCourt,
    answer: () => Math.floor((120 * (1020 + 5 * 255) + 1530) / 3060),
    tolerance: 0.5,
    digits: 0,
  },
  // A point a quarter of the way east and half of the way south between nodes of 40, 200, 40, 120.
  bilinear: {
    ...kCourt,
    answer: () => {
      const [east, south] = [0.25, 0.5];
      const north = 40 + (200 - 40) * east;
      const beyond = 40 + (120 - 40) * east;
      return north + (beyond - north) * south;
    },
    tolerance: 0.6,
    digits: 0,
  },
};
