// Paints with the chosen texture, by dragging: faces, with Shift whole blocks, and the tiles of
// floor and ceiling. A block that is painted gets a kind of its own, or one that looks so already.
// Takes targets; gives changes and lines to show. Knows no view.

import { cellChanges, kEmpty, sizeOf } from '../cells.js';
import { kindFor, kindOf } from '../kinds.js';
import { cellLines, faceLines, kCoral, kSea } from '../mark-lines.js';
import { extentOf, kFaces, withAllFaces, withFace } from '../shapes.js';
import { tileChanges } from '../tiles.js';
import { lineOf } from './strokes.js';

export const paint = {
  name: 'paint',
  label: 'Paint',
  key: 'P',
  about: 'Drag over faces, floor or ceiling. Shift paints whole blocks. O: only floor or ceiling.',
  touch: 'Drag over faces, floor or ceiling.',
  canRemove: true,
  ways: ['what is pointed at', 'floor', 'ceiling'],
  isFree: true, // a drag is not bound to the plane where it began

  point(target, { scene, isWhole, way, removes }) {
    const { map, mapName, cell, face } = target;
    const colour = removes ? kCoral : kSea;
    const tile = tileOf(target, scene, way);
    if (tile !== null) {
      const height = tile.layer === 'floor' ? 0 : heightOf(scene, map);
      return faceLines(mapName, { level: height, x: tile.x, y: tile.y }, 'bottom', colour);
    }
    if (cell === null) return [];
    const kind = kindOf(scene, map, scene.sign(map, cell.level, cell.x, cell.y));
    const extent = extentOf(kind?.blueprint);
    return isWhole || removes
      ? cellLines(mapName, cell, colour, extent)
      : faceLines(mapName, cell, face, colour, extent);
  },

  drag({ targets, removes }, { scene, texture, isWhole, way }) {
    const target = targets.at(-1);
    const { map, cell, face } = target;
    const tile = tileOf(target, scene, way);
    if (tile !== null) {
      const before = tileOf(targets.at(-2) ?? target, scene, way);
      const isGoingOn = before?.layer === tile.layer;
      const places = lineOf({ ...(isGoingOn ? before : tile), level: 0 }, { ...tile, level: 0 });
      return tileChanges(scene, map, tile.layer, places, removes ? null : texture);
    }
    if (cell === null) return [];
    const { level, x, y } = cell;
    if (removes) return cellChanges(scene, map, [{ layer: level, x, y, sign: kEmpty }]);
    if (texture === null || !kFaces.includes(face)) return [];
    const kind = kindOf(scene, map, scene.sign(map, cell.level, cell.x, cell.y));
    if (kind === null) return [];
    const painted = isWhole
      ? withAllFaces(kind.blueprint, texture)
      : withFace(kind.blueprint, face, texture);
    const { sign, changes } = kindFor(scene, map, `${kind.name}, ${texture}`, painted);
    return [...changes, ...cellChanges(scene, map, [{ layer: level, x, y, sign }])];
  },
};

const heightOf = (scene, map) =>
  scene.value.maps[map].ceiling?.height ?? Math.max(1, sizeOf(scene, map).levels);

// The tile of floor or ceiling that is pointed at, {layer, x, y}; null: a block's face.
function tileOf({ map, cell, before, face }, scene, way) {
  const at = cell ?? before;
  if (at === null) return null;
  const { level, x, y } = at;
  if (way === 'floor' || way === 'ceiling') return { layer: way, x, y };
  if (cell === null) return { layer: face === 'bottom' ? 'ceiling' : 'floor', x, y };
  // In the plan one points at a cell, also where nothing stands in it.
  const isFree = '. '.includes(scene.sign(map, level, x, y));
  return isFree && level === 0 ? { layer: 'floor', x, y } : null;
}
