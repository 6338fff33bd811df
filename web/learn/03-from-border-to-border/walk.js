import { codeView, mapView, numberTable, scrub, slider } from '../figures/kit.js';

const kCode = `let { x, y } = tileOf(eye);
while (!blockAt(map, x, y)) {
  const toX = (nextX(x) - eye.x) / ray.x;
  const toY = (nextY(y) - eye.y) / ray.y;
  if (toX < toY) {
    x += stepX; // blue
  } else {
    y += stepY; // red
  }
}`;

const reached = (now) => now.tiles.at(-1);

export default {
  scene: 'yard-1.json',
  view: '13.25,1.625,0.5,180',
  options: { fov: 66 },
  state: { column: 90, step: 5 },
  controls: [
    scrub({ of: 'walk' }),
    slider({ label: 'Turn', eye: 'heading', from: 100, to: 260, step: 1, unit: '°' }),
  ],
  rows: [
    [
      mapView({ handles: ['eye', 'heading'], share: 1.35 }),
      codeView({ code: kCode, lines: { start: [1], x: [3, 4, 5, 6], y: [3, 4, 7, 8] } }),
    ],
    [numberTable({ of: 'walk' })],
  ],
  numbers: {
    tiles: (now) =>
      String(
        now.slice.walk.findIndex(({ tile }) => String(tile) === String(now.slice.hits[0]?.tile)) +
          1,
      ),
    looks: (now) => String(Math.ceil((now.slice.hits[0]?.depth ?? 0) / 0.01) + 1),
  },
  says: (now) => {
    const { tile, axis } = reached(now);
    const place = `tile ${tile.join(', ')}`;
    return axis === null
      ? `The walk begins in ${place}.`
      : `Across the ${axis} border, into ${place}.`;
  },
};
