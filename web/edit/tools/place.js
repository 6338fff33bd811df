// Puts the chosen block against the face that is pointed at, or removes the block there; a drag
// makes a line of them. Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges, isInside, kEmpty } from '../cells.js';
import { kindOf } from '../kinds.js';
import { cellLines, faceLines, kBrass, kCoral } from '../mark-lines.js';
import { extentOf } from '../shapes.js';
import { edgeHint, lineOf, placesIn } from './strokes.js';

export const place = {
  name: 'place',
  label: 'Place',
  key: 'B',
  about: 'Click puts the block against a face. Right click or Delete removes.',
  touch: 'Tap where the block is to stand, drag for a row. To take blocks away, choose Remove.',
  canRemove: true,

  hint: edgeHint,

  point({ map, mapName, cell, before, face }, { scene, removes }) {
    if (removes) {
      if (cell === null) return [];
      const kind = kindOf(scene, map, scene.sign(map, cell.level, cell.x, cell.y));
      return cellLines(mapName, cell, kCoral, extentOf(kind?.blueprint));
    }
    if (before === null || !isInside(scene, map, before)) return [];
    const around = cellLines(mapName, before, kBrass);
    return cell === null || face === null
      ? around
      : [...around, ...faceLines(mapName, cell, face, kBrass)];
  },

  drag(stroke, { scene, sign }) {
    const { targets, removes } = stroke;
    const places = placesIn(stroke);
    const last = places.at(-1);
    if (last === undefined) return [];
    const cells = lineOf(places.at(-2) ?? last, last);
    return cellChanges(
      scene,
      targets[0].map,
      cells.map(({ level, x, y }) => ({ layer: level, x, y, sign: removes ? kEmpty : sign })),
    );
  },
};
