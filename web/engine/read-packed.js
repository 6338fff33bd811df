// Reads what the engine has packed (src/session/json_text.h): numbers one after another, in the
// order in which the headers of src/session list the members of each object.
//
//     const hits = readPacked(numbers, texts, readHits);      // numbers: a Float64Array

let numbers;
let texts;
let next;

export function readPacked(packed, itsTexts, read) {
  numbers = packed;
  texts = itsTexts;
  next = 0;
  const answer = read();
  numbers = null;
  return answer;
}

// Each kind of number has a function of its own: an engine of JavaScript keeps whole numbers and
// lists of real ones in less memory when it never meets anything else there.

// Never null.
function whole() {
  return numbers[next++] | 0;
}

// NaN is null.
function number() {
  const value = numbers[next++];
  return value === value ? value : null;
}

function index() {
  const value = numbers[next++];
  return value === value ? value | 0 : null;
}

function text() {
  return texts[numbers[next++]] ?? null;
}

function flag() {
  return numbers[next++] === 1;
}

const wholePair = () => [whole(), whole()];
const realPair = () => [numbers[next++], numbers[next++]];
const pair = () => [number(), number()];

export function list(read) {
  const count = whole();
  const values = new Array(count);
  for (let i = 0; i < count; ++i) values[i] = read();
  return values;
}

function orNull(read) {
  const value = numbers[next];
  if (value === value) return read();
  ++next;
  return null;
}

// ---- src/session/hits_json.h

const eye = () => ({
  x: number(),
  y: number(),
  z: number(),
  heading: number(),
  look: number(),
});
const view = () => ({ scene: text(), map: text(), size: wholePair(), eye: eye(), fov: number() });

const tile = () => {
  return [whole(), whole(), number(), text()];
};
const filled = () => ({ what: text(), face: text(), first: whole(), last: whole() });
const plane = () => ({ what: text(), map: text(), first: whole(), last: whole() });
const hit = () => ({
  map: text(),
  portals: whole(),
  tile: wholePair(),
  level: whole(),
  blueprint: text(),
  face: text(),
  point: realPair(),
  rawDepth: number(),
  depth: number(),
  backDepth: number(),
  bottom: number(),
  top: number(),
  bottomFrontRow: number(),
  topFrontRow: number(),
  bottomBackRow: number(),
  topBackRow: number(),
  filled: list(filled),
});
const object = () => ({
  map: text(),
  portals: whole(),
  sprite: text(),
  point: realPair(),
  bottom: number(),
  top: number(),
  width: number(),
  depth: number(),
  first: whole(),
  last: whole(),
});
const end = () => ({ map: text(), tile: wholePair() });
const portal = () => ({
  portals: whole(),
  from: end(),
  to: end(),
  turn: whole(),
  levels: whole(),
  depth: number(),
  first: whole(),
  last: whole(),
});
const mirror = () => ({
  map: text(),
  height: number(),
  strength: whole(),
  first: whole(),
  last: whole(),
});
const slice = () => ({
  column: whole(),
  horizonRow: number(),
  projectionDistance: number(),
  ray: realPair(),
  tiles: list(tile),
  hits: list(hit),
  planes: list(plane),
  objects: list(object),
  portals: list(portal),
  mirrors: list(mirror),
});

export const readHits = () => ({ ...view(), ...slice() });

// ---- src/session/trace_json.h

const walked = () => ({
  map: text(),
  portals: whole(),
  tile: wholePair(),
  axis: text(),
  distance: number(),
  speed: number(),
  along: number(),
  depth: number(),
  next: pair(),
});
const texel = () => ({
  row: whole(),
  depth: number(),
  detail: whole(),
  size: wholePair(),
  u: whole(),
  v: whole(),
  light: whole(),
  fog: whole(),
});
const run = () => ({
  what: text(),
  map: text(),
  portals: whole(),
  hit: index(),
  object: index(),
  face: text(),
  texture: text(),
  first: whole(),
  last: whole(),
  layer: flag(),
  texels: list(texel),
});
const work = () => ({ walk: list(walked), runs: list(run) });

export const readTrace = () => ({
  ...view(),
  ...slice(),
  ...work(),
  reflection: orNull(() => ({ ...slice(), ...work() })),
});

// ---- src/session/cast_json.h

const castTile = () => ({
  map: text(),
  portals: whole(),
  tile: wholePair(),
  axis: text(),
  distance: number(),
  next: pair(),
});
const castHit = () => ({
  map: text(),
  portals: whole(),
  tile: wholePair(),
  level: whole(),
  blueprint: text(),
  face: text(),
  point: realPair(),
  distance: number(),
  backDistance: number(),
  bottom: number(),
  top: number(),
});
const castPortal = () => ({
  portals: whole(),
  from: end(),
  to: end(),
  turn: whole(),
  levels: whole(),
  distance: number(),
});

export const readCast = () => ({
  map: text(),
  x: number(),
  y: number(),
  z: number(),
  heading: number(),
  ray: realPair(),
  tiles: list(castTile),
  hits: list(castHit),
  portals: list(castPortal),
  end: { why: text(), map: text(), point: pair(), distance: number() },
});

// ---- src/session/pick.h

export const readPick = () => ({
  column: whole(),
  row: whole(),
  what: text(),
  map: text(),
  portals: whole(),
  tile: orNull(wholePair),
  level: index(),
  blueprint: text(),
  face: text(),
  object: index(),
  texture: text(),
  point: orNull(() => [...realPair(), number()]),
  depth: number(),
  texel: orNull(texel),
  alpha: whole(),
  reflection: orNull(readPick),
});
