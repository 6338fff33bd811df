const kYard = { scene: 'yard-1.json', view: '1.6,6.7,0.5,345', options: { fov: 66 } };
const factor = Math.min(256, Math.floor(256 * 0.8 * 0.85 + 0.5));

export default {
  'half-bright': { ...kYard, answer: () => (0.5 * 6) / 1.5, tolerance: 0.01 },
  'byte-factor': { ...kYard, answer: () => factor },
  byte: { ...kYard, answer: () => (200 * factor + 128) >> 8 },
  'fog-depth': {
    ...kYard,
    answer: ({ source }) => (source.scene.maps[0].fog.start + source.scene.maps[0].fog.end) / 2,
    tolerance: 0.1,
    unit: 'units',
  },
};
