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

// NaN is null.
function number() {
  const value = numbers[next++];
  return value === value ? value : null;
}

function text() {
  return texts[numbers[next++]] ?? null;
}

function flag() {
  return numbers[next++] === 1;
}

function pair() {
  ++next; // its length
  return [number(), number()];
}

export function list(read) {
  const count = numbers[next++];
  const values = [];
  for (let i = 0; i < count; ++i) values.push(read());
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
const view = () => ({ scene: text(), map: text(), size: pair(), eye: eye(), fov: number() });

const tile = () => {
  ++next;
  return [number(), number(), number(), text()];
};
const filled = () => ({ what: text(), face: text(), first: number(), last: number() });
const plane = () => ({ what: text(), map: text(), first: number(), last: number() });
const hit = () => ({
  map: text(),
  portals: number(),
  tile: pair(),
  level: number(),
  blueprint: text(),
  face: text(),
  point: pair(),
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
  portals: number(),
  sprite: text(),
  point: pair(),
  bottom: number(),
  top: number(),
  width: number(),
  depth: number(),
  first: number(),
  last: number(),
});
const end = () => ({ map: text(), tile: pair() });
const portal = () => ({
  portals: number(),
  from: end(),
  to: end(),
  turn: number(),
  levels: number(),
  depth: number(),
  first: number(),
  last: number(),
});
const mirror = () => ({
  map: text(),
  height: number(),
  strength: number(),
  first: number(),
  last: number(),
});
const slice = () => ({
  column: number(),
  horizonRow: number(),
  projectionDistance: number(),
  ray: pair(),
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
  portals: number(),
  tile: pair(),
  axis: text(),
  distance: number(),
  speed: number(),
  along: number(),
  depth: number(),
  next: pair(),
});
const texel = () => ({
  row: number(),
  depth: number(),
  detail: number(),
  size: pair(),
  u: number(),
  v: number(),
  light: number(),
  fog: number(),
});
const run = () => ({
  what: text(),
  map: text(),
  portals: number(),
  hit: number(),
  object: number(),
  face: text(),
  texture: text(),
  first: number(),
  last: number(),
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
  portals: number(),
  tile: pair(),
  axis: text(),
  distance: number(),
  next: pair(),
});
const castHit = () => ({
  map: text(),
  portals: number(),
  tile: pair(),
  level: number(),
  blueprint: text(),
  face: text(),
  point: pair(),
  distance: number(),
  backDistance: number(),
  bottom: number(),
  top: number(),
});
const castPortal = () => ({
  portals: number(),
  from: end(),
  to: end(),
  turn: number(),
  levels: number(),
  distance: number(),
});

export const readCast = () => ({
  map: text(),
  x: number(),
  y: number(),
  z: number(),
  heading: number(),
  ray: pair(),
  tiles: list(castTile),
  hits: list(castHit),
  portals: list(castPortal),
  end: { why: text(), map: text(), point: pair(), distance: number() },
});

// ---- src/session/pick.h

export const readPick = () => ({
  column: number(),
  row: number(),
  what: text(),
  map: text(),
  portals: number(),
  tile: orNull(pair),
  level: number(),
  blueprint: text(),
  face: text(),
  object: number(),
  texture: text(),
  point: orNull(() => list(number)),
  depth: number(),
  texel: orNull(texel),
  alpha: number(),
  reflection: orNull(readPick),
});
