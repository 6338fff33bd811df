// A box of blocks from one corner to the other: solid, hollow, or only its walls. The wheel sets
// the height. Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges, clipped, kEmpty } from '../cells.js';
import { boxLines, boxOf, kBrass, kCoral } from '../mark-lines.js';
import { boxOfCells, cellMarks, cellsIn, edgeHint, placesIn } from './strokes.js';

// Within the map.
function cornersOf(stroke, { scene }) {
  const places = placesIn(stroke);
  if (places.length === 0) return null;
  const to = places.at(-1);
  const box = boxOfCells(places[0], { ...to, level: to.level + stroke.height });
  return clipped(scene, stroke.targets[0].map, box);
}

export const box = {
  name: 'box',
  label: 'Box',
  key: 'X',
  about: 'Drag from corner to corner. The wheel sets the height. O: solid, hollow or walls.',
  ways: ['solid', 'hollow', 'walls'],
  hasCorners: () => true,
  hint: edgeHint,

  point: cellMarks,

  // Lines while it is dragged.
  show(stroke, context) {
    const corners = cornersOf(stroke, context);
    if (corners === null) return [];
    const { west, north, low } = boxOf(corners.from);
    const { east, south, high } = boxOf(corners.to);
    const colour = stroke.removes ? kCoral : kBrass;
    return boxLines(stroke.targets[0].mapName, { west, north, low, east, south, high }, colour);
  },

  end(stroke, context) {
    const { scene, sign, way } = context;
    const corners = cornersOf(stroke, context);
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
