// Reads the engine's packed answers (src/answers/json_text.h): a flat list of numbers, in the order
// in which the headers of src/session list each object's members.
//
//     const answer = readPacked(numbers, texts, readCast);    // numbers: a Float64Array
//     const slices = readColumns(numbers, texts, readHits);
//
// All columns of a picture may hold a hundred thousand entries, of which a figure reads a few. So
// each column's lists are built when they are first read.

// The answer that is being read
let numbers;
let texts;
let next; // index of the next number
let isLazy; // whether its lists are built later

export function readPacked(packed, itsTexts, read) {
  return readFrom(packed, itsTexts, 0, read);
}

export function readColumns(packed, itsTexts, read) {
  const own = packed.slice(0, 2 + packed[1]); // a copy: the engine reuses its memory
  return readFrom(own, itsTexts, 0, () => list(read), own[0] > 1);
}

function readFrom(packed, itsTexts, first, read, lazily = false) {
  numbers = packed;
  texts = itsTexts;
  next = first;
  isLazy = lazily;
  const answer = read();
  numbers = null;
  return answer;
}

// Each kind of number has its own function: JavaScript engines store integers and lists of reals in
// less memory as long as nothing else appears in the same place.

// An integer, never null.
function whole() {
  return numbers[next++] | 0;
}

// Any number, or null.
function number() {
  const value = numbers[next++];
  return value === value ? value : null;
}

// An integer, or null.
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

function list(read) {
  const count = whole();
  ++next;
  const values = new Array(count);
  for (let i = 0; i < count; ++i) values[i] = read();
  return values;
}

// Adds lists to `answer`; `readers` maps each list's name to the reader of one element.
function lists(answer, readers) {
  for (const [name, read] of Object.entries(readers)) {
    if (isLazy) {
      listLater(answer, name, read);
    } else {
      answer[name] = list(read);
    }
  }
}

// Adds a list that is built when it is first read, or never if it is set before.
function listLater(answer, name, read) {
  const [packed, itsTexts, first] = [numbers, texts, next];
  next += 2 + packed[first + 1];
  const set = (value) => {
    const kept = { value, writable: true, enumerable: true, configurable: true };
    Object.defineProperty(answer, name, kept);
    return value;
  };
  const get = () => set(readFrom(packed, itsTexts, first, () => list(read)));
  Object.defineProperty(answer, name, { get, set, enumerable: true, configurable: true });
}

function orNull(read) {
  const value = numbers[next];
  if (value === value) return read();
  ++next;
  return null;
}

// ---- src/answers/hits_json.h

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
const kHitLists = {
  tiles: tile,
  hits: hit,
  planes: plane,
  objects: object,
  portals: portal,
  mirrors: mirror,
};
const slice = (answer, itsLists) => {
  answer.column = whole();
  answer.horizonRow = number();
  answer.projectionDistance = number();
  answer.ray = realPair();
  lists(answer, itsLists);
  return answer;
};

export const readHits = () => slice(view(), kHitLists);

// ---- src/answers/trace_json.h

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
  baked: [whole(), whole(), whole()],
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
const kTraceLists = { ...kHitLists, walk: walked, runs: run };

export const readTrace = () => {
  const answer = slice(view(), kTraceLists);
  answer.reflection = orNull(() => slice({}, kTraceLists));
  return answer;
};

// ---- src/answers/cast_json.h

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

// ---- src/answers/pick.h

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
