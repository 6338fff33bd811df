// Fills what is joined and alike in one level, as a bucket does: cells with the same sign that
// touch with a side. Takes a target; gives changes and lines to show. Knows no view.

import { cellChanges, kEmpty, sizeOf } from '../cells.js';
import { cellMarks, edgeHint } from './strokes.js';

export const fill = {
  name: 'fill',
  label: 'Fill',
  key: 'F',
  about: 'Fills the cells of a level that are joined and alike.',
  canRemove: true,

  hint: edgeHint,

  point: cellMarks,

  end({ targets, removes }, { scene, sign }) {
    const { map, cell, before } = targets.at(-1);
    const at = removes ? cell : before;
    if (at === null) return [];
    const to = removes ? kEmpty : sign;
    return cellChanges(
      scene,
      map,
      joined(scene, map, at).map(({ x, y }) => ({ layer: at.level, x, y, sign: to })),
    );
  },
};

// The cells that are joined with one, in its level.
export function joined(scene, map, { level, x, y }) {
  const { width, depth } = sizeOf(scene, map);
  const sign = scene.sign(map, level, x, y);
  const seen = new Uint8Array(width * depth);
  const found = [];
  const next = [[x, y]];
  while (next.length > 0) {
    const [atX, atY] = next.pop();
    if (atX < 0 || atY < 0 || atX >= width || atY >= depth) continue;
    const index = atY * width + atX;
    if (seen[index] === 1 || scene.sign(map, level, atX, atY) !== sign) continue;
    seen[index] = 1;
    found.push({ x: atX, y: atY });
    next.push([atX + 1, atY], [atX - 1, atY], [atX, atY + 1], [atX, atY - 1]);
  }
  return found;
}
