// Turns and mirrors what has a direction: faces, slopes, halves, plans, motions, headings.
// Takes and gives values as the scene has them. Changes nothing in place, and knows no document.
//
//     turnedBlueprint(blueprint, kTurns.right)     // seen from above, clockwise by 90 degrees
//     turnedMotion(motion, kTurns.left)
//     turnedHeading(90, kTurns['west-east'])       // mirrored: west and east change places
//     turnedName('west roof', kTurns.right)        // 'north roof'
//     composed(kTurns.right, kTurns.left)          // one after the other: kStill
//
// A turn is a matrix [a, b, c, d]: x goes to a x + b y, y to c x + d y; x is east, y south.

export const kStill = [1, 0, 0, 1];
export const kTurns = {
  right: [0, -1, 1, 0],
  left: [0, 1, -1, 0],
  'west-east': [-1, 0, 0, 1],
  'north-south': [1, 0, 0, -1],
};

const kWays = { east: [1, 0], south: [0, 1], west: [-1, 0], north: [0, -1] };
const kWords = Object.keys(kWays);
const kFullTurn = 360;
const kPrecise = 1e9; // what is left of 1 - 0.3 is 0.7, not 0.7000000000000001
const kSuffix = ', turned';

const exact = (number) => Math.round(number * kPrecise) / kPrecise + 0; // never -0

export function turnedPoint([x, y], [a, b, c, d]) {
  return [exact(a * x + b * y), exact(c * x + d * y)];
}

export function composed(first, then) {
  const [a, c] = turnedPoint([first[0], first[2]], then);
  const [b, d] = turnedPoint([first[1], first[3]], then);
  return [a, b, c, d];
}

export const isStill = (turn) => String(turn) === String(kStill);
export const isMirror = ([a, b, c, d]) => a * d - b * c < 0;

// Of sides; a top and a bottom stay.
export function turnedFace(face, turn) {
  if (kWays[face] === undefined) return face;
  const turned = String(turnedPoint(kWays[face], turn));
  return kWords.find((word) => String(kWays[word]) === turned);
}

// In degrees, clockwise from the east: 0 to below 360.
export function turnedHeading(heading, turn) {
  const [x, y] = turnedPoint(kWays.east, turn);
  const east = Math.round((Math.atan2(y, x) * 180) / Math.PI);
  const turned = isMirror(turn) ? east - heading : east + heading;
  return exact(((turned % kFullTurn) + kFullTurn) % kFullTurn);
}

// "north-east", "south-west"
export function turnedCorner(corner, turn) {
  const sides = corner.split('-').map((side) => turnedFace(side, turn));
  const isLatitude = (side) => side === 'north' || side === 'south';
  return [sides.find(isLatitude), sides.find((side) => !isLatitude(side))].join('-');
}

// The motion keeps its name: see turnedMotion.
export function turnedBlueprint(blueprint, turn) {
  if (isStill(turn)) return blueprint;
  const turned = { ...blueprint };
  if (blueprint.rise !== undefined) turned.rise = turnedFace(blueprint.rise, turn);
  if (blueprint.diagonal !== undefined) turned.diagonal = turnedCorner(blueprint.diagonal, turn);
  if (blueprint.plan !== undefined) turned.plan = turnedPlan(blueprint.plan, turn);
  if (typeof blueprint.faces === 'object') turned.faces = turnedFaces(blueprint, turned, turn);
  return turned;
}

function turnedPlan([west, north, east, south], turn) {
  const one = turnedPoint([west - 0.5, north - 0.5], turn);
  const other = turnedPoint([east - 0.5, south - 0.5], turn);
  const ends = (axis, choose) => exact(choose(one[axis], other[axis]) + 0.5);
  return [ends(0, Math.min), ends(1, Math.min), ends(0, Math.max), ends(1, Math.max)];
}

function turnedFaces({ faces, diagonal }, turned, turn) {
  const next = Object.fromEntries(
    Object.entries(faces).map(([name, face]) => [turnedFace(name, turn), face]),
  );
  if (diagonal === undefined) return next;
  // A cut without a face of its own looks like the side that looks the same way.
  const cut = faces.diagonal ?? cutOf(faces, diagonal);
  delete next.diagonal;
  if (JSON.stringify(cutOf(next, turned.diagonal)) !== JSON.stringify(cut)) next.diagonal = cut;
  return next;
}

function cutOf(faces, diagonal) {
  return faces[diagonal.startsWith('north') ? 'south' : 'north'] ?? faces.sides ?? faces.all;
}

export function turnedMotion(motion, turn) {
  const { along = 'z', moves, from, to } = motion;
  if (along === 'z') return motion;
  const [x, y] = turnedPoint(along === 'x' ? kWays.east : kWays.south, turn);
  const turned = {
    ...motion,
    along: x === 0 ? 'y' : 'x',
    moves: turnedFace(moves, turn),
    to: exact((x + y) * to),
  };
  if (from !== undefined) turned.from = exact((x + y) * from);
  return turned;
}

// A side in the name turns along; another name says that it was turned.
export function turnedName(name, turn) {
  const word = new RegExp(`\\b(${kWords.join('|')})\\b`, 'g');
  const renamed = name.replace(word, (side) => turnedFace(side, turn));
  if (renamed !== name) return renamed;
  return name.replace(/, turned( \d+)?$/, '') + kSuffix;
}

// What a portal turns by, when its own end is turned, the end that it leads to, or both.
export function turnedPortal({ face, turn = 0 }, own, exit) {
  const back = (degrees) => ((degrees % kFullTurn) + kFullTurn) % kFullTurn;
  if (isMirror(own) && String(own) === String(exit)) return back(-turn);
  // How the way through a face is headed; through a tile there are all ways, so take one.
  const [x, y] = kWays[face] ?? kWays.west;
  const into = back((Math.atan2(-y, -x) * 180) / Math.PI);
  const out = turnedHeading(back(into + turn), exit);
  return back(Math.round(out - turnedHeading(into, own)));
}
