// Scenes without a page: the engine under Node, drawing when asked to.
//
//     import { load } from 'slicecast/node';
//     const scene = await load('scenes/castle.json');           // a path, an address, the name of a shipped scene, or an object
//     scene.set('fov', 75);
//     scene.step(240, { forward: 1 });                          // two seconds ahead
//     await writeFile('castle.png', await scene.png({ width: 1280, height: 720 }));
//     scene.free();

import { parseView } from '../address.js';
import { Engine } from '../engine.js';
import { placeOf } from '../trouble.js';
import { readEngine } from './engine-files.js';
import { openScene } from './scene-files.js';

const kSize = { width: 640, height: 400 };

// What keeps a scene from being loaded: `code` and `faults` as in the element's event `error`, all of them in the message too.
export class SceneError extends Error {
  name = 'SceneError';

  constructor(code, message, faults = []) {
    super([message, ...faults.map((fault) => `  ${fault.place}: found ${fault.found}, expected ${fault.expected}`)].join('\n'));
    this.code = code;
    this.faults = faults;
  }
}

// `engine` is 'auto', 'simd' or 'scalar'; `base` the address from which an object names its files, that of the shipped scenes if it is left out.
export async function load(scene, { engine: kind = 'auto', base } = {}) {
  const source = openScene(scene, base);
  const engine = await Engine.create({ files: await readEngine(kind) });
  let faults;
  try {
    faults = await engine.loadScene(source);
  } catch (error) {
    throw new SceneError(error.code ?? 'engine', error.message);
  }
  if (faults.length > 0) {
    throw new SceneError('scene', `${source.name} has ${faults.length === 1 ? 'a fault' : `${faults.length} faults`}:`, faults.map(withPlace));
  }
  return new Scene(engine);
}

class Scene {
  #engine;

  constructor(engine) {
    this.#engine = engine;
  }

  get warnings() {
    return this.#engine.warnings.map(withPlace);
  }

  get world() {
    const { title, maps } = this.#engine.world;
    return { title, maps };
  }

  get currentView() {
    return this.#engine.view;
  }

  get optionList() {
    return this.#engine.options;
  }

  get memory() {
    return this.#engine.memoryBytes;
  }

  set(name, value) {
    try {
      this.#engine.setOption(name, value);
    } catch (error) {
      throw new SceneError('option', error.message);
    }
  }

  get(name) {
    const value = this.#engine.option(name);
    if (value === '') throw new SceneError('option', `option: found "${name}", expected one of ${this.optionList.map((option) => option.name).join(', ')}`);
    return value;
  }

  look(view) {
    return this.#engine.look(typeof view === 'string' ? parseView(view) : view);
  }

  step(count = 1, input = {}) {
    this.#engine.step(input, count);
  }

  reset() {
    this.#engine.reset();
  }

  hits(column, { width, height } = kSize) {
    return this.#engine.hits(width, height, column);
  }

  trace(column = undefined, { width, height } = kSize) {
    return column === undefined ? this.#engine.traceFrame(width, height) : this.#engine.trace(width, height, column);
  }

  picture({ width, height } = kSize) {
    const data = this.#engine.drawPixels(width, height);
    if (data === null) throw new RangeError(`size: found ${width} x ${height}, expected 1 to 8192 pixels a side`);
    return { width, height, data };
  }

  async png(size = kSize) {
    const { encode } = await import('fast-png');
    return encode({ ...this.picture(size), channels: 4, depth: 8 });
  }

  free() {
    this.#engine.stop();
  }
}

function withPlace(fault) {
  return { ...fault, place: placeOf(fault) };
}
