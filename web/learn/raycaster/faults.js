// Named wrong ways, for the sections "what goes wrong without it": text replacements in a state.

import { asBody } from './states.js';

const kEqualAngles = `  const middle = Math.atan2(view.forward.y, view.forward.x);
  const width = 2 * Math.atan(view.width / 2 / view.distance);
  const aside = ((column + 0.5) / view.width - 0.5) * width;
  const angle = middle + aside;
`;
const kRay = `  const sideways = (column + 0.5 - view.width / 2) / view.distance;
  const { forward, right } = view;
  return { x: forward.x + sideways * right.x, y: forward.y + sideways * right.y };
`;

// `chapter` is the state that it is made from; `change` lists texts and what replaces them.
export const faults = {
  mirrored: {
    chapter: 1,
    change: [['x: -forward.y, y: forward.x', 'x: forward.y, y: -forward.x']],
    says: 'y grows to the north: left and right are exchanged.',
  },
  'mirrored-yard': {
    chapter: 9,
    change: [['x: -forward.y, y: forward.x', 'x: forward.y, y: -forward.x']],
    says: 'The same, in a picture with letters to read.',
  },
  'big-steps': {
    chapter: 2,
    change: [['const step = 0.01;', 'const step = 0.3;']],
    says: 'Steps of 0.3: the ray jumps over corners.',
  },
  'drifting-sums': {
    chapter: 3,
    change: [
      [
        '  while (isInside',
        `  const f = Math.fround;
  let farX = f((stepX > 0 ? tile.x + 1 - eye.x : eye.x - tile.x) / Math.abs(ray.x));
  let farY = f((stepY > 0 ? tile.y + 1 - eye.y : eye.y - tile.y) / Math.abs(ray.y));
  while (isInside`,
      ],
      [
        '    const farX = (stepX > 0 ? tile.x + 1 - eye.x : eye.x - tile.x) / Math.abs(ray.x);\n',
        '',
      ],
      [
        '    const farY = (stepY > 0 ? tile.y + 1 - eye.y : eye.y - tile.y) / Math.abs(ray.y);\n',
        '',
      ],
      [
        "near: farX, face: stepX > 0 ? 'west' : 'east' };\n",
        "near: farX, face: stepX > 0 ? 'west' : 'east' };\n      farX = f(farX + f(1 / Math.abs(ray.x)));\n",
      ],
      [
        "near: farY, face: stepY > 0 ? 'north' : 'south' };\n",
        "near: farY, face: stepY > 0 ? 'north' : 'south' };\n      farY = f(farY + f(1 / Math.abs(ray.y)));\n",
      ],
    ],
    says: 'Depths are summed with 32 bits: they drift, and rays meet the wrong face at corners.',
  },
  'whole-heights': {
    chapter: 4,
    change: [
      [
        'return view.horizon - ((height - eye.z) * view.distance) / depth;',
        'return view.horizon - (height - eye.z) * Math.round(view.distance / depth);',
      ],
    ],
    says: 'A unit is a whole number of rows: edges far above or below the eye have large steps.',
  },
  'cut-heights': {
    chapter: 4,
    change: [
      ['const bottom = rowOf(slice, 0, tile.near);', 'const bottom = top + tall;'],
      [
        'const top = rowOf(slice, 1, tile.near);',
        'const tall = Math.min(slice.view.height, slice.view.distance / tile.near);\n      const top = slice.view.horizon - tall * (1 - eye.z);',
      ],
    ],
    says: 'A wall is never taller than the picture: near walls end before they reach the ground.',
  },
  'half-row': {
    chapter: 8,
    change: [['(row + 0.5)', 'row']],
    says: 'A row counts from its upper edge, not from its middle.',
  },
  'distance-for-depth': {
    chapter: 5,
    change: [
      [
        'view.distance) / depth;',
        'view.distance) / (depth * Math.hypot(slice.ray.x, slice.ray.y));',
      ],
    ],
    says: 'Heights follow the distance, not the depth: straight walls bend.',
  },
  'equal-angles': {
    chapter: 5,
    change: [[kRay, `${kEqualAngles}  return { x: Math.cos(angle), y: Math.sin(angle) };\n`]],
    says: 'Equal angles from column to column, and distances: walls bend twice.',
  },
  'cosine-cure': {
    chapter: 5,
    change: [
      [
        kRay,
        `${kEqualAngles}  const cure = Math.cos(aside);
  return { x: Math.cos(angle) / cure, y: Math.sin(angle) / cure };
`,
      ],
    ],
    says: 'The cosine makes depths right, but the columns still have equal angles.',
  },
  'mirrored-letters': {
    chapter: 6,
    change: [["  if (face === 'north' || face === 'east') u = 1 - u;\n", '']],
    says: 'The letters on northern and eastern faces are mirrored.',
  },
  'no-detail': {
    chapter: 7,
    change: [
      [
        '  while (pixelSize * texture.height > 2 ** level && level < texture.levels.length - 1) level++;\n',
        '',
      ],
    ],
    says: 'No levels of detail: far textures sparkle.',
  },
  'floor-by-distance': {
    chapter: 8,
    change: [
      [
        'const depth = rise / slopeOf(slice, row);',
        'const depth = rise / slopeOf(slice, row) / Math.hypot(ray.x, ray.y);',
      ],
    ],
    says: 'The floor takes distances for depths: its lines bend.',
  },
  'glued-sky': {
    chapter: 9,
    change: [
      [
        '(row) => skyColour(map, slopeOf(slice, row))',
        '(row) => skyColour(map, (slice.view.height / 2 - row) / slice.view.distance)',
      ],
    ],
    says: 'The sky does not move when the eye looks up or down.',
  },
  'no-darkest': {
    chapter: 10,
    change: [['Math.max(falloff, light.darkest)', 'falloff']],
    says: 'No least brightness: what is far is black.',
  },
  'unrounded-light': {
    chapter: 10,
    change: [
      ['Math.floor(256 * light + 0.5)', '256 * light'],
      ['(channel * factor + 128) >> 8', 'Math.floor((channel * factor) / 256)'],
    ],
    says: 'The light is cut off instead of rounded: some colours are one step too dark.',
  },
  'point-body': {
    chapter: 11,
    change: [
      ['[body.x - body.halfWidth, body.x + body.halfWidth]', '[body.x]'],
      ['[body.y - body.halfWidth, body.y + body.halfWidth]', '[body.y]'],
    ],
    says: 'The body is a point: the eye comes so near to a wall that one texel fills the picture.',
  },
  'no-sliding': {
    chapter: 11,
    change: [['[alongX, alongY]', '[{ x: dx, y: dy }]']],
    says: 'Both axes are tested at once: a body that touches a wall sticks to it.',
  },
  'first-hit-only': {
    chapter: 12,
    change: [
      [
        '  for (const tile of walkGrid(map, eye, ray).reverse()) {',
        `  const tiles = walkGrid(map, eye, ray);
  const hit = tiles.findIndex((tile) => blockAt(map, tile.x, tile.y, 0));
  const seen = hit < 0 ? tiles : tiles.slice(0, hit + 1);
  for (const tile of seen.reverse()) {`,
      ],
    ],
    says: 'The walk ends at the first block: nothing is behind a low wall.',
  },
  'painters-order': {
    chapter: 13,
    change: [['if (slice.open[row]) put(', 'put(']],
    says: 'No row is ever closed: what is far covers what is near.',
  },
  'one-hit-a-level': {
    chapter: 14,
    change: [
      [
        '    tile.blocks = blocksOf(map, tile.x, tile.y);\n',
        `    slice.met ??= new Set();
    tile.blocks = blocksOf(map, tile.x, tile.y).filter(({ level }) => !slice.met.has(level));
    for (const { level } of tile.blocks) slice.met.add(level);
`,
      ],
    ],
    says: 'One hit a level: what stands behind, on the same level, is gone.',
  },
  'one-depth-a-column': {
    chapter: 15,
    change: [
      [
        '  const objects = objectsOf(slice);\n',
        `  const isWall = (tile) => blocksOf(map, tile.x, tile.y).length > 0;
  const wall = walkGrid(map, eye, ray).find(isWall)?.near ?? Infinity;
  const objects = objectsOf(slice).filter(({ depth }) => depth < wall);
`,
      ],
    ],
    says: 'One depth a column: an object behind a low wall is gone.',
  },
  'floating-feet': {
    chapter: 15,
    change: [
      [
        '{ texture, z, height, light, depth, u }) {\n',
        '{ texture, height, light, depth, u }) {\n  const z = slice.eye.z - height / 2;\n',
      ],
    ],
    says: "Objects are centred at the eye's height: their feet float or sink.",
  },
  'opaque-holes': {
    chapter: 16,
    change: [
      ['  if (colour[3] === 0) return;\n', ''],
      ['if (colour[3] < 255) {', 'if (colour[3] < 0) {'],
    ],
    says: 'Holes are painted: bars and trees stand in boxes.',
  },
  'inner-panes': {
    chapter: 16,
    change: [['if (!block.seeThrough || !block.join) return false;', 'if (block) return false;']],
    says: 'The faces between panes that touch are drawn.',
  },
  'gate-shuts': {
    chapter: 17,
    change: [
      ['const body = world.body?.map === map.name ? world.body : null;', 'const body = null;'],
    ],
    says: 'The gate shuts on whoever stands in it.',
  },
  'flipped-rows': {
    chapter: 18,
    change: [
      [
        '  drawPart(part);\n}',
        `  slice.flips ??= [];
  for (let row = part.first; row < part.last; row++) {
    if (slice.open[row]) slice.flips.push(row);
    slice.open[row] = 0;
  }
}`,
      ],
      [
        '  const { picture, column } = slice;\n',
        `  const { picture, column, flips = [] } = slice;
  const edge = Math.min(...flips);
  for (const row of flips) {
    const from = 4 * (Math.max(0, 2 * edge - row - 1) * picture.width + column);
    const to = 4 * (row * picture.width + column);
    picture.pixels.copyWithin(to, from, from + 4);
  }
`,
      ],
    ],
    says: 'The mirror shows the rows above it, flipped: heights do not fit, and undersides are missing.',
  },
  'offset-not-turned': {
    chapter: 19,
    change: [['y: eye.y - y - 0.5 }, turn);', 'y: eye.y - y - 0.5 }, 0);']],
    says: "The eye's place relative to the portal is not turned with it.",
  },
  'painted-last': {
    chapter: 20,
    change: [['if (slice.open[row]) put(', 'put(']],
    says: 'What is painted last is seen, though it is further away.',
  },
  'less-or-equal': {
    chapter: 22,
    change: [
      ['stepX * 2 ** -40', '0'],
      ['stepY * 2 ** -46', '0'],
      ['if (farX < farY) {', 'if (farX <= farY) {'],
    ],
    says: 'At every corner the x border comes first: half of the corners are wrong.',
  },
};

// The answer of a chapter with a fault in it. Throws if a text that it replaces does not occur
// exactly once.
export function faultyText(states, name, chapter = faults[name]?.chapter) {
  const fault = faults[name];
  if (!fault) throw new Error(`There is no fault ${name}.`);
  return fault.change.reduce((text, [find, put]) => {
    if (text.split(find).length !== 2)
      throw new Error(`${name}: in chapter ${chapter} this does not occur once: ${find}`);
    return text.replace(find, () => put);
  }, states.answer(chapter));
}

// A program's functions, for tests under Node.
export function program(text) {
  return new Function(asBody(text))();
}
