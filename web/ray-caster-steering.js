// The part of <ray-caster> that comes when somebody does: tools/bundle.mjs makes one file of it.
// Nothing in it may be shared with ray-caster.js, of which it then has a copy of its own: modules
// with a state, classes that are told apart by instanceof.

export { Steering } from './element/steering.js';
