// The figure kit as one module for other pages: learn/figures.js of the built page.
//
//     import { mapView, mount, picture } from './slicecast/learn/figures.js';

export * from './figures/kit.js';
export { mount } from './figures/mount.js';
