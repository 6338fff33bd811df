// A ray on the lettered block: where it meets the wall, and the texel of the picked row.

import { mapView, picture, textureView } from '../figures/kit.js';

const fraction = (number) => number - Math.floor(number);
const isAcross = (face) => face === 'east' || face === 'west';

// What the picked pixel shows, if it is the side of a block.
export function sideOf({ pick }) {
  if (pick === null || pick.what !== 'side') return null;
  const { point, face, texel, depth } = pick;
  const along = isAcross(face) ? point[1] : point[0];
  return { ...texel, face, depth, along, axis: isAcross(face) ? 'y' : 'x', share: fraction(along) };
}

const numbered = (write) => (now) => {
  const side = sideOf(now);
  return side === null ? '–' : write(side, now);
};

export default {
  scene: 'yard-1.json',
  view: '7.6,7.9,0.5,308',
  options: { fov: 66, detail: 'off' },
  size: [480, 300],
  state: { column: 260, row: 178 },
  rows: [
    [
      picture({ handles: ['column', 'row', 'turn'], mark: 'pixel', share: 1.5 }),
      mapView({
        title: 'The ray from above',
        window: [7, 5, 3, 3],
        handles: ['eye'],
        order: false,
        lit: false,
      }),
      textureView({ grid: true, title: 'The texture' }),
    ],
  ],
  numbers: {
    depth: (now) => now.fixed(now.pick?.depth),
    coordinate: numbered(({ axis, along }, { fixed }) => `${axis}\u00a0=\u00a0${fixed(along)}`),
    fraction: numbered(({ share }, { fixed }) => fixed(share)),
    column: numbered(({ u }) => String(u)),
  },
  says(now) {
    const side = sideOf(now);
    if (side === null) return 'This pixel shows no wall: move the column or the row onto one.';
    const { face, axis, along, u, v, size } = side;
    return `The ray meets the ${face} side at ${axis} = ${now.fixed(along)}: texel ${u} from the left, ${v} from the top, of ${size[0]} by ${size[1]}.`;
  },
};
