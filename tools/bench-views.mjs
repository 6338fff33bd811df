// The views of tools/bench, and what is asked of each: a list of {name, title, scene, isTour}. A
// `name` is slicecast-bench's (tests/bench/views.h). Shipped scenes are listed by
// assets/scenes/index.json; tests/bench/moments.json has the step at which the tour through a scene
// is slowest to draw, as tools/bench --slowest has found it.

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

export const root = dirname(dirname(fileURLToPath(import.meta.url)));
export const kMoments = 'tests/bench/moments.json';
const kStepsPerSecond = 120;

const readJson = (file) => JSON.parse(readFileSync(join(root, file), 'utf8'));

export const scenes = readJson('assets/scenes/index.json').map(({ file, tour = false }) => ({
  scene: file.replace('.json', ''),
  tour,
}));
export const moments = readJson(kMoments);

const kMade = [
  'flat hall',
  'hall of heights',
  '100 objects',
  '10,000 objects, 100 seen',
  'stones on 64 x 64 tiles',
  'stones on 2048 x 2048 tiles',
];

export const views = [
  ...scenes.map(({ scene }) => ({ scene, name: scene, title: `${scene}, start` })),
  ...scenes
    .filter(({ scene }) => Object.hasOwn(moments, scene))
    .map(({ scene }) => ({
      scene,
      isTour: true,
      name: `${scene}@${moments[scene]}`,
      title: `${scene}, tour ${(moments[scene] / kStepsPerSecond).toFixed(1)} s`,
    })),
  ...kMade.map((name) => ({ name, title: name })),
];

// Those whose title has these words, "water palace"; all if nothing is given.
export function viewsLike(words, all = views) {
  const plain = (text) => text.toLowerCase().replaceAll(/[^a-z0-9]+/g, ' ');
  const found = all.filter(({ title }) => words.some((some) => plain(title).includes(plain(some))));
  return words.length === 0 ? all : found;
}

// Nanoseconds a pixel that a view may take as WebAssembly on the machine whose limit stands below;
// elsewhere as many times the limit.
const kMost = {
  'water-palace, start': 10,
  'hill-abbey, start': 10,
  'glassworks, start': 8,
  'harbour-town, start': 8,
  'flat hall': 1.3,
  'hall of heights': 1.25,
  '10,000 objects, 100 seen': 17,
};
const kMostOfStart = 5;
const kMostOfTour = 12;
const kNativeShare = 0.65;
const kLimits = { native: 0.686, wasm: 0.724 };

// What is asked of a view in a build, times the limit; Infinity for nothing.
export function mostOf(title, build) {
  const { scene, isTour } = views.find((view) => view.title === title);
  const usual = isTour ? kMostOfTour : scene ? kMostOfStart : Infinity;
  return ((kMost[title] ?? usual) * (build === 'native' ? kNativeShare : 1)) / kLimits[build];
}

// What is asked of some views beside others: [title, times, of]
export const kBeside = [
  ['10,000 objects, 100 seen', 1.5, '100 objects'], // the unseen are looked at once a frame
  ['stones on 2048 x 2048 tiles', 1.15, 'stones on 64 x 64 tiles'],
];
