// Completes a draft: what each layer, kind of tile and class of objects becomes, where the file
// does not say so itself. A person may change all of it in a dialog before makeScene() reads it.
//
//     proposal = {
//       file, format, title,
//       outside        'move to edge' or 'leave out': objects beside the map
//       light          'day', 'dusk' or 'night': how dark it is where no lamp of the map shines
//       layers         [{ name, use, level, bottom, top, look, tiles, comment }]: `use` is 'level',
//                      'floor', 'ceiling', 'sprites' or 'leave out'; `level` counts from 0, for a
//                      ceiling it is the height; `bottom` and `top` are heights of its blocks, or
//                      null; `look` is the number of the layer whose tiles its blocks show, or null
//       kinds          [{ name, use, show, bottom, top, heading, parts, size, count, comment }]:
//                      `use` is 'by layer', 'block', 'floor', 'sprite', 'start' or 'empty'; `show`
//                      is 'picture' (its parts), the name of a shipped texture, or '#rrggbb';
//                      animated ones have the parts of each of their `frames`, and a `rate`
//       objectLayers   [{ name, use, level, comment }]: 'take' or 'leave out'
//       classes        [{ name, use, sprite, count }]: 'object', 'start', 'lamp', 'message' or
//                      'leave out'; `sprite` is a shipped one that shows them instead of their own
//                      picture, or null
//       maps           [{ name, width, depth, background, floor, comment, cells, objects }]:
//                      `cells` has for each layer a list of kinds, counted from 1; 0 is nothing;
//                      where no floor is painted lies the shipped texture `floor`, or a colour
//       pictures       [{ file, bytes, transparent }]
//       base           { scene, map } if export-tmj.js wrote the map, or null: all but its cells
//       notTaken       [{ place, reason }]: what cannot be taken so far
//     }

import { kShippedSprites } from './shipped-sprites.js';

const kLayerNames = [
  ['leave out', /(^|\/)(lights?|lighting|shadows?|glow)$/i],
  ['ceiling', /ceiling/i],
  ['level', /wall|block|solid|collision|collide|level|storey|story|obstacle|building|house/i],
  ['floor', /ground|floor|terrain|background|base|water|grass|land|path|road/i],
  ['sprites', /deco|detail|prop|object|plant|tree|bush|furniture|item|sprite/i],
];
const kAbove = /roof|above|overhead|overlay|canopy|treetop/i; // on the level above the walls
const kClassNames = [
  ['start', /^(player|start|spawn|hero|entrance)|(player|start|spawn)\b|_(start|spawn)$/i],
  ['lamp', /lamp|light|torch|lantern|candle|brazier/i],
  ['message', /^(text|message|sign|note|label)$/i],
];

export function propose(draft) {
  const proposal = draft.lists();
  const { layers, maps, kinds, classes } = proposal;
  for (const { cells } of maps)
    for (const [layer, list] of cells.entries())
      for (const kind of list ?? [])
        if (kind !== 0) {
          layers[layer].tiles += 1;
          kinds[kind - 1].count += 1;
        }
  const above = layers.filter(({ use, name }) => use === null && kAbove.test(name));
  for (const layer of above) layer.use = 'level';
  for (const layer of layers)
    layer.use ??= kLayerNames.find(([, words]) => words.test(layer.name))?.[0] ?? null;
  if (!layers.some(({ use }) => use === 'floor')) {
    const lowest = layers.find((layer, index) => layer.use === null && covers(maps, index));
    if (lowest !== undefined) lowest.use = 'floor';
  }
  for (const layer of layers) layer.use ??= 'level';
  const highest = giveLevels(layers, above);
  raise(above, highest, proposal);
  for (const one of classes) {
    one.use ??= kClassNames.find(([, words]) => words.test(one.name))?.[0] ?? 'object';
    one.sprite ??= shippedFor(one, maps);
  }
  return proposal;
}

// A class that is called as a shipped sprite, and has no picture of its own.
function shippedFor({ name, use }, maps) {
  const hasPicture = maps.some(({ objects }) =>
    objects.some(({ of, kind }) => of === name && kind !== 0),
  );
  const wanted = name
    .trim()
    .toLowerCase()
    .replaceAll(/[\s_]+/g, '-');
  return use === 'object' && !hasPicture && Object.hasOwn(kShippedSprites, wanted) ? wanted : null;
}

function covers(maps, layer) {
  const own = maps.map(({ cells }) => cells[layer]).filter(Boolean);
  return own.length > 0 && own.every((cells) => cells.every((kind) => kind !== 0));
}

// Numbers at the end of names count from the lowest one; others go on upwards. Gives the highest.
function giveLevels(layers, above) {
  const levels = layers.filter((layer) => layer.use === 'level' && !above.includes(layer));
  const numberIn = ({ name }) => {
    const [, digits] = /(\d{1,3})\D*$/.exec(name) ?? [];
    return digits === undefined ? null : Number(digits);
  };
  const numbers = levels.map(numberIn).filter((number) => number !== null);
  const least = Math.min(...numbers);
  let next = 0;
  for (const layer of levels) {
    const number = numberIn(layer);
    layer.level ??= number !== null && numbers.length > 1 ? number - least : next;
    layer.level = Math.min(31, Math.max(0, Math.round(layer.level)));
    next = layer.level + 1;
  }
  const highest = levels.reduce(
    (most, { level, tiles }) => (tiles > 0 ? Math.max(most, level) : most),
    0,
  );
  for (const layer of layers) {
    if (layer.use === 'ceiling') layer.level ??= highest + 1;
    else if (!above.includes(layer)) layer.level ??= 0;
  }
  return highest;
}

// All on one level, but for those that lie on another one mostly, as chimneys on their roofs.
function raise(above, highest, { layers, maps }) {
  const cellsOf = (layer) => maps.map(({ cells }) => cells[layers.indexOf(layer)] ?? []);
  const meets = (one, other) => {
    const others = cellsOf(other);
    const common = cellsOf(one).reduce(
      (sum, cells, map) =>
        cells.reduce((count, kind, at) => count + (kind !== 0 && others[map][at] > 0), sum),
      0,
    );
    return common > one.tiles / 2;
  };
  above.forEach((layer, index) => {
    layer.level = Math.min(31, highest + 1);
    for (const lower of above.slice(0, index))
      if (lower.level >= layer.level && meets(layer, lower))
        layer.level = Math.min(31, lower.level + 1);
  });
}
