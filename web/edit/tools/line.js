// A straight line of blocks from one end to the other. The wheel lifts the second end.
// Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges, kEmpty, kMostLevels } from '../cells.js';
import { cellLines, kBrass, kCoral, linesOf } from '../mark-lines.js';
import { keyOf, outlineOf } from '../selection.js';
import { lineOf } from './strokes.js';

function placesOf({ targets, removes, height }) {
  const places = targets.map(({ cell, before }) => (removes ? cell : before)).filter(Boolean);
  if (places.length === 0) return [];
  const to = places.at(-1);
  const level = Math.max(0, Math.min(kMostLevels - 1, to.level + height));
  return lineOf(places[0], { ...to, level });
}

export const line = {
  name: 'line',
  label: 'Line',
  key: 'L',
  about: 'Drag from end to end. The wheel lifts the second end.',
  touch: 'Drag from end to end.',
  canRemove: true,
  hasCorners: () => true,

  point({ mapName, cell, before }, { removes }) {
    const at = removes ? cell : before;
    return at === null ? [] : cellLines(mapName, at, removes ? kCoral : kBrass);
  },

  show(stroke) {
    const colour = stroke.removes ? kCoral : kBrass;
    return linesOf(stroke.targets[0].mapName, outlineOf(this.cells(stroke)), colour);
  },

  // The cells to show in the plan.
  cells(stroke) {
    return new Set(placesOf(stroke).map(keyOf));
  },

  end(stroke, { scene, sign }) {
    const put = stroke.removes ? kEmpty : sign;
    return cellChanges(
      scene,
      stroke.targets[0].map,
      placesOf(stroke).map(({ level, x, y }) => ({ layer: level, x, y, sign: put })),
    );
  },
};
