// Paints faces with the chosen texture, by dragging over them; with Shift, whole blocks. A block
// that is painted gets a kind of its own, or one that looks so already.
// Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges } from '../cells.js';
import { kindFor, kindOf } from '../kinds.js';
import { cellLines, faceLines, kSea } from '../mark-lines.js';
import { extentOf, kFaces, withAllFaces, withFace } from '../shapes.js';

export const paint = {
  name: 'paint',
  label: 'Paint',
  key: 'P',
  about: 'Drag over faces to give them the texture. Shift paints whole blocks.',
  isFree: true, // a drag is not bound to the plane where it began

  point({ map, mapName, cell, face }, { scene, isWhole }) {
    if (cell === null) return [];
    const kind = kindOf(scene, map, scene.sign(map, cell.level, cell.x, cell.y));
    const extent = extentOf(kind?.blueprint);
    return isWhole
      ? cellLines(mapName, cell, kSea, extent)
      : faceLines(mapName, cell, face, kSea, extent);
  },

  drag({ targets }, { scene, texture, isWhole }) {
    const { map, cell, face } = targets.at(-1);
    if (cell === null || texture === null || !kFaces.includes(face)) return [];
    const kind = kindOf(scene, map, scene.sign(map, cell.level, cell.x, cell.y));
    if (kind === null) return [];
    const painted = isWhole
      ? withAllFaces(kind.blueprint, texture)
      : withFace(kind.blueprint, face, texture);
    const { sign, changes } = kindFor(scene, map, `${kind.name}, ${texture}`, painted);
    const { level, x, y } = cell;
    return [...changes, ...cellChanges(scene, map, [{ layer: level, x, y, sign }])];
  },
};
