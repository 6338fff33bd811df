// Describes the view in words for screen readers: the place, the heading, and what stands ahead, to
// the left and to the right.
//
//     status.textContent = describeView(engine, canvas.width, canvas.height);
//
// It walks three slices, so call it only when the player has come to rest.

const kDirections = [
  'east',
  'south-east',
  'south',
  'south-west',
  'west',
  'north-west',
  'north',
  'north-east',
];
const kWays = [
  ['Ahead', 1 / 2],
  ['To the left', 1 / 6],
  ['To the right', 5 / 6],
];
const kThingsNamed = 3; // per slice, the nearest first
const kLeastShare = 1 / 50; // of the picture's height; smaller things are not named

// Returns '' without a game.
export function describeView(engine, width, height) {
  const columns = kWays.map(([, share]) => Math.floor(width * share));
  const slices = engine.questions.hits(width, height, columns);
  if (slices[0] === null) return '';
  const { map, scene, eye } = slices[0];
  const place = map === scene || engine.world.maps.length === 1 ? scene : `${scene}, ${map}`;
  const ways = slices.map((slice, index) => `${kWays[index][0]}: ${describeSlice(slice, height)}.`);
  return [`${place}. Facing ${directionOf(eye.heading)}${lookOf(eye.look)}.`, ...ways].join(' ');
}

function directionOf(heading) {
  return kDirections[((Math.round(heading / 45) % 8) + 8) % 8];
}

function lookOf(look) {
  if (Math.abs(look) < 0.1) return '';
  return look > 0 ? ' and up' : ' and down';
}

function describeSlice({ hits, objects, portals }, height) {
  const least = height * kLeastShare;
  const things = [
    ...hits.map(({ blueprint, depth, filled }) => ({
      name: blueprint,
      depth,
      rows: filled.reduce((sum, { first, last }) => sum + last - first + 1, 0),
    })),
    ...objects.map(({ sprite, depth, first, last }) => ({
      name: sprite,
      depth,
      rows: last - first + 1,
    })),
    ...portals.map(({ to, depth, first, last }) => ({
      name: `a way to ${to.map}`,
      depth,
      rows: last - first + 1,
    })),
  ].filter(({ rows }) => rows >= least);
  const nearest = things.sort((one, other) => one.depth - other.depth);
  // Of several blocks of one kind only the nearest is named.
  const named = nearest
    .filter(({ name }, index) => nearest.findIndex((other) => other.name === name) === index)
    .slice(0, kThingsNamed);
  return named.length === 0
    ? 'nothing near'
    : named.map(({ name, depth }) => `${name} at ${distanceOf(depth)}`).join(', then ');
}

function distanceOf(depth) {
  const rounded = depth < 10 ? Math.round(depth * 10) / 10 : Math.round(depth);
  return `${rounded} ${rounded === 1 ? 'unit' : 'units'}`;
}
