// Loads the WebAssembly that the page ships into Node, and gives its functions the types of
// JavaScript.
//
//     const module = await loadModule('simd');
//     const session = new Session(module);
//     session.load('assets/scenes/first-walk.json');       the list of its faults

import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { createModule } from '../../build/web/engine/engine-module.js';
import { Engine } from '../../build/web/engine/engine.js';
import { Questions } from '../../build/web/engine/questions.js';
import { readEngine } from '../../build/web/node/engine-files.js';
import { openScene } from '../../build/web/node/scene-files.js';

export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
export const flavours = ['simd', 'scalar'];

export const shippedScenes = readdirSync(join(root, 'assets/scenes'))
  .filter((name) => name.endsWith('.json') && name !== 'index.json')
  .map((name) => join(root, 'assets/scenes', name));

export const shippedTours = readdirSync(join(root, 'assets/tours')).map((name) =>
  join(root, 'assets/tours', name),
);

// A new instance, with memory of its own.
export async function loadModule(flavour) {
  const { program, later } = await readEngine(flavour);
  return createModule(program, { later });
}

// Those that take long to find, {warnings, spares}, in a scene as for `load` of the package.
export async function mistakesOf(scene) {
  const engine = await Engine.create({ files: await readEngine('auto') });
  try {
    return await engine.findMistakes(openScene(scene), () => true);
  } finally {
    engine.stop();
  }
}

export class Session {
  constructor(module) {
    this.module = module;
    this.address = module._slicecast_create();
  }

  free() {
    this.module._slicecast_free(this.address);
  }

  // Reads a scene file from disk.
  load(path) {
    return this.loadText(readFileSync(path), path, (name) =>
      readFileSync(join(dirname(path), name)),
    );
  }

  // `readFile` gives the bytes of a file that the scene names, or throws.
  loadText(text, name, readFile) {
    const { files, faults } = this.parse(text, name);
    if (faults.length > 0) return faults;
    for (const file of files) {
      let bytes;
      try {
        bytes = readFile(file);
      } catch {
        continue;
      }
      this.supply(file, bytes);
    }
    return this.start();
  }

  parse(text, name) {
    const bytes = Buffer.from(text);
    const parse = () => {
      this.withMemory([bytes, cString(name)], (textAt, nameAt) =>
        this.module._slicecast_parse(this.address, textAt, bytes.length, nameAt),
      );
      return this.finish();
    };
    const answer = parse();
    if (answer.files !== undefined) return answer;
    // It asks for the table of shipped pictures, of which there are none here.
    const table = Buffer.from('{}');
    this.withMemory([table], (at) =>
      this.module._slicecast_takePictures(this.address, at, table.length),
    );
    return parse();
  }

  // What parse and start begin.
  finish() {
    while (this.module._slicecast_next(this.address) < 1);
    return this.json(this.module._slicecast_answer(this.address));
  }

  supply(name, bytes) {
    this.withMemory([cString(name), bytes], (nameAt, at) =>
      this.module._slicecast_supply(this.address, nameAt, at, bytes.length),
    );
  }

  start() {
    this.module._slicecast_start(this.address, 0);
    const { faults, warnings } = this.finish();
    this.warnings = warnings;
    return faults;
  }

  world() {
    return this.json(this.module._slicecast_world(this.address));
  }

  state() {
    return this.json(this.module._slicecast_state(this.address));
  }

  game() {
    return this.json(this.module._slicecast_game(this.address));
  }

  news() {
    return this.json(this.module._slicecast_news(this.address));
  }

  // The input in the order of slicecast_step.
  step(input, count = 1) {
    for (let i = 0; i < count; ++i) this.module._slicecast_step(this.address, ...input);
  }

  // A copy of the picture, or null.
  draw(width, height, fraction = 1) {
    if (this.module._slicecast_draw(this.address, width, height, fraction) === 0) return null;
    const at = this.module._slicecast_picture(this.address);
    return Buffer.from(this.module.HEAPU8.subarray(at, at + width * height * 4));
  }

  setOption(name, value) {
    return this.withMemory([cString(name), cString(value)], (nameAt, valueAt) =>
      this.module.UTF8ToString(this.module._slicecast_setOption(this.address, nameAt, valueAt)),
    );
  }

  option(name) {
    return this.withMemory([cString(name)], (nameAt) =>
      this.module.UTF8ToString(this.module._slicecast_option(this.address, nameAt)),
    );
  }

  options() {
    return this.json(this.module._slicecast_options(this.address));
  }

  setEye({ map = 0, x, y, z, heading = 0, look = 0 }) {
    return this.module._slicecast_setEye(this.address, map, x, y, z, heading, look) === 1;
  }

  goToMap(map) {
    return this.module._slicecast_goToMap(this.address, map) === 1;
  }

  // Rays, pixels, points and cells.
  get questions() {
    const maps = this.world()?.maps ?? [];
    const names = maps.map(({ name }) => name);
    return new Questions(this.module, this.address, names);
  }

  hits(width, height, column) {
    return this.questions.hits(width, height, column);
  }

  // Column -1 means the whole picture.
  trace(width, height, column) {
    return column === -1
      ? this.questions.traceFrame(width, height)
      : this.questions.trace(width, height, column);
  }

  record(sceneName) {
    this.withMemory([cString(sceneName)], (nameAt) =>
      this.module._slicecast_record(this.address, nameAt),
    );
  }

  takeRecording() {
    return this.module.UTF8ToString(this.module._slicecast_takeRecording(this.address));
  }

  readRecording(text, name) {
    const bytes = Buffer.from(text);
    return this.withMemory([bytes, cString(name)], (textAt, nameAt) =>
      this.json(this.module._slicecast_readRecording(this.address, textAt, bytes.length, nameAt)),
    );
  }

  replay() {
    return this.module._slicecast_replay(this.address) === 1;
  }

  replayStep(count) {
    return this.module._slicecast_replayStep(this.address, count);
  }

  seekReplay(step) {
    return this.module._slicecast_seekReplay(this.address, step) === 1;
  }

  replayState() {
    return this.json(this.module._slicecast_replayState(this.address));
  }

  json(at) {
    return JSON.parse(this.module.UTF8ToString(at));
  }

  withMemory(blocks, use) {
    const addresses = blocks.map((block) => {
      const at = this.module._malloc(Math.max(1, block.length));
      this.module.HEAPU8.set(block, at);
      return at;
    });
    try {
      return use(...addresses);
    } finally {
      addresses.forEach((at) => this.module._free(at));
    }
  }
}

function cString(text) {
  return Buffer.from(`${text}\0`);
}

// A small room: walls around an open middle, one texture, which `textureBytes` gives.
export function roomScene({ width = 8, depth = 6, texture = 'brick.png', ...more } = {}) {
  const rows = Array.from({ length: depth }, (_, y) =>
    y === 0 || y === depth - 1 ? '#'.repeat(width) : `#${'.'.repeat(width - 2)}#`,
  );
  return JSON.stringify({
    title: 'A room',
    textures: { brick: texture },
    blueprints: { wall: { faces: 'brick' } },
    legend: { '#': 'wall' },
    maps: [{ name: 'room', levels: [rows], floor: 'brick' }],
    start: { map: 'room', x: width / 2, y: depth / 2, heading: 0 },
    ...more,
  });
}

export const textureBytes = readFileSync(join(root, 'assets/textures/brick.png'));
