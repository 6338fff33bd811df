// A box of blocks from one corner to the other: solid, hollow, or only its walls. The wheel sets
// the height. Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges, kEmpty, kMostLevels } from '../cells.js';
import { boxLines, boxOf, cellLines, kBrass, kCoral } from '../mark-lines.js';
import { boxOfCells, cellsIn } from './strokes.js';

const cornersOf = ({ targets, removes, height }) => {
  const places = targets.map(({ cell, before }) => (removes ? cell : before)).filter(Boolean);
  if (places.length === 0) return null;
  const to = places.at(-1);
  const level = Math.max(0, Math.min(kMostLevels - 1, to.level + height));
  return boxOfCells(places[0], { ...to, level });
};

export const box = {
  name: 'box',
  label: 'Box',
  key: 'X',
  about: 'Drag from corner to corner. The wheel sets the height. O: solid, hollow or walls.',
  touch: 'Drag from corner to corner, over the ground or up a wall.',
  canRemove: true,
  ways: ['solid', 'hollow', 'walls'],
  hasCorners: () => true,

  point({ mapName, cell, before }, { removes }) {
    const at = removes ? cell : before;
    return at === null ? [] : cellLines(mapName, at, removes ? kCoral : kBrass);
  },

  // Lines while it is dragged.
  show(stroke) {
    const corners = cornersOf(stroke);
    if (corners === null) return [];
    const { west, north, low } = boxOf(corners.from);
    const { east, south, high } = boxOf(corners.to);
    const colour = stroke.removes ? kCoral : kBrass;
    return boxLines(stroke.targets[0].mapName, { west, north, low, east, south, high }, colour);
  },

  end(stroke, { scene, sign, way }) {
    const corners = cornersOf(stroke);
    if (corners === null) return [];
    return cellChanges(
      scene,
      stroke.targets[0].map,
      cellsIn(corners, stroke.removes ? 'solid' : way).map(({ level, x, y }) => ({
        layer: level,
        x,
        y,
        sign: stroke.removes ? kEmpty : sign,
      })),
    );
  },
};
