// Draws the posters of the lessons into web/examples/posters: the first picture of each <ray-caster
// poster="...">, for readers whose browser cannot run the engine. Run it after tools/page when a
// lesson's scene or view has changed; it uses the engine of build/web.
//
//   node tools/lesson-posters.mjs

import { encode } from 'fast-png';
import { mkdir, readFile, readdir, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';

const kSize = { width: 480, height: 300 };

const root = path.resolve(fileURLToPath(import.meta.url), '../..');
const { load } = await import(new URL('../build/web/node/index.js', import.meta.url));
const { parseOptions } = await import(new URL('../web/engine/address.js', import.meta.url));

// Finds the elements of a page: {attributes, inline}. It handles only the markup that the lessons
// use.
function* elementsOf(html) {
  for (const [, attributes, content] of html.matchAll(
    /<ray-caster\s([^>]*)>([\s\S]*?)<\/ray-caster>/g,
  )) {
    const found = Object.fromEntries(
      [...attributes.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, name, value]) => [name, value]),
    );
    yield {
      attributes: found,
      inline: /<script type="application\/json">([\s\S]*?)<\/script>/.exec(content)?.[1] ?? null,
    };
  }
}

const lessons = path.join(root, 'build/web/examples');
const posters = path.join(root, 'web/examples');
for (const name of (await readdir(lessons)).filter((file) => file.endsWith('.html'))) {
  for (const { attributes, inline } of elementsOf(
    await readFile(path.join(lessons, name), 'utf8'),
  )) {
    if (attributes.poster === undefined) continue;
    const scene = await load(
      inline === null ? path.join(lessons, attributes.scene) : JSON.parse(inline),
    );
    for (const [option, value] of parseOptions(attributes.options ?? '')) scene.set(option, value);
    if (attributes.view !== undefined && !scene.look(attributes.view))
      throw new Error(`${name}: there is no view ${attributes.view} in its scene.`);
    const file = path.join(posters, attributes.poster);
    await mkdir(path.dirname(file), { recursive: true });
    await writeFile(
      file,
      encode({ ...scene.pixels(kSize), channels: 4, depth: 8 }, { zlib: { level: 9 } }),
    );
    scene.free();
  }
}
