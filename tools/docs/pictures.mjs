// The pictures of the documentation. A fence ```json picture=glass alt="A pane"``` holds a part of
// a scene. Merged over web/docs/scenes/base.json and, if it exists, glass.json there, it is a whole
// scene. The engine draws it from its start when the pages are built, and readers can open it. So
// every snippet is known to load.
//
// A snippet in braces is a whole scene by itself.
//
//     picture=NAME      docs/scenes/NAME.json and NAME.png in the built page
//     alt="..."         what the picture shows, for readers who cannot see it
//     in=map            the snippet belongs into the scene's first map
//     view=x,y,...      the view, as in the element's attribute; the default is kView, or the start
//                       of a whole scene
//     seconds=2.5       the time in the world at which to draw the picture
//     live              a playable element instead of a picture
//
// A fence ```json opens=NAME``` is loaded and can be opened as well, but is not drawn. With
// under=OTHER it is merged over OTHER.json.

import { encode } from 'fast-png';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const kSize = { width: 640, height: 360 };
const kView = '3.4,8.9,1.9,293,-0.1';
const kStepsPerSecond = 120;

export class Pictures {
  #folder; // of the built page
  #all = new Map(); // name -> {scene, view, seconds, isDrawn}

  constructor(folder) {
    this.#folder = folder;
  }

  // Registers a snippet, and returns the HTML of its picture.
  add(
    { picture: name, alt, in: place, view: ownView, seconds = 0, live = false },
    snippet,
    escapeHtml,
  ) {
    if (alt === undefined) throw new Error(`web/docs: the picture ${name} has no alt="...".`);
    const { view, address } = this.#add(name, snippet, { place, ownView, seconds, isDrawn: true });
    const from = view === null ? '' : ` view="${view}"`;
    const words = escapeHtml(alt);
    const image = (loading) =>
      `<img src="scenes/${name}.png" alt="${words}" width="${kSize.width}" height="${kSize.height}"${loading}>`;
    return live
      ? `<ray-caster scene="scenes/${name}.json" poster="scenes/${name}.png"${from} controls label="${words}">${image('')}</ray-caster>\n`
      : `<a class="open" href="${address}">${image(' loading="lazy"')}<span>Open</span></a>\n`;
  }

  // Registers a snippet that is not drawn: {part, link}, what it says and the HTML of a link to it.
  addUnseen({ opens: name, under, in: place, view: ownView }, snippet) {
    const { part, address } = this.#add(name, snippet, { place, ownView, under, isDrawn: false });
    return { part, link: `<a href="${address}">Open it in the player.</a>` };
  }

  // Returns {part, view, address}: what the snippet says, and where in the player it can be seen.
  #add(name, snippet, { place, ownView, seconds = 0, under = name, isDrawn }) {
    if (this.#all.has(name)) throw new Error(`web/docs: two pictures are named ${name}.`);
    const part = parsePart(snippet, name);
    const isWhole = snippet.startsWith('{');
    const below = isWhole ? [] : [partOf('base'), partOf(under)];
    const layers = [...below, place === 'map' ? { maps: [part] } : part];
    const scene = layers.reduce((lower, upper) => laidOver(lower, upper));
    const view = ownView ?? (isWhole ? null : kView);
    this.#all.set(name, { scene: movedDown(scene), view, seconds: Number(seconds), isDrawn });
    const fromHere = view === null ? '' : `&amp;view=fly,${view}`;
    return { part, view, address: `../index.html?scene=docs/scenes/${name}.json${fromHere}` };
  }

  async draw() {
    const { load } = await import(pathToFileURL(path.join(this.#folder, 'node/index.js')));
    const scenes = path.join(this.#folder, 'docs/scenes');
    mkdirSync(scenes, { recursive: true });
    for (const [name, { scene, view, seconds, isDrawn }] of this.#all) {
      const file = path.join(scenes, `${name}.json`);
      writeFileSync(file, `${JSON.stringify(scene, null, 2)}\n`);
      const running = await load(file);
      if (running.warnings.length > 0)
        throw new Error(`web/docs, picture ${name}: ${JSON.stringify(running.warnings, null, 2)}`);
      if (view !== null && !running.look(view))
        throw new Error(`web/docs, picture ${name}: no eye can be at ${view}.`);
      if (seconds > 0) running.step(Math.round(seconds * kStepsPerSecond));
      if (isDrawn) {
        const png = encode(withoutAlpha(running.pixels(kSize)), { zlib: { level: 9 } });
        writeFileSync(path.join(scenes, `${name}.png`), png);
      }
      running.free();
    }
  }
}

function partOf(name) {
  const file = `web/docs/scenes/${name}.json`;
  return existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
}

// Snippets omit the outer braces.
function parsePart(snippet, name) {
  try {
    const text = snippet.trim();
    return JSON.parse(text.startsWith('{') ? text : `{${text}}`);
  } catch (error) {
    throw new Error(`web/docs, picture ${name}: ${error.message}`);
  }
}

// Merges objects key by key, and maps one by one. Everything else is replaced; so is a sky, because
// it has one form or another.
function laidOver(under, over, key) {
  const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);
  if (key === 'maps' && Array.isArray(under) && Array.isArray(over))
    return [
      ...over.map((map, index) => laidOver(under[index] ?? {}, map)),
      ...under.slice(over.length),
    ];
  if (!isObject(under) || !isObject(over) || key === 'sky') return over;
  const names = new Set([...Object.keys(under), ...Object.keys(over)]);
  return Object.fromEntries(
    [...names].map((name) => [
      name,
      !Object.hasOwn(over, name)
        ? under[name]
        : Object.hasOwn(under, name)
          ? laidOver(under[name], over[name], name)
          : over[name],
    ]),
  );
}

// Snippets name pictures as scenes in assets/scenes do, but are one folder further down.
function movedDown(scene) {
  return JSON.parse(JSON.stringify(scene).replaceAll('"../', '"../../'));
}

function withoutAlpha({ width, height, data }) {
  const colours = new Uint8Array(width * height * 3);
  for (let pixel = 0; pixel < width * height; pixel++)
    colours.set(data.subarray(4 * pixel, 4 * pixel + 3), 3 * pixel);
  return { width, height, data: colours, channels: 3, depth: 8 };
}
