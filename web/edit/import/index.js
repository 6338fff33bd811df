// Maps from elsewhere: what the editor and the command `slicecast import` use of this folder. Pure
// modules: no document, nothing of Node, and no file but what they are given.
//
//     const proposal = await readForeign({ name, bytes, readFile });    // a dialog may change it
//     const { scene, pictures, notTaken } = await makeScene(proposal);
//     const { tmj, pictures } = exportTmj(scene, 'courtyard');

export * from './choices.js';
export { exportTmj } from './export-tmj.js';
export { ImportError } from './import-error.js';
export { makeScene } from './make-scene.js';
export { counted } from './notes.js';
export { readForeign } from './read-foreign.js';
export { kShippedSprites } from './shipped-sprites.js';
