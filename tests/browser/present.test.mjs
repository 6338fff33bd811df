// Putting a picture on the canvas takes no longer than one putImageData of a view of the engine's
// memory.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch, openScene } from './browser.mjs';

const kFrames = 60;
const kSlack = 1.3; // ratio of the medians; an extra copy of the picture would double them

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Records for each picture what is passed to the canvas, and how long that took since the picture
// was drawn. It was drawn when the program last read the clock.
function watch() {
  window.shown = [];
  let drawn = 0;
  const now = performance.now.bind(performance);
  performance.now = () => (drawn = now());
  const { prototype } = CanvasRenderingContext2D;
  const { putImageData } = prototype;
  prototype.putImageData = function put(image, ...place) {
    putImageData.call(this, image, ...place);
    window.shown.push({ image, place, milliseconds: now() - drawn });
  };
  for (const name of ['drawImage', 'createImageData', 'getImageData']) {
    const original = prototype[name];
    prototype[name] = function call(...parameters) {
      window.shown.push({ call: name });
      return original.apply(this, parameters);
    };
  }
  // The bytes of a picture put on a canvas of the same size: the minimum cost of
  // presenting.
  window.putAgain = ({ image, place }, context) => {
    const view = new ImageData(
      new Uint8ClampedArray(image.data.buffer, image.data.byteOffset, image.data.length),
      image.width,
      image.height,
    );
    const begin = now();
    putImageData.call(context, view, ...place);
    return now() - begin;
  };
}

test('a picture is put on the canvas directly from memory, without extra time', async (t) => {
  const { page } = await openScene(t, browser, {
    viewport: { width: 1280, height: 720 },
    prepare: (newPage) => newPage.addInitScript(watch),
  });
  const result = await page.evaluate(async (frames) => {
    const nextFrame = () =>
      new Promise((resolve) => {
        requestAnimationFrame(resolve);
      });
    const other = document.createElement('canvas');
    const caster = window.slicecast;
    caster.size = '1280x720';
    await nextFrame();
    await nextFrame();
    Object.assign(other, { width: 1280, height: 720 });
    const context = other.getContext('2d', { alpha: false });
    const bare = [];
    window.shown.length = 0;
    for (let i = 0; i < frames; ++i) {
      caster.look({ heading: i });
      await nextFrame();
      await nextFrame();
      bare.push(window.putAgain(window.shown.at(-1), context));
    }
    const median = (numbers) => [...numbers].sort((a, b) => a - b)[Math.floor(numbers.length / 2)];
    const calls = window.shown.filter(({ call }) => call !== undefined).map(({ call }) => call);
    const pictures = window.shown.filter(({ image }) => image !== undefined);
    return {
      calls,
      count: pictures.length,
      sizes: [...new Set(pictures.map(({ image }) => `${image.width}x${image.height}`))],
      isView: pictures.every(({ image }) => image.data.buffer.byteLength === caster.memory),
      objects: new Set(pictures.map(({ image }) => image)).size,
      presenting: median(pictures.map(({ milliseconds }) => milliseconds)),
      putting: median(bare),
    };
  }, kFrames);
  t.diagnostic(
    `presenting ${result.presenting.toFixed(2)} ms, putImageData alone ${result.putting.toFixed(2)} ms`,
  );
  assert.deepEqual(result.calls, []);
  assert.equal(result.count, kFrames, 'one for each picture');
  assert.deepEqual(result.sizes, ['1280x720']);
  assert.ok(result.isView, "the bytes are the engine's own memory");
  assert.equal(result.objects, 1, 'and are wrapped once');
  assert.ok(
    result.presenting <= result.putting * kSlack + 0.1,
    `presenting takes ${result.presenting} ms, putImageData ${result.putting} ms`,
  );
});
