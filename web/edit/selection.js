// Sets of cells: what is selected in a map, or where a part would be pasted.
// Takes cells {level, x, y}; gives sets of numbers, boxes and outlines. Knows no document.
//
//     const cells = new Set([keyOf({ level: 0, x: 3, y: 4 })]);
//     cellOf(key)                                  // {level, x, y}
//     boxAround(cells)                             // {from, to}, both within
//     outlineOf(cells)                             // [{from: [x, y, z], to: [x, y, z]}], its edges
//     const transform = transformOf(boxAround(cells), kTurns.right, { level: 0, x: 1, y: 0 });
//     transformed(cells, transform)                // the set there, whatever lies there
//     transform.point([3.5, 4.5, 0])               // where a point goes with it

import { kStill, turnedPoint } from './turning.js';

// Maps have up to 4,096 tiles a side; a part that is pasted may reach beyond a map on each side.
const kSpan = 1 << 14; // of x and of y
const kMiddle = kSpan / 2;
const kLowest = 64; // levels below the ground

export function keyOf({ level, x, y }) {
  return ((level + kLowest) * kSpan + y + kMiddle) * kSpan + x + kMiddle;
}

export function cellOf(key) {
  const row = Math.floor(key / kSpan);
  const level = Math.floor(row / kSpan);
  return {
    level: level - kLowest,
    x: key - row * kSpan - kMiddle,
    y: row - level * kSpan - kMiddle,
  };
}

export function boxAround(cells) {
  const from = { level: Infinity, x: Infinity, y: Infinity };
  const to = { level: -Infinity, x: -Infinity, y: -Infinity };
  for (const key of cells) {
    const cell = cellOf(key);
    for (const axis of ['level', 'x', 'y']) {
      from[axis] = Math.min(from[axis], cell[axis]);
      to[axis] = Math.max(to[axis], cell[axis]);
    }
  }
  return { from, to };
}

// How a box is turned about its middle, and then moved. Whole tiles stay whole.
export function transformOf({ from, to }, turn = kStill, by = { level: 0, x: 0, y: 0 }) {
  const width = to.x - from.x + 1;
  const depth = to.y - from.y + 1;
  const isAcross = turn[0] === 0;
  const moved = {
    x: from.x + by.x + (isAcross ? Math.trunc((width - depth) / 2) : 0),
    y: from.y + by.y + (isAcross ? Math.trunc((depth - width) / 2) : 0),
  };
  const middle = [from.x + width / 2, from.y + depth / 2];
  const after = isAcross
    ? [moved.x + depth / 2, moved.y + width / 2]
    : [moved.x + width / 2, moved.y + depth / 2];
  const point = ([x, y, z]) => {
    const [east, south] = turnedPoint([x - middle[0], y - middle[1]], turn);
    return [after[0] + east, after[1] + south, z + by.level];
  };
  const cell = ({ level, x, y }) => {
    const [east, south, up] = point([x + 0.5, y + 0.5, level]);
    return { level: up, x: Math.floor(east), y: Math.floor(south) };
  };
  return { turn, point, cell };
}

export function transformed(cells, transform) {
  const next = new Set();
  for (const key of cells) next.add(keyOf(transform.cell(cellOf(key))));
  return next;
}

// Edges elsewhere: of cells that were moved.
export function shiftedEdges(edges, { level, x, y }) {
  const moved = ([east, south, up]) => [east + x, south + y, up + level];
  return edges.map(({ from, to }) => ({ from: moved(from), to: moved(to) }));
}

// Those of a box, {from, to}, both within.
export function boxEdges({ from, to }) {
  const ends = [
    [from.x, to.x + 1],
    [from.y, to.y + 1],
    [from.level, to.level + 1],
  ];
  const edges = [];
  for (const axis of [0, 1, 2]) {
    const [one, other] = [0, 1, 2].filter((number) => number !== axis);
    for (const a of ends[one]) {
      for (const b of ends[other]) {
        const at = (along) => [0, 1, 2].map((k) => (k === axis ? along : k === one ? a : b));
        edges.push({ from: at(ends[axis][0]), to: at(ends[axis][1]) });
      }
    }
  }
  return edges;
}

// The edges where the surface of the set bends, each run of them as one line.
export function outlineOf(cells) {
  const edges = new Map(); // axis, a, b as one number -> where along the axis there is one
  const add = (line, along) => {
    const places = edges.get(line);
    if (places === undefined) edges.set(line, [along]);
    else places.push(along);
  };
  const has = (key) => (cells.has(key) ? 1 : 0);
  // Whether the surface bends at an edge between four cells, which are a step apart in two ways.
  const isBend = (key, across, up) => {
    const [one, two] = [has(key), has(key + across)];
    const [three, four] = [has(key + across + up), has(key + up)];
    const count = one + two + three + four;
    return count % 2 === 1 || (count === 2 && one === three);
  };
  const lineOf = (axis, a, b) => (axis * kSpan + a + kMiddle) * kSpan + b + kMiddle;
  const [stepX, stepY, stepLevel] = [1, kSpan, kSpan * kSpan];
  for (const key of cells) {
    const { level, x, y } = cellOf(key);
    // Each edge is found by all cells around it, but counts once.
    for (const i of [0, 1]) {
      for (const j of [0, 1]) {
        const [a, b] = [i - 1, j - 1];
        if (isBend(key + a * stepY + b * stepLevel, stepY, stepLevel))
          add(lineOf(0, y + i, level + j), x);
        if (isBend(key + a * stepX + b * stepLevel, stepX, stepLevel))
          add(lineOf(1, x + i, level + j), y);
        if (isBend(key + a * stepX + b * stepY, stepX, stepY)) add(lineOf(2, x + i, y + j), level);
      }
    }
  }
  const lines = [];
  for (const [line, places] of edges) {
    const rest = Math.floor(line / kSpan);
    const b = line - rest * kSpan - kMiddle;
    const axis = Math.floor(rest / kSpan);
    const a = rest - axis * kSpan - kMiddle;
    const at = (along) =>
      [
        [along, a, b],
        [a, along, b],
        [a, b, along],
      ][axis];
    let begin = null;
    let last = null;
    for (const along of places.sort((one, other) => one - other)) {
      if (along === last) continue;
      if (begin !== null && along !== last + 1) {
        lines.push({ from: at(begin), to: at(last + 1) });
        begin = along;
      }
      begin ??= along;
      last = along;
    }
    lines.push({ from: at(begin), to: at(last + 1) });
  }
  return lines;
}
