// Tiles of floors and ceilings: textures, and the characters that stand for them there.
// Takes a document; gives changes. Changes nothing itself.
//
//     tileChanges(scene, 0, 'floor', [{ x: 1, y: 2 }], 'sand')
//     tileChanges(scene, 0, 'ceiling', places, null)           // the layer's own texture again
//     textureOfSign(scene.value.maps[0].floor, 'floor', 's')   // a texture's name, or null
//
// A map without a ceiling gets one above its highest level, open to the sky but for those tiles.

import { cellChanges, kEmpty, sizeOf } from './cells.js';
import { freeSign } from './kinds.js';

export const kOpen = ' '; // in ceilings

const layerOf = (scene, map, layer) => {
  const present = scene.value.maps[map][layer];
  return typeof present === 'string' ? { texture: present } : (present ?? null);
};

// Of what a scene says of a floor or a ceiling that has tiles.
export function textureOfSign(said, layer, sign) {
  const { texture, legend = {} } = said ?? {};
  if (texture === undefined || (sign === kOpen && layer === 'ceiling')) return null;
  return sign === kEmpty || sign === kOpen ? texture : (legend[sign] ?? null);
}

export function tileChanges(scene, map, layer, places, texture) {
  const { width, depth, levels } = sizeOf(scene, map);
  const inside = places.filter(({ x, y }) => x >= 0 && y >= 0 && x < width && y < depth);
  const present = layerOf(scene, map, layer);
  const isBare = texture === null || texture === present?.texture;
  if (inside.length === 0 || (present === null && texture === null)) return [];
  if (present === null) return [newLayer(scene, map, layer, inside, texture, levels)];
  const legend = present.legend ?? {};
  const known = Object.keys(legend).find((sign) => legend[sign] === texture);
  const sign = isBare ? kEmpty : (known ?? freeSign(texture, Object.keys(legend)));
  const cells = inside.map(({ x, y }) => ({ layer, x, y, sign }));
  const made = cellChanges(scene, map, cells);
  if (made.length === 0 || isBare || known !== undefined) return made;
  // The layer first, if it was a name alone, so that its legend has a place.
  const name = { path: ['maps', map, layer, 'legend', sign], value: texture };
  return [...made.slice(0, -1), name, made.at(-1)];
}

function newLayer(scene, map, layer, places, texture, levels) {
  const { width, depth } = sizeOf(scene, map);
  const isPainted = new Set(places.map(({ x, y }) => `${x} ${y}`));
  const other = layer === 'ceiling' ? kOpen : kEmpty;
  const tiles = Array.from({ length: depth }, (_, y) =>
    Array.from({ length: width }, (__, x) => (isPainted.has(`${x} ${y}`) ? kEmpty : other)).join(
      '',
    ),
  );
  const value = { texture, tiles };
  return {
    path: ['maps', map, layer],
    value: layer === 'ceiling' ? { height: Math.max(1, levels), ...value } : value,
  };
}
