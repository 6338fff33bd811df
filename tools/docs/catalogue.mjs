// The catalogue of the shipped pictures, web/docs/catalogue.md. The pictures and their sizes come
// from the files, usual heights from the shipped scenes, and the words from the page:
//
//     ```pictures joined=both              a list of pictures, one a line; those that stand on top
//     textures/brick.png                   of each other on one line, the upper one first. joined:
//     ```                                  both ways or sideways, to show how copies meet
//
//     ```json opens=lava frames="..."      a snippet that uses sheets. Their frames are shown above
//     ...                                  it, the words say what they are. opens: see pictures.mjs
//     ```
//
//     <!-- other-pictures -->              all pictures that the page does not name
//
// The build fails if the page names a picture that does not exist, or does not say what the frames
// of a sheet are. Sheets are the pictures in assets/sheets, and those that a shipped scene uses
// with frames or views.

import { decode } from 'fast-png';
import { readFileSync, readdirSync } from 'node:fs';

import { usesInScenes } from './picture-uses.mjs';
import { readPngHeader } from './png-header.mjs';

const kPage = 'web/docs/catalogue.md';
const kAssets = 'assets';
const kForReadme = 'pictures'; // the only folder whose pictures are not for scenes
const kCopies = { both: 4, sideways: 2 };
const kSides = ['front', 'right', 'back', 'left']; // the rows of a sprite with views

// Sizes in the page, in its pixels
const kTile = 128; // the side of a texture, if several are shown together
const kAlone = 256; // and of one alone
const kFrame = 160; // the longest side of an enlarged frame
const kLine = 960; // what is wider may be made smaller

export class Catalogue {
  #assets;
  #pictures = new Map(); // by name, 'textures/brick.png': {name, width, height, hasAlpha}
  #uses; // by the shipped scenes: see picture-uses.mjs
  #shown = new Set();

  constructor(assets = kAssets) {
    this.#assets = assets;
    for (const name of shippedPictures(assets)) {
      const file = `${assets}/${name}`;
      this.#pictures.set(name, { name, ...readPngHeader(readFileSync(file), file) });
    }
    this.#uses = usesInScenes(`${assets}/scenes`);
  }

  // The HTML of a list of pictures.
  list({ joined }, text) {
    if (joined !== undefined && !Object.hasOwn(kCopies, joined))
      fail(`joined=${joined}`, 'both or sideways');
    const lines = text.trim().split('\n');
    return cards(lines.map((line) => this.#card(line.trim().split(/\s+/), joined)));
  }

  // The HTML of the frames of each sheet in `part`, a part of a scene.
  sheets(words, part) {
    const all = Object.values({ ...part.textures, ...part.sprites });
    const sheets = all.filter(({ frames, views }) => frames ?? views);
    if (sheets.length === 0) fail(`frames="${words}"`, 'a picture with "frames" or "views" below');
    if (typeof words !== 'string' || words.trim() === '')
      fail(`no words about ${sheets[0].file}`, 'frames="what they are"');
    return `<div class="sheets">\n${sheets.map((sheet) => this.#sheet(sheet)).join('\n')}\n</div>\n`;
  }

  // The HTML of all pictures that the page does not name, with a heading; or nothing.
  others() {
    const names = [...this.#pictures.keys()].filter((name) => !this.#shown.has(name));
    const sheet = names.find((name) => this.#isSheet(name));
    if (sheet)
      fail(`nothing about the sheet ${sheet}`, 'a block ```json opens=NAME frames="what they are"');
    if (names.length === 0) return '';
    const figures = names.map((name) =>
      this.#card([name], isTile(this.#pictures.get(name)) ? 'both' : undefined),
    );
    return `<h2 id="others">Others</h2>\n${cards(figures)}`;
  }

  #isSheet(name) {
    const uses = this.#uses.get(name)?.named ?? [];
    return name.startsWith('sheets/') || uses.some(({ frames, views }) => frames * views > 1);
  }

  #show(name) {
    const picture = this.#pictures.get(name);
    if (!picture) fail(name, `a picture in ${this.#assets}`);
    if (this.#shown.has(name)) fail(`${name} twice`, 'each picture once');
    this.#shown.add(name);
    return picture;
  }

  #card(names, joined) {
    const sheet = names.find((name) => this.#isSheet(name));
    if (sheet)
      fail(`the sheet ${sheet} in a list`, 'a block ```json opens=NAME frames="what they are"');
    const pictures = names.map((name) => this.#show(name));
    const copies = kCopies[joined] ?? 1;
    const images = pictures.flatMap((picture) => {
      const scale = isTile(picture)
        ? (copies * pictures.length > 1 ? kTile : kAlone) / picture.width
        : spriteScale(picture);
      return Array.from({ length: copies }, (_, index) => image(picture, scale, index === 0));
    });
    const kind = [
      'shown',
      ...(joined === undefined ? [] : ['joined']),
      ...(pictures.some(({ hasAlpha }) => hasAlpha) ? ['see-through'] : []),
      ...(pictures.some(isTile) ? [] : pictures.some(isPanorama) ? ['panorama'] : ['standing']),
    ].join(' ');
    const captions = pictures.map((picture) => this.#path(picture, size(picture)));
    return `<figure><div class="${kind}">${images.join('')}</div><figcaption>${captions.join('')}</figcaption></figure>`;
  }

  #sheet({ file, frames = 1, views = 1 }) {
    const name = file.replace(/^\.\.\//, '');
    const picture = this.#show(name);
    for (const use of this.#uses.get(name)?.named ?? [])
      if (use.frames !== frames || use.views !== views)
        fail(
          `${frames} frames, ${views} views of ${name}`,
          `${use.frames}, ${use.views} as in ${use.scene}`,
        );
    const frame = { width: picture.width / frames, height: picture.height / views };
    const scale = Math.max(1, Math.floor(kFrame / Math.max(frame.width, frame.height)));
    const numbers = Array.from({ length: frames }, (_, index) => index + 1);
    const counts = [views > 1 ? `${views} sides` : '', frames > 1 ? `${frames} frames` : ''];
    const count = counts.filter((each) => each !== '').join(' × ');
    return `<figure class="sheet"><div class="strip" tabindex="0" role="group" aria-label="${titleOf(name)}"><div class="frames${picture.hasAlpha ? ' see-through' : ''}">${image(picture, scale, true)}${marks('numbers', numbers)}${marks('sides', views > 1 ? kSides : [])}</div></div><figcaption>${this.#path(picture, `${count} of ${size(frame)}`)}</figcaption></figure>`;
  }

  // The page is as deep in its folder as the shipped scenes are, so that both name files alike.
  #path(picture, start) {
    const facts = [start];
    const heights = this.#uses.get(picture.name)?.heights ?? [];
    if (heights.length > 0)
      facts.push(`height ${[...new Set([heights[0], heights.at(-1)])].join(' to ')}`);
    if (isPanorama(picture))
      facts.push(`horizon <code>${horizon(`${this.#assets}/${picture.name}`)}</code>`);
    return `<p class="path"><code>../${picture.name.replace('/', '/<wbr>')}</code> <span>${facts.join(', ')}</span></p>`;
  }
}

// The names of all pictures for scenes.
export function shippedPictures(assets = kAssets) {
  return readdirSync(assets, { withFileTypes: true })
    .filter((entry) => entry.isDirectory() && entry.name !== kForReadme)
    .flatMap(({ name }) => readdirSync(`${assets}/${name}`).map((file) => `${name}/${file}`))
    .filter((name) => name.endsWith('.png'))
    .sort();
}

function isPanorama({ name, width, height }) {
  return name.startsWith('textures/') && width > height;
}

function isTile({ name, width, height }) {
  return !name.startsWith('sprites/') && width === height;
}

function spriteScale({ width, height }) {
  return Math.max(1, Math.min(2, Math.floor(kAlone / Math.max(width, height))));
}

// The colour of the lowest row.
function horizon(file) {
  const { width, height, channels, data, palette } = decode(readFileSync(file));
  const at = width * (height - 1) * channels;
  const colour = palette ? palette[data[at]] : [...data.subarray(at, at + 3)];
  return `#${Buffer.from(colour.slice(0, 3)).toString('hex')}`;
}

function fail(found, expected) {
  throw new Error(`${kPage}: found ${found}, expected ${expected}.`);
}

// ---- HTML

function cards(figures) {
  return `<div class="gallery">\n${figures.join('\n')}\n</div>\n`;
}

function image({ name, width, height }, scale, isFirst) {
  const kind = scale < 1 || width * scale > kLine ? ' class="smooth"' : '';
  return `<img${kind} src="../${name}" alt="${isFirst ? titleOf(name) : ''}" width="${width * scale}" height="${height * scale}" loading="lazy">`;
}

function marks(kind, titles) {
  return titles.length < 2
    ? ''
    : `<ol class="${kind}">${titles.map((title) => `<li>${title}</li>`).join('')}</ol>`;
}

function size({ width, height }) {
  return `${width} × ${height}`;
}

function titleOf(name) {
  return name.replace(/^.*\/|\.png$/g, '').replaceAll('-', ' ');
}
