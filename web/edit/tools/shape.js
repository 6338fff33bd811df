// Raises and lowers the top of the block that is pointed at, or its underside, by the wheel; the
// side view lets one drag them. Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges } from '../cells.js';
import { kindFor, kindOf } from '../kinds.js';
import { cellLines, faceLines, kSea } from '../mark-lines.js';
import { extentOf, nameWithHeights, withHeight } from '../shapes.js';

const kStep = 0.1; // of a block's height, for each notch of the wheel

export const shape = {
  name: 'shape',
  label: 'Shape',
  key: 'H',
  about: 'The wheel raises and lowers the pointed top or underside. Drag edges in the side view.',
  touch: 'Drag the edges of blocks in the side view, or write Top and Bottom into the panel.',

  point({ map, mapName, cell, face }, { scene }) {
    if (cell === null) return [];
    const kind = kindOf(scene, map, scene.sign(map, cell.level, cell.x, cell.y));
    const extent = extentOf(kind?.blueprint);
    return [
      ...cellLines(mapName, cell, kSea, extent),
      ...faceLines(mapName, cell, face === 'bottom' ? 'bottom' : 'top', '#ffffff', extent),
    ];
  },

  // Notches of the wheel, up positive.
  turn({ map, cell, face }, notches, { scene }) {
    if (cell === null) return [];
    const { level, x, y } = cell;
    const kind = kindOf(scene, map, scene.sign(map, level, x, y));
    if (kind === null) return [];
    const { low, high } = extentOf(kind.blueprint);
    const edge = face === 'bottom' ? 'bottom' : 'top';
    const height = Math.round(((edge === 'top' ? high : low) + notches * kStep) / kStep) * kStep;
    const shaped = withHeight(kind.blueprint, edge, height);
    if (shaped === null) return [];
    const { sign, changes } = kindFor(scene, map, nameWithHeights(kind.name, shaped), shaped);
    return [...changes, ...cellChanges(scene, map, [{ layer: level, x, y, sign }])];
  },
};
