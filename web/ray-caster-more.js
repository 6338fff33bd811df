// The part of <ray-caster> for pages that put something on its picture or join two of them:
// tools/bundle.mjs makes one file of it, as it does of ray-caster-steering.js.

export { Hotspots } from './element/hotspots.js';
export { Partner } from './element/partner.js';
