// Turns Tiled's XML files (TMX, TSX, TX) into what its JSON files (TMJ, TSJ, TJ) hold, so that
// tiled.js reads both alike. It resolves nothing and reads no other file. The parser takes no
// entities but XML's own five, so none can grow.
//
//     const map = tiledOfXml(text, 'town.tmx');       // { type: 'map', width, layers, ... }

import { parseXml } from '@rgrove/parse-xml';

import { ImportError } from './import-error.js';
import { kMostNesting } from './import-limits.js';

const kNumbers = new Set(
  `width height x y tilewidth tileheight firstgid gid id spacing margin tilecount columns offsetx
  offsety opacity rotation infinite duration tileid visible parallaxx parallaxy`.split(/\s+/),
);
const kLayers = {
  layer: 'tilelayer',
  objectgroup: 'objectgroup',
  imagelayer: 'imagelayer',
  group: 'group',
};
const kShapes = ['ellipse', 'point', 'capsule', 'polygon', 'polyline'];
const kRoots = { map: mapOf, tileset: tilesetOf, template: templateOf };

export function tiledOfXml(text, file) {
  let root;
  try {
    ({ root } = parseXml(text));
  } catch (error) {
    // Elements nested too deep end the parser's stack.
    const [reason] = String(error.message).split('\n');
    throw new ImportError(file, '', `XML that cannot be read: ${reason}`, 'a file of Tiled');
  }
  if (!Object.hasOwn(kRoots, root.name))
    throw new ImportError(file, '', `<${root.name}>`, '<map>, <tileset> or <template>');
  return { ...kRoots[root.name](root, file), type: root.name };
}

function attributesOf(element) {
  const values = {};
  for (const [name, value] of Object.entries(element.attributes))
    if (name !== '__proto__') values[name] = kNumbers.has(name) ? Number(value) : value;
  return values;
}

const elementsOf = (element, name) =>
  element.children.filter((child) => child.type === 'element' && child.name === name);
const elementOf = (element, name) => elementsOf(element, name)[0];

function mapOf(element, file) {
  return {
    ...attributesOf(element),
    properties: propertiesOf(element),
    tilesets: elementsOf(element, 'tileset').map((one) => tilesetOf(one)),
    layers: layersOf(element, file),
  };
}

function layersOf(element, file, depth = 0) {
  if (depth > kMostNesting)
    throw new ImportError(file, '', 'groups within groups', `at most ${kMostNesting} deep`);
  return element.children
    .filter((child) => child.type === 'element' && Object.hasOwn(kLayers, child.name))
    .map((child) => {
      const layer = {
        ...attributesOf(child),
        type: kLayers[child.name],
        properties: propertiesOf(child),
      };
      if (child.name === 'layer') return { ...layer, ...dataOf(elementOf(child, 'data')) };
      if (child.name === 'objectgroup')
        return { ...layer, objects: elementsOf(child, 'object').map(objectOf) };
      if (child.name === 'imagelayer')
        return { ...layer, image: elementOf(child, 'image')?.attributes.source ?? '' };
      return { ...layer, layers: layersOf(child, file, depth + 1) };
    });
}

function dataOf(element) {
  if (element === undefined) return { data: [] };
  const { encoding, compression } = element.attributes;
  const ofCells = (one) =>
    encoding === undefined
      ? elementsOf(one, 'tile').map((tile) => Number(tile.attributes.gid ?? 0))
      : one.text;
  const chunks = elementsOf(element, 'chunk');
  return {
    encoding,
    compression,
    ...(chunks.length > 0
      ? { chunks: chunks.map((one) => ({ ...attributesOf(one), data: ofCells(one) })) }
      : { data: ofCells(element) }),
  };
}

function objectOf(element) {
  const shape = elementsOf(element, 'text')[0];
  const object = { ...attributesOf(element), properties: propertiesOf(element) };
  for (const name of kShapes) {
    const found = elementOf(element, name);
    if (found !== undefined)
      object[name] = found.attributes.points === undefined ? true : pointsOf(found);
  }
  if (shape !== undefined) object.text = { ...attributesOf(shape), text: shape.text };
  return object;
}

function pointsOf({ attributes: { points } }) {
  return points
    .trim()
    .split(/\s+/)
    .map((pair) => {
      const [x, y] = pair.split(',').map(Number);
      return { x, y };
    });
}

function tilesetOf(element) {
  const image = elementOf(element, 'image');
  const tiles = elementsOf(element, 'tile').map((tile) => {
    const own = elementOf(tile, 'image');
    const animation = elementOf(tile, 'animation');
    return {
      ...attributesOf(tile),
      properties: propertiesOf(tile),
      ...(own && imageOf(own)),
      ...(animation && { animation: elementsOf(animation, 'frame').map(attributesOf) }),
      ...(elementOf(tile, 'objectgroup') && { objectgroup: {} }),
    };
  });
  const offset = elementOf(element, 'tileoffset');
  return {
    ...attributesOf(element),
    properties: propertiesOf(element),
    ...(image && imageOf(image)),
    ...(offset && { tileoffset: attributesOf(offset) }),
    tiles,
  };
}

function imageOf(element) {
  const { source, trans, width, height } = element.attributes;
  return {
    ...(source !== undefined && { image: source }),
    ...(width !== undefined && { imagewidth: Number(width), imageheight: Number(height) }),
    ...(trans !== undefined && { transparentcolor: trans }),
  };
}

function templateOf(element, file) {
  const object = elementOf(element, 'object');
  if (object === undefined) throw new ImportError(file, '', 'no object', 'a template with one');
  const tileset = elementOf(element, 'tileset');
  return { object: objectOf(object), ...(tileset && { tileset: tilesetOf(tileset) }) };
}

function propertiesOf(element, depth = 0) {
  const list = elementOf(element, 'properties');
  if (list === undefined || depth > kMostNesting) return [];
  return elementsOf(list, 'property').map((one) => {
    const { name = '', type = 'string', value } = one.attributes;
    return { name, type, value: valueOf(type, value ?? one.text, one, depth) };
  });
}

function valueOf(type, text, element, depth) {
  if (type === 'class')
    return Object.fromEntries(
      propertiesOf(element, depth + 1)
        .filter(({ name }) => name !== '__proto__')
        .map(({ name, value }) => [name, value]),
    );
  if (type === 'bool') return text === 'true';
  return ['int', 'float', 'object'].includes(type) ? Number(text) : text;
}

// For messages about a whole file.
export function looksLikeXml(text) {
  return /^\s*</.test(text);
}
