// One engine in a page from start to stop: its events, what it schedules, and what is
// left of it.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, openPage } from './browser.mjs';
import { roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kSceneAt = readFileSync(new URL('pages/scene-at.js', import.meta.url));
const kPage =
  '<!doctype html><html lang="en"><title>An engine</title><link rel="icon" href="favicon.svg"><body></body></html>';

// The room, and a tile before its eastern wall that leads into a cellar like it.
function doubleRoom() {
  const scene = roomScene();
  const portals = [{ x: 5, y: 3, to: { map: 'cellar', x: 1, y: 3 } }];
  return JSON.stringify({
    ...scene,
    maps: [
      { ...scene.maps[0], portals },
      { ...scene.maps[0], name: 'cellar' },
    ],
    start: { ...scene.start, map: 'room' },
  });
}

// Records what the page schedules and listens to, before anything runs.
function watch() {
  window.scheduled = 0;
  for (const name of [
    'requestAnimationFrame',
    'setTimeout',
    'setInterval',
    'requestIdleCallback',
    'setImmediate',
    'queueMicrotask',
  ]) {
    const original = window[name];
    if (original === undefined) continue;
    window[name] = (...parameters) => {
      ++window.scheduled;
      return original.apply(window, parameters);
    };
  }
  const keyOf = (target, type, listener, options) => {
    const capture = typeof options === 'boolean' ? options : (options?.capture ?? false);
    return [target, type, listener, capture];
  };
  const known = [];
  const same = (a, b) => a.every((part, index) => part === b[index]);
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  EventTarget.prototype.addEventListener = function add(type, listener, options) {
    const key = keyOf(this ?? window, type, listener, options);
    if (listener && !known.some((other) => same(other, key))) known.push(key);
    if (options?.signal)
      addEventListener.call(options.signal, 'abort', () =>
        this.removeEventListener(type, listener, options),
      );
    return addEventListener.call(this, type, listener, options);
  };
  EventTarget.prototype.removeEventListener = function remove(type, listener, options) {
    const key = keyOf(this ?? window, type, listener, options);
    const at = known.findIndex((other) => same(other, key));
    if (at >= 0) known.splice(at, 1);
    return removeEventListener.call(this, type, listener, options);
  };
  window.listening = () => known.map(([target, type]) => `${target.constructor.name} ${type}`);

  // An engine in a room, and all its events.
  window.startEngine = async ({ paused = true, scene = 'room' } = {}) => {
    const [{ fetchEngine }, { Engine }, { Questions }, { sceneAt }] = await Promise.all(
      [
        './engine/engine-files.js',
        './engine/engine.js',
        './engine/questions.js',
        './scene-at.js',
      ].map((name) => import(name)),
    );
    window.files ??= { ...(await fetchEngine()), Questions };
    const canvas = document.body.appendChild(document.createElement('canvas'));
    const told = [];
    const engine = await Engine.create({
      files: window.files,
      canvas,
      // Of 'animation', which tells how long each frame took, pace.test.mjs speaks.
      onEvent: (event, value) => event === 'animation' || told.push([event, value]),
    });
    engine.resize(160, 100);
    engine.paused = paused;
    await engine.loadScene(sceneAt(scene));
    engine.begin();
    while (!told.some(([event]) => event === 'ready'))
      await new Promise((resolve) => {
        requestAnimationFrame(resolve);
      });
    return { engine, canvas, told };
  };
}

async function openEngine(t, options) {
  const { page } = await openPage(t, browser, {
    query: 'engine.html',
    server: {
      files: { 'engine.html': kPage, 'scene-at.js': kSceneAt, 'scenes/double.json': doubleRoom() },
    },
    prepare: (newPage) => newPage.addInitScript(watch),
  });
  await page.evaluate(async (wanted) => {
    Object.assign(window, await window.startEngine(wanted));
  }, options);
  return page;
}

const rest = (page, milliseconds = 150) => page.waitForTimeout(milliseconds);

// How many frames the engine has requested and shown meanwhile.
async function during(page, act) {
  await page.evaluate(() => {
    window.scheduled = 0;
    window.told.length = 0;
  });
  await page.evaluate(act);
  await rest(page);
  return page.evaluate(() => [
    window.scheduled,
    window.told.filter(([event]) => event === 'frame').length,
  ]);
}

test('a paused engine schedules nothing, and one frame for each change', async (t) => {
  const page = await openEngine(t);
  await rest(page);
  assert.deepEqual(await during(page, () => {}), [0, 0]);
  assert.deepEqual(await during(page, () => window.engine.setOption('fov', 75)), [1, 1]);
  assert.deepEqual(await during(page, () => window.engine.resize(100, 80)), [1, 1]);
  assert.deepEqual(await during(page, () => window.engine.look({ heading: 45 })), [1, 1]);
  assert.deepEqual(await during(page, () => window.engine.step({ forward: 1 }, 100)), [1, 1]);
  assert.deepEqual(await during(page, () => window.engine.reset()), [1, 1]);
  assert.deepEqual(
    await during(page, () => {
      window.engine.drawOnce(50, 50);
      window.engine.questions.hits(50, 50, 25);
    }),
    [0, 0],
  );
  const [asked, shown] = await during(page, () => {
    window.engine.paused = false;
  });
  assert.ok(asked > 3 && shown > 3, `${shown} pictures of ${asked} frames while it plays`);
  await page.evaluate(() => {
    window.engine.paused = true;
  });
  await rest(page);
  assert.deepEqual(await during(page, () => {}), [0, 0]);
});

test('a step is exactly 1/120 s; view, picture and events agree', async (t) => {
  const page = await openEngine(t);
  await rest(page);
  const start = await page.evaluate(() => window.engine.view);
  assert.deepEqual(start, { map: 'room', x: 3.5, y: 3.5, z: start.z, heading: 0, look: 0 });
  assert.ok(start.z > 0.3 && start.z < 1);

  await page.evaluate(() => {
    window.told.length = 0;
    window.engine.step({ forward: 1 }, 60);
  });
  await rest(page);
  assert.equal(await page.evaluate(() => window.engine.state.steps), 60);
  const view = await page.evaluate(() => window.engine.view);
  assert.ok(view.x > 4 && view.x < 5.5 && view.y === 3.5, JSON.stringify(view));
  assert.deepEqual(await page.evaluate(() => window.told.map(([event]) => event)), [
    'view',
    'frame',
  ]);
  const isSame = () =>
    page.evaluate(() => {
      const { data } = window.canvas.getContext('2d').getImageData(0, 0, 160, 100);
      return window.engine.drawOnce(160, 100).data.every((byte, index) => byte === data[index]);
    });
  assert.ok(await isSame(), 'the canvas shows the view after the last step');

  await page.evaluate(() => {
    window.told.length = 0;
    window.engine.setOption('light', 'off');
  });
  await rest(page);
  assert.deepEqual(
    await page.evaluate(() => window.told.map(([event]) => event)),
    ['frame'],
    'nobody has moved',
  );

  assert.equal(
    await page.evaluate(() => window.engine.look({ x: 2.25, y: 2.5, heading: 90, look: 0.25 })),
    true,
  );
  assert.deepEqual(await page.evaluate(() => [window.engine.view, window.engine.state.flying]), [
    { map: 'room', x: 2.25, y: 2.5, z: view.z, heading: 90, look: 0.25 },
    false,
  ]);
  assert.equal(await page.evaluate(() => window.engine.look({ map: 'nowhere' })), false);
  assert.equal(await page.evaluate(() => window.engine.look({ z: -1 })), false);
  assert.match(
    await page.evaluate(() => {
      try {
        return window.engine.step({ forwards: 1 });
      } catch (error) {
        return error.message;
      }
    }),
    /found "forwards", expected forward, strafe/,
  );
  assert.match(
    await page.evaluate(() => {
      try {
        return window.engine.step({ turn: 2 });
      } catch (error) {
        return error.message;
      }
    }),
    /found turn 2, expected a number from -1 to 1/,
  );

  const options = await page.evaluate(() => window.engine.options);
  const method = options.find(({ name }) => name === 'method');
  assert.ok(
    method.choices.length >= 2 && method.choices.includes(method.value),
    JSON.stringify(method),
  );
  assert.ok((await page.evaluate(() => window.engine.memoryBytes)) >= 1024 * 1024);
});

test("the engine's clock works however long a page is open", async (t) => {
  const { page } = await openPage(t, browser, {
    query: 'engine.html',
    server: { files: { 'engine.html': kPage, 'scene-at.js': kSceneAt } },
    prepare: async (newPage) => {
      await newPage.addInitScript(watch);
      await newPage.addInitScript(() => {
        // A page that was opened three hours ago, as it says itself
        const now = performance.now.bind(performance);
        const later = 3 * 3600 * 1000;
        performance.now = () => now() + later;
        const ask = window.requestAnimationFrame.bind(window);
        window.requestAnimationFrame = (act) => ask((time) => act(time + later));
      });
    },
  });
  const rates = await page.evaluate(async () => {
    const { engine, told } = await window.startEngine({ paused: false });
    engine.resize(640, 400);
    const frames = () => told.filter(([event]) => event === 'frames').map(([, value]) => value);
    while (frames().length < 3)
      await new Promise((resolve) => {
        setTimeout(resolve, 50);
      });
    engine.stop();
    return frames();
  });
  for (const { framesPerSecond, drawMilliseconds, longestMilliseconds } of rates) {
    assert.ok(framesPerSecond > 1 && framesPerSecond < 300, `${framesPerSecond} frames per second`);
    assert.ok(drawMilliseconds > 0.01 && drawMilliseconds < 1000, `${drawMilliseconds} ms`);
    assert.ok(longestMilliseconds > 0 && longestMilliseconds < 10000, `${longestMilliseconds} ms`);
  }
});

test('going through a portal is reported with the names of both maps', async (t) => {
  const page = await openEngine(t, { scene: 'double' });
  assert.equal(await page.evaluate(() => window.engine.view.map), 'room');
  await page.evaluate(() => {
    window.told.length = 0;
    window.engine.step({ forward: 1 }, 120);
  });
  await rest(page);
  assert.deepEqual(await page.evaluate(() => window.told), [
    ['portal', { from: 'room', to: 'cellar' }],
    ['view', true],
    ['frame', true],
  ]);
  assert.equal(await page.evaluate(() => window.engine.view.map), 'cellar');
  await page.evaluate(() => {
    window.told.length = 0;
    window.engine.look({ map: 'room' });
    window.engine.reset();
  });
  await rest(page);
  assert.equal(
    await page.evaluate(() => window.told.some(([event]) => event === 'portal')),
    false,
    'nobody has gone through one',
  );
  assert.equal(
    await page.evaluate(
      () => window.engine.look({ map: 'cellar', x: 2.5, y: 2.5 }) && window.engine.view.map,
    ),
    'cellar',
  );
  assert.equal(
    await page.evaluate(() => window.engine.questions.traceFrame(40, 30).columns.nearest.length),
    40,
  );
  assert.equal(await page.evaluate(() => window.engine.questions.trace(40, 30, 20).map), 'cellar');
});

test('a stopped engine leaves nothing behind', async (t) => {
  const page = await openEngine(t, { paused: false });
  const {
    before: begun,
    left,
    scheduled,
  } = await page.evaluate(async () => {
    const before = window.listening();
    window.engine.stop();
    const left = window.listening();
    await new Promise((resolve) => {
      setTimeout(resolve, 100);
    });
    window.scheduled = 0;
    await new Promise((resolve) => {
      setTimeout(resolve, 200);
    });
    return { before, left, scheduled: window.scheduled };
  });
  assert.ok(
    begun.some((name) => name === 'HTMLCanvasElement keydown') &&
      begun.some((name) => name === 'HTMLDocument visibilitychange'),
    begun.join('; '),
  );
  assert.deepEqual(left, []);
  assert.equal(scheduled, 1, 'the wait itself');
  await assert.rejects(
    page.evaluate(() => window.engine.state),
    /has been stopped/,
  );
  await page.evaluate(() => window.engine.stop());
});

test("a stopped engine's memory is freed, though the page holds the engine", async (t) => {
  const page = await openEngine(t);
  await page.evaluate(async () => {
    window.held = [window.engine];
    window.kept = [];
    const instantiate = WebAssembly.instantiate;
    WebAssembly.instantiate = async (...parameters) => {
      const instance = await instantiate.apply(WebAssembly, parameters);
      const memory = Object.values(instance.exports).find(
        (value) => value instanceof WebAssembly.Memory,
      );
      // The program's later part uses that of the first one
      if (memory !== undefined) window.kept.push(new WeakRef(memory));
      return instance;
    };
    for (let i = 0; i < 3; ++i) {
      const { engine, canvas } = await window.startEngine();
      window.held.push(engine);
      engine.stop();
      canvas.remove();
    }
  });
  const session = await page.context().newCDPSession(page);
  let alive;
  for (let tries = 0; tries < 10 && alive !== 0; ++tries) {
    await session.send('HeapProfiler.collectGarbage');
    alive = await page.evaluate(
      () => window.kept.filter((reference) => reference.deref() !== undefined).length,
    );
  }
  assert.equal(await page.evaluate(() => window.kept.length), 3);
  assert.equal(alive, 0);
});
