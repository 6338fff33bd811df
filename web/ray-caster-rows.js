// The part of <ray-caster> that reads plain rows of characters: tools/bundle.mjs makes one file of
// it, as it does of ray-caster-steering.js.

export { sceneOfObject, sceneOfRows } from './engine/rows.js';
