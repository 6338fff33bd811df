// The row of the long wall's upper edge by three ways of drawing, in arithmetic of its own.

const kWall = 1; // y of the wall's face
const kRadians = Math.PI / 180;

// The row in a column: flat pane and depth; equal angles and distance; the same times the cosine.
export function edgeRows(column, { eye, fov, width, height }) {
  const distance = width / 2 / Math.tan((fov / 2) * kRadians);
  const rise = ((1 - eye.z) * distance) / (eye.y - kWall);
  const turn = (eye.heading - 270) * kRadians;
  const side = column + 0.5 - width / 2;
  const angle = (side / width) * fov * kRadians;
  const rowAt = (perDepth) => height / 2 - rise * perDepth;
  const flat = (k) => Math.cos(turn) - k * Math.sin(turn); // of a ray, towards the wall
  return {
    exact: rowAt(flat(side / distance)),
    distance: rowAt(Math.cos(angle + turn)),
    cosine: rowAt(flat(Math.tan(angle))),
  };
}

// Rows by which the old ways are too low: {distance: [[column, rows], ...], cosine: ...}.
export function errorsOf({ eye, slice, width, height }) {
  const errors = { distance: [], cosine: [] };
  for (let column = 0; column < width; column += 4) {
    const rows = edgeRows(column, { eye, fov: slice.fov, width, height });
    for (const way of ['distance', 'cosine']) errors[way].push([column, rows[way] - rows.exact]);
  }
  return errors;
}
