// Cells between two others, for the tools that draw lines and boxes.
// Takes cells {level, x, y}; gives lists of cells.
//
//     lineOf(from, to)            // each touches the next with a face or an edge
//     boxOfCells(from, to)        // {from, to} with the smaller numbers in `from`
//     cellsIn(box, 'hollow')      // 'solid', 'hollow' (its faces) or 'walls' (its sides)

export const kMostCells = 1 << 20; // of one stroke

export function lineOf(from, to) {
  const axes = ['x', 'y', 'level'];
  const steps = Math.max(...axes.map((axis) => Math.abs(to[axis] - from[axis])));
  return Array.from({ length: steps + 1 }, (_, step) =>
    Object.fromEntries(
      axes.map((axis) => [
        axis,
        steps === 0
          ? from[axis]
          : Math.round(from[axis] + ((to[axis] - from[axis]) * step) / steps),
      ]),
    ),
  );
}

export function boxOfCells(one, other) {
  const pick = (choose) => ({
    x: choose(one.x, other.x),
    y: choose(one.y, other.y),
    level: choose(one.level, other.level),
  });
  return { from: pick(Math.min), to: pick(Math.max) };
}

export function cellsIn({ from, to }, how = 'solid') {
  const cells = [];
  const isEdge = (axis, value) => value === from[axis] || value === to[axis];
  for (let level = from.level; level <= to.level; ++level) {
    for (let y = from.y; y <= to.y; ++y) {
      for (let x = from.x; x <= to.x; ++x) {
        const isSide = isEdge('x', x) || isEdge('y', y);
        const isIn = how === 'solid' || isSide || (how === 'hollow' && isEdge('level', level));
        if (isIn) cells.push({ level, x, y });
        if (cells.length > kMostCells) return cells;
      }
    }
  }
  return cells;
}
