// Lines for <ray-caster>.mark(): outlines of cells, faces and boxes.
// Takes places in cells and units; gives lists of lines. Knows no element.
//
//     boxLines('yard', { west: 1, north: 2, east: 2, south: 3, low: 0, high: 1 }, kBrass)
//     cellLines('yard', { level: 0, x: 1, y: 2 }, kBrass)          // the cell's box
//     edgeLines('yard', { width: 12, depth: 8 })                   // where the map ends
//     faceLines('yard', cell, 'top', kBrass, extentOf(blueprint))  // one face of a block in it

export const kBrass = '#ecc862';
export const kCoral = '#e3835f';
export const kSea = '#7fc4e8';
const kEdge = '#f7f1e1';

const kPost = 1; // units: of the corners of a map's edge

const kWhole = { low: 0, high: 1, west: 0, north: 0, east: 1, south: 1 };

export function boxOf({ level, x, y }, { low, high, west, north, east, south } = kWhole) {
  return {
    west: x + west,
    north: y + north,
    east: x + east,
    south: y + south,
    low: level + low,
    high: level + high,
  };
}

export function boxLines(map, { west, north, east, south, low, high }, colour) {
  const ring = (z) => [
    [west, north, z],
    [east, north, z],
    [east, south, z],
    [west, south, z],
  ];
  const bottom = ring(low);
  const top = ring(high);
  return [bottom, top, ...bottom.map((corner, index) => [corner, top[index]])].flatMap((points) =>
    closed(points, points.length > 2).map(([from, to]) => ({ map, from, to, colour })),
  );
}

const kMostLines = 6000; // of one outline; beyond it, its box is shown

// Of edges as outlineOf() in selection.js gives them.
export function linesOf(map, edges, colour) {
  if (edges.length <= kMostLines) return edges.map(({ from, to }) => ({ map, from, to, colour }));
  const [west, north, low] = [0, 1, 2].map((axis) =>
    edges.reduce((least, { from }) => Math.min(least, from[axis]), Infinity),
  );
  const [east, south, high] = [0, 1, 2].map((axis) =>
    edges.reduce((most, { to }) => Math.max(most, to[axis]), -Infinity),
  );
  return boxLines(map, { west, north, low, east, south, high }, colour);
}

export function edgeLines(map, { width, depth }) {
  const box = { west: 0, north: 0, east: width, south: depth, low: 0, high: kPost };
  // On the ground, and upright at the corners.
  return boxLines(map, box, kEdge).filter(({ from }) => from[2] === 0);
}

export function cellLines(map, cell, colour, extent = kWhole) {
  return boxLines(map, boxOf(cell, extent), colour);
}

export function faceLines(map, cell, face, colour, extent = kWhole) {
  const { west, north, east, south, low, high } = boxOf(cell, extent);
  const upright = (from, to) => [
    [...from, low],
    [...to, low],
    [...to, high],
    [...from, high],
  ];
  const flat = (z) => [
    [west, north, z],
    [east, north, z],
    [east, south, z],
    [west, south, z],
  ];
  const corners = {
    north: upright([west, north], [east, north]),
    east: upright([east, north], [east, south]),
    south: upright([east, south], [west, south]),
    west: upright([west, south], [west, north]),
    top: flat(high),
    bottom: flat(low),
  }[face];
  if (corners === undefined) return cellLines(map, cell, colour, extent);
  return closed(corners, true).map(([from, to]) => ({ map, from, to, colour }));
}

function closed(points, isClosed) {
  const pairs = points.slice(1).map((point, index) => [points[index], point]);
  return isClosed ? [...pairs, [points.at(-1), points[0]]] : pairs;
}
