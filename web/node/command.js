#!/usr/bin/env node
// The command of the package: makes scenes of maps from elsewhere, and HTML files of scenes.
//
//     npx slicecast import maps/town.tmx -o town.json
//     npx slicecast html town.json -o town.html
//
// `import` reads FILE and what that names in its folder, and writes the scene and its pictures,
// shipped ones too, beside each other. `html` writes one file that plays the scene from a disk. The
// exit status is 0, 1 after an error, 2 if it was called wrongly.

import { mkdir, readFile, realpath, stat, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { parseArgs } from 'node:util';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';

import { htmlFile } from '../edit/files/html-file.js';
import { textIn } from '../edit/files/text-form.js';
import { knowShipped } from '../edit/files/shipped.js';
import { Engine } from '../engine/engine.js';
import { kMostFileBytes, tooLong } from '../engine/limits.js';
import { isShippedFile, placesOf, readFirst } from '../engine/source-parts.js';
import { counted, ImportError, makeScene, readForeign } from '../edit/import/index.js';
import { readEngine } from './engine-files.js';
import { load, SceneError } from './index.js';

const kUsage = `slicecast import FILE [-o SCENE] [--root FOLDER] [--force]

Makes a scene of a map of Tiled (.tmx, .tmj), a project of LDtk (.ldtk), or a text with rows of
numbers or characters. It lists what it could not take.

  -o SCENE       the scene to write; NAME-scene.json in this folder if left out
  --root FOLDER  the folder with all files that the map may name; that of FILE if left out
  --force        overwrites files

slicecast html SCENE [-o FILE] [--force]

Makes one HTML file that plays the scene from a disk, without a server. Its pictures are looked for
beside it, then among the shipped ones.

  -o FILE        the file to write; NAME.html in this folder if left out
  --force        overwrites the file
`;
const kOptions = {
  output: { type: 'string', short: 'o' },
  root: { type: 'string' },
  force: { type: 'boolean', default: false },
  help: { type: 'boolean', short: 'h', default: false },
};
const kPackage = fileURLToPath(new URL('../', import.meta.url));

class UsageError extends Error {}

function readWords() {
  let words;
  try {
    words = parseArgs({ options: kOptions, allowPositionals: true });
  } catch (error) {
    throw new UsageError(error.message);
  }
  const { values, positionals } = words;
  if (values.help) return { help: true };
  const [command, file, ...more] = positionals;
  if (!Object.hasOwn(kCommands, command ?? ''))
    throw new UsageError(`found ${command ?? 'nothing'}, expected import or html`);
  if (file === undefined || more.length > 0)
    throw new UsageError(`found ${positionals.length - 1} files, expected one`);
  const name = path.basename(file).replace(/\.\w+$/, '');
  if (command === 'html' && values.root !== undefined)
    throw new UsageError('found --root, which html does not take');
  const { ending } = kCommands[command];
  const { output = `${name}${ending}`, root = path.dirname(file), force } = values;
  return { command, file, output, root, force };
}

async function bytesOf(file) {
  const { size } = await stat(file);
  if (size > kMostFileBytes) throw tooLong(size, kMostFileBytes);
  return readFile(file);
}

// `name` is the map's place within the root, with forward slashes.
async function readMap({ file, root }) {
  const name = path.relative(await realpath(root), await realpath(file));
  if (name.startsWith('..') || path.isAbsolute(name))
    throw new UsageError(`${file} does not lie in ${root}`);
  return readForeign({
    name: name.split(path.sep).join('/'),
    bytes: await bytesOf(file),
    readFile: (one) =>
      bytesOf(path.join(root, one)).catch((error) => {
        throw error.code === 'ENOENT' ? new Error('there is no such file') : error;
      }),
  });
}

// Shipped pictures are copied beside the others, so that the scene's folder is whole.
async function takeShipped(scene, pictures, folder) {
  const named = new Map();
  const moved = (file) => {
    if (typeof file !== 'string' || !isShippedFile(file)) return file;
    const name = `${folder}/${file.slice('../'.length)}`;
    named.set(name, file);
    return name;
  };
  const ofTable = (table) =>
    Object.fromEntries(
      Object.entries(table).map(([name, one]) => [
        name,
        typeof one === 'string' ? moved(one) : { ...one, file: moved(one.file) },
      ]),
    );
  for (const list of ['textures', 'sprites']) if (scene[list]) scene[list] = ofTable(scene[list]);
  for (const map of scene.maps)
    if (map.sky?.panorama) map.sky = { ...map.sky, panorama: moved(map.sky.panorama) };
  for (const [name, file] of named)
    pictures.set(name, await readFile(path.join(kPackage, 'scenes', file)));
}

async function write(files, force) {
  const there = [];
  for (const [name] of files)
    if (await stat(name).catch(() => null)) there.push(path.relative('.', name));
  if (there.length > 0 && !force)
    throw new Error(`${there.slice(0, 5).join(', ')}: already there; --force overwrites files`);
  for (const [name, content] of files) {
    await mkdir(path.dirname(name), { recursive: true });
    await writeFile(name, content, { flag: force ? 'w' : 'wx' });
  }
}

async function importMap(words) {
  const output = path.resolve(words.output);
  if (output === path.resolve(words.file)) throw new UsageError('the scene would replace the map');
  const { scene, pictures, notTaken } = await makeScene(await readMap(words));
  const folder = path.dirname(output);
  const [own = path.basename(output).replace(/\.\w+$/, '/')] = pictures.keys();
  await takeShipped(scene, pictures, own.split('/')[0]);
  const files = [[output, `${JSON.stringify(scene, null, 2)}\n`]];
  for (const [name, bytes] of pictures) files.push([path.join(folder, name), bytes]);
  await write(files, words.force);
  const loaded = await load(output);
  const maps = loaded.world.maps.map(
    ({ name, width, depth, levels }) => `  ${name}: ${width} x ${depth} tiles, levels: ${levels}`,
  );
  loaded.free();
  const lines = [
    `Wrote ${words.output} and ${counted(pictures.size, 'picture')}.`,
    ...maps,
    ...(notTaken.length > 0 ? ['Not taken, or not as it was:'] : []),
    ...notTaken.map(({ place, reason }) => `  ${place}: ${reason}`),
  ];
  process.stdout.write(`${lines.map(printable).join('\n')}\n`);
}

// The scene is loaded first, so that no file is made of one with faults.
async function makeHtml(words) {
  const output = path.resolve(words.output);
  if (output === path.resolve(words.file))
    throw new UsageError('the HTML file would replace the scene');
  const folder = path.dirname(path.resolve(words.file));
  const { text } = textIn(await bytesOf(words.file));
  const home = pathToFileURL(kPackage);
  const readPicture = (file) =>
    readFirst(placesOf(file, pathToFileURL(path.join(folder, file)), home), (place) =>
      bytesOf(fileURLToPath(place)),
    ).catch(() => null);
  const engine = await Engine.create({ files: await readEngine('auto') });
  const source = { name: words.file, readText: () => new TextEncoder().encode(text) };
  const faults = await engine.loadScene({ ...source, readFile: readPicture });
  engine.stop();
  if (faults.length > 0) throw new SceneError('scene', `${words.file} has faults:`, faults);
  knowShipped(JSON.parse(await bytesOf(path.join(kPackage, 'pictures.json'))));
  const player = await readFile(path.join(kPackage, 'edit/player.bin'));
  const deflate = (bytes) => deflateRawSync(bytes, { level: 9 });
  const html = await htmlFile({ player, text, readPicture, deflate });
  await write([[output, html]], words.force);
  const size = Math.ceil(html.length / 1024);
  process.stdout.write(`${printable(`Wrote ${words.output}: ${size} KB.`)}\n`);
}

const kCommands = {
  import: { run: importMap, ending: '-scene.json' },
  html: { run: makeHtml, ending: '.html' },
};

// Names of strangers may hold what a terminal obeys.
function printable(text) {
  return text.replaceAll(/\p{Cc}+/gu, ' ');
}

try {
  const words = readWords();
  if (words.help) process.stdout.write(kUsage);
  else await kCommands[words.command].run(words);
} catch (error) {
  const isUsage = error instanceof UsageError;
  const isTold = isUsage || error instanceof ImportError || error instanceof SceneError;
  const reason = isTold || error.code ? error.message : error.stack;
  const told = error.constructor === Error ? error.message : reason;
  process.stderr.write(`slicecast: ${told.split('\n').map(printable).join('\n')}\n`);
  if (isUsage) process.stderr.write(`\n${kUsage}`);
  process.exitCode = isUsage ? 2 : 1;
}
