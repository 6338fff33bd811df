// The things of a map that stand at a point: objects, lamps, named places, and the start.
// Takes a document; gives lists of {path, kind, x, y, z}. Changes nothing.
//
//     thingsOf(scene, 0)
//     moveChanges(scene, path, { x, y, z })       // changes that put it there

const kStandingStart = 0.6; // of the marks of things that are not seen, units above their feet

export function thingsOf(scene, map) {
  const { maps, start } = scene.value;
  const { objects = [], baked, name, places = {} } = maps[map];
  const list = (things, kind, path) =>
    things.map(({ x, y, z = 0 }, index) => ({ path: [...path, index], kind, x, y, z }));
  const found = [
    ...list(objects, 'object', ['maps', map, 'objects']),
    ...list(baked?.lamps ?? [], 'lamp', ['maps', map, 'baked', 'lamps']),
  ];
  for (const [place, { x, y, z = 0 }] of Object.entries(places))
    found.push({
      path: ['maps', map, 'places', place],
      kind: 'place',
      x,
      y,
      z: z + kStandingStart,
    });
  if (start?.place !== undefined) return found; // at that place
  if (start !== undefined && (start.map ?? maps[0].name) === name)
    found.push({
      path: ['start'],
      kind: 'start',
      x: start.x,
      y: start.y,
      z: (start.z ?? 0) + kStandingStart,
    });
  return found;
}

const rounded = (value, step) => Math.round(Math.round(value / step) * step * 1000) / 1000;

// Only what differs; without a z the height stays.
export function moveChanges(scene, path, { x, y, z }) {
  const present = valueAt(scene.value, path) ?? {};
  const wanted = { x: rounded(x, 0.05), y: rounded(y, 0.05) };
  if (z !== undefined) wanted.z = rounded(z, 0.01);
  const changes = Object.entries(wanted)
    .filter(([key, value]) => (present[key] ?? 0) !== value)
    .map(([key, value]) => ({ path: [...path, key], value }));
  // What was at a named place gets one of its own.
  return present.place === undefined || changes.length === 0
    ? changes
    : [{ path: [...path, 'place'], value: undefined }, ...changes];
}

// Undefined if there is no such value.
export function valueAt(value, path) {
  return path.reduce((node, key) => node?.[key], value);
}
