// <ray-caster>: a live raycaster in any page, from one script.
//
//     <script type="module" src="slicecast/ray-caster.js"></script>
//     <ray-caster scene="castle" controls></ray-caster>
//
// element/api.json lists attributes, properties, methods, events, slots and parts. Without a
// document (server rendering) importing this does nothing.

import { RayCaster } from './element/ray-caster-element.js';

export { errorCodes } from './element/faults.js';
export { RayCaster };

// Increased when something that pages rely on changes its meaning.
export const apiVersion = 1;

// If a page loads two copies of this script, the first one serves both.
if (globalThis.customElements?.get('ray-caster') === undefined)
  globalThis.customElements?.define('ray-caster', RayCaster);
