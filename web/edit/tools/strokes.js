// Cells between two others, for the tools that draw lines and boxes.
// Takes cells {level, x, y}; gives lists of cells.
//
//     lineOf(from, to)            // each touches the next with a face or an edge
//     boxOfCells(from, to)        // {from, to} with the smaller numbers in `from`
//     cellsIn(box, 'hollow')      // 'solid', 'hollow' (its faces) or 'walls' (its sides)
//     placesIn(stroke)            // the cells where it puts or removes
//     edgeHint(stroke, context)   // words, if it points past the map
//     cellMarks(target, context)  // lines around the cell that a click changes

import { isInside, outsideWords } from '../cells.js';
import { cellLines, kBrass, kCoral } from '../mark-lines.js';

export const kMostCells = 1 << 20; // of one stroke

export const placesIn = ({ targets, removes }) =>
  targets.map(({ cell, before }) => (removes ? cell : before)).filter(Boolean);

export function edgeHint(stroke, { scene }) {
  const last = placesIn(stroke).at(-1) ?? null;
  const { map } = stroke.targets[0];
  return outsideWords(scene, map, last && { ...last, level: last.level + (stroke.height ?? 0) });
}

export function cellMarks({ map, mapName, cell, before }, { scene, removes }) {
  const at = removes ? cell : before;
  if (at === null || !isInside(scene, map, at)) return [];
  return cellLines(mapName, at, removes ? kCoral : kBrass);
}

export function lineOf(from, to) {
  const axes = ['x', 'y', 'level'];
  const steps = Math.max(...axes.map((axis) => Math.abs(to[axis] - from[axis])));
  return Array.from({ length: steps + 1 }, (_, step) =>
    Object.fromEntries(
      axes.map((axis) => [
        axis,
        steps === 0
          ? from[axis]
          : Math.round(from[axis] + ((to[axis] - from[axis]) * step) / steps),
      ]),
    ),
  );
}

export function boxOfCells(one, other) {
  const pick = (choose) => ({
    x: choose(one.x, other.x),
    y: choose(one.y, other.y),
    level: choose(one.level, other.level),
  });
  return { from: pick(Math.min), to: pick(Math.max) };
}

export function cellsIn({ from, to }, how = 'solid') {
  const cells = [];
  const isEdge = (axis, value) => value === from[axis] || value === to[axis];
  for (let level = from.level; level <= to.level; ++level) {
    for (let y = from.y; y <= to.y; ++y) {
      for (let x = from.x; x <= to.x; ++x) {
        const isSide = isEdge('x', x) || isEdge('y', y);
        const isIn = how === 'solid' || isSide || (how === 'hollow' && isEdge('level', level));
        if (isIn) cells.push({ level, x, y });
        if (cells.length > kMostCells) return cells;
      }
    }
  }
  return cells;
}
