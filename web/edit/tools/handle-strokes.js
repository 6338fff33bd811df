// What tools do with the handles of things and links: name, mark, drag, turn and remove them.
// Takes targets; gives changes and lines to show. Knows no view.

import { isInside, kEdgeWords } from '../cells.js';
import {
  dragChanges,
  handlesOf,
  removeChanges,
  standingOf,
  turnChanges,
  wordsOf,
} from '../handles.js';
import { kBrass, kCoral, kSea } from '../mark-lines.js';

const kSpan = 0.12; // of the marks of what is not seen, units

const isSame = (path, other) => other !== null && String(path) === String(other);

// What is pointed at, in words.
export function thingHint({ targets }, { scene, edited }) {
  const { map, thing: found, point } = targets.at(-1);
  if (found !== null) return wordsOf(scene, map, found, edited);
  const isOut = point !== null && !isInside(scene, map, { x: point[0], y: point[1] });
  return isOut ? kEdgeWords : undefined;
}

// Objects are seen, and the plan has pictures of the others; all else gets a cross.
export function handleMarks(
  { map, mapName, point, thing: found, view },
  { scene, edited, removes },
) {
  const lines = handlesOf(scene, map, edited)
    .filter(({ kind, path }) => (kind !== 'object' && view !== 'plan') || isSame(path, found))
    .flatMap(({ x, y, z, path, kind }) =>
      cross(
        mapName,
        [x, y, z + (kind === 'object' ? 0.3 : 0)],
        isSame(path, found) ? (removes ? kCoral : '#ffffff') : kSea,
      ),
    );
  return found === null && point !== null ? [...lines, ...cross(mapName, point, kBrass)] : lines;
}

export function dragHandle({ targets, removes }, { scene }) {
  const [first] = targets;
  if (removes || first.thing === null) return [];
  first.stands ??= standingOf(scene, first.map, first.thing); // before it is moved
  if (targets.length < 2) return [];
  return dragChanges(scene, first.thing, targets.at(-1), first.stands);
}

export function removeHandle({ targets }, { scene }) {
  const [{ thing: found }] = targets;
  return found === null ? [] : removeChanges(scene, found);
}

export function turnHandle({ thing: found }, notches, { scene }) {
  return found === null ? null : turnChanges(scene, found, notches);
}

export function cross(map, [x, y, z], colour) {
  return [
    [
      [x - kSpan, y, z],
      [x + kSpan, y, z],
    ],
    [
      [x, y - kSpan, z],
      [x, y + kSpan, z],
    ],
    [
      [x, y, z - kSpan],
      [x, y, z + kSpan],
    ],
  ].map(([from, to]) => ({ map, from, to, colour }));
}
