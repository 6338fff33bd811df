// <ray-caster>: a live raycaster in any page, from one script.
//
//     <script type="module" src="slicecast/ray-caster.js"></script>
//     <ray-caster scene="castle" controls></ray-caster>
//
// element/api.json lists attributes, properties, methods, events, slots and parts. Without a
// document (server rendering) importing this does nothing.

import { RayCaster } from './element/ray-caster-element.js';
import { version } from './element/version.js';

export { errorCodes } from './element/faults.js';
export { RayCaster };

// Increased when something that pages rely on changes its meaning.
export const apiVersion = 1;

RayCaster.version = version;

// If a page loads two copies of this script, the first one serves both: a tag is defined only once.
const defined = globalThis.customElements?.get('ray-caster');
if (defined === undefined) globalThis.customElements?.define('ray-caster', RayCaster);
else if (defined.version !== version)
  console.warn(
    `<ray-caster> stays version ${defined.version}, whose script ran first, and version ${version} is not used. Load only one of the two scripts.`,
  );
