// What comes out of the frame of a reader's program, checked by shape and range before anything
// else sees it. A program may change what the frame's own code is made of, such as `Array.from`.
//
//     checkedAnswer('draw', { width: 320, height: 200 }, answer)     // one of worker.js
//     checkedError(error)                                 // { name, message, line, column, isEnd }
//
// Throws a RangeError for anything else. The results have nothing but the fields named here. Long
// texts are cut off. What the reader's functions return may be anything: it becomes a number or
// undefined.

const kMostText = 2000; // characters
const kMostChecks = 200;
const kMostTiles = 2000; // of a ray's walk
const kMostLines = 1e6;
const kFarthest = 32767; // a coordinate, in units

export function checkedAnswer(action, asked, answer) {
  return kAnswers[action](record(answer), asked);
}

export function checkedError(error) {
  const { name, message, line, column, isEnd } = record(error);
  return {
    name: text(name),
    message: text(message),
    line: whole(line, 0, kMostLines),
    column: whole(column, 0, Number.MAX_SAFE_INTEGER),
    isEnd: isEnd === true,
  };
}

const kAnswers = {
  run: () => ({}),

  draw({ picture }, { width, height }) {
    const { data } = record(picture);
    const isPicture = data instanceof Uint8ClampedArray && data.length === 4 * width * height;
    return { picture: { width, height, data: isPicture ? data : refuse('a picture') } };
  },

  check({ checks }) {
    return {
      checks: list(checks, 0, kMostChecks).map(({ name, ok, says }) => ({
        name: /^[\w$]{1,60}$/.test(text(name)) ? name : refuse('a name'),
        ok: ok === true,
        says: text(says),
      })),
    };
  },

  explain({ difference }, { mine }) {
    if (difference === null) return { difference };
    const { column, row, what, ray, walk, ...colours } = record(difference);
    return {
      difference: {
        column: whole(column, 0, mine.width - 1),
        row: whole(row, 0, mine.height - 1),
        mine: colour(colours.mine),
        engine: colour(colours.engine),
        what: text(what),
        ray: list(ray, 2, 2).map((part) => number(part, 'the direction of a ray')),
        walk: walk === null ? null : bothWalks(record(walk)),
      },
    };
  },

  move({ view }, asked) {
    const { x, y, z } = record(view);
    const [east, south, up] = [x, y, z].map((part) => number(part, 'a place'));
    return { view: { ...asked.view, x: east, y: south, z: up } };
  },
};

function bothWalks({ mine, engine, first }) {
  const [own, theirs] = [mine, engine].map((tiles) =>
    list(tiles, 0, Infinity)
      .slice(0, kMostTiles)
      .map((tile) => {
        const [x, y, near] = [tile?.x, tile?.y, tile?.near].map((part) =>
          typeof part === 'number' ? part : undefined,
        );
        return { x, y, near };
      }),
  );
  return { mine: own, engine: theirs, first: first === null ? null : text(first) };
}

function colour(parts) {
  return list(parts, 3, 3).map((part) => whole(part, 0, 255));
}

function record(value) {
  return typeof value === 'object' && value !== null ? value : refuse('an object');
}

function list(value, least, most) {
  const isFit = Array.isArray(value) && value.length >= least && value.length <= most;
  return isFit ? value : refuse('a list');
}

function text(value) {
  return typeof value === 'string' ? value.slice(0, kMostText) : refuse('a text');
}

function number(value, what) {
  return typeof value === 'number' && Math.abs(value) <= kFarthest ? value : refuse(what);
}

function whole(value, least, most) {
  const isWhole = Number.isInteger(value) && value >= least && value <= most;
  return isWhole ? value : refuse('a whole number');
}

function refuse(expected) {
  throw new RangeError(`The program gave something else than ${expected}.`);
}
