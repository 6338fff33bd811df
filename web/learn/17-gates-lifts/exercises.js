import { blockAt, gate, offsetAt } from './motion.js';

// The first moment at which the formula's edge is this high, in seconds.
function firstTimeAt(height) {
  for (let step = 0; ; ++step) if (offsetAt(gate, step / 1000) >= height) return step / 1000;
}

export default {
  edge: {
    scene: 'yard-6.json',
    view: '8.5,4.5,0.5,0,0.1',
    state: { time: 180 },
    answer: (now) => blockAt(now, { x: 9, y: 4.5 }, 'gate').bottom,
    tolerance: 0.005,
    unit: 'units',
    digits: 3,
  },
  fit: {
    scene: 'yard-6.json',
    view: '8.5,4.5,0.5,0,0.1',
    answer: () => firstTimeAt(0.72),
    tolerance: 0.1,
    unit: 's',
    digits: 2,
  },
  ride: {
    scene: 'yard-6.json',
    view: '13.5,6.5,0.75,215,0',
    state: { time: 480 },
    answer: (now) => now.eye.z,
    tolerance: 0.01,
    unit: 'units',
    digits: 2,
  },
};
