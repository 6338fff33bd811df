// A box of blocks from one corner to the other: solid, hollow, only its walls, or with water in
// it; or a pond in the floor. The wheel sets the height. Takes targets; gives changes and lines to
// show. Knows no view.

import { cellChanges, clipped, kEmpty } from '../cells.js';
import { boxLines, boxOf, kBrass, kCoral } from '../mark-lines.js';
import { pondChanges, poolChanges, withoutPond } from '../water.js';
import { boxOfCells, cellMarks, cellsIn, edgeHint, placesIn } from './strokes.js';

// Within the map.
function cornersOf(stroke, { scene, way }) {
  // A pond is where the floor is pointed at, also to be removed.
  const places = placesIn(way === 'pond' ? { ...stroke, removes: false } : stroke);
  if (places.length === 0) return null;
  const to = places.at(-1);
  const box = boxOfCells(places[0], { ...to, level: to.level + stroke.height });
  const within = clipped(scene, stroke.targets[0].map, box);
  if (way !== 'pond' || within === null) return within;
  return { from: { ...within.from, level: 0 }, to: { ...within.to, level: 0 } };
}

export const box = {
  name: 'box',
  label: 'Box',
  key: 'X',
  about: 'Drag from corner to corner. The wheel sets the height. O: solid, hollow, walls or water.',
  touch: 'Drag from corner to corner, over the ground or up a wall.',
  canRemove: true,
  ways: ['solid', 'hollow', 'walls', 'pool', 'pond'],
  waysAbout: {
    pool: 'Water within walls of the chosen block',
    pond: 'Shallow water in the floor, level with the ground',
  },
  hasCorners: () => true,
  hint(stroke, context) {
    const outside = edgeHint(stroke, context);
    if (outside !== undefined) return outside;
    if (context.way === 'pond') return 'Drag over the floor: it becomes shallow water, to wade in.';
    if (context.way !== 'pool') return undefined;
    return 'Drag over 3 × 3 tiles or more: walls of the chosen block, with water within.';
  },

  point: cellMarks,

  // Lines while it is dragged.
  show(stroke, context) {
    const corners = cornersOf(stroke, context);
    if (corners === null) return [];
    const { west, north, low } = boxOf(corners.from);
    const { east, south, high: top } = boxOf(corners.to);
    const high = context.way === 'pond' ? low : top;
    const colour = stroke.removes ? kCoral : kBrass;
    return boxLines(stroke.targets[0].mapName, { west, north, low, east, south, high }, colour);
  },

  end(stroke, context) {
    const { scene, sign, way } = context;
    const corners = cornersOf(stroke, context);
    if (corners === null) return [];
    const { map } = stroke.targets[0];
    if (way === 'pond')
      return stroke.removes ? withoutPond(scene, map, corners) : pondChanges(scene, map, corners);
    if (way === 'pool' && !stroke.removes) return poolChanges(scene, map, corners, sign);
    return cellChanges(
      scene,
      map,
      cellsIn(corners, stroke.removes ? 'solid' : way).map(({ level, x, y }) => ({
        layer: level,
        x,
        y,
        sign: stroke.removes ? kEmpty : sign,
      })),
    );
  },
};
