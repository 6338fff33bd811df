// Puts the chosen block in the place of all blocks of the pointed kind, in the whole map.
// Takes a target; gives changes and lines to show. Knows no view.

import { cellChanges, kEmpty, signReader, sizeOf } from '../cells.js';
import { kindOf } from '../kinds.js';
import { cellLines, kBrass, kCoral } from '../mark-lines.js';

export const replace = {
  name: 'replace',
  label: 'Replace',
  key: 'R',
  about: 'Changes all blocks of the pointed kind in this map into the chosen one.',
  touch: 'Tap a block: all of its kind in this map become the chosen one.',
  canRemove: true,

  // How many it would change.
  hint({ targets, removes }, { scene, sign }) {
    const { map, cell } = targets.at(-1);
    const old = cell === null ? null : kindAt(scene, map, cell);
    if (old === null || (old.sign === sign && !removes)) return undefined;
    const all = `${counted(cellsLike(scene, map, old.sign))} of "${old.name}" in this map`;
    if (removes) return `A click removes ${all}.`;
    return `A click changes ${all} into "${kindOf(scene, map, sign)?.name}".`;
  },

  point({ mapName, cell }, { removes }) {
    return cell === null ? [] : cellLines(mapName, cell, removes ? kCoral : kBrass);
  },

  end({ targets, removes }, { scene, sign }) {
    const { map, cell } = targets.at(-1);
    const old = cell === null ? null : kindAt(scene, map, cell);
    if (old === null) return { words: 'Click a block: all of its kind are replaced.' };
    const cells = cellsLike(scene, map, old.sign);
    const put = removes ? kEmpty : sign;
    const changes = cellChanges(
      scene,
      map,
      cells.map((at) => ({ ...at, sign: put })),
    );
    if (changes.length === 0) return [];
    const how = removes ? 'removed' : `changed into "${kindOf(scene, map, sign)?.name}"`;
    return { changes, words: `${counted(cells)} of "${old.name}" ${how}. Undo takes it back.` };
  },
};

const counted = ({ length }) => (length === 1 ? '1 block' : `${length} blocks`);

const kindAt = (scene, map, { level, x, y }) => kindOf(scene, map, scene.sign(map, level, x, y));

function cellsLike(scene, map, sign) {
  const { width, depth, levels } = sizeOf(scene, map);
  const signAt = signReader(scene, map);
  const cells = [];
  for (let level = 0; level < levels; ++level)
    for (let y = 0; y < depth; ++y)
      for (let x = 0; x < width; ++x)
        if (signAt(level, x, y) === sign) cells.push({ layer: level, x, y });
  return cells;
}
