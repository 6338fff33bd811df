// The second lesson: a wall's height from its depth, distance and depth side by side, fish-eye
// distortion beside flat glass, and one row of the floor.

import { box, dot, find, fixed, follow, line, markColumn, slider, text } from './lesson.js';
import { putMarkup } from './markup.js';

const kWallEdge = 1; // y of the long wall's southern face, units
const kFacing = 270; // degrees: north

const near = find('near');
const flat = find('flat');
const old = find('old');
const floor = find('floor');

// The first block of a slice, with the values that its projection needs.
function firstHit(caster, column) {
  const slice = caster.trace(column);
  return { slice, hit: slice.hits[0] };
}

// ---- Near is large

const depth = slider(
  'depth',
  (value) => `${fixed(value)} units`,
  (value) => near.look({ y: kWallEdge + value, heading: kFacing }),
);

const kSide = { eyeX: 44, glassX: 104, unit: 54, floorY: 262, height: 150, right: 528 };

function drawNear() {
  const { width, height } = near.picture;
  const { slice, hit } = firstHit(near, Math.floor(width / 2));
  if (hit === undefined) return;
  const rows = hit.bottomFrontRow - hit.topFrontRow;
  const tall = hit.top - hit.bottom;
  depth.value = hit.depth;
  find('height-sum').textContent =
    `= ${fixed(slice.projectionDistance, 1)} · ${fixed(tall, 0)} ÷ ${fixed(hit.depth)} = ${fixed(rows, 1)}`;
  find('near-mark').setAttribute('viewBox', `0 0 ${width} ${height}`);
  putMarkup(find('near-mark'), bracket(width / 2, hit.topFrontRow, hit.bottomFrontRow));
  putMarkup(find('side'), side(slice, hit, rows));
}

function bracket(x, top, bottom) {
  const shape = `M${x - 12} ${top}h24M${x} ${top}V${bottom}M${x - 12} ${bottom}h24`;
  return `<path d="${shape}" class="mark-line edge"/><path d="${shape}" class="mark-line"/>`;
}

function side({ eye }, hit, rows) {
  const { eyeX, glassX, unit, floorY, height, right } = kSide;
  const up = (z) => floorY - height * z;
  const wallX = eyeX + unit * hit.depth;
  const through = (z) => up(eye.z) + ((up(z) - up(eye.z)) * (glassX - eyeX)) / (wallX - eyeX);
  const parts = [
    box(0, floorY, right, 68, 'class="ground"'),
    box(wallX, up(hit.top), right - wallX, height * (hit.top - hit.bottom), 'class="bricks"'),
    line(glassX, 30, glassX, floorY, 'class="glass"'),
  ];
  for (const z of [hit.top, hit.bottom])
    parts.push(line(eyeX, up(eye.z), wallX, up(z), 'class="sight"'));
  parts.push(
    line(glassX, through(hit.top), glassX, through(hit.bottom), 'class="on-glass"'),
    dot(eyeX, up(eye.z), 8, 'class="eye"'),
    text(glassX + 8, 44, `${fixed(rows, 1)} rows`, 'class="ray-text" font-size="16"'),
    line(eyeX, floorY + 24, wallX, floorY + 24, 'class="measure"'),
    line(eyeX, floorY + 17, eyeX, floorY + 31, 'class="measure"'),
    line(wallX, floorY + 17, wallX, floorY + 31, 'class="measure"'),
    text(
      (eyeX + wallX) / 2,
      floorY + 50,
      `t = ${fixed(hit.depth)}`,
      'font-size="16" text-anchor="middle"',
    ),
  );
  if (wallX < right - 62)
    parts.push(
      text(
        wallX + 12,
        up((hit.top + hit.bottom) / 2) + 5,
        `h = ${fixed(hit.top - hit.bottom, 0)}`,
        'class="on-bricks" font-size="16"',
      ),
    );
  return parts.join('');
}

// ---- Distance and depth

const slice = slider('slice', (value) => `${value} of ${flat.picture.width || 480}`, drawFlat);
const turn = slider(
  'turn',
  (value) =>
    value === 0
      ? 'facing the wall'
      : `${fixed(Math.abs(value), 0)}° to the ${value < 0 ? 'left' : 'right'}`,
  (value) => flat.look({ heading: kFacing + value }),
);
slider(
  'fov',
  (value) => `${value}°`,
  (value) => {
    for (const caster of [flat, old]) caster.set('fov', value);
  },
);

function drawFlat() {
  const { width, height } = flat.picture;
  slice.spread(width);
  turn.value = Math.round(((flat.currentView.heading - kFacing + 540) % 360) - 180);
  const { slice: traced, hit } = firstHit(flat, slice.value);
  const edges = [0, width - 1]
    .map((column) => ({ column, ...firstHit(flat, column) }))
    .filter((edge) => edge.hit?.face === 'south');
  drawLengths(traced, hit, edges);

  const straight =
    edges.length === 2
      ? `M${edges[0].column + 0.5} ${edges[0].hit.topFrontRow}L${edges[1].column + 0.5} ${edges[1].hit.topFrontRow}`
      : '';
  for (const name of ['flat', 'old']) {
    markColumn(
      find(`${name}-mark`),
      { width, height },
      slice.value,
      `<path d="${straight}" class="mark-line edge"/><path d="${straight}" class="mark-line"/>`,
    );
  }
}

// Seen from above and turned so that ahead is up.
const kLengths = { x: 320, y: 296, unit: 96 };

function drawLengths(traced, hit, edges) {
  const { x, y, unit } = kLengths;
  if (hit === undefined) return;
  const distance = hit.rawDepth;
  const tall = hit.top - hit.bottom;
  const slope = slopeOf(traced, traced.column);
  const place = (k, t) => [x + unit * k * t, y - unit * t];
  const [hitX, hitY] = place(slope, hit.depth);
  const parts = [];
  if (edges.length === 2) {
    const [[fromX, fromY], [toX, toY]] = edges.map(({ slice: edge, hit: { depth: t } }) =>
      place(slopeOf(edge, edge.column), t),
    );
    const wider = (toX - fromX) * 0.5;
    const lean = (toY - fromY) * 0.5;
    parts.push(line(fromX - wider, fromY - lean, toX + wider, toY + lean, 'class="wall-line"'));
    parts.push(
      line(x, y, fromX, fromY, 'class="view-side"'),
      line(x, y, toX, toY, 'class="view-side"'),
    );
  }
  parts.push(
    line(x, y, hitX, hitY, 'class="sight thick"'),
    line(x, y, x, hitY, 'class="depth-line"'),
    line(x, hitY, hitX, hitY, 'class="across-line"'),
    dot(hitX, hitY, 6, 'class="ray-fill"'),
    dot(x, y, 9, 'class="eye"'),
    text(
      x + (slope < 0 ? 10 : -10),
      (y + hitY) / 2 + 24,
      `depth ${fixed(hit.depth)}`,
      `class="across-text halo" font-size="16" text-anchor="${slope < 0 ? 'start' : 'end'}"`,
    ),
    text(
      (x + hitX) / 2 + (slope < 0 ? -14 : 14),
      (y + hitY) / 2 + 14,
      `distance ${fixed(distance)}`,
      `class="ray-text halo" font-size="16" text-anchor="${slope < 0 ? 'end' : 'start'}"`,
    ),
  );
  putMarkup(find('lengths'), parts.join(''));
  find('length-depth').textContent = fixed(hit.depth, 3);
  find('length-distance').textContent = fixed(distance, 3);
  find('rows-depth').textContent = fixed((traced.projectionDistance * tall) / hit.depth, 1);
  find('rows-distance').textContent = fixed((traced.projectionDistance * tall) / distance, 1);
}

function slopeOf({ size: [width], projectionDistance }, column) {
  return (column + 0.5 - width / 2) / projectionDistance;
}

// ---- The fish eye: the right picture goes where the left one goes

const kTitles = {
  equalAngles: 'The old way: distance, equal angles',
  equalAnglesCorrected: 'The old cure: distance × cosine',
  plane: 'The old renderer, with the depth',
};

function showProjection() {
  const { value } = document.querySelector('[name="projection"]:checked');
  old.set('classic.projection', value);
  find('old-title').textContent = kTitles[value];
}

function bringAlong() {
  const { x, y, z, heading, look } = flat.currentView;
  const there = old.currentView;
  if (
    there !== null &&
    [x - there.x, y - there.y, z - there.z, heading - there.heading, look - there.look].some(
      (apart) => apart !== 0,
    )
  )
    old.look({ x, y, z, heading, look });
}

// ---- The floor

const row = slider('row', (value) => `${value} of ${floor.picture.height || 300}`, drawFloor);

const kFloor = { x: 264, y: 312, unit: 36, reach: 14, tick: 40 };

function drawFloor() {
  const { width, height } = floor.picture;
  row.spread(height);
  const traced = floor.trace(Math.floor(width / 2));
  const below = row.value + 0.5 - traced.horizonRow;
  const t = (traced.projectionDistance * traced.eye.z) / below;
  find('floor-sum').textContent =
    below > 0
      ? `= ${fixed(traced.projectionDistance, 1)} · ${fixed(traced.eye.z)} ÷ ${fixed(below, 1)} = ${fixed(t)}`
      : 'and this row is above the horizon: it never comes to the floor';
  const mark = find('floor-mark');
  mark.setAttribute('viewBox', `0 0 ${width} ${height}`);
  mark.setAttribute('preserveAspectRatio', 'none');
  putMarkup(
    mark,
    box(0, row.value - 2, width, 5, 'class="mark-edge"') +
      box(0, row.value, width, 1, 'class="mark"'),
  );
  putMarkup(find('floor-plan'), floorPlan(traced, width, below > 0 ? t : null));
}

// Turned so that ahead is up.
function floorPlan({ eye, fov: degrees, projectionDistance }, width, t) {
  const { x, y, unit, reach, tick } = kFloor;
  const slope = Math.tan((degrees * Math.PI) / 360);
  const parts = [
    '<pattern id="checks" width="1" height="1" patternUnits="userSpaceOnUse"><rect width="1" height="1" class="check-light"/>' +
      '<rect width="0.5" height="0.5" class="check-dark"/><rect x="0.5" y="0.5" width="0.5" height="0.5" class="check-dark"/></pattern>',
    `<g transform="translate(${x} ${y}) scale(${unit}) rotate(${-90 - eye.heading}) translate(${-eye.x} ${-eye.y})">`,
    box(eye.x - 20, kWallEdge, 40, 30, 'fill="url(#checks)"'),
    box(eye.x - 20, kWallEdge - 1, 40, 1, 'class="bricks"'),
    '</g>',
    line(x, y, x - unit * reach * slope, y - unit * reach, 'class="view-side"'),
    line(x, y, x + unit * reach * slope, y - unit * reach, 'class="view-side"'),
  ];
  if (t !== null) {
    const half = unit * t * slope;
    const rowY = y - unit * t;
    parts.push(line(x - half, rowY, x + half, rowY, 'class="on-glass"'));
    for (let column = tick / 2; column < width; column += tick) {
      const tickX = x + (unit * t * (column + 0.5 - width / 2)) / projectionDistance;
      parts.push(line(tickX, rowY - 6, tickX, rowY + 6, 'class="tick"'));
    }
    const labelX = Math.min(x + half + 10, 440);
    parts.push(
      box(labelX - 4, Math.max(2, rowY - 15), 84, 26, 'class="label-back"'),
      text(labelX, Math.max(20, rowY + 5), `t = ${fixed(t)}`, 'font-size="16"'),
    );
  }
  parts.push(dot(x, y, 9, 'class="eye"'));
  return parts.join('');
}

// ---- All of it together

follow(near, drawNear);
follow(floor, drawFloor);
await Promise.all([flat.whenReady(), old.whenReady()]);
follow(flat, () => {
  bringAlong();
  drawFlat();
});
for (const choice of document.querySelectorAll('[name="projection"]'))
  choice.addEventListener('input', showProjection);
showProjection();
