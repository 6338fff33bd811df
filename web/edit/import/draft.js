// What the readers of all formats fill: the lists of a proposal (propose.js has their fields), with
// each kind, picture and class in them once. It checks the limits while the lists grow, and touches
// nothing but them.
//
//     const draft = startDraft('town.tmx', 'Tiled', 'town');
//     const kind = draft.kind(key, () => ({ name: 'walls 4', parts }));  // its number, from 1
//     draft.note('layer "Clouds"', 'an image layer');         // what cannot be taken

import { ImportError, quoted } from './import-error.js';
import {
  kMostKinds,
  kMostLayers,
  kMostMaps,
  kMostObjects,
  kMostPictureSide,
  kMostNotes,
  kMostSide,
  kMostTiles,
} from './import-limits.js';
import { listNotes } from './notes.js';

const kKind = {
  use: 'by layer',
  show: 'picture',
  bottom: null,
  top: null,
  parts: [],
  frames: [],
  rate: null,
  size: null,
  comment: '',
};
const kLayer = { use: null, level: null, bottom: null, top: null, look: null, comment: '' };

export function startDraft(file, format, title) {
  const kinds = [];
  const numbers = new Map();
  const pictures = [];
  const pictureNumbers = new Map();
  const classes = new Map();
  const layers = [];
  const objectLayers = [];
  const maps = [];
  const notes = listNotes(kMostNotes);
  let tiles = 0;
  let objects = 0;
  const atMost = (place, found, count, most) => {
    if (count > most) throw new ImportError(file, place, `${count} ${found}`, `at most ${most}`);
  };

  function checkPart(name, { x, y, width, height }) {
    const isSide = (side) => Number.isInteger(side) && side >= 1 && side <= kMostPictureSide;
    if (![x, y].every(Number.isInteger) || !isSide(width) || !isSide(height))
      throw new ImportError(
        file,
        `tile ${quoted(name)}`,
        `${quoted(width)} x ${quoted(height)} texels at ${quoted(x)},${quoted(y)}`,
        `whole numbers, and sides from 1 to ${kMostPictureSide}`,
      );
  }

  return {
    file,
    format,
    title,
    layers,
    objectLayers,
    maps,
    kinds,
    pictures,
    note: notes.add,
    base: null, // the scene that a map of Tiled came from

    // Counts tiles before memory is taken for them.
    room(place, width, depth) {
      const isSide = (side) => Number.isInteger(side) && side >= 1 && side <= kMostSide;
      if (!isSide(width) || !isSide(depth))
        throw new ImportError(
          file,
          place,
          `a size of ${width} x ${depth} tiles`,
          `whole numbers from 1 to ${kMostSide}`,
        );
      tiles += width * depth;
      atMost(place, 'tiles on all layers', tiles, kMostTiles);
    },

    kind(key, make) {
      if (!numbers.has(key)) {
        const kind = { ...kKind, ...make(), count: 0 };
        for (const part of [...kind.parts, ...kind.frames.flat()]) checkPart(kind.name, part);
        kinds.push(kind);
        atMost('', 'kinds of tiles', kinds.length, kMostKinds);
        numbers.set(key, kinds.length);
      }
      return numbers.get(key);
    },

    picture(name, make) {
      if (!pictureNumbers.has(name)) {
        pictures.push(make());
        pictureNumbers.set(name, pictures.length - 1);
      }
      return pictureNumbers.get(name);
    },

    layer(layer) {
      layers.push({ ...kLayer, ...layer, tiles: 0 });
      atMost('', 'layers', layers.length + objectLayers.length, kMostLayers);
      return layers.length - 1;
    },

    objectLayer(layer) {
      objectLayers.push({ use: 'take', level: 0, ...layer });
      atMost('', 'layers', layers.length + objectLayers.length, kMostLayers);
      return objectLayers.length - 1;
    },

    map(map) {
      maps.push(map);
      atMost('', 'maps', maps.length, kMostMaps);
    },

    // `of` is the name under which the table of classes lists it.
    object(list, object) {
      objects += 1;
      atMost(`object ${object.id}`, 'objects', objects, kMostObjects);
      const row = classes.get(object.of) ?? { name: object.of, use: null, count: 0 };
      row.count += 1;
      classes.set(object.of, row);
      list.push(object);
    },

    lists() {
      return {
        file,
        format,
        title,
        outside: 'move to edge',
        light: 'day',
        layers,
        kinds,
        objectLayers,
        classes: [...classes.values()],
        maps,
        pictures,
        base: this.base,
        notTaken: notes.list(),
      };
    },
  };
}
