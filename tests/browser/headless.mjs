// The engine of the page, loaded by Node: no page, no canvas, no SDL.

import { createHash } from 'node:crypto';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';

const kEngine = new URL('../../build/web/engine/', import.meta.url);

async function createModule(name) {
  // The glue of older Emscriptens is written for scripts, not for modules.
  globalThis.require ??= createRequire(import.meta.url);
  globalThis.__dirname ??= fileURLToPath(kEngine);
  const { default: create } = await import(new URL(`${name}.js`, kEngine).href);
  return create({ wasmBinary: await readFile(new URL(`${name}.wasm`, kEngine)) });
}

// The picture of a scene from its start, hashed like pictureHash of browser.mjs does. `files` are those of a server: the scene is in scenes/.
export async function hashHeadless(sceneName, files, width, height) {
  const module = await createModule('slicecast-scalar');
  const put = (content) => {
    const bytes = Buffer.from(content);
    const at = module._malloc(bytes.length + 1);
    module.HEAPU8.set(bytes, at);
    module.HEAPU8[at + bytes.length] = 0;
    return [at, bytes.length];
  };
  const answer = (at) => JSON.parse(module.UTF8ToString(at));

  const session = module._slicecast_create();
  const parsed = answer(module._slicecast_parse(session, ...put(files[`scenes/${sceneName}`]), put(sceneName)[0]));
  for (const name of parsed.files) module._slicecast_supply(session, put(name)[0], ...put(files[`scenes/${name}`]));
  const { faults } = answer(module._slicecast_start(session));
  if (faults.length > 0) throw new Error(faults[0].message);
  if (module._slicecast_draw(session, width, height, 1) !== 1) throw new Error('The engine draws nothing.');
  const at = module._slicecast_picture(session);
  const hash = createHash('sha256').update(module.HEAPU8.subarray(at, at + width * height * 4)).digest('hex');
  return `${width}x${height} ${hash}`;
}
