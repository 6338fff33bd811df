// What sounds are made of: plain data, which voices.js plays. All of it is computed; there are no
// recordings.
//
//     onceRecipe('step', 'wood')       layers of a sound that is heard once
//     lastingRecipe('gate', 'metal')   layers of one that lasts; null for kinds without a voice
//     variation(7)                     {pitch, gain}: the seventh sound differs a little
//
// Kinds and materials are those of src/include/slicecast/sound.h. A layer is filtered noise or a
// tone:
//
//     noise      'lowpass', 'bandpass' or 'highpass'      hertz, to   from this frequency to that
//     tone       'sine' or 'sawtooth'                     q           width of the filter
//     gain       loudness, 0 to 1
//
// Once: it begins after `delay`, rises for `attack` and fades out within `decay`, in seconds. One
// that lasts may sway: its frequency by `sway.hertz` up and down, `sway.rate` times a second; its
// loudness by the share `pulse.depth`, `pulse.rate` times a second.

export const kMaterials = [
  'stone',
  'wood',
  'earth',
  'grass',
  'sand',
  'metal',
  'glass',
  'cloth',
  'water',
];
export const kOnce = [
  'step',
  'land',
  'jump',
  'splash',
  'stroke',
  'knock',
  'crossing',
  'find',
  'goal',
];
export const kLasting = ['gate', 'mover', 'water', 'wind', 'submerged'];

const noise = (filter, hertz, gain, decay, more = {}) => ({
  noise: filter,
  hertz,
  to: hertz,
  q: 0.7,
  gain,
  delay: 0,
  attack: 0.003,
  decay,
  ...more,
});
const tone = (hertz, gain, decay, more = {}) => ({
  tone: 'sine',
  hertz,
  to: hertz,
  gain,
  delay: 0,
  attack: 0.003,
  decay,
  ...more,
});

// A heel, what it touches, and the toe after it.
const kSteps = {
  stone: [
    tone(140, 0.26, 0.05, { to: 85 }),
    noise('bandpass', 1900, 0.9, 0.05, { q: 0.9 }),
    noise('bandpass', 2600, 0.45, 0.035, { q: 1, delay: 0.075 }),
  ],
  wood: [
    tone(190, 0.3, 0.09, { to: 150 }),
    tone(310, 0.2, 0.07),
    noise('lowpass', 1100, 0.9, 0.04),
    tone(240, 0.16, 0.05, { delay: 0.08 }),
  ],
  earth: [
    tone(95, 0.2, 0.07, { to: 60 }),
    noise('lowpass', 600, 1.7, 0.07),
    noise('lowpass', 800, 0.8, 0.06, { delay: 0.08 }),
  ],
  grass: [
    tone(85, 0.14, 0.05, { to: 55 }),
    noise('bandpass', 3200, 0.5, 0.1, { q: 0.5, attack: 0.012 }),
    noise('bandpass', 5200, 0.3, 0.09, { q: 0.8, attack: 0.02, delay: 0.05 }),
  ],
  sand: [
    tone(75, 0.12, 0.05),
    noise('bandpass', 4300, 0.5, 0.12, { q: 0.6, attack: 0.02 }),
    noise('bandpass', 2500, 0.45, 0.1, { attack: 0.02, delay: 0.06 }),
  ],
  metal: [
    tone(120, 0.2, 0.04, { to: 80 }),
    tone(410, 0.14, 0.22),
    tone(973, 0.09, 0.16),
    tone(1710, 0.06, 0.1),
    noise('highpass', 2800, 0.2, 0.03),
  ],
  glass: [
    tone(170, 0.18, 0.04, { to: 120 }),
    tone(2350, 0.07, 0.12),
    tone(3620, 0.05, 0.09),
    noise('bandpass', 5200, 0.4, 0.03, { q: 2 }),
  ],
  cloth: [tone(75, 0.16, 0.05, { to: 55 }), noise('lowpass', 420, 2, 0.07, { attack: 0.006 })],
  water: [
    noise('bandpass', 900, 0.8, 0.2, { to: 2200, q: 0.8, attack: 0.02 }),
    noise('bandpass', 3800, 0.35, 0.14, { q: 0.8, attack: 0.02, delay: 0.05 }),
    tone(420, 0.12, 0.05, { to: 900, delay: 0.09 }),
    tone(560, 0.09, 0.04, { to: 1180, delay: 0.15 }),
  ],
};

const kSplash = [
  noise('bandpass', 700, 1.2, 0.45, { to: 2600, q: 0.5, attack: 0.01 }),
  noise('lowpass', 400, 1.4, 0.3),
  tone(300, 0.16, 0.07, { to: 700, delay: 0.12 }),
  tone(420, 0.14, 0.06, { to: 980, delay: 0.21 }),
  tone(350, 0.1, 0.06, { to: 860, delay: 0.33 }),
];

const louder = (layers, factor, longer = 1) =>
  layers.map((layer) => ({ ...layer, gain: layer.gain * factor, decay: layer.decay * longer }));

const kOnceRecipes = {
  step: (material) => kSteps[material],
  land: (material) =>
    material === 'water'
      ? kSplash
      : [tone(90, 0.3, 0.16, { to: 48 }), ...louder(kSteps[material], 1.3, 1.3)],
  jump: (material) => [
    noise('bandpass', 700, 0.5, 0.09, { to: 1400, attack: 0.02 }),
    ...louder(kSteps[material].slice(0, 2), 0.5),
  ],
  splash: () => kSplash,
  stroke: () => [
    noise('bandpass', 600, 0.9, 0.28, { to: 1500, q: 0.8, attack: 0.06 }),
    tone(380, 0.07, 0.05, { to: 820, delay: 0.2 }),
  ],
  knock: (material) => [
    tone(80, 0.34, 0.22, { to: 45 }),
    ...louder(kSteps[material], 1.1, material === 'metal' ? 3 : 1.6),
  ],
  crossing: () => [
    noise('bandpass', 300, 1, 0.5, { to: 2400, q: 1.2, attack: 0.12 }),
    tone(220, 0.1, 0.6, { to: 440, attack: 0.1 }),
    tone(330, 0.07, 0.6, { to: 660, attack: 0.12 }),
  ],
  // Two bells, a fifth apart; and three that rise to the octave.
  find: () => [
    tone(880, 0.16, 0.7),
    tone(1760, 0.05, 0.4),
    tone(1320, 0.14, 0.9, { delay: 0.11 }),
    tone(2640, 0.04, 0.5, { delay: 0.11 }),
  ],
  goal: () => [
    tone(587, 0.15, 0.9),
    tone(880, 0.14, 1, { delay: 0.16 }),
    tone(1174, 0.15, 1.1, { delay: 0.34 }),
    tone(1480, 0.08, 1.1, { delay: 0.34 }),
    tone(2348, 0.04, 1, { delay: 0.34 }),
  ],
};

export function onceRecipe(kind, material) {
  return kOnceRecipes[kind](material);
}

// ---- Sounds that last

const hum = (filter, hertz, gain, more = {}) => ({ noise: filter, hertz, q: 0.7, gain, ...more });
const drone = (hertz, gain, more = {}) => ({ tone: 'sine', hertz, gain, ...more });

// Stone grinds, wood creaks, metal rattles and hums. Other materials rumble like stone.
const kGrinding = [
  hum('lowpass', 240, 1.4, { pulse: { rate: 5.3, depth: 0.4 } }),
  hum('bandpass', 720, 0.6, { q: 1.6, pulse: { rate: 11, depth: 0.7 } }),
];
const kMoving = {
  gate: {
    stone: kGrinding,
    wood: [
      hum('bandpass', 460, 2.4, {
        q: 9,
        sway: { rate: 0.9, hertz: 150 },
        pulse: { rate: 7, depth: 0.8 },
      }),
      hum('lowpass', 220, 0.9),
    ],
    metal: [
      hum('bandpass', 2500, 0.3, { q: 3, pulse: { rate: 13, depth: 0.9 } }),
      drone(92, 0.08, { pulse: { rate: 13, depth: 0.4 } }),
      hum('lowpass', 260, 0.6),
    ],
  },
  mover: {
    stone: [
      hum('lowpass', 180, 1.6, { pulse: { rate: 2.1, depth: 0.3 } }),
      hum('bandpass', 420, 0.6, { q: 1.2, pulse: { rate: 6.7, depth: 0.6 } }),
    ],
    wood: [
      hum('bandpass', 320, 2.2, {
        q: 8,
        sway: { rate: 0.5, hertz: 110 },
        pulse: { rate: 4, depth: 0.7 },
      }),
      hum('lowpass', 200, 0.9),
    ],
    metal: [drone(55, 0.08), drone(110.7, 0.08), hum('bandpass', 900, 0.4, { q: 2 })],
  },
};

const kAround = {
  water: [
    hum('bandpass', 620, 0.8, { q: 0.5, pulse: { rate: 0.13, depth: 0.6 } }),
    hum('bandpass', 2300, 0.24, {
      q: 1.2,
      sway: { rate: 0.37, hertz: 700 },
      pulse: { rate: 0.29, depth: 0.5 },
    }),
  ],
  wind: [
    hum('bandpass', 400, 1.2, {
      sway: { rate: 0.07, hertz: 170 },
      pulse: { rate: 0.11, depth: 0.45 },
    }),
    hum('bandpass', 1150, 0.3, {
      q: 5,
      sway: { rate: 0.09, hertz: 320 },
      pulse: { rate: 0.17, depth: 0.8 },
    }),
  ],
};

export function lastingRecipe(kind, material) {
  return kAround[kind] ?? kMoving[kind]?.[material] ?? kMoving[kind]?.stone ?? null;
}

// ---- Levels

// How loud a kind is among the others, before the sound's own gain.
export const kLevels = {
  step: 0.8,
  land: 0.9,
  jump: 0.8,
  splash: 0.9,
  stroke: 0.8,
  knock: 0.8,
  crossing: 0.8,
  find: 0.7,
  goal: 0.8,
  gate: 0.5,
  mover: 0.45,
  water: 0.4,
  wind: 0.4,
};

// The cut-off frequency of everything, in hertz: under water only what is low is heard.
export const kOpenHertz = 20000;
export const kSubmergedHertz = 480;

const kPitchSpread = 0.06;
const kGainSpread = 0.15;

// A share from 0 to 1, the same for the same number.
export function shareOf(number) {
  let mixed = Math.imul(number ^ (number >>> 15), 0x2c1b3c6d);
  mixed = Math.imul(mixed ^ (mixed >>> 12), 0x297a2d39);
  return ((mixed ^ (mixed >>> 15)) >>> 0) / 2 ** 32;
}

export function variation(count) {
  return {
    pitch: 1 + kPitchSpread * (2 * shareOf(2 * count + 1) - 1),
    gain: 1 - kGainSpread * shareOf(2 * count + 2),
  };
}
