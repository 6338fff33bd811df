// Glass blocks in a row: joined on the left, each with all its panes on the right.

import { picture, sliceStrip } from '../figures/kit.js';

const kinds = { joined: 'joined blocks', single: 'blocks that keep all panes' };

// The panes that the slice crosses at the height of the eye.
export function panesAtEye({ slice }) {
  const row = Math.floor(slice.horizonRow);
  return slice.runs.filter(
    ({ layer, what, first, last }) => layer && what === 'side' && first <= row && row <= last,
  );
}

export default {
  scene: 'panes.json',
  view: '1.1,3.5,0.7,0,0',
  options: { fov: 60 },
  size: [480, 300],
  state: { column: 392, row: 150 },
  controls: [],
  rows: [[picture({ handles: ['column'], share: 2 }), sliceStrip({ names: true })]],
  numbers: { panes: (now) => String(panesAtEye(now).length) },
  says: (now) => {
    const panes = panesAtEye(now);
    if (panes.length === 0) return 'This slice meets no glass at the height of the eye.';
    const { blueprint } = now.slice.hits[panes[0].hit];
    return `At the height of the eye this slice crosses ${panes.length} panes of ${kinds[blueprint]}.`;
  },
};
