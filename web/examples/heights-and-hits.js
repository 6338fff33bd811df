// The third lesson: one slice of a world with heights, as a strip of rows, from the side, and as a
// list.

import { at, box, dot, find, fixed, follow, line, markColumn, slider, text } from './lesson.js';
import { escape, putMarkup } from './markup.js';

const kRunNames = {
  side: 'side',
  roof: 'roof',
  underside: 'underside',
  floor: 'floor',
  ceiling: 'ceiling',
  sky: 'sky',
  haze: 'haze',
};
const kFaces = { north: 'north', east: 'east', south: 'south', west: 'west' };

const caster = find('yard');

let follows = true; // all runs are shown, however many there are

const column = slider('column', (value) => `${value} of ${caster.picture.width || 480}`, draw);
const turn = slider(
  'turn',
  (value) => `${fixed(value, 0)}°`,
  (value) => caster.look({ heading: value }),
);
const filled = slider(
  'filled',
  (value) => (value === 0 ? 'nothing' : value === 1 ? '1 run' : `${value} runs`),
  (value) => {
    follows = value >= opaqueRuns(caster.trace(column.value)).length;
    draw();
  },
);

follow(caster, draw);

// Front to back. The lesson's scene has no see-through runs.
function opaqueRuns({ runs }) {
  return runs.filter(({ layer }) => !layer);
}

function draw() {
  column.spread(caster.picture.width);
  const slice = caster.trace(column.value);
  const runs = opaqueRuns(slice);
  filled.greatest = runs.length;
  if (follows) filled.value = runs.length;
  turn.value = Math.round(((caster.currentView.heading + 180) % 360) - 180);
  const shown = runs.slice(0, filled.value);

  markColumn(find('yard-mark'), caster.picture, column.value);
  putMarkup(find('strip'), strip(slice, shown));
  const width = find('side').clientWidth < kSide.phone ? kSide.narrow : kSide.wide;
  find('side').setAttribute('viewBox', `0 0 ${width} ${kSide.bottom}`);
  putMarkup(find('side'), side(slice, shown, width));
  find('side-says').textContent =
    `Now the ray passes ${slice.hits.length} blocks, and ${runs.length} runs fill the ${slice.size[1]} rows.`;
  putMarkup(find('hits').tBodies[0], table(slice, shown));
}

function nameOf({ hits }, { what, hit }) {
  return hit === null ? kRunNames[what] : `${hits[hit].blueprint}, ${kRunNames[what]}`;
}

// ---- The rows of the slice, as tall as the drawing

const kStrip = { left: 12, width: 120, height: 394, right: 420, label: 22 }; // a label's height

function strip(slice, shown) {
  const { left, width, height, right, label } = kStrip;
  const scale = height / slice.size[1];
  const parts = [
    '<pattern id="hatch" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)"><rect width="8" height="8" class="open"/><rect width="2" height="8" class="open-line"/></pattern>',
    box(left, 0, width, height, 'fill="url(#hatch)"'),
  ];
  const labels = shown
    .map((run, index) => ({ run, index, middle: (scale * (run.first + run.last + 1)) / 2 }))
    .sort((a, b) => a.middle - b.middle);
  spread(labels, label, height);
  for (const { run, index, middle, y } of labels) {
    const top = scale * run.first;
    parts.push(
      box(
        left,
        top,
        width,
        scale * (run.last + 1 - run.first),
        `class="run ${run.what}${index === shown.length - 1 ? ' newest' : ''}"`,
      ),
    );
    parts.push(
      `<path d="M${at(left + width)} ${at(middle)}H${at(left + width + 8)}L${at(left + width + 22)} ${at(y)}" class="leader"/>`,
    );
    parts.push(text(left + width + 28, y + 5, `${index + 1}`, 'class="run-number" font-size="15"'));
    parts.push(text(left + width + 52, y + 5, nameOf(slice, run), 'font-size="15"'));
    parts.push(
      text(
        right - 4,
        y + 5,
        run.first === run.last ? `${run.first}` : `${run.first}–${run.last}`,
        'class="soft" font-size="14" text-anchor="end"',
      ),
    );
  }
  parts.push(
    line(
      left - 8,
      scale * slice.horizonRow,
      left + width,
      scale * slice.horizonRow,
      'class="horizon"',
    ),
  );
  return parts.join('');
}

// Labels beside their rows, pushed apart so that they do not touch.
function spread(labels, tall, height) {
  let lowest = tall / 2;
  for (const label of labels) {
    label.y = Math.max(label.middle, lowest);
    lowest = label.y + tall;
  }
  let highest = height - tall / 2;
  for (const label of [...labels].reverse()) {
    label.y = Math.min(label.y, highest);
    highest = label.y - tall;
  }
}

// ---- From the side

// `wide` and `narrow` are widths of the drawing; it is narrow in boxes of less than `phone`.
const kSide = { left: 56, top: 16, floor: 340, bottom: 380, wide: 1080, narrow: 560, phone: 640 };

function side(slice, shown, width) {
  const { left, top, floor, bottom } = kSide;
  const right = width - 16;
  const { eye, hits, horizonRow, projectionDistance } = slice;
  const farthest =
    Math.max(
      4,
      ...hits.map(({ backDepth, depth }) => Math.min(backDepth ?? depth + 1, depth + 2)),
    ) * 1.04;
  const highest = Math.max(eye.z + 0.5, ...hits.map((hit) => hit.top)) * 1.12;
  const unitX = (right - left) / farthest;
  const unitZ = (floor - top) / highest;
  const x = (depth) => left + unitX * Math.min(depth, farthest * 1.1);
  const y = (z) => floor - unitZ * z;
  const slope = (row) => (horizonRow - row) / projectionDistance;

  // Where the ray through the upper or lower edge of a row meets the run's surface.
  const reach = (run, row) => {
    const s = slope(row);
    const hit = run.hit === null ? null : hits[run.hit];
    if (run.what === 'side') return [hit.depth, eye.z + s * hit.depth];
    const height = { roof: hit?.top, underside: hit?.bottom, floor: 0 }[run.what];
    const depth =
      height === undefined || (height - eye.z) / s < 0 ? Infinity : (height - eye.z) / s;
    const end = Math.min(depth, farthest * 1.1);
    return [end, depth === end ? height : eye.z + s * end];
  };

  const parts = [
    `<clipPath id="side-clip"><rect x="${left}" y="0" width="${width - left}" height="${bottom}"/></clipPath>`,
    box(left, floor, width - left, bottom - floor, 'class="ground"'),
    '<g clip-path="url(#side-clip)">',
  ];
  for (const run of shown) {
    const [upper, lower] = [reach(run, run.first), reach(run, run.last + 1)];
    const points = [[0, eye.z], upper, lower]
      .map(([depth, z]) => `${at(left + unitX * depth)},${at(y(z))}`)
      .join(' ');
    parts.push(`<polygon points="${points}" class="wedge ${run.what}"/>`);
  }
  for (const hit of hits) {
    const isSeen = shown.some((run) => run.hit !== null && hits[run.hit] === hit);
    parts.push(
      box(
        x(hit.depth),
        y(hit.top),
        x(hit.backDepth ?? farthest * 1.1) - x(hit.depth),
        unitZ * (hit.top - hit.bottom),
        `class="solid${isSeen ? ' seen' : ''}"`,
      ),
    );
  }
  for (const run of shown) {
    const [upper, lower] = [reach(run, run.first), reach(run, run.last + 1)];
    if (run.what !== 'sky' && run.what !== 'haze')
      parts.push(
        line(x(upper[0]), y(upper[1]), x(lower[0]), y(lower[1]), `class="seen-edge ${run.what}"`),
      );
  }
  parts.push('</g>');
  shown.forEach((run, index) => {
    if (run.what === 'sky' || run.what === 'haze') return;
    const [upper, lower] = [reach(run, run.first), reach(run, run.last + 1)];
    const [markX, markY] = [(x(upper[0]) + x(lower[0])) / 2, (y(upper[1]) + y(lower[1])) / 2];
    if (markX > left && markX < width - 12)
      parts.push(
        dot(markX, markY, 10, 'class="badge"'),
        text(
          markX,
          markY + 5,
          String(index + 1),
          'class="badge-number" font-size="13" text-anchor="middle"',
        ),
      );
  });
  for (let depth = 0; x(depth) < width - 130; depth += farthest > 10 ? 2 : 1)
    parts.push(
      text(x(depth), floor + 26, String(depth), 'class="soft" font-size="14" text-anchor="middle"'),
    );
  for (let z = 0; z <= highest; ++z)
    parts.push(
      text(left - 26, y(z) + 5, String(z), 'class="soft" font-size="14" text-anchor="end"'),
      line(left - 20, y(z), left - 12, y(z), 'class="measure"'),
    );
  parts.push(
    text(width - 12, bottom - 8, 'depth, units', 'class="soft" font-size="14" text-anchor="end"'),
    dot(left, y(eye.z), 9, 'class="eye"'),
  );
  return parts.join('');
}

// ---- The list

function table(slice, shown) {
  const newest = shown.at(-1)?.hit ?? null;
  return slice.hits
    .map((hit, index) => {
      const runs = shown
        .map((run, order) => ({ run, order }))
        .filter(({ run }) => run.hit === index);
      const rows = runs
        .map(
          ({ run, order }) =>
            `<span class="swatch ${run.what}"></span>${order + 1}: ${kRunNames[run.what]} ${run.first}–${run.last}`,
        )
        .join('<br>');
      const isSeen = slice.runs.some((run) => run.hit === index);
      return (
        `<tr class="${index === newest ? 'now' : isSeen ? '' : 'unseen'}"><td>${escape(hit.blueprint)}</td><td>${hit.tile.join(', ')}</td><td class="number">${hit.level}</td>` +
        `<td>${hit.face === null ? 'you are above it' : kFaces[hit.face]}</td><td class="number">${fixed(hit.depth)}</td><td class="number">${hit.backDepth === null ? '∞' : fixed(hit.backDepth)}</td>` +
        `<td class="number">${fixed(hit.bottom)}</td><td class="number">${fixed(hit.top)}</td><td>${rows || (isSeen ? '…' : 'none')}</td></tr>`
      );
    })
    .join('');
}
