// What a person may choose in a proposal (propose.js has its fields), in words for a dialog, and
// what follows from a choice. Takes a proposal; changes that alone. Knows no page.
//
//     summaryOf(proposal)                  // 'Tiled, 20 × 15 tiles, 3 layers, ...'
//     groupsOf(proposal.layers)            // [{ name, layers: [0, 1] }]; '' is no group
//     layerUses                            // [use, its words] of all that a layer may become
//     setLayerUse(proposal, layer, 'ceiling')
//     const layers = layersOfKinds(proposal);  // for each kind
//     kindUses(kind, layers[0])            // [use, its words]
//     setKindUse(kind, 'block')
//     lampsOf(proposal)                    // how many objects shine
//     outsideOf(proposal)                  // how many objects lie beside the map
//     keepChoices(old, proposal)           // after further files were added

const kHighest = 31; // of levels
const kPlain = '#9a8f80'; // of a kind without a picture that is to be seen

export const layerUses = [
  ['level', 'Blocks'],
  ['floor', 'Floor'],
  ['ceiling', 'Ceiling'],
  ['sprites', 'Upright pictures'],
  ['leave out', 'Leave out'],
];
export const objectLayerUses = [
  ['take', 'Take its objects'],
  ['leave out', 'Leave out'],
];
export const classUses = [
  ['object', 'Upright picture'],
  ['start', 'Start'],
  ['lamp', 'Lamp'],
  ['message', 'Message'],
  ['leave out', 'Leave out'],
];
export const outsideUses = [
  ['move to edge', 'Move to its edge'],
  ['leave out', 'Leave out'],
];
export const lightUses = [
  ['day', 'Day'],
  ['dusk', 'Dusk: lamps show'],
  ['night', 'Night'],
];
const kKindWords = {
  block: 'Block',
  floor: 'Floor',
  ceiling: 'Ceiling',
  sprite: 'Upright picture',
  start: 'Start',
  empty: 'Nothing',
};
const kByLayer = {
  level: 'block',
  floor: 'floor',
  ceiling: 'ceiling',
  sprites: 'sprite',
  'leave out': 'empty',
};

export function summaryOf({ format, maps, layers, objectLayers, kinds }) {
  const count = (number, one, many) =>
    number === 0 ? [] : [`${number} ${number === 1 ? one : many}`];
  const [first] = maps;
  const used = kinds.filter(({ count: times }) => times > 0).length;
  const objects = maps.reduce((sum, map) => sum + map.objects.length, 0);
  const isText = format === 'numbers' || format === 'characters';
  return [
    isText ? `Text with ${format}` : format,
    maps.length === 1
      ? `${first.width} × ${first.depth} tiles`
      : `${maps.length} maps, the first of ${first.width} × ${first.depth} tiles`,
    ...count(layers.length + objectLayers.length, 'layer', 'layers'),
    ...count(used, 'kind of tile', 'kinds of tiles'),
    ...count(objects, 'object', 'objects'),
  ].join(', ');
}

// Layers that stand in one group of the file follow each other.
export function groupsOf(layers) {
  const groups = [];
  layers.forEach(({ name }, index) => {
    const group = name.includes('/') ? name.slice(0, name.lastIndexOf('/')) : '';
    if (groups.at(-1)?.name === group) groups.at(-1).layers.push(index);
    else groups.push({ name: group, layers: [index] });
  });
  return groups;
}

// The level stays, if it is one of those that the use has.
export function setLayerUse(proposal, layer, use) {
  layer.use = use;
  if (use === 'ceiling') {
    const blocks = proposal.layers.filter((other) => other.use === 'level' && other.tiles > 0);
    const highest = blocks.reduce((most, { level }) => Math.max(most, level + 1), 1);
    layer.level = Math.max(layer.level, highest);
  } else {
    layer.level = Math.min(kHighest, Math.max(0, Math.floor(layer.level)));
  }
}

// For each kind the layers that have it.
export function layersOfKinds({ layers, maps, kinds }) {
  const found = kinds.map(() => new Set());
  for (const { cells } of maps)
    layers.forEach((layer, index) => {
      for (const kind of cells[index] ?? []) if (kind !== 0) found[kind - 1].add(layer);
    });
  return found;
}

// Only kinds with a picture can stand upright.
export function kindUses(kind, layers) {
  const made = [...new Set([...layers].map(({ use }) => kKindWords[kByLayer[use]]))];
  return [
    ['by layer', made.length === 1 ? `${made[0]} (layer)` : 'As its layers'],
    ...['block', 'floor', 'sprite', 'start', 'empty']
      .filter((use) => use !== 'sprite' || kind.parts.length > 0)
      .map((use) => [use, kKindWords[use]]),
  ];
}

// What it shows as: 'block', 'floor', ... of the layers that have it.
export function seenAs(kind, layers) {
  return kind.use === 'by layer' ? [...layers].map(({ use }) => kByLayer[use]) : [kind.use];
}

// What becomes visible must look like something.
export function setKindUse(kind, use) {
  kind.use = use;
  if (kind.show === 'picture' && kind.parts.length === 0) kind.show = kPlain;
  if (use === 'start') kind.heading ??= 0;
}

export function lampsOf({ maps, classes, objectLayers }) {
  const lamps = new Set(classes.filter(({ use }) => use === 'lamp').map(({ name }) => name));
  const shines = ({ of, layer, isHidden }) =>
    lamps.has(of) && !isHidden && objectLayers[layer].use === 'take';
  return maps.reduce((sum, { objects }) => sum + objects.filter(shines).length, 0);
}

export function outsideOf({ maps }) {
  const isOutside = ({ x, y }, { width, depth }) => !(x >= 0 && y >= 0 && x < width && y < depth);
  return maps.reduce(
    (sum, map) => sum + map.objects.filter((object) => isOutside(object, map)).length,
    0,
  );
}

const kKept = {
  layers: ['use', 'level', 'bottom', 'top', 'look'],
  kinds: ['use', 'show', 'bottom', 'top'],
  objectLayers: ['use', 'level'],
  classes: ['use', 'sprite'],
};

// Both are of one file, so what has the same name is the same.
export function keepChoices(old, proposal) {
  proposal.outside = old.outside;
  proposal.light = old.light;
  for (const [list, fields] of Object.entries(kKept))
    proposal[list].forEach((row, index) => {
      const before = old[list][index];
      if (before?.name !== row.name) return;
      for (const field of fields) row[field] = before[field];
    });
}
