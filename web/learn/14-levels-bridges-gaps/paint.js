import { choice, mapView, picture, sideView, slider } from '../figures/kit.js';

const kLevels = [0, 1, 2];
const kBlocks = ['o', 'h', 'v', '-', '#', '.'];

export default {
  scene: 'yard-3.json',
  view: '7.3,6.6,0.5,270,0.1',
  options: { fov: 66 },
  state: {
    column: 240,
    level: '1',
    edits: [
      ['yard', 0, 6, 2, 'o'],
      ['yard', 1, 6, 2, 'h'],
      ['yard', 1, 7, 2, 'h'],
    ],
  },
  controls: [
    choice({ label: 'Level', field: 'level', of: kLevels.map(String) }),
    slider({ label: 'Turn', eye: 'heading', from: 180, to: 360, step: 1, unit: '°' }),
  ],
  rows: [
    [
      picture({ title: 'Your yard', handles: ['column'] }),
      ...kLevels.map((level) =>
        mapView({
          title: `Level ${level}: paint here`,
          paint: true,
          level,
          levels: [level],
          blocks: kBlocks,
          window: [4, 0, 7, 8],
          order: false,
          marks: false,
          lit: false,
          when: (state) => state.level === String(level),
        }),
      ),
    ],
    [sideView({ title: 'The slice from the side', handles: [], height: 2.5 })],
  ],
  numbers: {},
  says: (now) => {
    const floating = now.slice.hits.filter(
      ({ bottom, tile }) =>
        bottom > 0 &&
        !now.slice.hits.some((other) => other.tile.join() === tile.join() && other.top === bottom),
    );
    return floating.length === 0
      ? 'In this slice every block stands on something.'
      : `In this slice ${floating.length === 1 ? 'one block has' : `${floating.length} blocks have`} nothing below.`;
  },
};
