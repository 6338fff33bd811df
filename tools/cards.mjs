// Gives each page of a built site what a link to it shows elsewhere: title, description and a
// picture, as Open Graph and Twitter cards.
//
//     node tools/cards.mjs FOLDER [ADDRESS]
//       // FOLDER/card.png, and <meta> tags in every FOLDER/**/*.html that has a title
//
// ADDRESS is where the folder will be, as https://host.example/slicecast/. Most services follow only
// full addresses of pictures; without ADDRESS, which tools/page does not know, they are relative to
// the page. A page shows its own first picture if that is large enough, else a view of the first
// scene. It can be called again, with another address.

import { encode } from 'fast-png';
import { readFile, readdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';

const kCard = 'card.png';
const kSize = { width: 1200, height: 630 }; // pixels; what the services recommend
const kLeastWidth = 480; // pixels; smaller pictures stand beside the text, or nowhere

const [argument, address] = process.argv.slice(2);
if (argument === undefined)
  throw new Error('tools/cards.mjs: found no folder, expected that of a built page');
if (address !== undefined && !/^https?:\/\/.*\/$/.test(address))
  throw new Error(
    `tools/cards.mjs: found the address '${address}', expected one like https://host.example/slicecast/`,
  );
const folder = path.resolve(argument);

const { load } = await import(pathToFileURL(path.join(folder, 'node/index.js')));
const [first] = JSON.parse(await readFile(path.join(folder, 'scenes/index.json'), 'utf8'));
const scene = await load(path.join(folder, 'scenes', first.file));
await writeFile(
  path.join(folder, kCard),
  encode({ ...scene.pixels(kSize), channels: 4, depth: 8 }),
);
scene.free();

for (const file of await readdir(folder, { recursive: true })) {
  // The player is no page yet: it becomes the file of a world.
  if (!file.endsWith('.html') || file.split(path.sep).join('/').includes('edit/player/')) continue;
  const place = path.join(folder, file);
  const page = await readFile(place, 'utf8');
  const carded = withCard(page, file.split(path.sep).join('/'));
  if (carded !== page) await writeFile(place, carded);
}

// `file` is the page's path in the folder.
function withCard(page, file) {
  const title = /<title>([^<]*)<\/title>\n/.exec(page);
  if (title === null || /http-equiv="refresh"/.test(page)) return page;
  const description = /<meta name="description" content="([^"]*)">/.exec(page)?.[1];
  const picture = ownPicture(page, title[1]) ?? {
    address: upFrom(file) + kCard,
    ...kSize,
    alt: escaped(first.about),
  };
  const full = (relative) =>
    address === undefined ? relative : new URL(relative, new URL(file, address)).href;
  const tags = [
    ['property', 'og:type', 'website'],
    ['property', 'og:site_name', 'Slicecast'],
    ['property', 'og:title', title[1].replaceAll('"', '&quot;')],
    ['property', 'og:description', description],
    [
      'property',
      'og:url',
      address === undefined ? undefined : full('').replace(/index\.html$/, ''),
    ],
    ['property', 'og:image', full(picture.address)],
    ['property', 'og:image:width', picture.width],
    ['property', 'og:image:height', picture.height],
    ['property', 'og:image:alt', picture.alt],
    ['name', 'twitter:card', 'summary_large_image'],
  ]
    .filter(([, , content]) => content !== undefined)
    .map(([kind, name, content]) => `<meta ${kind}="${name}" content="${content}">\n`);
  return page
    .replace(/<meta (property="og|name="twitter):[^>]*>\n/g, '')
    .replace(title[0], () => title[0] + tags.join(''));
}

// The first picture of the page that is large enough. Its text may be short beside the page's.
function ownPicture(page, title) {
  for (const [tag] of page.matchAll(/<img [^>]*>/g)) {
    const of = (name) => new RegExp(` ${name}="([^"]*)"`).exec(tag)?.[1];
    if (/^[^:]*\.png$/.test(of('src') ?? '') && Number(of('width')) >= kLeastWidth)
      return {
        address: of('src'),
        width: of('width'),
        height: of('height'),
        alt: `${title}: ${of('alt')}`,
      };
  }
  return null;
}

function escaped(text) {
  return text.replaceAll('&', '&amp;').replaceAll('"', '&quot;');
}

function upFrom(file) {
  return '../'.repeat(file.split('/').length - 1);
}
