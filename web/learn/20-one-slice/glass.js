// One pixel in all views: the picture, both maps, the slice from the side, its rows, the texture,
// and the steps from the texel to the colour.

import {
  button,
  fixed,
  mapView,
  picture,
  sideView,
  sliceStrip,
  slider,
  textureView,
  why,
} from '../figures/kit.js';
import { kEye, kOptions, listed, slopesOf, thingsIn } from './pixel.js';

const kNothing = '–';

export default {
  scene: 'yard.json',
  view: kEye,
  options: kOptions,
  state: { column: 250, row: 170 },
  controls: [
    button({ label: 'In the glass', change: () => ({ column: 250, row: 170 }) }),
    button({ label: 'In the floor', change: () => ({ column: 250, row: 280 }) }),
    button({ label: 'Beyond the portal', change: () => ({ column: 250, row: 200 }) }),
    slider({ label: 'Turn', eye: 'heading', from: 150, to: 230, step: 1, unit: '°' }),
  ],
  rows: [
    [
      picture({ title: 'The picture', mark: 'pixel', handles: ['column', 'row'] }),
      why({ title: 'Why this colour?' }),
    ],
    [
      mapView({ map: 'hall', title: 'The hall' }),
      mapView({ map: 'yard', title: 'The yard, behind the portal' }),
    ],
    [sideView({ title: 'The slice from the side', share: 2 })],
    [
      sliceStrip({ title: 'The rows of the slice', names: true, pick: true }),
      textureView({ title: 'The texture', run: (now) => thingsIn(now)[0]?.run ?? now.run }),
    ],
  ],
  numbers: {
    column: (now) => String(now.column),
    row: (now) => String(now.row),
    distance: (now) => fixed(now.slice.projectionDistance, 1),
    horizon: (now) => fixed(now.slice.horizonRow, 0),
    sideways: (now) => fixed(slopesOf(now).sideways, 4),
    upward: (now) => fixed(slopesOf(now).upward, 4),
    things: (now) => listed(thingsIn(now).map(({ name }) => name)),
    what: (now) => thingsIn(now)[0]?.name ?? 'the sky',
    map: (now) => now.pick.map,
    tile: (now) => now.pick.tile?.join(', ') ?? kNothing,
    depth: (now) => (now.pick.depth === null ? kNothing : fixed(now.pick.depth, 3)),
    portals: (now) => countOf(now.pick.portals, 'portal'),
    texel: (now) => now.pick.texel?.size.join(' × ') ?? kNothing,
    u: (now) => String(now.pick.texel?.u ?? kNothing),
    v: (now) => String(now.pick.texel?.v ?? kNothing),
    light: (now) => String(now.pick.texel?.light ?? kNothing),
    fog: (now) => String(now.pick.texel?.fog ?? kNothing),
    alpha: (now) => String(now.pick.alpha),
  },
  says: (now) => {
    const names = thingsIn(now).map(({ name }) => name);
    return `Column ${now.column}, row ${now.row}: ${listed(names, ', then ')}.`;
  },
};

const countOf = (count, of) =>
  `${['no', 'one', 'two', 'three'][count] ?? count} ${of}${count === 1 ? '' : 's'}`;
