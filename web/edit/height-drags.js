// Drags of heights: the edge of a block, the ceiling, a thing. Each move begins with what was there
// before, so that no kind of block is left of the heights between, and one undo takes all back.
// Takes an editor; gives changes to its history. Knows no canvas.
//
//     const drag = edgeDrag(editor, { cell, kind, edge: 'top', index }, 2.9);  // from that height
//     drag.move([along, 3.4], kStep);    drag.end();    drag.cancel();
//     ceilingDrag(editor, 3);
//     thingDrag(editor, section, thing, [along, 0.5]);          // a thing of section.js
//
// `kind` is one of kinds.js; `index` says which height of a slope.

import { cellChanges } from './cells.js';
import { kindFor } from './kinds.js';
import { lengthOf, withEdge } from './section.js';
import { nameWithHeights } from './shapes.js';
import { moveChanges, valueAt } from './things.js';

export const kStep = 0.1; // units, as the tool Shape has it
export const kFine = 0.01;
const kMostCeiling = 1000; // units
const kRim = 0.05; // tiles: what is rounded onto the edge would be outside

let drags = 0;

export const snapped = (value, step) => Math.round(Math.round(value / step) * step * 1000) / 1000;

function dragOf({ history }, label, changesFor) {
  drags += 1;
  const key = `heights ${drags}`;
  let isDone = false;
  let last = null;
  const back = () => {
    if (isDone) history.undo();
    isDone = false;
  };
  return {
    // `wanted` is what the changes come from: the same, the same.
    move(place, step) {
      const wanted = changesFor.place(place, step);
      const said = JSON.stringify(wanted);
      if (said === last) return;
      last = said;
      back();
      const before = history.length;
      history.do(label, changesFor.changes(wanted), key);
      isDone = history.length !== before;
    },
    end: () => history.close(),
    cancel: back,
  };
}

export function edgeDrag(editor, { cell, kind, edge, index }, from) {
  const { scene, map } = editor;
  const { name, blueprint } = kind;
  const whole = blueprint[edge] ?? (edge === 'top' ? 1 : 0);
  const first = Array.isArray(whole) ? whole[index] : whole;
  return dragOf(editor, 'Shape', {
    place: ([, z], step) => Math.min(1, Math.max(0, snapped(first + z - from, step))),
    changes(height) {
      const shaped = withEdge(blueprint, edge, index, height);
      if (shaped === null || height === first) return [];
      const isSlope = [shaped.bottom, shaped.top].some(Array.isArray);
      const named = isSlope ? name : nameWithHeights(name, shaped);
      const { sign, changes } = kindFor(scene, map, named, shaped);
      const { level, x, y } = cell;
      return [...changes, ...cellChanges(scene, map, [{ layer: level, x, y, sign }])];
    },
  });
}

export function ceilingDrag(editor, from) {
  const { scene, map } = editor;
  const { height: first } = scene.value.maps[map].ceiling;
  return dragOf(editor, 'Ceiling', {
    place: ([, z], step) => Math.min(kMostCeiling, Math.max(step, snapped(first + z - from, step))),
    changes: (value) =>
      value === first ? [] : [{ path: ['maps', map, 'ceiling', 'height'], value }],
  });
}

export function thingDrag(editor, section, { path, along }, [fromAlong, fromZ]) {
  const { scene, map } = editor;
  const { x, y, z: first = 0 } = valueAt(scene.value, path);
  const most = lengthOf(scene, map, section) - kRim;
  return dragOf(editor, 'Thing', {
    place: ([right, z], step) => ({
      at: Math.min(most, Math.max(0, along + right - fromAlong)),
      z: Math.max(0, snapped(first + z - fromZ, step)),
    }),
    changes({ at, z }) {
      const place = section.axis === 'x' ? { x: at, y } : { x, y: at };
      return moveChanges(scene, path, { ...place, z });
    },
  });
}
