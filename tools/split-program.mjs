// Splits the engine's program in two, so that a page shows its first picture sooner: what draws it,
// and the later part. What draws it is found by a try: the scenes of the page and of the tutorial
// are loaded, drawn and walked a little, and each function that is called stays in the first part.
//
//     node tools/split-program.mjs BINARYEN WEB NAME FEATURE...
//
// BINARYEN is the folder of wasm-split and wasm-opt, which come with Emscripten. WEB is the page's
// folder: WEB/engine/NAME.wasm becomes the first part, WEB/engine/NAME-later.wasm the later one.
// Features are spelled as Binaryen's options: --enable-simd.

import { encode } from 'fast-png';
import { execFile } from 'node:child_process';
import { createHash } from 'node:crypto';
import {
  appendFileSync,
  copyFileSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { promisify } from 'node:util';

const start = promisify(execFile);

const kProfileBytes = 1 << 20;
const kChannels = [1, 2, 3, 4]; // of a picture
const kPlainRoom = {
  title: 'A plain room',
  textures: Object.fromEntries(kChannels.map((count) => [`brick${count}`, `${count}.png`])),
  blueprints: {
    wall: { faces: { all: 'brick1', north: 'brick2', east: 'brick3', south: 'brick4' } },
  },
  legend: { '#': 'wall' },
  maps: [
    {
      name: 'room',
      levels: [['####', '#..#', '####']],
      floor: 'brick3',
      sky: '#88a0b8',
      light: { on: false },
    },
  ],
  start: { x: 1.5, y: 1.5, heading: 0 },
};

const [binaryen, web, name, ...features] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'slicecast-split-'));
try {
  const whole = resolve(web, 'engine', `${name}.wasm`);
  const later = resolve(web, 'engine', `${name}-later.wasm`);
  const watched = join(folder, 'watched.wasm');
  const profile = join(folder, 'profile');
  const first = join(folder, 'first.wasm');
  await run('wasm-split', '--instrument', whole, '-o', watched, '--profile-export=write_profile');
  writeFileSync(profile, await profileOf(readFileSync(watched)));
  await run(
    'wasm-split',
    whole,
    `--profile=${profile}`,
    '-o1',
    first,
    '-o2',
    later,
    '--export-prefix=%',
  );
  const mark = markOf(readFileSync(whole));
  await Promise.all([first, later].map(finish));
  for (const part of [first, later]) appendFileSync(part, mark);
  copyFileSync(first, whole);
} finally {
  rmSync(folder, { recursive: true });
}

// What is called in one place stays a function here too: one large function of many unlike parts
// compresses worse than these beside their like.
async function finish(part) {
  const tool = fileURLToPath(new URL('order-functions.mjs', import.meta.url));
  await start(process.execPath, [tool, binaryen, part, ...features]);
  await run('wasm-opt', '-Oz', '--one-caller-inline-max-function-size=40', part, '-o', part);
}

// A custom section "whole": both parts have the same one, so that a page notices parts of different
// programs.
function markOf(bytes) {
  const name = 'whole';
  const hash = createHash('sha256').update(bytes).digest().subarray(0, 8);
  return Uint8Array.of(
    0,
    1 + name.length + hash.length,
    name.length,
    ...Buffer.from(name),
    ...hash,
  );
}

function run(program, ...values) {
  return start(join(binaryen, program), [...values, ...features]);
}

// Which functions the engine calls for the first pictures of all shipped scenes, as Binaryen
// writes it.
async function profileOf(bytes) {
  const module = (path) => import(pathToFileURL(resolve(web, path)));
  const { Engine } = await module('engine/engine.js');
  const { openScene } = await module('node/scene-files.js');
  const program = await WebAssembly.compile(bytes);
  // The window's part of engine-module.js and engine-canvas.js
  const frames = [];
  globalThis.requestAnimationFrame = (frame) => frames.push(frame);
  globalThis.cancelAnimationFrame = () => {};
  const canvas = { blur() {} };
  const running = [];
  const openCanvas = (_, exports) => {
    running.push(exports);
    exports.slicecast_steerByCursor(1);
    exports.slicecastHidden(0);
    exports.slicecastBlurred();
    return { show() {}, close() {} };
  };

  const files = { program, openCanvas, later: null };
  const engine = await Engine.create({ files, canvas });
  for (const channels of kChannels) writeFileSync(join(folder, `${channels}.png`), grey(channels));
  const scenes = ['scenes', 'learn/scenes'].flatMap(scenesIn);
  for (const scene of [...scenes, kPlainRoom]) {
    const faults = await engine.loadScene(openScene(scene, folder));
    if (faults.length > 0) {
      console.error(`The engine is split without a scene that has faults. ${faults[0].message}`);
      continue;
    }
    // What the element asks of it before it plays
    engine.paused = true;
    engine.setMouse({ degreesPerPixel: 0.1, invert: false });
    engine.look(engine.view);
    engine.setOption('bob', engine.option('bob'));
    engine.begin();
    engine.resize(640, 400);
    frames.at(-1)?.(0);
    // Scenes of others may show less, and begin elsewhere
    const names = ['fog', 'baked', 'light', 'textures'];
    for (const name of names) {
      engine.setOption(name, 'off');
      lookAround(engine);
    }
    for (const name of names) engine.setOption(name, 'on');
    lookAround(engine);
    for (let frame = 1; frame < 8; ++frame) frames.at(-1)?.(16 * frame);
  }
  await askForTable(engine);
  const twin = await Engine.create({ files, canvas });
  if (!twin.adopt(engine)) throw new Error('an engine cannot adopt the scene of another');
  twin.begin();
  frames.at(-1)?.(0);
  twin.stop();
  engine.stop();
  return merged(running.map(takeProfile));
}

// A scene that names shipped pictures waits for their table and the later part: up to there.
async function askForTable(engine) {
  let isWanted = true;
  const text = JSON.stringify({ ...kPlainRoom, textures: {} });
  await engine.loadScene(
    {
      name: 'scene',
      readText: () => new TextEncoder().encode(text),
      readFile() {
        isWanted = false;
        return null;
      },
    },
    { isWanted: () => isWanted },
  );
}

function grey(channels) {
  const [width, height] = [64, 64];
  const data = new Uint8Array(width * height * channels).map((_, index) => 100 + (index % 64));
  return encode({ width, height, channels, depth: 8, data });
}

function lookAround(engine) {
  const before = engine.view;
  for (const heading of [0, 90, 180, 270]) {
    for (const look of [-1, 0, 1]) {
      engine.look({ ...before, heading, look });
      engine.drawPixels(160, 100);
    }
  }
  engine.look(before);
}

function scenesIn(folder) {
  return readdirSync(resolve(web, folder))
    .filter((name) => name.endsWith('.json') && name !== 'index.json')
    .map((name) => resolve(web, folder, name));
}

function takeProfile(exports) {
  const at = exports.malloc(kProfileBytes);
  const size = exports.write_profile(at, kProfileBytes);
  return new Uint32Array(exports.memory.buffer.slice(at, at + size));
}

// A profile is two numbers for the program, and one for each function: 0 if it was not called.
function merged(profiles) {
  const [first, ...others] = profiles;
  return first.map((number, index) =>
    Math.max(number, ...others.map((profile) => (index < 2 ? 0 : profile[index]))),
  );
}
