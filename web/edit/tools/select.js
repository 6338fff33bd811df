// Selects cells: a box by dragging, all cells of a kind, or those of a kind that are joined. What
// is selected is dragged elsewhere. Takes targets; gives a selection, changes, and lines to show.
// Knows no view.

import { carryChanges, placeOfThing } from '../carrying.js';
import { clipped, isInside, kEdgeWords, kMostLevels, signReader, sizeOf } from '../cells.js';
import { kBrass, kCoral, kSea, linesOf } from '../mark-lines.js';
import {
  boxAround,
  boxEdges,
  cellOf,
  keyOf,
  outlineOf,
  shiftedEdges,
  transformed,
  transformOf,
} from '../selection.js';
import { boxOfCells, cellsIn } from './strokes.js';

const kSteps = [
  { level: 1, x: 0, y: 0 },
  { level: 0, x: 1, y: 0 },
  { level: 0, x: 0, y: 1 },
];

export const placeOf = ({ cell, before }) => cell ?? before;

export const select = {
  name: 'select',
  label: 'Select',
  key: 'M',
  about:
    'Drag a box; the wheel adds levels. Drag what is selected to move it. O: box, kind, joined.',
  touch: 'Drag a box. Drag what is selected to move it.',
  ways: ['box', 'same kind', 'joined'],
  hasSelection: true,
  hasCorners: (way) => way === 'box',

  hint(stroke, context) {
    const { map } = stroke.targets[0];
    if (isMove(stroke, context)) {
      const moved = moveOf(stroke, context);
      const ends = Object.values(boxAround(context.selection.cells)).map(moved.cell);
      const isIn = ends.every((cell) => isInside(context.scene, map, cell));
      return isIn ? undefined : 'What lies outside the map is left out.';
    }
    const last = stroke.targets.map(placeOf).filter(Boolean).at(-1);
    const isIn = last === undefined || isInside(context.scene, map, { ...last, level: 0 });
    return isIn ? undefined : kEdgeWords;
  },

  point(target, { scene, selection, removes }) {
    const at = placeOf(target);
    if (at === null || !isInside(scene, target.map, at)) return [];
    const isSelected = selection?.map === target.map && selection.cells.has(keyOf(at));
    return lines(
      target.mapName,
      new Set([keyOf(at)]),
      removes ? kCoral : isSelected ? '#ffffff' : kSea,
    );
  },

  show(stroke, context) {
    const colour = stroke.removes ? kCoral : isMove(stroke, context) ? kBrass : kSea;
    return linesOf(stroke.targets[0].mapName, this.edges(stroke, context), colour);
  },

  // The outline of those cells, without finding it anew while it is dragged.
  edges(stroke, context) {
    const { selection, way } = context;
    if (isMove(stroke, context)) {
      selection.outline ??= outlineOf(selection.cells);
      return shiftedEdges(selection.outline, moveOf(stroke, context).by);
    }
    if (way !== 'box') return outlineOf(found(stroke, context));
    const box = boxOfStroke(stroke, context);
    return box === null ? [] : boxEdges(box);
  },

  // The cells to show in the plan.
  cells(stroke, context) {
    return isMove(stroke, context)
      ? transformed(context.selection.cells, moveOf(stroke, context))
      : found(stroke, context);
  },

  end(stroke, context) {
    if (!isMove(stroke, context)) return [];
    const { map, cells } = context.selection;
    const transform = moveOf(stroke, context);
    return transform.isIdle ? [] : carryChanges(context.scene, map, cells, transform);
  },

  // What is selected afterwards.
  select(stroke, context) {
    const { map } = stroke.targets[0];
    const { selection } = context;
    const known = selection?.map === map ? selection.cells : new Set();
    if (isMove(stroke, context) && stroke.targets.length > 1) {
      const transform = moveOf(stroke, context);
      return transform.isIdle ? selection : { map, cells: transformed(known, transform) };
    }
    const cells = found(stroke, context);
    if (stroke.removes)
      return selectionOf(
        map,
        [...known].filter((key) => !cells.has(key)),
      );
    return selectionOf(map, stroke.adds ? [...known, ...cells] : cells);
  },
};

const selectionOf = (map, cells) => {
  const all = new Set(cells);
  return all.size === 0 ? null : { map, cells: all };
};

const lines = (mapName, cells, colour) => linesOf(mapName, outlineOf(cells), colour);

function isMove({ targets, removes, adds }, { selection }) {
  const at = placeOf(targets[0]);
  return (
    !removes &&
    !adds &&
    at !== null &&
    selection?.map === targets[0].map &&
    selection.cells.has(keyOf(at))
  );
}

function moveOf({ targets, height }, { selection }) {
  const from = placeOf(targets[0]);
  const to = placeOf(targets.at(-1)) ?? from;
  const by = { level: to.level - from.level + height, x: to.x - from.x, y: to.y - from.y };
  const box = boxAround(selection.cells);
  by.level = Math.max(-box.from.level, Math.min(kMostLevels - 1 - box.to.level, by.level));
  const isIdle = by.level === 0 && by.x === 0 && by.y === 0;
  return { ...transformOf(box, undefined, by), by, isIdle };
}

function found(stroke, context) {
  const { scene, way } = context;
  const last = stroke.targets.map(placeOf).filter(Boolean).at(-1);
  if (last === undefined) return new Set();
  const { map } = stroke.targets[0];
  if (way === 'same kind') return sameKind(scene, map, last);
  if (way === 'joined') return joinedCells(scene, map, last);
  const box = boxOfStroke(stroke, context);
  return new Set(box === null ? [] : cellsIn(box).map(keyOf));
}

function boxOfStroke({ targets, height }, { scene }) {
  const places = targets.map(placeOf).filter(Boolean);
  if (places.length === 0) return null;
  const last = places.at(-1);
  const box = boxOfCells(places[0], { ...last, level: last.level + height });
  return clipped(scene, targets[0].map, box);
}

export function sameKind(scene, map, { level, x, y }) {
  const wanted = scene.sign(map, level, x, y);
  const cells = new Set();
  if (wanted === '.' || wanted === ' ') return cells;
  eachCell(scene, map, (cell, sign) => sign === wanted && cells.add(keyOf(cell)));
  return cells;
}

// All blocks and things of a map, and where its portals lie and lead to.
export function allOf(scene, map) {
  const { maps, start } = scene.value;
  const { objects = [], baked, portals = [], name } = maps[map];
  const cells = allBlocks(scene, map);
  const isStart = start !== undefined && (start.map ?? maps[0].name) === name;
  for (const thing of [...objects, ...(baked?.lamps ?? []), ...(isStart ? [start] : [])])
    cells.add(keyOf(placeOfThing(thing)));
  for (const { level = 0, x, y } of portals) cells.add(keyOf({ level, x, y }));
  for (const other of maps)
    for (const { level = 0, to } of other.portals ?? [])
      if ((to.map ?? other.name) === name) cells.add(keyOf({ level, ...to }));
  return cells;
}

export function allBlocks(scene, map) {
  const cells = new Set();
  eachCell(scene, map, (cell, sign) => sign !== '.' && sign !== ' ' && cells.add(keyOf(cell)));
  return cells;
}

function eachCell(scene, map, take) {
  const { width, depth, levels } = sizeOf(scene, map);
  const signAt = signReader(scene, map);
  for (let level = 0; level < levels; ++level)
    for (let y = 0; y < depth; ++y)
      for (let x = 0; x < width; ++x) take({ level, x, y }, signAt(level, x, y));
}

// Those that touch with a face, also above and below.
export function joinedCells(scene, map, at) {
  const signAt = signReader(scene, map);
  const wanted = signAt(at.level, at.x, at.y);
  const cells = new Set();
  if (wanted === '.' || wanted === ' ') return cells;
  const next = [at];
  while (next.length > 0) {
    const { level, x, y } = next.pop();
    const key = keyOf({ level, x, y });
    if (cells.has(key) || signAt(level, x, y) !== wanted) continue;
    cells.add(key);
    for (const step of kSteps)
      for (const sign of [1, -1])
        next.push({
          level: level + sign * step.level,
          x: x + sign * step.x,
          y: y + sign * step.y,
        });
  }
  return cells;
}

// The whole columns of a selection, as high as the map is.
export function columnsOf(scene, { map, cells }) {
  const { levels } = sizeOf(scene, map);
  const all = new Set(cells);
  for (const key of cells)
    for (let level = 0; level < levels; ++level) all.add(keyOf({ ...cellOf(key), level }));
  return { map, cells: all };
}
