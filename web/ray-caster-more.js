// The part of <ray-caster> for pictures that move, have something on them, or move together:
// tools/bundle.mjs makes one file of it, as it does of ray-caster-steering.js.

export { Hotspots } from './element/hotspots.js';
export { Partner } from './element/partner.js';
export { joinPace } from './element/shared-pace.js';
