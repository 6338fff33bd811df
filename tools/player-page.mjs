// Makes the player of a built page: the HTML file that plays a world from a disk, without a world,
// in UTF-16.
// The editor and the command `slicecast html` fill one in (edit/files/html-file.js).
//
//     node tools/player-page.mjs FOLDER   // makes FOLDER/edit/player.bin of FOLDER/edit/player
//
// Programs are packed better than zlib does it, as a file is to be small: oxipng packs them as the
// pixels of a picture with one row, and what is packed there is taken out again.

import optimise, { init } from '@jsquash/oxipng/optimise.js';
import { readFile, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import path from 'node:path';
import process from 'node:process';
import { deflateRawSync, deflateSync, inflateRawSync } from 'node:zlib';
import { denseText, utf16 } from '../web/edit/files/dense-text.js';

const kParts = {
  player: 'edit/player/main.js',
  program: 'engine/slicecast-simd.wasm',
  later: 'engine/slicecast-simd-later.wasm',
};
const kLicences = {
  Slicecast: 'LICENSE',
  RapidJSON: 'licences/RapidJSON.txt',
  stb_image: 'licences/stb.txt',
  SDL: 'licences/SDL2.txt',
  musl: 'licences/musl.txt',
};
const kPacking = { level: 2, interlace: false, optimiseAlpha: false };
const kSignature = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const kGrey = [8, 0, 0, 0, 0]; // 8 bits a pixel

const [folder] = process.argv.slice(2);
if (folder === undefined)
  throw new Error('tools/player-page.mjs: found no folder, expected that of a built page');
const at = (name) => path.join(folder, name);

const require = createRequire(import.meta.url);
await init(
  await WebAssembly.compile(
    await readFile(require.resolve('@jsquash/oxipng/codec/pkg/squoosh_oxipng_bg.wasm')),
  ),
);

const crcs = Uint32Array.from({ length: 256 }, (_, byte) => {
  let value = byte;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

function chunk(type, data) {
  const bytes = Buffer.alloc(data.length + 12);
  bytes.writeUInt32BE(data.length, 0);
  bytes.write(type, 4, 'latin1');
  bytes.set(data, 8);
  let crc = -1;
  for (const byte of bytes.subarray(4, -4)) crc = crcs[(crc ^ byte) & 255] ^ (crc >>> 8);
  bytes.writeInt32BE(~crc, data.length + 8);
  return bytes;
}

// Deflated, with a zero before them, as a row of a picture has it.
async function packed(bytes) {
  const row = Buffer.concat([Buffer.alloc(1), bytes]);
  const header = Buffer.alloc(13);
  header.writeUInt32BE(bytes.length, 0);
  header.writeUInt32BE(1, 4);
  header.set(kGrey, 8);
  const picture = Buffer.concat([
    Buffer.from(kSignature),
    chunk('IHDR', header),
    chunk('IDAT', deflateSync(row)),
    chunk('IEND', Buffer.alloc(0)),
  ]);
  const small = Buffer.from(await optimise(Uint8Array.from(picture).buffer, kPacking));
  const data = [];
  for (let begin = kSignature.length; begin < small.length;) {
    const length = small.readUInt32BE(begin);
    if (small.toString('latin1', begin + 4, begin + 8) === 'IDAT')
      data.push(small.subarray(begin + 8, begin + 8 + length));
    begin += length + 12;
  }
  const better = Buffer.concat(data).subarray(2, -4); // without the frame of zlib
  const isSame = row.equals(inflateRawSync(better));
  return isSame ? better : deflateRawSync(row, { level: 9, memLevel: 9 });
}

const texts = [];
for (const [name, file] of Object.entries(kLicences))
  texts.push(`${name}\n\n${(await readFile(at(file), 'utf8')).trim()}`);
const parts = [['texts', Buffer.from(texts.join('\n\n\n'))]];
for (const [id, file] of Object.entries(kParts)) parts.push([id, await readFile(at(file))]);

let page = await readFile(at('edit/player/page.html'), 'utf8');
const fill = (mark, text) => {
  if (!page.includes(mark)) throw new Error(`tools/player-page.mjs: the page lacks ${mark}`);
  page = page.replace(mark, () => text.trim());
};
const boot = (await readFile(at('edit/player/boot.js'), 'utf8')).replace(/^\/\/.*\n/, '');
fill('{{boot}}', boot);
const elements = [];
for (const [id, bytes] of parts)
  elements.push(
    `<script type="text/plain" id="${id}">\n${denseText(await packed(bytes))}\n</script>`,
  );
fill('{{parts}}', elements.join('\n'));
await writeFile(at('edit/player.bin'), utf16(page));
await rm(at('edit/player'), { recursive: true });
