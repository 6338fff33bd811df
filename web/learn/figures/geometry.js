// The arithmetic of figures: what a page computes itself, to stand beside what the engine says.

// A vector turned clockwise by degrees, a multiple of 90.
function turned([x, y], degrees) {
  const quarters = (((degrees / 90) % 4) + 4) % 4;
  for (let i = 0; i < quarters; ++i) [x, y] = [-y, x];
  return [x, y];
}

// The eye as seen behind 0, 1, ... portals of a slice: a portal moves the eye, the ray goes on.
export function eyesOf(slice) {
  const { x, y, z } = slice.eye;
  const eyes = [{ map: slice.map, x, y, z, ray: slice.ray }];
  for (const { portals, from, to, turn, levels } of slice.portals) {
    const eye = eyes[portals];
    if (eye === undefined || eyes[portals + 1] !== undefined) continue;
    const [right, down] = turned([eye.x - from.tile[0] - 0.5, eye.y - from.tile[1] - 0.5], turn);
    eyes[portals + 1] = {
      map: to.map,
      x: to.tile[0] + 0.5 + right,
      y: to.tile[1] + 0.5 + down,
      z: eye.z + levels,
      ray: turned(eye.ray, turn),
    };
  }
  return eyes;
}

// Where the walk entered tile `index` > 0: the border, and the page's own quotient beside the
// engine's depth. `x`, `y` are of the map in which the tile lies.
export function crossing(slice, index, eyes = eyesOf(slice)) {
  const { axis, depth, portals } = slice.walk[index];
  const eye = eyes[portals] ?? eyes[0];
  const isX = axis === 'x';
  const [from, ray] = isX ? [eye.x, eye.ray[0]] : [eye.y, eye.ray[1]];
  const border = Math.round(from + depth * ray);
  return {
    axis,
    border,
    eye: from,
    ray,
    quotient: (border - from) / ray,
    depth,
    x: isX ? border : eye.x + depth * eye.ray[0],
    y: isX ? eye.y + depth * eye.ray[1] : border,
  };
}

// Pixels between the eye and the picture plane.
export function distanceOf(fov, width) {
  return width / 2 / Math.tan((fov * Math.PI) / 360);
}

// The direction of a column's ray on the ground, per unit of depth.
export function rayOf({ heading }, column, [width], fov) {
  const angle = (heading * Math.PI) / 180;
  const [x, y] = [Math.cos(angle), Math.sin(angle)];
  const slope = (column + 0.5 - width / 2) / distanceOf(fov, width);
  return [x - slope * y, y + slope * x];
}

// The row, a real number, of a height at a depth.
export function rowOf(z, depth, { eye, horizonRow, projectionDistance }) {
  return horizonRow - (projectionDistance * (z - eye.z)) / depth;
}

// Rise per unit of depth of the sight line through the upper edge of a row.
export function slopeOf(row, { horizonRow, projectionDistance }) {
  return (horizonRow - row) / projectionDistance;
}

// The heights of a block's top or underside where the slice's line enters and leaves it, as the eye
// counts heights: [front, back]. They differ on slopes.
export function slopeEnds(hit, part, slice) {
  const [front, back] = [
    [hit[`${part}FrontRow`], hit.depth],
    [hit[`${part}BackRow`], hit.backDepth],
  ].map(([row, depth]) =>
    row === null || depth === null || depth <= 0
      ? null
      : slice.eye.z + ((slice.horizonRow - row) * depth) / slice.projectionDistance,
  );
  const level = eyesOf(slice)[0].z - (eyesOf(slice)[hit.portals]?.z ?? slice.eye.z) + hit[part];
  return [front ?? back ?? level, back ?? front ?? level];
}

// The height of the surface that a run shows, or null for upright ones and the sky.
export function heightOf(run, slice, ceiling = null) {
  const hit = run.hit === null ? null : slice.hits[run.hit];
  if (run.what === 'roof') return hit?.top ?? null;
  if (run.what === 'underside') return hit?.bottom ?? null;
  if (run.what === 'floor') return 0;
  return run.what === 'ceiling' ? ceiling : null;
}

// Where the sight line through the upper edge of a row ends: on the run's surface, or at
// `farthest`.
export function placeOf(run, row, slice, { ceiling = null, farthest = Infinity } = {}) {
  const slope = slopeOf(row, slice);
  // Behind portals, in that map's heights.
  const rise = eyesOf(slice)[run.portals]?.z ?? slice.eye.z;
  const upright =
    run.what === 'side'
      ? slice.hits[run.hit]
      : run.what === 'object'
        ? slice.objects[run.object]
        : null;
  const surface = heightOf(run, slice, ceiling);
  const onSlope = slopePlace(run, slope, slice);
  if (onSlope !== null) return onSlope;
  // Of a see-through block also the inner side, where the ray leaves it.
  const isInner = run.what === 'side' && run.face !== upright.face;
  const reach =
    (isInner ? upright.backDepth : upright?.depth) ??
    (surface === null ? Infinity : (surface - rise) / slope);
  const depth = Math.min(reach >= 0 ? reach : Infinity, farthest);
  return { depth, z: slice.eye.z + slope * depth };
}

// Where a sight line that rises by `slope` meets a sloped roof or underside; null on other runs.
function slopePlace(run, slope, slice) {
  const part = { roof: 'top', underside: 'bottom' }[run.what];
  const hit = run.hit === null ? null : slice.hits[run.hit];
  if (part === undefined || hit === null || hit.backDepth === null) return null;
  const [front, back] = slopeEnds(hit, part, slice);
  if (Math.abs(back - front) < 1e-6) return null;
  const rise = (back - front) / (hit.backDepth - hit.depth);
  const above = front - rise * hit.depth - slice.eye.z; // of the plane over the eye
  const depth = clamp(above / (slope - rise), hit.depth, hit.backDepth);
  return { depth, z: slice.eye.z + slope * depth };
}

export function blockName(slice, run) {
  if (run.hit !== null) return `${slice.hits[run.hit].blueprint}, ${run.what}`;
  if (run.object !== null) return slice.objects[run.object].sprite;
  return run.what;
}

export const clamp = (value, least, greatest) => Math.max(least, Math.min(greatest, value));

// Even marks on an axis: 1, 2 or 5 times a power of ten apart, at least `most` of them.
export function ticks(from, to, most) {
  const raw = (to - from) / Math.max(1, most);
  const power = 10 ** Math.floor(Math.log10(raw || 1));
  const gap = [1, 2, 5, 10].map((n) => n * power).find((g) => g >= raw * 0.999) ?? power;
  const list = [];
  for (let i = Math.ceil(from / gap - 1e-9); i * gap <= to + 1e-9; ++i)
    list.push(Number((i * gap).toFixed(9)));
  return list;
}
