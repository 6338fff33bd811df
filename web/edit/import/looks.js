// The textures and sprites of a scene that is made: tiles cut out of their pictures, shipped
// textures and plain colours, each once. Pictures that look alike become one file.
//
//     const looks = startLooks(proposal, base, notes, fault);
//     const texture = looks.texture([kind], null);        // its name in the scene's "textures"
//     const sprite = looks.sprite(kind);                  // in "sprites", or null
//     looks.textures, looks.sprites, looks.pictures        // for the scene; file -> PNG bytes

import { openPictures, pngOf } from './foreign-pictures.js';
import { kLeastTextureSide, kMostSceneTexels, kMostTextureSide } from './import-limits.js';
import { kShippedSprites } from './shipped-sprites.js';
import { uniqueNames } from './titles.js';

const kColour = /^#[0-9a-f]{6}$/i;
const kShipped = /^[a-z][a-z0-9-]*$/;
const kMostColours = 2048; // as in the engine: each is a texture

export function startLooks({ title, kinds, pictures: files }, base, notes, fault) {
  const source = openPictures(files, notes);
  const textures = { ...base?.textures };
  const sprites = { ...base?.sprites };
  const pictures = new Map();
  const byKey = new Map();
  const byBytes = new Map();
  const named = uniqueNames();
  const namedFile = uniqueNames();
  const folder = slugOf(title) || 'map';
  let texels = 0;
  let colours = 0;
  for (const name of [...Object.keys(textures), ...Object.keys(sprites)]) named(name);

  function addFile(table, name, image, more = null) {
    const bytes = pngOf(image);
    const key = `${table === sprites} ${hashOf(bytes)} ${JSON.stringify(more)}`;
    const same = (byBytes.get(key) ?? []).find((one) => isSame(one.bytes, bytes));
    if (same !== undefined) return same.name;
    texels += image.width * image.height;
    if (texels > kMostSceneTexels)
      throw fault('', `${texels} texels in the tiles that are used`, `at most ${kMostSceneTexels}`);
    const unlike = named(name, 'tile');
    const file = `${folder}/${namedFile(slugOf(unlike) || 'tile')}.png`.replaceAll(' ', '-');
    pictures.set(file, bytes);
    table[unlike] = more === null ? file : { file, ...more };
    byBytes.set(key, [...(byBytes.get(key) ?? []), { bytes, name: unlike }]);
    return unlike;
  }

  function addColour(colour) {
    if (Object.hasOwn(textures, colour)) return colour;
    colours += 1;
    if (colours > kMostColours)
      throw fault('', `${colours} plain colours`, `at most ${kMostColours}`);
    textures[colour] = colour;
    return colour;
  }

  // Kinds one over another, the lowest first; `background` fills what they leave see-through.
  function texture(list, background) {
    const key = `${list.join()} ${background}`;
    if (!byKey.has(key)) byKey.set(key, makeTexture(list, background));
    return byKey.get(key);
  }

  function makeTexture(list, background) {
    const all = list.map((number) => kinds[number - 1]);
    const top = all.at(-1);
    if (top.show !== 'picture') return plain(top.show, top.name);
    const parts = all.filter(({ show }) => show === 'picture').flatMap((kind) => kind.parts);
    const longest = parts.reduce((most, part) => Math.max(most, part.width, part.height), 1);
    const side = Math.min(kMostTextureSide, Math.max(kLeastTextureSide, nextPower(longest)));
    if (longest > kMostTextureSide)
      notes.add(`tile "${top.name}"`, `it is made smaller, to ${side} texels a side`);
    if (parts.some(({ width, height }) => width !== height))
      notes.add(`tile "${top.name}"`, 'it is stretched to a square');
    const name = all.map((kind) => kind.name).join(' on ');
    const image = source.draw(parts, side, side, background);
    if (image === null) return addColour(colourFor(top.name));
    if (top.frames.length === 0) return addFile(textures, name, image);
    const below = parts.slice(0, parts.length - top.parts.length);
    const images = top.frames.map((frame) =>
      source.draw([...below, ...frame], side, side, background),
    );
    return addSheet(textures, name, images, image, top.rate);
  }

  // Frames side by side; one that cannot be drawn shows the first picture.
  function addSheet(table, name, images, first, rate) {
    const { width: side, height } = first;
    const width = side * images.length;
    const data = new Uint8Array(4 * width * height);
    images.forEach((image, index) => {
      const texels = (image ?? first).data;
      for (let y = 0; y < height; ++y)
        data.set(texels.subarray(4 * y * side, 4 * (y + 1) * side), 4 * (y * width + index * side));
    });
    return addFile(table, name, { width, height, data }, { frames: images.length, rate });
  }

  // A plain colour, or a shipped texture.
  function plain(show, name) {
    if (kColour.test(show)) return addColour(show.toLowerCase());
    if (!kShipped.test(show))
      throw fault(`tile "${name}"`, `the look ${JSON.stringify(show)}`, 'a texture or a colour');
    textures[show] ??= `../textures/${show}.png`;
    return show;
  }

  // Null if there is no picture to show.
  function sprite(number) {
    const key = `sprite ${number}`;
    if (!byKey.has(key)) byKey.set(key, makeSprite(kinds[number - 1]));
    return byKey.get(key);
  }

  function makeSprite({ name, parts, frames, rate }) {
    const [part] = parts;
    if (part === undefined) return null;
    const [across, down] = part.flip & 4 ? [part.height, part.width] : [part.width, part.height];
    const scale = Math.min(1, kMostTextureSide / Math.max(across, down));
    if (scale < 1) notes.add(`tile "${name}"`, 'it is made smaller, to 1024 texels');
    const sides = [across, down].map((side) => Math.max(1, Math.round(side * scale)));
    const image = source.draw(parts, ...sides, null);
    if (image === null) return null;
    if (frames.length === 0) return addFile(sprites, name, image);
    if (sides[0] !== sides[1]) {
      notes.add(`tile "${name}"`, 'only one picture of its animation is taken: it is no square');
      return addFile(sprites, name, image);
    }
    const images = frames.map((frame) => source.draw(frame, ...sides, null));
    return addSheet(sprites, name, images, image, rate);
  }

  function shippedSprite(name) {
    const file = `../sprites/${name}.png`;
    const { frames, rate } = kShippedSprites[name];
    sprites[name] ??= frames === undefined ? file : { file, frames, rate };
    return name;
  }

  return { texture, plain, sprite, shippedSprite, textures, sprites, pictures };
}

function nextPower(side) {
  return 2 ** Math.ceil(Math.log2(Math.max(1, side)));
}

// The same name always gets the same colour, neither dark nor pale.
function colourFor(name) {
  const hash = hashOf(new TextEncoder().encode(name));
  const channel = (shift) => 80 + ((hash >>> shift) & 127);
  return `#${[0, 7, 14].map((shift) => channel(shift).toString(16).padStart(2, '0')).join('')}`;
}

function hashOf(bytes) {
  return bytes.reduce((hash, byte) => Math.imul(hash ^ byte, 0x01000193) >>> 0, 0x811c9dc5);
}

function isSame(a, b) {
  return a.length === b.length && a.every((byte, index) => byte === b[index]);
}

export function slugOf(name) {
  return name
    .toLowerCase()
    .replaceAll(/[^a-z0-9]+/g, '-')
    .replaceAll(/^-|-$/g, '')
    .slice(0, 60);
}
