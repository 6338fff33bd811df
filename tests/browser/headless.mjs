// The engine of the page under Node: no page, no canvas, no SDL.

import { createHash } from 'node:crypto';

import { load } from '../../build/web/node/index.js';
import { serve } from './static-server.mjs';

// The picture of a scene from its start, hashed like pictureHash of browser.mjs does. `files` are
// those of a server: the scene is in scenes/.
export async function hashHeadless(sceneName, files, width, height) {
  const server = await serve({ files });
  try {
    const scene = await load(`${server.address}scenes/${sceneName}`, { engine: 'scalar' });
    const hash = createHash('sha256').update(scene.pixels({ width, height }).data).digest('hex');
    scene.free();
    return `${width}x${height} ${hash}`;
  } finally {
    await server.close();
  }
}
