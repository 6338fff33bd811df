// Twelve columns on the pane, from above: evenly spaced on the pane, or at equal angles.

import { choice, degrees, dot, drawing, fixed, line, slider, text } from '../figures/kit.js';

const kMargin = 16;
const kColumns = 12;
const kWidest = 120; // degrees: fills the drawing

const tangentOf = (fov) => Math.tan((fov * Math.PI) / 360);

// The eye keeps its distance from the pane, which becomes wider with the field of view.
function frameOf(now, width) {
  const distance = Math.min((width / 2 - kMargin) / tangentOf(kWidest), 190);
  const half = distance * tangentOf(now.slice.fov);
  const pane = 92;
  return { half, distance, pane, middle: width / 2, height: Math.round(pane + distance + 24) };
}

const isEven = ({ state }) => state.way === 'pane';

// Where the border before column i is on the pane: -1 to 1.
function placeOf(i, now) {
  const part = (2 * i) / kColumns - 1;
  if (isEven(now)) return part;
  const angle = (now.slice.fov * Math.PI) / 360;
  return Math.tan(part * angle) / Math.tan(angle);
}

function markup(now, { width }) {
  const { half, distance, pane, middle } = frameOf(now, width);
  const eye = pane + distance;
  const parts = [];
  for (let i = 0; i < kColumns; ++i) {
    const [from, to] = [placeOf(i, now), placeOf(i + 1, now)].map((place) => middle + half * place);
    parts.push(
      `<path d="M${middle} ${eye.toFixed(2)}L${from.toFixed(2)} ${pane}H${to.toFixed(2)}Z" fill="${i % 2 ? 'var(--lit)' : 'var(--sheet)'}" fill-opacity="${i % 2 ? 0.55 : 1}"/>`,
    );
  }
  for (let i = 0; i <= kColumns; ++i) {
    const x = middle + half * placeOf(i, now);
    parts.push(
      line(middle, eye, x, pane, 'stroke="var(--rule)"'),
      line(x, pane - 12, x, pane, 'stroke="var(--ink)" stroke-width="1.5"'),
    );
  }
  const wide = (i) => ((placeOf(i + 1, now) - placeOf(i, now)) * kColumns) / 2;
  parts.push(
    line(middle - half, pane, middle + half, pane, 'stroke="var(--ink)" stroke-width="3"'),
    text(
      middle,
      pane - 38,
      `middle: ${fixed(wide(kColumns / 2))}`,
      'text-anchor="middle" class="strong"',
    ),
    text(middle - half, pane - 22, `edge: ${fixed(wide(0))}`, 'text-anchor="start" class="strong"'),
    text(middle, 22, 'width of a column on the pane', 'text-anchor="middle" class="soft"'),
    dot(middle, eye, 8, 'fill="var(--ink)" stroke="var(--paper)" stroke-width="2"'),
  );
  return parts.join('');
}

export default {
  scene: 'long-wall.json',
  view: '20.5,3.2,0.5,270',
  state: { way: 'angles' },
  controls: [
    choice({
      label: 'Columns',
      field: 'way',
      of: { angles: 'at equal angles', pane: 'at equal distances' },
      opening: 'angles',
    }),
    slider({
      label: 'Field of view',
      option: 'fov',
      from: 60,
      to: kWidest,
      step: 1,
      unit: '°',
      opening: 100,
    }),
  ],
  rows: [
    [
      drawing({
        label: (now) =>
          `Twelve columns from above, ${isEven(now) ? 'at equal distances on the pane' : 'at equal angles'}, with a field of view of ${degrees(now.slice.fov)}`,
        height: (width, now) => frameOf(now, width).height,
        markup,
      }),
    ],
  ],
  says: (now) =>
    isEven(now)
      ? 'Each column covers the same length of the pane.'
      : 'Each column covers the same angle. On the pane, columns at the edge are wider.',
};
