// Reads what an engine hears: engine.heard, numbers as slicecast_hear gives them
// (src/wasm/bindings.h).
//
//     heardOf(engine.heard)      [{kind: 'step', material: 'wood', gain: 0.5, pan: 0}, ...]

import { kLasting, kMaterials, kOnce } from './recipes.js';

const kKinds = [...kOnce, ...kLasting];
const kNumbers = 4; // of a sound

export function heardOf(numbers) {
  return Array.from({ length: numbers.length / kNumbers }, (_, index) => {
    const [kind, material, gain, pan] = numbers.subarray(kNumbers * index, kNumbers * (index + 1));
    return { kind: kKinds[kind], material: kMaterials[material], gain, pan };
  });
}
