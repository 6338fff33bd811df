// The first lesson: one ray's walk as a plan, as two rulers and as a table, all from the engine's
// trace of one slice.

import { compass, dot, find, fixed, follow, line, markColumn, slider, text } from './lesson.js';
import { putMarkup } from './markup.js';
import { crossingInto, plan, planBox } from './plan.js';

const kKinds = { '#': 'wall', o: 'pillar', b: 'shelf', f: 'wall' };
const kRulers = { left: 36, right: 1044, middle: 92, tall: 34 }; // of the drawing

const caster = find('hall');
const rows = await readRows().catch(() => ['']); // the element itself says what is wrong
find('plan').setAttribute('viewBox', planBox(rows));

let follows = true; // the walk is shown to its end, however long it is

const heading = slider(
  'heading',
  (value) => `${fixed(value, 0)}°, ${compass(value)}`,
  (value) => caster.look({ heading: value }),
);
const column = slider(
  'column',
  (value) => `${value} of ${caster.picture.width || 480}`,
  () => draw(),
);
const shown = slider(
  'shown',
  (value) => (value === 1 ? 'only the first tile' : `${value} tiles`),
  (value) => {
    follows = value >= caster.trace(column.value).walk.length;
    draw();
  },
);

follow(caster, draw);

async function readRows() {
  const answer = await fetch(new URL('scenes/one-ray.json', import.meta.url));
  const { maps } = await answer.json();
  return maps[0].levels[0];
}

function draw() {
  column.spread(caster.picture.width);
  const slice = caster.trace(column.value);
  const count = slice.walk.length;
  shown.greatest = count;
  if (follows) shown.value = count;
  heading.value = Math.round(((((caster.currentView.heading + 180) % 360) + 360) % 360) - 180);
  const tiles = Math.min(shown.value, count);

  markColumn(find('hall-mark'), caster.picture, column.value);
  putMarkup(find('plan'), plan({ rows, kinds: kKinds, slice, shown: tiles }));
  find('plan-says').textContent = sentence(slice);
  putMarkup(find('rulers'), rulers(slice, tiles));
  putMarkup(find('depths').tBodies[0], table(slice, tiles));
  putMarkup(find('drift'), drift(slice));
  find('ray-length').textContent = fixed(Math.hypot(...slice.ray), 3);
}

function sentence({ walk, hits }) {
  const block =
    hits[0] === undefined
      ? 'leaves the map'
      : `meets a ${hits[0].blueprint} at depth ${fixed(hits[0].depth)}`;
  return `Now it comes through ${walk.length} tiles and ${block}.`;
}

// Depth to the right: marks of both rulers, as far as the walk went, and the tiles between them.
function rulers(slice, tiles) {
  const { left, right, middle, tall } = kRulers;
  const farthest = slice.walk.at(-1).depth || 1;
  const place = (depth) => left + ((right - left) * depth) / farthest;
  const parts = [
    `<rect x="0" y="0" width="1080" height="178" class="sheet"/>`,
    line(left, middle, right + 20, middle, 'class="axis"'),
    text(left, 24, 'borders of constant x', 'class="across-text" font-size="15"'),
    text(left, 166, 'borders of constant y', 'class="along-text" font-size="15"'),
    text(right + 20, 166, 'depth t, units', 'class="soft" font-size="15" text-anchor="end"'),
  ];
  let before = 0;
  for (let index = 1; index < slice.walk.length; ++index) {
    const { alongX, depth } = crossingInto(slice, index);
    const x = place(depth);
    const state = index < tiles ? '' : ' opacity="0.25"';
    parts.push(
      line(
        x,
        middle,
        x,
        alongX ? middle - tall : middle + tall,
        `class="${alongX ? 'across-mark' : 'along-mark'}"${state}`,
      ),
    );
    parts.push(dot(x, middle, 4, `class="${alongX ? 'across-fill' : 'along-fill'}"${state}`));
    if (x - place(before) > 36 || index === 1) {
      parts.push(
        text(
          x,
          alongX ? middle - tall - 8 : middle + tall + 20,
          fixed(depth),
          `class="soft" font-size="14" text-anchor="middle"${state}`,
        ),
      );
      before = depth;
    }
  }
  for (let index = 0; index + 1 < slice.walk.length; ++index) {
    const [from, to] = [place(slice.walk[index].depth), place(slice.walk[index + 1].depth)];
    const state = index < tiles ? '' : ' opacity="0.25"';
    if (to - from > 22)
      parts.push(
        text(
          (from + to) / 2,
          middle - 8,
          String(index + 1),
          `class="tile-number" font-size="15" text-anchor="middle"${state}`,
        ),
      );
  }
  parts.push(dot(left, middle, 7, 'class="eye"'));
  return parts.join('');
}

function table(slice, tiles) {
  const body = [];
  for (let index = 1; index < slice.walk.length; ++index) {
    const { alongX, border, distance, speed, depth } = crossingInto(slice, index);
    const eye = alongX ? slice.eye.x : slice.eye.y;
    const ray = alongX ? slice.ray[0] : slice.ray[1];
    const quotient = (distance / speed) * slice.projectionDistance;
    body.push(
      `<tr${index === tiles - 1 ? ' class="now"' : ''}>` +
        `<td class="number">${index + 1}</td>` +
        `<td class="${alongX ? 'across' : 'along'}">${alongX ? 'x' : 'y'} = ${border}</td>` +
        `<td>(${border} − ${fixed(eye, 3)}) ÷ ${ray < 0 ? `(${fixed(ray, 4)})` : fixed(ray, 4)}</td>` +
        `<td class="number">${fixed(quotient, 6)}</td>` +
        `<td class="number">${quotient === depth ? '= ' : ''}${fixed(depth, 6)}</td></tr>`,
    );
  }
  return body.join('');
}

// The error, in units, after adding the gap between two borders of constant x a thousand times.
function drift({ eye, ray }) {
  const gap = 1 / Math.abs(ray[0]);
  const first =
    (ray[0] > 0 ? Math.floor(eye.x) + 1 - eye.x : eye.x - Math.floor(eye.x)) / Math.abs(ray[0]);
  let sum = first;
  for (let i = 0; i < 1000; ++i) sum += gap;
  const error = Math.abs(sum - (1000 + first * Math.abs(ray[0])) / Math.abs(ray[0]));
  if (error === 0 || !Number.isFinite(error)) return 'nothing';
  const [digits, power] = error.toExponential(1).split('e-');
  return `${digits} × 10<sup>−${power}</sup> units`;
}
