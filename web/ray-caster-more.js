// The part of <ray-caster> for questions about the picture, automatic picture size, hotspots,
// elements that share a view, the view in words, and snapshots. It loads after the first picture.
// tools/bundle.mjs bundles it into one file, like ray-caster-steering.js.

export { Hotspots } from './element/hotspots.js';
export { Partner } from './element/partner.js';
export { joinPace } from './element/shared-pace.js';
export { encoded } from './element/snapshot.js';
export { describeView } from './element/view-text.js';
export { Questions } from './engine/questions.js';
