// Scenes without a page: the engine under Node, which draws on request.
//
//     import { load } from 'slicecast/node';
//     const scene = await load('scenes/castle.json');
//     scene.set('fov', 75);
//     scene.step(240, { forward: 1 });                          // walk ahead for two seconds
//     await writeFile('castle.png', await scene.png({ width: 1280, height: 720 }));
//     scene.free();
//
// load() takes a path, an address, the name of a shipped scene, or a scene object.

import { readView } from '../engine/address.js';
import { Engine } from '../engine/engine.js';
import { withReason } from '../engine/source-parts.js';
import { placeOf, withList } from '../engine/trouble.js';
import { readEngine } from './engine-files.js';
import { openScene } from './scene-files.js';

const kSize = { width: 640, height: 400 };
const kOptions = ['engine', 'base', 'onProgress'];
const kLargestSide = 8192; // pixels, as in the engine

// Thrown if a scene cannot be loaded: `code` and `faults` as in the element's event `error`. The
// message lists all faults too.
export class SceneError extends Error {
  name = 'SceneError';

  constructor(code, message, faults = []) {
    super(withList(message, faults));
    this.code = code;
    this.faults = faults;
  }
}

// `engine` is 'auto', 'simd' or 'scalar'. `onProgress(share)` is told how far loading is, from 0 to
// 1; in between, other work goes on. A scene object names its files relative to the folder `base`
// (or the folder of the file `base`); without it, relative to the shipped scenes.
export async function load(scene, options = {}) {
  const { engine: kind = 'auto', base, onProgress = () => {} } = readOptions(options);
  let engine = null;
  try {
    const source = openScene(scene, base);
    engine = await Engine.create({ files: await readEngine(kind) });
    const faults = await engine.loadScene(source, { onProgress: (share) => onProgress(share) });
    if (faults.length === 0) return new Scene(engine);
    const count = faults.length === 1 ? 'a fault' : `${faults.length} faults`;
    throw new SceneError(
      'scene',
      `${source.name} has ${count}:`,
      faults.map((fault) => withPlace(withReason(fault, source.failures))),
    );
  } catch (error) {
    engine?.stop();
    // A wrong argument stays a TypeError.
    throw error instanceof SceneError || error instanceof TypeError
      ? error
      : new SceneError(error.code ?? 'engine', error.message, (error.faults ?? []).map(withPlace));
  }
}

class Scene {
  #engine; // null once freed

  constructor(engine) {
    this.#engine = engine;
  }

  get #running() {
    if (this.#engine === null) throw new Error('This scene has been freed.');
    return this.#engine;
  }

  get warnings() {
    return this.#running.warnings.map(withPlace);
  }

  get world() {
    const { title, maps } = this.#running.world;
    return { title, maps };
  }

  get currentView() {
    return this.#running.view;
  }

  get game() {
    return this.#running.game;
  }

  takeNews() {
    return this.#running.takeNews();
  }

  get optionList() {
    return this.#running.options;
  }

  get oldWays() {
    return this.#running.oldWays;
  }

  get leftOut() {
    return this.#running.leftOut;
  }

  get memory() {
    return this.#running.memoryBytes;
  }

  set(name, value) {
    const engine = this.#running;
    orSceneError('option', () => engine.setOption(name, value));
  }

  get(name) {
    const engine = this.#running;
    return orSceneError('option', () => engine.knownOption(name));
  }

  look(view) {
    return this.#running.look(orSceneError('address', () => readView(view)));
  }

  step(count = 1, input = {}) {
    this.#running.step(input, count);
  }

  reset() {
    this.#running.reset();
  }

  hits(columns, size = kSize) {
    return this.#running.questions.hits(...sidesOf(size), columns);
  }

  trace(columns = undefined, size = kSize) {
    const { questions } = this.#running;
    return columns === undefined
      ? questions.traceFrame(...sidesOf(size))
      : questions.trace(...sidesOf(size), columns);
  }

  cast(from) {
    return this.#running.questions.cast(from);
  }

  pick(column, row, size = kSize) {
    return this.#running.questions.pick(...sidesOf(size), column, row);
  }

  project(x, y, z, map = undefined, size = kSize) {
    return this.#running.questions.project(...sidesOf(size), x, y, z, map);
  }

  cells(map, level) {
    return this.#running.questions.cells(map, level);
  }

  blueprints(map) {
    return this.#running.questions.blueprints(map);
  }

  tryOldWay(number) {
    return this.#running.questions.tryOldWay(number);
  }

  setCell(map, level, x, y, character) {
    this.#running.questions.setCells(map, [{ level, x, y, character }]);
  }

  setCells(map, changes) {
    this.#running.questions.setCells(map, changes);
  }

  mark(lines) {
    this.#running.questions.mark(lines);
  }

  pixels(size = kSize) {
    const engine = this.#running;
    const [width, height] = sidesOf(size);
    return { width, height, data: engine.drawPixels(width, height) };
  }

  // Draws the view at the moment of the call.
  async png(size = kSize) {
    const pixels = this.pixels(size);
    const { encode } = await import('fast-png');
    return encode({ ...pixels, channels: 4, depth: 8 });
  }

  free() {
    this.#engine?.stop();
    this.#engine = null;
  }
}

function readOptions(options) {
  if (typeof options !== 'object' || options === null)
    throw new TypeError(
      `options: found ${String(options)}, expected an object with some of ${kOptions.join(', ')}`,
    );
  for (const name of Object.keys(options))
    if (!kOptions.includes(name))
      throw new TypeError(`options: found ${name}, expected some of ${kOptions.join(', ')}`);
  const { onProgress } = options;
  if (onProgress !== undefined && typeof onProgress !== 'function')
    throw new TypeError(`onProgress: found ${String(onProgress)}, expected a function`);
  return options;
}

function sidesOf(size) {
  const { width, height } = size ?? {};
  const sides = [width, height];
  if (sides.every((side) => Number.isInteger(side) && side >= 1 && side <= kLargestSide))
    return sides;
  throw new RangeError(
    `size: found ${size === null ? null : `${width} x ${height}`}, expected a width and a height of 1 to ${kLargestSide} whole pixels`,
  );
}

function orSceneError(code, act) {
  try {
    return act();
  } catch (error) {
    throw new SceneError(code, error.message);
  }
}

function withPlace(fault) {
  return { ...fault, place: placeOf(fault) };
}
