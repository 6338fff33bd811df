import { fixed, mapView, numberTable, picture, slider } from '../figures/kit.js';

const kTrees = [2, 3]; // their places in the map's list
const kNames = ['taller tree', 'shorter tree'];

function treesOf(now) {
  const { eye } = now;
  const angle = (eye.heading * Math.PI) / 180;
  const [forwardX, forwardY] = [Math.cos(angle), Math.sin(angle)];
  const { objects } = now.map('yard');
  return kTrees
    .map((index, i) => {
      const { x, y, height } = objects[index];
      const depth = (x - eye.x) * forwardX + (y - eye.y) * forwardY;
      return {
        name: kNames[i],
        height,
        depth,
        engine: now.source.project(x, y, 0, 'yard')?.depth ?? null,
      };
    })
    .sort((a, b) => a.depth - b.depth);
}

export const kView = '3.3,3.9,0.6,78,0.1';

export const nearestDepth = (now) => treesOf(now)[0].depth;

export default {
  scene: 'yard-4.json',
  view: kView,
  options: { fov: 66 },
  controls: [slider({ label: 'Turn', eye: 'heading', from: 20, to: 200, step: 1, unit: '°' })],
  rows: [
    [
      picture({ title: 'Two trees', mark: 'none', handles: ['turn'] }),
      mapView({
        title: 'From above',
        handles: ['eye', 'heading'],
        window: [1, 3, 8, 6],
        ray: false,
        lit: false,
        marks: false,
        order: false,
      }),
    ],
    [
      numberTable({
        title: 'In the order of drawing',
        columns: [
          { head: '', value: ({ name }) => name },
          { head: 'Height', value: ({ height }) => fixed(height, 1), class: 'number' },
          { head: 'Depth', value: ({ depth }) => fixed(depth), class: 'number' },
          { head: 'Engine', value: ({ engine }) => fixed(engine), class: 'number' },
        ],
        items: treesOf,
        current: () => 0,
      }),
    ],
  ],
  numbers: { near: (now) => fixed(nearestDepth(now)) },
  says: (now) => {
    const [near, far] = treesOf(now);
    return `The ${near.name} comes first: its depth is ${fixed(near.depth)}, the other’s ${fixed(far.depth)}.`;
  },
};
