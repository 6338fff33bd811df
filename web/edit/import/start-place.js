// Finds where a player has room: at the place that a map wants, or near it, or, without one, where
// most of the map can be walked. Heights are those of scenes; a body is 0.72 high and 0.4 wide.
//
//     const ground = groundOf(width, depth, stackAt, isPainted, ceilingAt);
//     const { x, y, z } = placeNear(ground, 3.5, 4.2, 0);
//     const { x, y, z } = bestPlace(ground);
//     headingAt(ground, x, y)                 // towards the longest free way, in degrees
//
// stackAt(tile) lists the blocks over a tile as [bottom, top], the lowest first; ceilingAt(tile) is
// the height of its ceiling, or null.

const kBody = 0.72;
const kHalfWidth = 0.2;
const kStep = 0.5; // the highest step that one walks up

// `feet` holds the lowest height over each tile where a body has room.
export function groundOf(width, depth, stackAt, isPainted, ceilingAt) {
  const hasRoom = (tile, z) => {
    const ceiling = ceilingAt(tile);
    const isBelow = ceiling !== null && z < ceiling && z + kBody > ceiling;
    return !isBelow && stackAt(tile).every(([low, high]) => z >= high || z + kBody <= low);
  };
  const feet = new Float32Array(width * depth);
  for (let tile = 0; tile < feet.length; ++tile) {
    if (stackAt(tile).length === 0 && ceilingAt(tile) === null) continue;
    const heights = [0, ...stackAt(tile).map(([, high]) => high), ceilingAt(tile) ?? 0];
    const free = heights.filter((z) => hasRoom(tile, z));
    feet[tile] = Math.min(...free);
  }
  return { width, depth, feet, hasRoom, isPainted };
}

export function placeNear(ground, x, y, z) {
  if (hasRoomAt(ground, x, y, z)) return { x, y, z };
  return nearest(ground, x, y, ({ feet }, tile) => feet[tile] <= kStep);
}

export function bestPlace(ground) {
  const { width, depth } = ground;
  const area = largestArea(ground);
  return nearest(ground, width / 2, depth / 2, (_, tile) => area.has(tile));
}

export function headingAt({ width, depth, feet }, x, y) {
  const [column, row] = [Math.floor(x), Math.floor(y)];
  const height = feet[row * width + column];
  const lengths = [
    [1, 0],
    [0, 1],
    [-1, 0],
    [0, -1],
  ].map(([dx, dy]) => {
    let length = 0;
    for (let [i, j] = [column + dx, row + dy]; ; i += dx, j += dy, ++length) {
      const isInside = i >= 0 && j >= 0 && i < width && j < depth;
      if (!isInside || Math.abs(feet[j * width + i] - height) > kStep) return length;
    }
  });
  return 90 * lengths.indexOf(Math.max(...lengths));
}

function hasRoomAt({ width, depth, hasRoom }, x, y, z) {
  const sides = [-kHalfWidth, kHalfWidth];
  return sides.every((dx) =>
    sides.every((dy) => {
      const [column, row] = [Math.floor(x + dx), Math.floor(y + dy)];
      const isInside = column >= 0 && row >= 0 && column < width && row < depth;
      return isInside && hasRoom(row * width + column, z);
    }),
  );
}

// The middle of the nearest tile that is fit, else of the nearest one: above all blocks is room.
function nearest(ground, x, y, isFit) {
  const { width, feet } = ground;
  let best = null;
  for (const wanted of [isFit, () => true]) {
    for (let tile = 0; tile < feet.length; ++tile) {
      if (!wanted(ground, tile)) continue;
      const place = { x: (tile % width) + 0.5, y: Math.floor(tile / width) + 0.5, z: feet[tile] };
      const distance = (place.x - x) ** 2 + (place.y - y) ** 2;
      if (best === null || distance < best.distance) best = { ...place, distance };
    }
    if (best !== null) return { x: best.x, y: best.y, z: best.z };
  }
  return null;
}

// The most tiles that are joined, all low enough to walk; where floors are painted, only on these.
function largestArea({ width, depth, feet, isPainted }) {
  const isFree = (tile) => feet[tile] <= kStep;
  const some = feet.some((_, tile) => isFree(tile) && isPainted(tile));
  const isWanted = (tile) => isFree(tile) && (!some || isPainted(tile));
  const areas = new Uint32Array(width * depth); // the number of each tile's area, 0 for none
  const waiting = new Uint32Array(width * depth);
  let [count, largest, size] = [0, 0, 0];
  for (let first = 0; first < areas.length; ++first) {
    if (areas[first] !== 0 || !isWanted(first)) continue;
    count += 1;
    let end = 0;
    const enter = (tile) => {
      if (areas[tile] !== 0 || !isWanted(tile)) return;
      areas[tile] = count;
      waiting[end++] = tile;
    };
    enter(first);
    for (let next = 0; next < end; ++next) {
      const tile = waiting[next];
      const column = tile % width;
      if (column > 0) enter(tile - 1);
      if (column < width - 1) enter(tile + 1);
      if (tile >= width) enter(tile - width);
      if (tile + width < areas.length) enter(tile + width);
    }
    if (end > size) [largest, size] = [count, end];
  }
  return { has: (tile) => largest !== 0 && areas[tile] === largest };
}
