// The part of <ray-caster> that loads when somebody is about to steer. tools/bundle.mjs bundles it
// into one file, with its own copy of each module that ray-caster.js has too. So it must not import
// modules with state, or classes checked with instanceof, that ray-caster.js also uses.

export { Steering } from './element/steering.js';
