// Puts a part of a world where one points, again and again: what was copied, or a stamp.
// Takes targets; gives changes and lines to show. Knows no view.

import { isInside } from '../cells.js';
import { kBrass, linesOf } from '../mark-lines.js';
import { cellsOfPart, pasteChanges, turnedPart } from '../parts.js';
import { outlineOf, shiftedEdges } from '../selection.js';

export const stamp = {
  name: 'stamp',
  label: 'Stamp',
  key: 'K',
  about: 'Click puts the copied part or the chosen stamp. U turns it, I mirrors it, Escape ends.',
  touch: 'Tap where the copied part or the chosen stamp is to stand.',
  hasStamps: true,

  hint({ targets }, { scene, brush }) {
    const target = targets.at(-1);
    const at = brush === null ? null : cornerOf(target, brush);
    if (at === null) return undefined;
    const { width, depth } = turned(brush);
    const ends = [at, { ...at, x: at.x + width - 1, y: at.y + depth - 1 }];
    const isIn = ends.every((cell) => isInside(scene, target.map, cell));
    return isIn ? undefined : 'What lies outside the map is left out. Map > Size makes it larger.';
  },

  point(target, { brush }) {
    return linesOf(target.mapName, this.edges(target, { brush }), kBrass);
  },

  // The outline of those cells, found once for each turn of the part.
  edges(target, { brush }) {
    const at = brush === null ? null : cornerOf(target, brush);
    if (at === null) return [];
    const part = turned(brush);
    if (!outlines.has(part))
      outlines.set(part, outlineOf(cellsOfPart(part, { level: 0, x: 0, y: 0 })));
    return shiftedEdges(outlines.get(part), at);
  },

  // The cells that a click would fill.
  ghost(target, { brush }) {
    const at = brush === null ? null : cornerOf(target, brush);
    return at === null ? new Set() : cellsOfPart(turned(brush), at);
  },

  end({ targets, removes }, { scene, brush, world }) {
    const target = targets.at(-1);
    const at = brush === null || removes ? null : cornerOf(target, brush);
    return at === null ? [] : pasteChanges(scene, target.map, turned(brush), at, world);
  },
};

const outlines = new WeakMap(); // part -> edges
const known = new WeakMap(); // part -> Map of its turns

export function turned({ part, turn }) {
  if (!known.has(part)) known.set(part, new Map());
  const turns = known.get(part);
  const key = String(turn);
  if (!turns.has(key)) turns.set(key, turnedPart(part, turn));
  return turns.get(key);
}

// The pointed cell is in the middle of the part's lowest level.
function cornerOf({ before }, brush) {
  if (before === null) return null;
  const { width, depth } = turned(brush);
  return {
    level: before.level,
    x: before.x - Math.floor((width - 1) / 2),
    y: before.y - Math.floor((depth - 1) / 2),
  };
}
