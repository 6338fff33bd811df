// Puts the chosen block in the place of all blocks of the pointed kind, in the whole map.
// Takes a target; gives changes and lines to show. Knows no view.

import { cellChanges, kEmpty, sizeOf } from '../cells.js';
import { cellLines, kBrass, kCoral } from '../mark-lines.js';

export const replace = {
  name: 'replace',
  label: 'Replace',
  key: 'R',
  about: 'Changes all blocks of the pointed kind in this map into the chosen one.',
  touch: 'Tap a block: all of its kind in this map become the chosen one.',
  canRemove: true,

  point({ mapName, cell }, { removes }) {
    return cell === null ? [] : cellLines(mapName, cell, removes ? kCoral : kBrass);
  },

  end({ targets, removes }, { scene, sign }) {
    const { map, cell } = targets.at(-1);
    if (cell === null) return [];
    const old = scene.sign(map, cell.level, cell.x, cell.y);
    const { width, depth, levels } = sizeOf(scene, map);
    const cells = [];
    for (let level = 0; level < levels; ++level)
      for (let y = 0; y < depth; ++y)
        for (let x = 0; x < width; ++x)
          if (scene.sign(map, level, x, y) === old)
            cells.push({ layer: level, x, y, sign: removes ? kEmpty : sign });
    return cellChanges(scene, map, cells);
  },
};
