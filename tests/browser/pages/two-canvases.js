// Two engines on one page: one canvas in the page itself, one inside a shadow root.

import { fetchEngine } from './engine/engine-files.js';
import { Engine } from './engine/engine.js';
import { sceneAt } from './scene-at.js';

const shadow = document.getElementById('second').attachShadow({ mode: 'open' });
const second = document.createElement('canvas');
second.tabIndex = 0;
shadow.append(second);
const canvases = [document.getElementById('first'), second];

const files = await fetchEngine();
window.engines = await Promise.all(
  canvases.map(async (canvas, index) => {
    const engine = await Engine.create({
      files,
      canvas,
      onEvent(event) {
        if (event === 'ready') engine.isReady = true;
      },
    });
    engine.resize(160 + 40 * index, 100);
    await engine.loadScene(sceneAt(['room', 'other'][index]));
    engine.begin();
    return engine;
  }),
);
