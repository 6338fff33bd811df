// A straight line of blocks from one end to the other. The wheel lifts the second end.
// Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges, isInside, kEmpty, kMostLevels } from '../cells.js';
import { kBrass, kCoral, linesOf } from '../mark-lines.js';
import { keyOf, outlineOf } from '../selection.js';
import { cellMarks, edgeHint, lineOf, placesIn } from './strokes.js';

// What lies outside the map is left out.
function cellsOf(stroke, { scene }) {
  const places = placesIn(stroke);
  if (places.length === 0) return [];
  const to = places.at(-1);
  const level = Math.max(0, Math.min(kMostLevels - 1, to.level + stroke.height));
  const { map } = stroke.targets[0];
  return lineOf(places[0], { ...to, level }).filter((cell) => isInside(scene, map, cell));
}

export const line = {
  name: 'line',
  label: 'Line',
  key: 'L',
  about: 'Drag from end to end. The wheel lifts the second end.',
  touch: 'Drag from end to end.',
  canRemove: true,
  hasCorners: () => true,
  hint: edgeHint,

  point: cellMarks,

  show(stroke, context) {
    const colour = stroke.removes ? kCoral : kBrass;
    return linesOf(stroke.targets[0].mapName, outlineOf(this.cells(stroke, context)), colour);
  },

  // The cells to show in the plan.
  cells(stroke, context) {
    return new Set(cellsOf(stroke, context).map(keyOf));
  },

  end(stroke, context) {
    const { scene, sign } = context;
    const put = stroke.removes ? kEmpty : sign;
    return cellChanges(
      scene,
      stroke.targets[0].map,
      cellsOf(stroke, context).map(({ level, x, y }) => ({ layer: level, x, y, sign: put })),
    );
  },
};
