import {
  mapView,
  numberTable,
  picture,
  scrub,
  sideView,
  sliceStrip,
  slider,
  fixed,
} from '../figures/kit.js';

// The tiles of the walk with their blocks, and the depths that all of these share.
function tilesOf(now) {
  const { walk, hits } = now.slice;
  return now.tiles.map(({ tile, depth }, index) => ({
    tile,
    depth,
    leave: walk[index + 1]?.depth ?? null,
    blocks: hits.filter((hit) => hit.tile[0] === tile[0] && hit.tile[1] === tile[1]),
  }));
}

const blocksSay = ({ blocks }) =>
  blocks.length === 0
    ? '–'
    : blocks.map(({ blueprint, level }) => `${blueprint}, ${level}`).join('<br>');

export default {
  scene: 'yard-3.json',
  view: '8.2,4.4,0.45,186,0.22',
  options: { fov: 66 },
  state: { column: 255 },
  controls: [scrub({ of: 'walk' }), slider({ label: 'Slice', field: 'column' })],
  rows: [
    [
      picture({ title: 'The picture, and one slice', handles: ['column'] }),
      mapView({ title: 'One walk on the map', fov: false }),
    ],
    [
      sideView({ title: 'All levels in this slice', handles: ['eye'], share: 3 }),
      sliceStrip({ title: 'The rows of the slice', pick: false, tall: 220, share: 2 }),
    ],
    [
      numberTable({
        title: 'The tiles of the walk',
        caption: 'Two depths for each tile, for the blocks of all its levels',
        columns: [
          { head: 'Tile', value: ({ tile }) => tile.join(', ') },
          { head: 'In at', value: ({ depth }) => fixed(depth), class: 'number' },
          {
            head: 'Out at',
            value: ({ leave }) => (leave === null ? '–' : fixed(leave)),
            class: 'number',
          },
          { head: 'Blocks, level', value: blocksSay },
        ],
        items: tilesOf,
        current: (now) => (now.step === null ? -1 : now.step.index),
      }),
    ],
  ],
  numbers: {
    tiles: (now) => String(now.slice.walk.length),
    blocks: (now) => String(now.slice.hits.length),
  },
  says: (now) => {
    const { tile, depth, blocks } = tilesOf(now).at(-1);
    if (now.step === null)
      return `${now.slice.walk.length} tiles, ${now.slice.hits.length} blocks on all levels, one walk.`;
    const found =
      blocks.length === 0
        ? 'no block'
        : blocks.length === 1
          ? 'one block'
          : `${blocks.length} blocks`;
    return `Tile ${tile.join(', ')}, entered at depth ${fixed(depth)}: ${found}.`;
  },
};
