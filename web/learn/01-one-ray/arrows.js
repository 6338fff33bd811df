// The arrows forward and right on the compass, and the ray as their sum.

import {
  across,
  along,
  compass,
  degrees,
  dot,
  drawing,
  fixed,
  knob,
  line,
  path,
  picture,
  polygon,
  rayOf,
  slider,
  text,
} from '../figures/kit.js';

const kMargin = 30;

function frameOf(width) {
  const unit = Math.min((width - 2 * kMargin) / 3, 172); // pixels of an arrow of length 1
  return { unit, x: width / 2, y: kMargin + 1.42 * unit, height: 2 * kMargin + 2.84 * unit };
}

const arrowsOf = ({ heading }) => {
  const angle = (heading * Math.PI) / 180;
  return {
    forward: [Math.cos(angle), Math.sin(angle)],
    right: [-Math.sin(angle), Math.cos(angle)],
  };
};
const slopeOfColumn = (now) => (now.column + 0.5 - now.width / 2) / now.slice.projectionDistance;
const pair = ([x, y], digits = 3) => `(${fixed(x, digits)}, ${fixed(y, digits)})`;

function arrow(from, to, colour, thick) {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length < 3) return '';
  const [ux, uy] = [dx / length, dy / length];
  const size = Math.min(11, length);
  const neck = [to[0] - size * ux, to[1] - size * uy];
  return (
    line(...from, ...neck, `stroke="${colour}" stroke-width="${thick}"`) +
    polygon(
      [
        to,
        [neck[0] - 0.5 * size * uy, neck[1] + 0.5 * size * ux],
        [neck[0] + 0.5 * size * uy, neck[1] - 0.5 * size * ux],
      ],
      `fill="${colour}"`,
    )
  );
}

function markup(now, { width }) {
  const it = frameOf(width);
  const { unit } = it;
  const { forward, right } = arrowsOf(now.eye);
  const k = slopeOfColumn(now);
  const eye = [it.x, it.y];
  const at = (...vectors) => [
    it.x + unit * vectors.reduce((sum, [v, f = 1]) => sum + f * v[0], 0),
    it.y + unit * vectors.reduce((sum, [v, f = 1]) => sum + f * v[1], 0),
  ];
  const slope = now.width / 2 / now.slice.projectionDistance;
  const tip = at([forward]);
  const end = at([forward], [right, k]);
  const names = [
    ['E', 1, 0],
    ['S', 0, 1],
    ['W', -1, 0],
    ['N', 0, -1],
  ].map(([name, x, y]) =>
    text(
      it.x + (unit + 16) * x,
      it.y + (unit + 16) * y + 5,
      name,
      'text-anchor="middle" class="soft"',
    ),
  );
  return [
    dot(...eye, unit, 'fill="var(--sheet)" stroke="var(--rule)" stroke-width="2"'),
    line(it.x - unit, it.y, it.x + unit, it.y, 'stroke="var(--rule)"'),
    line(it.x, it.y - unit, it.x, it.y + unit, 'stroke="var(--rule)"'),
    ...names,
    // The pane, and what is seen through it.
    polygon(
      [eye, at([forward], [right, -slope]), at([forward], [right, slope])],
      'fill="var(--lit)" fill-opacity="0.16"',
    ),
    line(
      ...at([forward], [right, -slope]),
      ...at([forward], [right, slope]),
      'stroke="var(--ink)" stroke-width="2"',
    ),
    // Cosine and sine: the legs of the arrow forward.
    line(...eye, tip[0], it.y, 'stroke="var(--across)" stroke-width="4" stroke-linecap="round"'),
    line(tip[0], it.y, ...tip, 'stroke="var(--along)" stroke-width="4" stroke-linecap="round"'),
    legs(it, forward, end),
    arc(it, now.eye.heading),
    arrow(eye, tip, 'var(--ink)', 3),
    arrow(eye, at([right, 0.55]), 'var(--soft)', 2),
    arrow(tip, end, 'var(--soft)', 4),
    arrow(eye, end, 'var(--ray)', 4),
    label(at([right, 0.55]), right, 'right'),
    dot(...eye, 7, 'fill="var(--ray)" stroke="var(--paper)" stroke-width="2"'),
    knob(...tip, 'turn', 9),
    knob(...end, 'ray'),
    ...endLabels(tip, end, forward, k),
  ].join('');
}

// Names of the legs: below or above the one, and beside the other where the ray is not.
function legs({ x, y, unit }, [cosine, sine], end) {
  const parts = [];
  if (Math.abs(cosine) * unit > 60)
    parts.push(
      text(
        x + (unit * cosine) / 2,
        y + (sine < 0 ? 18 : -8),
        'cos h',
        'text-anchor="middle" class="halo across"',
      ),
    );
  const isRayOutside = (end[0] - x) / (unit * cosine) > 1;
  const side = Math.sign(cosine) * (isRayOutside ? -1 : 1);
  if (Math.abs(sine) * unit > 40)
    parts.push(
      text(
        x + unit * cosine + 8 * side,
        y + unit * sine * 0.4 + 5,
        'sin h',
        `text-anchor="${side < 0 ? 'end' : 'start'}" class="halo along"`,
      ),
    );
  return parts.join('');
}

// The heading, clockwise from east.
function arc({ x, y }, heading) {
  const angle = (heading * Math.PI) / 180;
  const radius = 26;
  const end = [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
  return path(
    `M${x + radius} ${y}A${radius} ${radius} 0 ${heading > 180 ? 1 : 0} 1 ${end.map((n) => n.toFixed(2)).join(' ')}`,
    'fill="none" stroke="var(--soft)" stroke-width="1.5"',
  );
}

function label([x, y], [dx, dy], content, kind = '') {
  return text(
    x + 14 * dx,
    y + 14 * dy + 5,
    content,
    `text-anchor="${dx > 0.35 ? 'start' : dx < -0.35 ? 'end' : 'middle'}" class="halo ${kind}"`,
  );
}

// Names of the arrow forward and of the ray, apart from each other.
function endLabels(tip, end, forward, k) {
  const [dx, dy] = forward;
  const away = (point, side) => [
    point[0] + side * -dy * 6 + 6 * dx,
    point[1] + side * dx * 6 + 6 * dy,
  ];
  const near = Math.abs(k) < 0.16;
  return [
    near ? '' : label(away(tip, k > 0 ? -1 : 1), forward, 'forward'),
    label(away(end, k > 0 ? 1 : -1), forward, near ? 'forward, and the ray' : 'ray', 'ray'),
  ];
}

function handles(now, { width }) {
  const { unit, x, y } = frameOf(width);
  const { forward, right } = arrowsOf(now.eye);
  const k = slopeOfColumn(now);
  return [
    {
      id: 'heading',
      label: 'Heading',
      x: x + unit * forward[0],
      y: y + unit * forward[1],
      value: Math.round(now.eye.heading),
      least: 0,
      greatest: 360,
      says: `${fixed(now.eye.heading, 0)} degrees, ${compass(now.eye.heading)}`,
      drag: (point) => ({
        eye: { heading: Math.round((Math.atan2(point.y - y, point.x - x) * 180) / Math.PI) },
      }),
      keys: (toRight) => ({ eye: { heading: now.state.eye.heading + toRight } }),
    },
    {
      id: 'column',
      label: 'Column',
      x: x + unit * (forward[0] + k * right[0]),
      y: y + unit * (forward[1] + k * right[1]),
      value: now.column,
      least: 0,
      greatest: now.width - 1,
      says: `column ${now.column} of ${now.width}`,
      drag: (point) => {
        const side = ((point.x - x) * right[0] + (point.y - y) * right[1]) / unit;
        return { column: Math.floor(side * now.slice.projectionDistance + now.width / 2) };
      },
      keys: (toRight) => ({ column: now.state.column + toRight }),
    },
  ];
}

export default {
  scene: 'yard-1.json',
  view: '1.6,6.7,0.5,325',
  options: { fov: 66 },
  state: { column: 420 },
  controls: [
    slider({ label: 'Heading', eye: 'heading', from: 0, to: 359, step: 1, unit: '°' }),
    slider({ label: 'Column', field: 'column' }),
  ],
  rows: [
    [
      drawing({
        label: (now) =>
          `A compass with the arrow forward ${pair(arrowsOf(now.eye).forward)} and the ray ${pair(now.slice.ray)}`,
        height: (width) => frameOf(width).height,
        markup,
        handles,
      }),
      picture({ handles: ['column', 'turn'] }),
    ],
  ],
  numbers: {
    heading: (now) => degrees(now.eye.heading),
    column: (now) => String(now.column),
    forward: (now) => pair(arrowsOf(now.eye).forward),
    k: (now) => fixed(slopeOfColumn(now), 3),
    ray: (now) => pair(rayOf(now.eye, now.column, now.size, now.slice.fov)),
    engine: (now) => pair(now.slice.ray),
  },
  says: (now) => {
    const { forward, right } = arrowsOf(now.eye);
    const k = slopeOfColumn(now);
    const sum = (index) =>
      `${fixed(forward[index], 3)} + ${fixed(k, 3)} × ${fixed(right[index], 3)}`;
    const [x, y] = now.slice.ray;
    return `${across(`x: ${sum(0)} = ${fixed(x, 3)}`)}, ${along(`y: ${sum(1)} = ${fixed(y, 3)}`)}`;
  },
};
