// Compares the reader's picture with the engine's. Pictures are { width, height, data } or
// { width, height, pixels }, with 4 bytes a pixel.

const kMostDifference = 1; // of 255, in each channel

// The chapters that teach to draw what runs of rows show.
const kTaught = {
  side: 4,
  floor: 8,
  ceiling: 8,
  sky: 9,
  haze: 9,
  roof: 13,
  underside: 13,
  object: 15,
};
const kObjects = 15;
const kLayers = 16; // whatever is seen through, and the soft edges of objects
const kMirrors = 18;
const kPortals = 19;
const kTies = 22; // rays that meet an edge or a corner exactly
const kTie = 1e-7; // rows; parts of a depth

// 1 for each pixel whose kind a chapter knows, by rows. `traces` are the engine's, of all columns.
// With the world, chapter 15 counts objects too, except for their half-transparent texels.
export function taught(chapter, traces, { width, height }, world = null) {
  const mask = new Uint8Array(width * height);
  for (const slice of traces) {
    const rows = new Uint8Array(height).fill(1);
    const leaveOut = ({ first, last }) => rows.fill(0, Math.max(0, first), last + 1);
    for (const run of slice.runs) {
      if (run.portals > 0 && chapter < kPortals) leaveOut(run);
      if (chapter < kTaught[run.what]) leaveOut(run);
      if (!run.layer || chapter >= kLayers) continue;
      if (run.what === 'object' && chapter === kObjects && world) {
        leaveOutSoftTexels(slice, run, world, rows);
      } else {
        leaveOut(run);
      }
    }
    if (chapter < kTies) leaveOutTies(slice, world, rows);
    if (chapter < kMirrors) slice.mirrors.forEach(leaveOut);
    rows.forEach((known, row) => {
      mask[row * width + slice.column] = known;
    });
  }
  return mask;
}

// The rows whose rays meet an edge exactly; all of them if the column's ray meets a corner.
function leaveOutTies(slice, world, rows) {
  const heights = new Set([0]);
  if (world) heights.add(world.maps[slice.map].ceilingHeight);
  for (const { bottom, top } of slice.hits) heights.add(bottom).add(top);
  for (const { depth, next, portals } of slice.walk) {
    if (portals > 0) continue;
    const [x, y] = next;
    if (x !== null && y !== null && Math.abs(x - y) <= kTie * x) rows.fill(0);
    for (const height of heights) {
      const rise = height - slice.eye.z;
      const row = slice.horizonRow - (rise * slice.projectionDistance) / depth - 0.5;
      const nearest = Math.round(row);
      if (Math.abs(row - nearest) < kTie && nearest >= 0) rows[nearest] = 0;
    }
  }
}

// The rows that show a texel of an object which is neither opaque nor a hole.
function leaveOutSoftTexels(slice, run, world, rows) {
  const object = slice.objects[run.object];
  const [{ detail, u }] = run.texels;
  const { width, height, texels } = world.textures[run.texture].levels[detail];
  for (let row = run.first; row <= run.last; row++) {
    const slope = (slice.horizonRow - (row + 0.5)) / slice.projectionDistance;
    const down = object.top - slice.eye.z - slope * object.depth;
    const v = (down / (object.top - object.bottom)) * height;
    // Rounding may choose either of two neighbours.
    for (const near of [v - 0.001, v + 0.001]) {
      const texelRow = Math.min(height - 1, Math.max(0, Math.floor(near)));
      const alpha = texels[4 * (texelRow * width + u) + 3];
      if (alpha > 0 && alpha < 255) rows[row] = 0;
    }
  }
}

const bytesOf = (picture) => picture.data ?? picture.pixels;

function differs(mine, engine, pixel) {
  for (let byte = 4 * pixel; byte < 4 * pixel + 3; byte++)
    if (Math.abs(mine[byte] - engine[byte]) > kMostDifference) return true;
  return false;
}

// How many of the mask's pixels are equal, a map of those that are not, and the first of them.
export function difference(minePicture, enginePicture, mask = null) {
  const { width, height } = enginePicture;
  const [mine, engine] = [bytesOf(minePicture), bytesOf(enginePicture)];
  const map = new Uint8Array(width * height);
  let all = 0;
  let same = 0;
  let first = null;
  for (let column = 0; column < width; column++) {
    for (let row = 0; row < height; row++) {
      const pixel = row * width + column;
      if (mask && !mask[pixel]) continue;
      all += 1;
      if (!differs(mine, engine, pixel)) {
        same += 1;
        continue;
      }
      map[pixel] = 1;
      first ??= { column, row };
    }
  }
  return { share: all === 0 ? 1 : same / all, same, all, map, first };
}

// Why the first different pixel is wrong: what the engine shows there, and both walks.
export function firstDifference(chapter, { mine, engine, mask, traces, functions, world, eye }) {
  const { first } = difference(mine, engine, mask);
  if (!first) return null;
  const { column, row } = first;
  const slice = traces.find((trace) => trace.column === column);
  const pixel = 4 * (row * engine.width + column);
  const colours = [mine, engine].map((each) => [...bytesOf(each).subarray(pixel, pixel + 3)]);
  const run = slice.runs.find((each) => !each.layer && each.first <= row && row <= each.last);
  const layers = slice.runs.filter((each) => each.layer && each.first <= row && row <= each.last);
  const what = [...layers, run].map((each) => nameOf(each, slice)).join(', in front of ');
  const walk = functions ? walksOf(slice, functions, world, eye) : null;
  const says = [
    `Your picture first differs in column ${column}, row ${row}.`,
    `There the engine shows ${what}.`,
    `Your colour is ${colours[0].join(', ')}; the engine's is ${colours[1].join(', ')}.`,
    ...(walk?.first ? [walk.first] : []),
  ];
  return {
    column,
    row,
    mine: colours[0],
    engine: colours[1],
    what,
    says: says.join(' '),
    ray: slice.ray,
    hits: slice.hits.map(({ blueprint, tile, depth, bottom, top }) => ({
      blueprint,
      tile,
      depth,
      bottom,
      top,
    })),
    walk,
  };
}

function nameOf(run, slice) {
  const [texel] = run.texels ?? [];
  const at = texel ? ` at depth ${texel.depth.toFixed(3)}` : '';
  const beyond = run.portals > 0 ? ' behind a portal' : '';
  if (run.what === 'object') return `the object ${run.texture}${at}${beyond}`;
  if (run.hit === null || run.hit === undefined) return `the ${run.what}${at}${beyond}`;
  const { blueprint, tile } = slice.hits[run.hit];
  const part = run.what === 'side' ? `${run.face} side` : run.what;
  return `the ${part} of the block "${blueprint}" in tile ${tile.join(', ')}${at}${beyond}`;
}

// The engine's tiles beside those of the reader's walk, in the eye's map.
function walksOf(slice, functions, world, eye) {
  if (typeof functions.walkGrid !== 'function') return null;
  const engine = slice.walk
    .filter(({ portals }) => portals === 0)
    .map(({ tile: [x, y], depth }) => ({ x, y, near: depth }));
  let mine;
  try {
    const [x, y] = slice.ray;
    mine = functions.walkGrid(world.maps[eye.map], eye, { x, y });
    mine = mine.map((tile) => ({ x: tile.x, y: tile.y, near: tile.near }));
  } catch (error) {
    return { engine, mine: [], first: `\`walkGrid\` stops with "${error.message}".` };
  }
  const wrong = engine.findIndex(({ x, y, near }, index) => {
    const own = mine[index];
    return !own || own.x !== x || own.y !== y || !(Math.abs(own.near - near) < 1e-6);
  });
  if (wrong < 0) return { engine, mine, first: null };
  const tell = (tile) => (tile ? `tile ${tile.x}, ${tile.y} at depth ${tile.near}` : 'no tile');
  const both = `yours ${tell(mine[wrong])}, engine ${tell(engine[wrong])}`;
  return { engine, mine, first: `\`walkGrid\`, tile ${wrong} of the way: ${both}.` };
}
