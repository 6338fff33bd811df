// Makes the pictures of a built page smaller, without changing a pixel: oxipng packs the PNG files
// anew. The results are kept in build/pictures, by the pictures' contents.
//
//     node tools/small-pictures.mjs FOLDER

import optimise, { init } from '@jsquash/oxipng/optimise.js';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import path from 'node:path';
import process from 'node:process';
import { fileURLToPath } from 'node:url';

const kFolders = ['textures', 'see-through', 'sheets', 'sprites'];
const kPacking = { level: 3, interlace: false, optimiseAlpha: false };
const kKept = fileURLToPath(new URL('../build/pictures/', import.meta.url));

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/small-pictures.mjs: found no folder, expected that of a built page');

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

mkdirSync(kKept, { recursive: true });
for (const name of kFolders) {
  const files = readdirSync(path.join(folder, name)).filter((file) => file.endsWith('.png'));
  for (const file of files) {
    const at = path.join(folder, name, file);
    const bytes = readFileSync(at);
    const kept = path.join(kKept, createHash('sha256').update(bytes).digest('hex'));
    if (!existsSync(kept)) writeFileSync(kept, await pack(bytes));
    writeFileSync(at, readFileSync(kept));
  }
}
