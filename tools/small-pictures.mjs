// Makes the pictures of a built page smaller, without changing a pixel: oxipng packs the PNG files
// anew. The results are kept in the folder KEPT, by the pictures' contents.
//
//     node tools/small-pictures.mjs FOLDER KEPT

import optimise, { init } from '@jsquash/oxipng/optimise.js';
import { createHash } from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  renameSync,
  writeFileSync,
} from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import process from 'node:process';

const kFolders = ['textures', 'see-through', 'sheets', 'sprites'];
const kPacking = { level: 3, interlace: false, optimiseAlpha: false };

const [folder, keptFolder] = process.argv.slice(2);
if (keptFolder === undefined)
  throw new Error('tools/small-pictures.mjs: expected two folders, a built page and what is kept');

let isReady = false;

async function pack(bytes) {
  if (!isReady) {
    const require = createRequire(import.meta.url);
    const program = require.resolve('@jsquash/oxipng/codec/pkg/squoosh_oxipng_bg.wasm');
    await init(await WebAssembly.compile(readFileSync(program)));
    isReady = true;
  }
  const packed = new Uint8Array(await optimise(Uint8Array.from(bytes).buffer, kPacking));
  return packed.length < bytes.length ? packed : bytes;
}

mkdirSync(keptFolder, { recursive: true });
for (const name of kFolders) {
  const files = readdirSync(path.join(folder, name)).filter((file) => file.endsWith('.png'));
  for (const file of files) {
    const at = path.join(folder, name, file);
    const bytes = readFileSync(at);
    const kept = path.join(keptFolder, createHash('sha256').update(bytes).digest('hex'));
    if (!existsSync(kept)) {
      // In one move, because other clones on the machine read the folder too.
      writeFileSync(`${kept}.${process.pid}`, await pack(bytes));
      renameSync(`${kept}.${process.pid}`, kept);
    }
    writeFileSync(at, readFileSync(kept));
  }
}
