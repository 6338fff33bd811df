// The part of <ray-caster> that makes sounds. Loaded when somebody steers an element with sound;
// tools/bundle.mjs bundles it into one file. The page's elements share its one board.

export { board } from './sound/board.js';
