// The ray, straightened out: borders of constant x above the line, of constant y below it.

import { crossing } from '../geometry.js';
import { at, box, fixed, kCharacter, line, mark, path, text } from '../markup.js';
import { drawing } from './own.js';

const kLeft = 14;
const kRight = 30;
const kMiddle = 84;
const kTall = 26; // of a mark
const kHeight = 168;

export function rulers({ depths = true, step = null, title, ...others } = {}) {
  return drawing({
    title,
    height: step === null ? kHeight : kHeight + 30,
    ...others,
    label: others.label ?? says,
    markup: (now, { width }) => draw(now, width, depths, step),
  });
}

function says({ slice }) {
  const count = (axis) => slice.walk.filter((tile) => tile.axis === axis).length;
  return `The ray crosses ${count('x')} x borders and ${count('y')} y borders.`;
}

function draw(now, width, depths, step) {
  const { slice, tiles, eyes } = now;
  const { walk } = slice;
  const last = walk.at(-1).depth;
  const end = slice.hits[0]?.depth ?? last;
  const farthest = Math.max(last, end, 0.001);
  const right = width - kRight;
  const place = (depth) => kLeft + ((right - kLeft) * depth) / farthest;
  const current = now.step?.of === 'walk' ? now.step.index : -1;
  const shown = tiles.length;
  const parts = [
    text(0, 15, 'x borders', 'class="across"'),
    text(0, kHeight - 6, 'y borders', 'class="along"'),
    text(width, kHeight - 6, 'depth, units', 'class="soft" text-anchor="end"'),
  ];
  // The tiles between the crossings, with their places in the walk.
  walk.forEach(({ depth }, index) => {
    const [from, to] = [
      place(depth),
      index + 1 < walk.length ? place(walk[index + 1].depth) : width,
    ];
    const isShown = index < shown;
    parts.push(
      box(
        from,
        kMiddle - 9,
        to - from,
        18,
        `class="fig-lit"${isShown ? ` opacity="${at(0.95 - (0.35 * index) / walk.length)}"` : ' opacity="0.08"'}`,
      ),
    );
    if (index === current)
      parts.push(box(from + 1, kMiddle - 8, to - from - 2, 16, 'class="fig-now"'));
    const number = String(index + 1);
    const free = index === 0 ? from + 8 : from; // beside the eye
    if (isShown && to - free > number.length * kCharacter + 4)
      parts.push(
        text((free + to) / 2, kMiddle + 4.5, number, 'class="fig-order" text-anchor="middle"'),
      );
  });
  parts.push(line(kLeft, kMiddle - 9, width, kMiddle - 9, 'class="fig-axis"'));
  parts.push(line(kLeft, kMiddle + 9, width, kMiddle + 9, 'class="fig-axis"'));
  // Labels from the far end, so that the last crossing has one.
  const free = { x: Infinity, y: Infinity };
  for (let index = walk.length - 1; index > 0; --index) {
    const { axis, depth } = crossing(slice, index, eyes);
    const x = place(depth);
    const up = axis === 'x' ? -1 : 1;
    const state = index < shown ? '' : ' opacity="0.28"';
    const tip = kMiddle + up * (9 + kTall);
    const kind = axis === 'x' ? 'across' : 'along';
    parts.push(
      `<g${state}>${line(x, kMiddle + up * 9, x, tip, `class="fig-tick ${kind}"`)}${mark(x, kMiddle + up * (9 + kTall / 2), axis, index === current ? 8 : 5.5)}</g>`,
    );
    const written = fixed(depth);
    const half = (written.length * kCharacter) / 2;
    const middle = Math.max(half, Math.min(width - half, x));
    if (!depths || middle + half + 6 > free[axis]) continue;
    free[axis] = middle - half;
    parts.push(
      text(
        middle,
        axis === 'x' ? tip - 6 : tip + 16,
        written,
        `class="${kind}" text-anchor="middle"${state}`,
      ),
    );
  }
  parts.push(path(`M${kLeft} ${kMiddle}m-7 0a7 7 0 1 0 14 0a7 7 0 1 0 -14 0`, 'class="fig-eye"'));
  if (step !== null)
    parts.push(samples(now, width, place, farthest, typeof step === 'function' ? step(now) : step));
  return parts.join('');
}

// Even steps of a march, below the rulers.
function samples(now, width, place, farthest, step) {
  const y = kHeight + 14;
  const parts = [text(width, y + 14, `steps of ${fixed(step)}`, 'class="ray" text-anchor="end"')];
  for (const depth of range(step, farthest))
    parts.push(line(place(depth), y - 8, place(depth), y, 'class="fig-tick ray"'));
  parts.push(line(kLeft, y, width, y, 'class="fig-axis"'));
  return parts.join('');
}

function range(step, farthest) {
  const list = [];
  for (let i = 1; i * step <= farthest && i < 1000; ++i) list.push(i * step);
  return list;
}
