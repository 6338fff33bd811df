// A picture of few pixels, with the exact edge of the wall and the middles of the pixels.

import { dot, fixed, line, picture, slider } from '../figures/kit.js';

const kWall = 1; // y of the wall's face

// The row of the wall's upper edge at a place across the picture.
function edgeAt(x, { slice, width }) {
  const { eye, projectionDistance, horizonRow } = slice;
  const angle = (eye.heading * Math.PI) / 180;
  const k = (x - width / 2) / projectionDistance;
  const rayY = Math.sin(angle) + k * Math.cos(angle);
  return horizonRow - ((1 - eye.z) * projectionDistance * rayY) / (kWall - eye.y);
}

function over(now) {
  const { width, height } = now;
  const parts = [
    line(0, edgeAt(0, now), width, edgeAt(width, now), 'stroke="#fff" stroke-width="0.34"'),
    line(0, edgeAt(0, now), width, edgeAt(width, now), 'stroke="#b8431f" stroke-width="0.18"'),
  ];
  for (let x = 0; x < width; ++x)
    for (let y = 0; y < height; ++y) {
      const isBelow = y + 0.5 > edgeAt(x + 0.5, now);
      const near = Math.abs(y + 0.5 - edgeAt(x + 0.5, now)) < 2;
      if (near)
        parts.push(
          dot(
            x + 0.5,
            y + 0.5,
            0.15,
            `fill="${isBelow ? '#232136' : '#fff'}" stroke="${isBelow ? '#fff' : '#232136'}" stroke-width="0.05"`,
          ),
        );
    }
  return parts.join('');
}

export default {
  scene: 'long-wall.json',
  view: '12.5,3.6,0.35,300',
  size: [24, 15],
  options: { fov: 66 },
  state: { column: 11 },
  controls: [
    slider({ label: 'Turn', eye: 'heading', from: 250, to: 310, step: 0.5, unit: '°' }),
    slider({ label: 'Height of the eye', eye: 'z', from: 0.1, to: 0.9, step: 0.01, unit: 'units' }),
  ],
  rows: [[picture({ handles: ['column'], mark: 'none', over })]],
  says: (now) => {
    const row = edgeAt(now.column + 0.5, now);
    return `In column ${now.column} the edge is at row ${fixed(row)}, so the wall begins with row ${Math.round(row)}.`;
  },
};
