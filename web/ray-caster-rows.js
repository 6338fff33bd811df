// The part of <ray-caster> that reads plain rows of characters. tools/bundle.mjs bundles it into
// one file, like ray-caster-steering.js.

export { sceneOfObject, sceneOfRows } from './engine/rows.js';
