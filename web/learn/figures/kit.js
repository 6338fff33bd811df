// Everything that a figure's module imports; web/docs/figure-kit.md tells what it offers.

export * from './controls.js';
export * from './geometry.js';
export * from './markup.js';
export { codeView } from './views/code.js';
export { divider } from './views/divider.js';
export { mapView } from './views/map.js';
export { drawing, panel } from './views/own.js';
export { picture } from './views/picture.js';
export { plot } from './views/plot.js';
export { rulers } from './views/rulers.js';
export { sideView } from './views/side.js';
export { sliceStrip } from './views/strip.js';
export { numberTable } from './views/table.js';
export { textureView } from './views/texture.js';
export { why } from './views/why.js';
