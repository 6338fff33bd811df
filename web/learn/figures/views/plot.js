// Functions as curves, with an abscissa to drag.

import { clamp, ticks } from '../geometry.js';
import { at, box, dot, fixed, group, kCharacter, knob, line, path, text } from '../markup.js';
import { changeOf, valueOf } from '../now.js';
import { drawing } from './own.js';

const kLeft = 46;
const kTop = 26;
const kFoot = 42;
const kRight = 14;

export function plot({ x, y, lines = [], marks, over, tall = 240, title, ...others }) {
  const rangeOf = (axis, now) =>
    [axis.from, axis.to].map((end) => (typeof end === 'function' ? end(now) : end));
  const frame = (now, width) => {
    const [fromX, toX] = x.field === 'column' ? [0, now.width - 1] : rangeOf(x, now);
    const [fromY, toY] = rangeOf(y, now);
    const [right, bottom] = [width - kRight, tall - kFoot];
    const place = (px, py) => [
      kLeft + ((right - kLeft) * (px - fromX)) / (toX - fromX),
      bottom - ((bottom - kTop) * (py - fromY)) / (toY - fromY),
    ];
    const back = (px) => fromX + ((px - kLeft) / (right - kLeft)) * (toX - fromX);
    return { fromX, toX, fromY, toY, right, bottom, place, back };
  };
  const step = x.step ?? 0.05;
  const even = (value, it) =>
    clamp(Number((Math.round(value / step) * step).toFixed(6)), it.fromX, it.toX);
  const stepOf = x.field === 'column' ? 1 : step;
  const digits = stepOf >= 1 ? 0 : 2;
  return drawing({
    title,
    height: tall,
    ...others,
    label:
      others.label ??
      ((now) =>
        `${y.label} by ${x.label}${x.field ? ` at ${fixed(valueOf(now.state, x.field))}` : ''}`),
    markup(now, size) {
      const it = frame(now, size.width);
      return draw(now, it, size, { x, y, lines, marks, over });
    },
    handles(now, { width }) {
      if (!x.field) return [];
      const it = frame(now, width);
      const value = valueOf(now.state, x.field);
      return [
        {
          id: `x-${x.field}`,
          label: x.label,
          axis: 'x',
          x: it.place(value, 0)[0],
          y: it.bottom,
          value,
          least: it.fromX,
          greatest: it.toX,
          unit: stepOf,
          says: `${fixed(value, digits)} ${x.unit ?? ''}`,
          drag: (point) =>
            changeOf(
              x.field,
              x.field === 'column' ? Math.round(it.back(point.x)) : even(it.back(point.x), it),
            ),
          keys: (right, down) =>
            changeOf(
              x.field,
              clamp(Number((value + stepOf * (right || -down)).toFixed(6)), it.fromX, it.toX),
            ),
        },
      ];
    },
  });
}

function draw(now, it, { width, id: key }, { x, y, lines, marks, over }) {
  const { place, right, bottom } = it;
  const id = `${key}-clip`;
  const parts = [box(kLeft, kTop, right - kLeft, bottom - kTop, 'class="fig-ground"')];
  for (const tick of ticks(it.fromX, it.toX, Math.max(2, (right - kLeft) / 70))) {
    const [px] = place(tick, 0);
    parts.push(
      line(px, kTop, px, bottom, 'class="fig-grid"'),
      text(px, bottom + 17, write(tick), 'class="soft" text-anchor="middle"'),
    );
  }
  for (const tick of ticks(it.fromY, it.toY, 4)) {
    const [, py] = place(it.fromX, tick);
    parts.push(
      line(kLeft, py, right, py, 'class="fig-grid"'),
      text(kLeft - 7, py + 4.5, write(tick), 'class="soft" text-anchor="end"'),
    );
  }
  parts.push(
    text(0, 13, y.label, 'class="fig-name"'),
    text(width, bottom + 36, x.label, 'class="soft" text-anchor="end"'),
  );
  const value = x.field ? valueOf(now.state, x.field) : null;
  const curves = lines.map((curve) => ({
    ...curve,
    kind: curve.class ?? 'ray',
    points: pointsOf(curve, now, it),
  }));
  const inner = curves.map(({ points, kind }) =>
    path(
      `M${points
        .map((p) =>
          place(...p)
            .map(at)
            .join(' '),
        )
        .join('L')}`,
      `class="fig-curve ${kind}"`,
    ),
  );
  if (value !== null)
    inner.push(line(place(value, 0)[0], kTop, place(value, 0)[0], bottom, 'class="fig-abscissa"'));
  parts.push(
    `<clipPath id="${id}">${box(kLeft, kTop - 3, right - kLeft, bottom - kTop + 6)}</clipPath>`,
  );
  parts.push(group(`clip-path="url(#${id})"`, inner));
  if (value !== null)
    for (const { of, kind } of curves) {
      const itsY = of?.(value, now);
      if (
        itsY === undefined ||
        itsY === null ||
        !Number.isFinite(itsY) ||
        itsY < it.fromY ||
        itsY > it.toY
      )
        continue;
      const [px, py] = place(value, itsY);
      const written = fixed(itsY, y.digits ?? 2);
      const isLeft = px + 10 + written.length * kCharacter > right;
      parts.push(
        dot(px, py, 5, `class="fig-curve-dot ${kind}"`),
        text(
          px + (isLeft ? -9 : 9),
          clamp(py - 8, kTop + 12, bottom - 4),
          written,
          `class="${kind} halo"${isLeft ? ' text-anchor="end"' : ''}`,
        ),
      );
    }
  // The names of the curves in the upper margin, from the right.
  let end = width;
  for (const { label, kind } of [...curves].reverse()) {
    if (!label) continue;
    parts.push(text(end, 13, label, `class="${kind}" text-anchor="end"`));
    end -= (label.length + 1) * kCharacter;
    parts.push(line(end - 16, 9, end, 9, `class="fig-curve ${kind}"`));
    end -= 34;
  }
  for (const each of marks?.(now) ?? []) {
    const [px, py] = place(each.x, each.y ?? it.fromY);
    parts.push(dot(px, py, 4, `class="fig-curve-dot ${each.class ?? 'ray'}"`));
    if (each.label)
      parts.push(
        text(
          clamp(px, kLeft + 20, right - 20),
          py - 9,
          each.label,
          'class="halo" text-anchor="middle"',
        ),
      );
  }
  parts.push(over?.(now, place) ?? '');
  if (value !== null) parts.push(knob(place(value, 0)[0], bottom, 'ray', 9, 'x'));
  return parts.join('');
}

const write = (number) => String(number).replace('-', '−');

function pointsOf({ of, points }, now, { fromX, toX }) {
  if (points) return points(now);
  const list = [];
  const count = 120;
  for (let i = 0; i <= count; ++i) {
    const px = fromX + ((toX - fromX) * i) / count;
    const py = of(px, now);
    if (py !== null && py !== undefined && !Number.isNaN(py)) list.push([px, clamp(py, -1e6, 1e6)]);
  }
  return list;
}
