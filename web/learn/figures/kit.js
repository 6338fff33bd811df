// Everything that a figure's module imports; README.md tells what it offers.

export * from './controls.js';
export * from './geometry.js';
export * from './markup.js';
export { openingState } from './state.js';
export { divider } from './views/divider.js';
export { mapView } from './views/map.js';
export { drawing, panel } from './views/own.js';
export { picture } from './views/picture.js';
export { rulers } from './views/rulers.js';
export { sideView } from './views/side.js';
export { sliceStrip } from './views/strip.js';
