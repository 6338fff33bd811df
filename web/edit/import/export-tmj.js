// Writes a map's cells as a map of Tiled (TMJ), with its palette as a tileset: one tile for each
// character of its legends. The rest of the scene lies in a property of the map, so reading it back
// gives the same scene; empty cells become full stops. Objects stay in that property.
//
//     const { tmj, pictures } = exportTmj(scene, 'courtyard');
//     JSON.stringify(tmj)                  // courtyard.tmj; pictures: file -> PNG bytes, beside it

import { pngOf, rgbOf } from './foreign-pictures.js';
import { ImportError, quoted } from './import-error.js';
import { slugOf } from './looks.js';
import { signsOf } from '../../engine/signs.js';

const kSide = 16; // texels of a tile in the palette's picture
const kColumns = 16;
const kColour = /^#[0-9a-f]{6}$/i;

export function exportTmj(scene, mapName) {
  const number = scene.maps.findIndex(({ name }) => name === mapName);
  if (number < 0)
    throw new ImportError(
      'the scene',
      '',
      `no map ${quoted(mapName)}`,
      scene.maps.map(({ name }) => name).join(', '),
    );
  const map = scene.maps[number];
  const palette = startPalette(scene, map);
  const isBlank = (sign) => sign === '.' || sign === ' ';
  const layers = [];
  const addLayer = (name, rows, property, role, isBare) => {
    const data = rows.flatMap((row) =>
      signsOf(row).map((sign) => (isBare(sign) ? 0 : palette.gid(role, sign))),
    );
    layers.push(layerOf(layers.length + 1, name, data, rows, property));
  };
  const { floor, ceiling } = map;
  if (floor?.tiles !== undefined)
    addLayer('floor', floor.tiles, ['floor', 'bool', true], 'floor', isBlank);
  map.levels.forEach((rows, level) => {
    if (rows.length > 0)
      addLayer(`level ${level}`, rows, ['level', 'int', level], 'block', isBlank);
  });
  if (ceiling?.tiles !== undefined)
    addLayer(
      'ceiling',
      ceiling.tiles,
      ['ceiling', 'float', ceiling.height],
      'ceiling',
      (sign) => sign === ' ',
    );
  const rows = map.levels.find((level) => level.length > 0);
  const image = `${slugOf(mapName) || 'map'}-palette.png`;
  const { tileset, picture } = palette.drawn(image);
  const tmj = {
    type: 'map',
    version: '1.10',
    orientation: 'orthogonal',
    renderorder: 'right-down',
    infinite: false,
    width: signsOf(rows[0]).length,
    height: rows.length,
    tilewidth: kSide,
    tileheight: kSide,
    nextlayerid: layers.length + 1,
    nextobjectid: 1,
    properties: [
      property(
        'slicecast',
        'string',
        JSON.stringify({ scene: bareScene(scene, map), map: number }),
      ),
      property('title', 'string', scene.title),
    ],
    tilesets: [tileset],
    layers,
  };
  return { tmj, pictures: new Map([[image, picture]]) };
}

const property = (name, type, value) => ({ name, type, value });

function layerOf(id, name, data, rows, own) {
  return {
    id,
    name,
    type: 'tilelayer',
    x: 0,
    y: 0,
    width: signsOf(rows[0]).length,
    height: rows.length,
    opacity: 1,
    visible: true,
    data,
    properties: [property(...own)],
  };
}

// Without the map's cells; what had rows keeps one as a mark.
function bareScene(scene, map) {
  const bare = {
    ...map,
    levels: map.levels.map((rows) => (rows.length > 0 ? ['.'] : [])),
  };
  for (const plane of ['floor', 'ceiling'])
    if (map[plane]?.tiles !== undefined) bare[plane] = { ...map[plane], tiles: ['.'] };
  return { ...scene, maps: scene.maps.map((one) => (one === map ? bare : one)) };
}

function startPalette(scene, map) {
  const tiles = [];
  const gids = new Map();
  const meaningOf = {
    block: (sign) => map.legend?.[sign] ?? scene.legend?.[sign],
    floor: (sign) => map.floor.legend?.[sign],
    ceiling: (sign) => map.ceiling.legend?.[sign] ?? map.ceiling.texture,
  };
  const textureOf = (role, meaning) => {
    if (role !== 'block') return meaning;
    const { faces } = scene.blueprints?.[meaning] ?? {};
    const face = faces?.top ?? faces?.all ?? faces?.sides ?? faces;
    return face?.texture ?? face;
  };

  return {
    gid(role, sign) {
      const key = `${role} ${sign}`;
      if (!gids.has(key)) {
        const meaning = meaningOf[role](sign);
        const texture = textureOf(role, meaning);
        const properties = [
          property('character', 'string', sign),
          property(role === 'block' ? 'blueprint' : 'texture', 'string', String(meaning)),
        ];
        tiles.push({ id: tiles.length, type: role, properties, colour: colourOf(scene, texture) });
        gids.set(key, tiles.length);
      }
      return gids.get(key);
    },

    drawn(image) {
      const height = kSide * Math.max(1, Math.ceil(tiles.length / kColumns));
      const width = kSide * kColumns;
      const data = new Uint8Array(4 * width * height);
      tiles.forEach(({ colour }, id) => drawTile(data, width, id, rgbOf(colour)));
      const tileset = {
        firstgid: 1,
        name: 'palette',
        tilewidth: kSide,
        tileheight: kSide,
        margin: 0,
        spacing: 0,
        columns: kColumns,
        tilecount: (height / kSide) * kColumns,
        image,
        imagewidth: width,
        imageheight: height,
        tiles: tiles.map(({ id, type, properties }) => ({ id, type, properties })),
      };
      return { tileset, picture: pngOf({ width, height, data }) };
    },
  };
}

// A plain colour is itself; others get one from their name.
function colourOf(scene, texture) {
  const file = Object.hasOwn(scene.textures, texture ?? '') ? scene.textures[texture] : null;
  if (kColour.test(file)) return file;
  let hash = 7;
  for (const character of String(texture)) hash = (hash * 31 + character.codePointAt(0)) >>> 0;
  const channel = (shift) => (80 + ((hash >>> shift) & 127)).toString(16);
  return `#${[0, 7, 14].map(channel).join('')}`;
}

// A square with a darker rim.
function drawTile(data, width, id, rgb) {
  const left = (id % kColumns) * kSide;
  const top = Math.floor(id / kColumns) * kSide;
  for (let y = 0; y < kSide; ++y)
    for (let x = 0; x < kSide; ++x) {
      const isRim = x === 0 || y === 0 || x === kSide - 1 || y === kSide - 1;
      const colour = rgb.map((channel) => Math.round(channel * (isRim ? 0.7 : 1)));
      data.set([...colour, 255], 4 * ((top + y) * width + left + x));
    }
}
