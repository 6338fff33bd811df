// Corners that a walk meets exactly.

// The tiles whose next two borders are at the same depth: [{tile, along, depth, axis}]; `axis` is
// that of the border that is crossed first.
export function tiesIn({ walk }) {
  return walk.slice(0, -1).flatMap(({ tile, next }, index) => {
    const [x, y] = next;
    if (x === null || x !== y) return [];
    const { axis, depth } = walk[index + 1];
    return [{ tile, along: x, depth, axis }];
  });
}

// The depths of both axes at the corners of a ray's way, as sums of steps and as quotients. The ray
// goes `right` units east for `down` units south, from a corner of the grid.
export function agreements(right, down, corners, rounded = (number) => number) {
  const divisor = greatestDivisor(right, down);
  const [eastward, southward] = [right / divisor, down / divisor];
  const list = [];
  let x = 0;
  let y = 0;
  for (let corner = 1; corner <= corners; ++corner) {
    for (let i = 0; i < eastward; ++i) x = rounded(x + rounded(1 / right));
    for (let i = 0; i < southward; ++i) y = rounded(y + rounded(1 / down));
    list.push({
      sums: [x, y],
      quotients: [rounded((eastward * corner) / right), rounded((southward * corner) / down)],
    });
  }
  return list;
}

function greatestDivisor(a, b) {
  return b === 0 ? a : greatestDivisor(b, a % b);
}

// Rules for a corner: whether the x border is crossed first, or both at once.
export const kRules = {
  exact: {
    title: 'x first to the east, y first to the west',
    first: (stepX) => (stepX > 0 ? 'x' : 'y'),
  },
  always: { title: 'always x first: <= instead of <', first: () => 'x' },
  both: { title: 'both at once', first: () => 'both' },
};

// The colour of the face that a slice's ray meets first, if corners are crossed by a rule.
export function blockOn({ eye, ray }, cells, blueprints, rule) {
  const step = ray.map(Math.sign);
  const start = [eye.x, eye.y];
  const tile = start.map(Math.floor);
  let face = null;
  for (;;) {
    const blueprint = blueprints.get(cells[tile[1]]?.[tile[0]]);
    if (blueprint && face) return { colour: blueprint.faces[face].colour, tile };
    if (cells[tile[1]]?.[tile[0]] === undefined) return { colour: 'none', tile };
    const [x, y] = [0, 1].map((axis) => {
      const border = tile[axis] + (step[axis] > 0 ? 1 : 0);
      return step[axis] === 0 ? Infinity : (border - start[axis]) / ray[axis];
    });
    const way = x === y ? kRules[rule].first(step[0]) : x < y ? 'x' : 'y';
    if (way !== 'y') tile[0] += step[0];
    if (way !== 'x') tile[1] += step[1];
    face = way === 'y' ? (step[1] > 0 ? 'north' : 'south') : step[0] > 0 ? 'west' : 'east';
  }
}
