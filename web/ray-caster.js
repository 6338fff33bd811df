// <ray-caster>: a living raycaster in any page, from one script.
//
//     <script type="module" src="slicecast/ray-caster.js"></script>
//     <ray-caster scene="castle" controls></ray-caster>
//
// Attributes, properties, methods, events, slots and parts: element/api.json. Where there is no
// document (under server rendering) importing it does nothing.

import { RayCaster } from './element/ray-caster-element.js';

export { errorCodes } from './element/faults.js';
export { RayCaster };

// Counts up when something that pages rely on changes its meaning.
export const apiVersion = 1;

// Two copies of this script may meet in one page; the first one serves both.
if (globalThis.customElements?.get('ray-caster') === undefined)
  globalThis.customElements?.define('ray-caster', RayCaster);
