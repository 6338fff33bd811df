// A part of the map from above, for this chapter's figures.
import { box, line, path, text } from '../figures/kit.js';
import { groundOf } from './body.js';

// `area` is [west, north, width, depth] in tiles. place(x, y) gives pixels, back(point) the map.
export function planFrame(width, [west, north, wide, deep], tallest) {
  const unit = Math.min((width - 8) / wide, (tallest - 8) / deep);
  const left = (width - unit * wide) / 2;
  return {
    unit,
    height: Math.round(unit * deep + 8),
    place: (x, y) => [left + unit * (x - west), 4 + unit * (y - north)],
    back: (point) => [west + (point.x - left) / unit, north + (point.y - 4) / unit],
    area: [west, north, wide, deep],
  };
}

// Tiles with their heights above the floor.
export function planTiles(now, { place, unit, area: [west, north, wide, deep] }) {
  const ground = groundOf(now);
  const [left, top] = place(west, north);
  const parts = [box(left, top, unit * wide, unit * deep, 'class="fig-ground"')];
  for (let y = north; y < north + deep; ++y) {
    for (let x = west; x < west + wide; ++x) {
      const height = ground(x, y);
      if (height === 0) continue;
      const [px, py] = place(x, y);
      parts.push(
        box(
          px,
          py,
          unit,
          unit,
          `class="fig-block" fill="var(--stone)" fill-opacity="${height > 0.5 ? 1 : 0.35}"`,
        ),
      );
      if (Number.isFinite(height) && unit > 34)
        parts.push(
          text(
            px + unit - 6,
            py + unit - 8,
            now.fixed(height, height % 0.5 === 0 ? 1 : 2),
            'class="on-block" text-anchor="end"',
          ),
        );
    }
  }
  for (let x = west; x <= west + wide; ++x)
    parts.push(line(...place(x, north), ...place(x, north + deep), 'class="fig-grid"'));
  for (let y = north; y <= north + deep; ++y)
    parts.push(line(...place(west, y), ...place(west + wide, y), 'class="fig-grid"'));
  return parts.join('');
}

// A body's outline. `look` are SVG attributes.
export function bodyBox({ place, unit }, { x, y, r }, look) {
  const [px, py] = place(x - r, y - r);
  return box(px, py, 2 * r * unit, 2 * r * unit, look);
}

export function arrow(from, to, look) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 1) return '';
  const [ux, uy] = [dx / length, dy / length];
  const head = Math.min(10, length);
  const back = [to[0] - head * ux, to[1] - head * uy];
  const side = head * 0.5;
  const points = [
    to,
    [back[0] - side * uy, back[1] + side * ux],
    [back[0] + side * uy, back[1] - side * ux],
  ];
  return (
    line(...from, ...back, look) +
    path(`M${points.map((point) => point.map((n) => n.toFixed(1)).join(' ')).join('L')}Z`, look)
  );
}
