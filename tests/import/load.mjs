// The import modules as a page gets them, in one bundle without Node's modules; and how tests make
// pictures and try the scenes that come out.
//
//     const { readForeign, makeScene } = await importModules();
//     const made = await make({ name, bytes, files });     // reads, makes, loads it by the engine

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { rmSync } from 'node:fs';
import { mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { load } from '../../build/web/node/index.js';

export const root = fileURLToPath(new URL('../..', import.meta.url));
const fromTools = createRequire(path.join(root, 'tools/package.json'));
const { build } = await import(pathToFileURL(fromTools.resolve('esbuild')));
export const { decode, encode } = fromTools('fast-png');
export const { gzipSync, zlibSync } = fromTools('fflate');

let modules = null;

export async function importModules() {
  modules ??= bundled();
  return modules;
}

async function bundled() {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-import-'));
  try {
    await build({
      entryPoints: [path.join(root, 'web/edit/import/index.js')],
      outdir: folder,
      outExtension: { '.js': '.mjs' },
      nodePaths: [path.join(root, 'tools/node_modules')],
      bundle: true,
      splitting: true, // what few maps need loads later
      platform: 'browser',
      format: 'esm',
      target: 'es2022',
      logLevel: 'warning',
    });
    return await import(pathToFileURL(path.join(folder, 'index.mjs')));
  } finally {
    // Parts load late, so the folder stays until the process ends.
    process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  }
}

export const bytesOf = (text) => new TextEncoder().encode(text);
export const textOf = (value) => bytesOf(typeof value === 'string' ? value : JSON.stringify(value));

// A picture whose texels are colourAt(x, y): [red, green, blue, alpha].
export function picture(width, height, colourAt) {
  const data = new Uint8Array(4 * width * height);
  for (let y = 0; y < height; ++y)
    for (let x = 0; x < width; ++x) data.set(colourAt(x, y), 4 * (y * width + x));
  return encode({ width, height, data, channels: 4, depth: 8 });
}

// Six tiles of 16 texels, in two rows; the last one is half see-through. Each has a light bar in
// the upper left, wider than high, so that turns can be told.
export const kTileColours = [
  [120, 60, 50, 255],
  [90, 130, 70, 255],
  [60, 90, 150, 255],
  [150, 140, 120, 255],
  [200, 180, 90, 255],
  [20, 120, 40, 255],
];

export function tilesPicture({ side = 16, columns = 3, margin = 0, spacing = 0 } = {}) {
  const step = side + spacing;
  const width = 2 * margin + columns * step - spacing;
  const rows = Math.ceil(kTileColours.length / columns);
  return picture(width, 2 * margin + rows * step - spacing, (x, y) => {
    const [column, row] = [x, y].map((at) => Math.floor((at - margin) / step));
    const [inX, inY] = [x, y].map((at) => (at - margin) % step);
    const colour = kTileColours[row * columns + column];
    const isInside = x >= margin && y >= margin && inX < side && inY < side && colour;
    if (!isInside) return [255, 0, 255, 255];
    if (inX < side / 2 && inY < side / 4) return [250, 250, 250, 255];
    return row * columns + column === 5 && inY > side / 2 ? [0, 0, 0, 0] : colour;
  });
}

export function readerOf(files) {
  const asked = [];
  const readFile = async (name) => {
    asked.push(name);
    if (!Object.hasOwn(files, name)) throw new Error('no such file');
    return files[name] instanceof Uint8Array ? files[name] : textOf(files[name]);
  };
  return { readFile, asked };
}

export async function proposalOf(name, content, files = {}) {
  const { readForeign } = await importModules();
  const bytes = content instanceof Uint8Array ? content : textOf(content);
  return readForeign({ name, bytes, readFile: readerOf(files).readFile });
}

// Reads a map, lets `change` alter the proposal, makes the scene, and loads it by the engine.
export async function make(name, content, files = {}, change = () => {}) {
  const proposal = await proposalOf(name, content, files);
  change(proposal);
  const { makeScene } = await importModules();
  const made = await makeScene(proposal);
  const world = await tryScene(made);
  return { ...made, proposal, world };
}

// Loads it, with its own pictures beside it, and the shipped ones where scenes have them.
export async function tryScene({ scene, pictures }, see = () => {}) {
  const folder = await writeScene({ scene, pictures });
  const file = path.join(folder, 'scenes/made.json');
  const loaded = await load(file);
  try {
    await see(loaded, file);
    return { ...loaded.world, warnings: loaded.warnings.map(({ message }) => message) };
  } finally {
    loaded.free();
    await rm(folder, { recursive: true });
  }
}

async function writeScene({ scene, pictures }) {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-made-'));
  const scenes = path.join(folder, 'scenes');
  await mkdir(scenes);
  for (const art of ['textures', 'sprites'])
    await symlink(path.join(root, 'assets', art), path.join(folder, art));
  await writeFile(path.join(scenes, 'made.json'), JSON.stringify(scene));
  for (const [name, bytes] of pictures) {
    await mkdir(path.dirname(path.join(scenes, name)), { recursive: true });
    await writeFile(path.join(scenes, name), bytes);
  }
  return folder;
}

export async function refused(name, content, files, expected) {
  const { ImportError } = await importModules();
  await assert.rejects(make(name, content, files), (error) => {
    assert.ok(error instanceof ImportError, `${error.stack}`);
    assert.match(error.message, expected);
    return true;
  });
}

export const base64 = (bytes) => Buffer.from(bytes).toString('base64');

// The cells as four bytes each, the lowest first.
export function packedCells(cells) {
  const bytes = new Uint8Array(4 * cells.length);
  const view = new DataView(bytes.buffer);
  cells.forEach((cell, index) => view.setUint32(4 * index, cell >>> 0, true));
  return bytes;
}
