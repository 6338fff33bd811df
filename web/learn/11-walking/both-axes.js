import { clamp, drawing, dot, fixed, knob, line, numberTable } from '../figures/kit.js';
import { kHalfWidth, solidOf, sweep } from './body.js';
import { arrow, bodyBox, planFrame, planTiles } from './plan.js';

const kArea = [6, 4, 5, 4]; // around the lettered block
const kLongest = 1.4; // units, of a wish

// The body, its move along x, and after that its move along y.
function movesOf(now) {
  return now.kept('moves', () => {
    const solid = solidOf(now);
    const { x, y } = now.eye;
    const [wishX, wishY] = now.state.wish;
    const body = { x, y, r: kHalfWidth };
    const alongX = sweep(solid, body, 'x', wishX);
    const middle = { ...body, x: x + alongX.way };
    const alongY = sweep(solid, middle, 'y', wishY);
    const end = { ...middle, y: y + alongY.way };
    const isInside = [body.x - body.r, body.x + body.r].some((cx) =>
      [body.y - body.r, body.y + body.r].some((cy) => solid(Math.floor(cx), Math.floor(cy))),
    );
    return { wishX, wishY, body, alongX, middle, alongY, end, isInside };
  });
}

function plan(now, { width }) {
  const it = planFrame(width, kArea, 400);
  const { wishX, wishY, body, alongX, middle, alongY, end, isInside } = movesOf(now);
  const from = it.place(body.x, body.y);
  const tip = it.place(body.x + wishX, body.y + wishY);
  const parts = [planTiles(now, it)];
  if (alongX.border !== null)
    parts.push(
      line(
        ...it.place(alongX.border, kArea[1]),
        ...it.place(alongX.border, kArea[1] + kArea[3]),
        'stroke="var(--across)" stroke-width="2.5"',
      ),
    );
  if (alongY.border !== null)
    parts.push(
      line(
        ...it.place(kArea[0], alongY.border),
        ...it.place(kArea[0] + kArea[2], alongY.border),
        'stroke="var(--along)" stroke-width="2.5"',
      ),
    );
  parts.push(
    bodyBox(
      it,
      { ...body, x: body.x + wishX, y: body.y + wishY },
      'fill="none" stroke="var(--soft)" stroke-width="1.5" stroke-dasharray="4 4"',
    ),
    bodyBox(
      it,
      body,
      'fill="var(--paper)" fill-opacity="0.8" stroke="var(--ink)" stroke-width="2"',
    ),
  );
  if (!isInside)
    parts.push(
      bodyBox(
        it,
        middle,
        'fill="var(--across)" fill-opacity="0.2" stroke="var(--across)" stroke-width="2.5"',
      ),
      bodyBox(
        it,
        end,
        'fill="var(--along)" fill-opacity="0.25" stroke="var(--along)" stroke-width="2.5"',
      ),
      dot(...it.place(end.x, end.y), 4, 'fill="var(--along)"'),
    );
  parts.push(
    arrow(from, tip, 'stroke="var(--ink)" fill="var(--ink)" stroke-width="2"'),
    knob(...from, 'eye'),
    knob(...tip, 'ray'),
  );
  return parts.join('');
}

function handles(now, { width }) {
  const it = planFrame(width, kArea, 400);
  const { x, y } = now.eye;
  const [wishX, wishY] = now.state.wish;
  const [px, py] = it.place(x, y);
  const [tx, ty] = it.place(x + wishX, y + wishY);
  const round = (number) => Math.round(number * 50) / 50;
  const bodyAt = (toX, toY) => ({
    eye: {
      x: clamp(round(toX), kArea[0] + 0.3, kArea[0] + kArea[2] - 0.3),
      y: clamp(round(toY), kArea[1] + 0.3, kArea[1] + kArea[3] - 0.3),
    },
  });
  const wishOf = (dx, dy) => {
    const length = Math.max(1, Math.hypot(dx, dy) / kLongest);
    return { wish: [round(dx / length), round(dy / length)] };
  };
  return [
    {
      id: 'body',
      label: 'Body',
      x: px,
      y: py,
      value: Number(x.toFixed(2)),
      least: kArea[0],
      greatest: kArea[0] + kArea[2],
      says: `x ${fixed(x)}, y ${fixed(y)}`,
      drag: (point) => bodyAt(...it.back(point)),
      keys: (right, down) => bodyAt(x + right * 0.04, y + down * 0.04),
    },
    {
      id: 'wish',
      label: 'Wish',
      x: tx,
      y: ty,
      value: wishX,
      least: -kLongest,
      greatest: kLongest,
      says: `${fixed(wishX)} along x, ${fixed(wishY)} along y`,
      drag: (point) => {
        const [toX, toY] = it.back(point);
        return wishOf(toX - x, toY - y);
      },
      keys: (right, down) => wishOf(wishX + right * 0.04, wishY + down * 0.04),
    },
  ];
}

const rowsOf = (now) => {
  const { wishX, wishY, alongX, alongY } = movesOf(now);
  return [
    { axis: 'x', wish: wishX, ...alongX },
    { axis: 'y', wish: wishY, ...alongY },
  ];
};

const stops = ({ wish, border }) =>
  border === null ? (wish === 0 ? 'no wish' : 'nothing') : `the border at ${border}`;

export default {
  scene: 'yard-2.json',
  view: '7.4,6.7,0.5,315',
  options: { fov: 66 },
  state: { wish: [0.9, -0.9] },
  rows: [
    [
      drawing({
        title: 'The body and its wish, from above',
        share: 1.6,
        label: () =>
          'A square body beside the lettered block, the move that is wished, and the two moves that happen',
        height: (width) => planFrame(width, kArea, 400).height,
        markup: plan,
        handles,
      }),
      numberTable({
        title: 'Two tests',
        caption: 'First along x, then along y',
        columns: [
          {
            head: 'Along',
            value: ({ axis }) => `<b class="${axis === 'x' ? 'across' : 'along'}">${axis}</b>`,
          },
          { head: 'Wished', value: ({ wish }) => fixed(wish), class: 'number' },
          { head: 'Free', value: ({ way }) => fixed(way), class: 'number' },
          { head: 'Stopped by', value: stops },
        ],
        items: rowsOf,
      }),
    ],
  ],
  numbers: {
    wayX: (now) => fixed(Math.abs(movesOf(now).alongX.way)),
    wishX: (now) => fixed(Math.abs(movesOf(now).wishX)),
    wayY: (now) => fixed(Math.abs(movesOf(now).alongY.way)),
    wishY: (now) => fixed(Math.abs(movesOf(now).wishY)),
  },
  says: (now) => {
    const { alongX, alongY, isInside } = movesOf(now);
    if (isInside) return 'Here the body is inside a block, which a game never lets happen.';
    if (alongX.border !== null && alongY.border !== null)
      return 'Both moves are stopped: the body is in a corner.';
    if (alongX.border !== null)
      return 'The move along x is stopped, the move along y is free: the body slides.';
    if (alongY.border !== null)
      return 'The move along x is free, the move along y is stopped: the body slides.';
    return 'Nothing is in the way: the body arrives where it wants to be.';
  },
};
