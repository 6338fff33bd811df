import { choice, drawing, dot, fixed, path, picture, slider } from '../figures/kit.js';
import { kHalfWidth, solidOf, sweep, units } from './body.js';
import { bodyBox, planFrame, planTiles } from './plan.js';

const kArea = [6, 4, 5, 4];
const kStart = { x: 6.7, y: 7.5 };
const kLength = 4.2; // units, of the way that is wished
const kParts = 84;
const kWays = { point: 'A point that stops', box: 'A box that stops', slide: 'A box that slides' };
const kLooks = {
  slide: { colour: 'good', dash: 'none', wide: 8 },
  box: { colour: 'link', dash: '9 5', wide: 5 },
  point: { colour: 'ray', dash: '2 5', wide: 2.5 },
};

// The places of a walker, from the start on.
export function walk(solid, way, heading) {
  const angle = (heading * Math.PI) / 180;
  const [dx, dy] = [Math.cos(angle), Math.sin(angle)].map((part) =>
    units((part * kLength) / kParts),
  );
  const r = way === 'point' ? 0 : kHalfWidth;
  const places = [{ x: units(kStart.x), y: units(kStart.y) }];
  for (let part = 0; part < kParts; ++part) {
    const { x, y } = places.at(-1);
    const alongX = sweep(solid, { x, y, r: Math.max(r, 1 / 4096) }, 'x', dx);
    const alongY = sweep(solid, { x: x + alongX.way, y, r: Math.max(r, 1 / 4096) }, 'y', dy);
    places.push({ x: x + alongX.way, y: y + alongY.way });
    if (way !== 'slide' && (alongX.border !== null || alongY.border !== null)) break;
  }
  return places;
}

const walksOf = (now) =>
  now.kept('walks', () => {
    const solid = solidOf(now);
    return Object.fromEntries(
      Object.keys(kWays).map((way) => [way, walk(solid, way, now.state.wish)]),
    );
  });

function plan(now, { width }) {
  const it = planFrame(width, kArea, 400);
  const parts = [planTiles(now, it)];
  for (const [way, { colour, dash, wide }] of Object.entries(kLooks)) {
    const places = walksOf(now)[way];
    const isChosen = way === now.state.way;
    const points = places.map(({ x, y }) =>
      it
        .place(x, y)
        .map((n) => n.toFixed(1))
        .join(' '),
    );
    const end = places.at(-1);
    parts.push(
      path(
        `M${points.join('L')}`,
        `fill="none" stroke="var(--${colour})" stroke-width="${wide}" stroke-opacity="${isChosen ? 1 : 0.55}" stroke-dasharray="${dash}"`,
      ),
      way === 'point'
        ? ''
        : bodyBox(
            it,
            { ...end, r: kHalfWidth },
            `fill="var(--${colour})" fill-opacity="0.2" stroke="var(--${colour})" stroke-width="${isChosen ? 3.5 : 2}"`,
          ),
      dot(
        ...it.place(end.x, end.y),
        isChosen ? 8 : 5,
        `fill="var(--${colour})" stroke="var(--paper)" stroke-width="1.5"`,
      ),
    );
  }
  parts.push(dot(...it.place(kStart.x, kStart.y), 5, 'fill="var(--ink)"'));
  return parts.join('');
}

export default {
  scene: 'yard-2.json',
  view: '7.8000030517578125,6.7646026611328125,0.5,327',
  options: { fov: 66 },
  state: { way: 'box', wish: 327 },
  // The eye is where the chosen walker ends.
  check(state, now) {
    if (now === null) return {};
    const { x, y } = walk(solidOf(now), state.way, state.wish).at(-1);
    return { eye: { x, y, heading: state.wish } };
  },
  controls: [
    choice({ label: 'See through the eyes of', field: 'way', of: kWays }),
    slider({ label: 'Wish', field: 'wish', from: 285, to: 350, step: 1, unit: '°' }),
  ],
  rows: [
    [
      picture({ title: 'What this walker sees in the end', mark: 'none', handles: [] }),
      drawing({
        title: 'Three walkers with one wish',
        height: (width) => planFrame(width, kArea, 400).height,
        label: (now) => {
          const ends = Object.entries(walksOf(now)).map(
            ([way, places]) =>
              `${kWays[way]} ends at ${fixed(places.at(-1).x)}, ${fixed(places.at(-1).y)}`,
          );
          return ends.join('; ');
        },
        markup: plan,
      }),
    ],
  ],
  numbers: { x: (now) => fixed(walksOf(now).slide.at(-1).x) },
  says: (now) => {
    const { x, y } = walksOf(now)[now.state.way].at(-1);
    const dash = { point: 'dotted', box: 'dashed', slide: 'solid' }[now.state.way];
    const end = `${kWays[now.state.way]} (the ${dash} line) ends at ${fixed(x)}, ${fixed(y)}.`;
    const touches = now.state.way === 'point' && walksOf(now).point.length <= kParts;
    return touches ? `${end} Its eye is on the wall: few texels fill the picture.` : end;
  },
};
