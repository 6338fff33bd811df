import { divider, fixed, slider } from '../figures/kit.js';

const kMost = 9; // times, painted darkest

// How often a painter paints each row of a column: sky or haze, the floor, then the faces of all
// blocks.
function timesOf({ hits, horizonRow }, height) {
  const times = new Uint8Array(height).fill(1);
  const paint = (from, to) => {
    const last = Math.min(height, Math.round(to));
    for (let row = Math.max(0, Math.round(from)); row < last; ++row) ++times[row];
  };
  paint(horizonRow, height);
  for (const hit of hits) {
    const isOwn = hit.depth === 0;
    if (!isOwn) paint(hit.topFrontRow, hit.bottomFrontRow);
    paint(hit.topBackRow, isOwn ? height : hit.topFrontRow);
    if (!isOwn) paint(hit.bottomFrontRow, hit.bottomBackRow);
  }
  return times;
}

const columnsOf = (source, [width]) => source.hits({ first: 0, last: width - 1 });

function draw(picture, source) {
  const { width, height, data } = picture;
  const columns = columnsOf(source, [width, height]);
  for (let column = 0; column < width; ++column) {
    const times = timesOf(columns[column], height);
    for (let row = 0; row < height; ++row) {
      const share = Math.min(1, (times[row] - 1) / (kMost - 1));
      const start = 4 * (row * width + column);
      data[start] = 250 - 130 * share;
      data[start + 1] = 240 - 215 * share;
      data[start + 2] = 215 - 175 * share;
      data[start + 3] = 255;
    }
  }
}

const averageOf = (now) =>
  now.kept('painted', () => {
    const columns = columnsOf(now.source, now.size);
    let sum = 0;
    for (const column of columns) for (const times of timesOf(column, now.height)) sum += times;
    return sum / (now.width * now.height);
  });

export default {
  scene: 'yard-2.json',
  view: '9.3,7.4,2.2,222,-0.15',
  options: { fov: 66 },
  state: { split: 0.4 },
  world: (source) => source,
  controls: [
    slider({ label: 'Eye', eye: 'z', from: 0.3, to: 5, step: 0.1, unit: 'units' }),
    slider({ label: 'Turn', eye: 'heading', from: 180, to: 270, step: 1, unit: '°' }),
  ],
  rows: [[divider({ left: { title: 'The picture' }, right: { title: 'Times painted', draw } })]],
  numbers: { painted: (now) => fixed(averageOf(now), 1) },
  says: (now) =>
    `The painter paints ${fixed(averageOf(now), 1)} pixels for each pixel of the picture; open rows paint 1.`,
};
