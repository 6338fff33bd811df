// Puts objects, finds, lamps, messages, the goal and the start, moves them by dragging, turns them
// by the wheel, and removes them. Takes targets; gives changes and lines to show. Knows no view.

import { areaChanges, tilesOf } from '../areas.js';
import { isInside } from '../cells.js';
import { groundAt } from '../ground.js';
import { kFinds, spriteFor } from '../finds.js';
import { moveChanges, valueAt } from '../things.js';
import { dragHandle, handleMarks, removeHandle, thingHint, turnHandle } from './handle-strokes.js';

const kLampHeight = 0.8; // over the ground
const kLamp = { colour: '#ffd9a0', radius: 5 };

export const thing = {
  name: 'thing',
  label: 'Thing',
  key: 'T',
  about: 'Click puts the chosen thing. Drag one to move it, the wheel turns it, Delete removes it.',
  touch: 'Tap where the chosen thing is to stand. Drag one to move it; the panel has the rest.',
  canRemove: true,
  isFree: true,
  hasThings: true,

  hint: thingHint,
  point: handleMarks,
  drag: dragHandle,
  turn: turnHandle,

  end(stroke, context) {
    const { targets, removes } = stroke;
    const [{ thing: found, map, mapName, point, before, cell, view, isExact = false }] = targets;
    const { scene, thing: chosen } = context;
    if (removes) return removeHandle(stroke, context);
    if (found !== null || targets.length > 1 || point === null) return [];
    const [x, y] = point;
    if (!isInside(scene, map, { x, y })) return [];
    const z = view === 'plan' ? groundAt(scene, map, { x, y, z: point[2] }) : point[2];
    if (chosen === 'start') {
      const isElsewhere = scene.value.start.map !== undefined || map !== 0;
      return {
        changes: [
          ...(isElsewhere ? [{ path: ['start', 'map'], value: mapName }] : []),
          ...moveChanges(scene, ['start'], { x, y, z }),
        ],
        edited: ['start'],
      };
    }
    if (chosen === 'message' || chosen === 'goal') {
      const at = before ?? cell;
      return areaChanges(scene, chosen, map, tilesOf({ from: at, to: at }));
    }
    // Keys in the order of the shipped scenes.
    const added = (path, { sprite, ...rest }, height, changes = []) => {
      const first = sprite === undefined ? {} : { sprite };
      const at = [...path, (valueAt(scene.value, path) ?? []).length];
      const place = moveChanges(scene, at, { x, y, z: height });
      const where = Object.fromEntries(place.map((change) => [change.path.at(-1), change.value]));
      return {
        changes: [...changes, { path: at, value: { ...first, x: 0, y: 0, ...where, ...rest } }],
        edited: at,
      };
    };
    const lampAt = isExact ? z : z + kLampHeight;
    if (chosen === 'lamp') return added(['maps', map, 'baked', 'lamps'], kLamp, lampAt);
    const objects = ['maps', map, 'objects'];
    if (chosen?.find !== undefined) {
      const { height } = kFinds.find(({ name }) => name === chosen.find);
      const { sprite, changes } = spriteFor(scene, chosen.find);
      return added(objects, { sprite, height, glow: true, find: chosen.find }, z, changes);
    }
    const { name, height } = chosen ?? {};
    return name === undefined ? [] : added(objects, { sprite: name, height }, z);
  },
};
