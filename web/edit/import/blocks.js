// The blueprints of a scene that is made: one for each kind of tile with each look and each pair of
// heights. Their characters are chosen when all are known, `#` for the commonest.
//
//     const blocks = startBlocks(proposal, base, old, looks, notes);
//     const number = blocks.ofLayer(layer)(kind, look);       // of the blueprint, from 1
//     const { signs, table } = blocks.legend(fault);          // signs[number]; the scene's legend
//     blocks.stack(levels, tile)                              // [[bottom, top]] over a tile

import { kMostKinds, kMostLegend } from './import-limits.js';
import { startLegend } from './legend-signs.js';
import { uniqueNames } from './titles.js';

const kMostLooks = kMostKinds + 1;
const kNoBlocks = [];

export function startBlocks({ kinds }, base, old, looks, notes) {
  const list = [null]; // { name, bottom, top, count, sign }
  const numbers = new Map();
  const blueprints = { ...base?.blueprints };
  const named = uniqueNames();
  for (const name of Object.keys(blueprints)) named(name);

  function add(kind, look, bottom, top) {
    const own = kinds[kind - 1];
    if (own.blueprint !== undefined) {
      const { bottom: low = 0, top: high = 1 } = blueprints[own.blueprint] ?? {};
      return { name: own.blueprint, sign: own.sign, bottom: lowest(low), top: highest(high) };
    }
    const isFit = bottom >= 0 && bottom < top && top <= 1;
    if (!isFit) notes.add(`tile "${own.name}"`, `heights from ${bottom} to ${top} are no block's`);
    const [low, high] = isFit ? [bottom, top] : [0, 1];
    const texture = looks.texture(look === 0 ? [kind] : [look], null);
    const name = named(own.name, 'block');
    blueprints[name] = {
      ...(own.comment !== '' && { comment: own.comment }),
      ...(low > 0 && { bottom: low }),
      ...(high < 1 && { top: high }),
      faces: faces(texture),
    };
    return { name, bottom: low, top: high };
  }

  function find(kind, look, layer) {
    const { bottom, top } = kinds[kind - 1];
    const low = bottom ?? layer.bottom ?? 0;
    const high = top ?? layer.top ?? 1;
    const key = `${kind} ${look} ${low} ${high}`;
    if (!numbers.has(key)) {
      list.push({ ...add(kind, look, low, high), count: 0 });
      numbers.set(key, list.length - 1);
    }
    return numbers.get(key);
  }

  return {
    blueprints,

    // Maps have millions of cells, so what a layer has met is found by a number.
    ofLayer(layer) {
      const known = new Map();
      return (kind, look) => {
        const key = kind * kMostLooks + look;
        let number = known.get(key);
        if (number === undefined) known.set(key, (number = find(kind, look, layer)));
        list[number].count += 1;
        return number;
      };
    },

    legend(fault) {
      if (list.length > kMostLegend)
        throw fault('', `${list.length - 1} kinds of blocks`, `at most ${kMostLegend}`);
      const legend = startLegend(base?.legend, old?.legend);
      const order = list.slice(1).sort((a, b) => b.count - a.count);
      for (const block of order) block.sign ??= legend.add(block.name, block.name, ['#']);
      return { signs: ['.', ...list.slice(1).map(({ sign }) => sign)], table: legend.table };
    },

    stack(levels, tile) {
      let stack = kNoBlocks;
      for (const [level, cells] of levels.entries()) {
        const block = list[cells?.[tile] ?? 0];
        if (block !== null) stack = [...stack, [level + block.bottom, level + block.top]];
      }
      return stack;
    },
  };
}

const lowest = (height) => (Array.isArray(height) ? Math.min(...height) : height);
const highest = (height) => (Array.isArray(height) ? Math.max(...height) : height);

// Lights the sides from the south-west, so that corners show.
function faces(texture) {
  return {
    all: texture,
    north: { texture, light: 0.76 },
    east: { texture, light: 0.86 },
    west: { texture, light: 0.94 },
  };
}
