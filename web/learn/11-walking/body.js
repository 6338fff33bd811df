// A body on the map, for this chapter's figures: a square of half width r that sweeps along one
// axis until something solid stops it. Lengths are multiples of 1/65536 of a unit, as in the
// engine, so that touching is not overlapping.

export const kHalfWidth = units(0.2);

export function units(number) {
  return Math.round(number * 65536) / 65536;
}

// The highest top over each tile, Infinity outside the map.
export function groundOf({ cells, blueprints }) {
  return (x, y) => {
    if (cells[0][y]?.[x] === undefined) return Infinity;
    return Math.max(
      0,
      ...cells.map((rows, level) => {
        const block = blueprints.get([...rows[y]][x]);
        return block ? level + block.top : 0;
      }),
    );
  };
}

// Whether a tile stops a body with its feet on the floor, or at another height.
export function solidOf(now, feet = 0, step = 0.5) {
  const ground = groundOf(now);
  return (x, y) => ground(x, y) > feet + step;
}

// How far a body gets along an axis, at most `distance`, and the border that stops it, or null.
export function sweep(solid, { x, y, r }, axis, distance) {
  const isX = axis === 'x';
  const [at, beside] = isX ? [x, y] : [y, x];
  const sign = Math.sign(distance);
  const wished = units(distance);
  if (sign === 0) return { way: 0, border: null };
  const edge = units(at + sign * r);
  const first = Math.floor(units(beside - r));
  const last = Math.ceil(units(beside + r)) - 1;
  const begin = sign > 0 ? Math.ceil(edge) : Math.floor(edge);
  for (let border = begin; sign * (border - edge) < sign * wished; border += sign) {
    const ahead = sign > 0 ? border : border - 1;
    for (let other = first; other <= last; ++other) {
      if (solid(...(isX ? [ahead, other] : [other, ahead])))
        return { way: units(border - edge), border };
    }
  }
  return { way: wished, border: null };
}
