// Puts objects, lamps and the start, moves them by dragging, and removes them.
// Takes targets; gives changes and lines to show. Knows no view.

import { isInside } from '../cells.js';
import { kBrass, kCoral, kSea } from '../mark-lines.js';
import { moveChanges, thingsOf, valueAt } from '../things.js';

const kSpan = 0.12; // of the marks of things that are not seen, units
const kLampHeight = 0.8; // over the ground
const kLamp = { colour: '#ffd9a0', radius: 5 };

export const thing = {
  name: 'thing',
  label: 'Thing',
  key: 'T',
  about: 'Click puts the chosen thing. Drag one to move it, right click removes it.',
  isFree: true,
  hasThings: true,

  point({ map, mapName, point, thing: found }, { scene, removes }) {
    const lines = thingsOf(scene, map)
      .filter(({ kind, path }) => kind !== 'object' || isSame(path, found))
      .flatMap(({ x, y, z, path, kind }) =>
        cross(
          mapName,
          [x, y, z + (kind === 'object' ? 0.3 : 0)],
          isSame(path, found) ? (removes ? kCoral : '#ffffff') : kSea,
        ),
      );
    return found === null && point !== null ? [...lines, ...cross(mapName, point, kBrass)] : lines;
  },

  drag({ targets, removes }, { scene }) {
    const [{ thing: found, map }] = targets;
    const { point, map: here } = targets.at(-1);
    if (removes || found === null || point === null || targets.length < 2 || here !== map)
      return [];
    const [x, y, z] = point;
    if (!isInside(scene, map, { x, y })) return [];
    return moveChanges(scene, found, { x, y, z: found[2] === 'baked' ? z + kLampHeight : z });
  },

  end({ targets, removes }, { scene, thing: chosen }) {
    const [{ thing: found, map, mapName, point, isExact = false }] = targets;
    if (removes)
      return found === null || found[0] === 'start' ? [] : [{ path: found, value: undefined }];
    if (found !== null || targets.length > 1 || point === null) return [];
    const [x, y, z] = point;
    if (!isInside(scene, map, { x, y })) return [];
    if (chosen === 'start') {
      const isElsewhere = scene.value.start.map !== undefined || map !== 0;
      return [
        ...(isElsewhere ? [{ path: ['start', 'map'], value: mapName }] : []),
        ...moveChanges(scene, ['start'], { x, y, z }),
      ];
    }
    const added = (path, value, height) => {
      const at = [...path, (valueAt(scene.value, path) ?? []).length];
      const place = moveChanges(scene, at, { x, y, z: height });
      const where = Object.fromEntries(place.map((change) => [change.path.at(-1), change.value]));
      return [{ path: at, value: { ...value, x: 0, y: 0, ...where } }];
    };
    const height = isExact ? z : z + kLampHeight;
    if (chosen === 'lamp') return added(['maps', map, 'baked', 'lamps'], kLamp, height);
    const { name, height: tall } = chosen ?? {};
    if (name === undefined) return [];
    return added(['maps', map, 'objects'], { sprite: name, height: tall }, z);
  },
};

const isSame = (path, other) => other !== null && String(path) === String(other);

function cross(map, [x, y, z], colour) {
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
