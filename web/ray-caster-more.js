// The part of <ray-caster> for automatic picture size, hotspots, and elements that share a view.
// tools/bundle.mjs bundles it into one file, like ray-caster-steering.js.

export { Hotspots } from './element/hotspots.js';
export { Partner } from './element/partner.js';
export { joinPace } from './element/shared-pace.js';
