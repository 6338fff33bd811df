// The controller of the picture's scale, with simulated screens and machines.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Pace, kLeastScale } from '../../web/element/pace.js';
import { layOut } from '../../web/element/stage.js';

const k60 = 1000 / 60;

// Plays so many seconds: `milliseconds(scale, time)` is what a frame takes to draw, and
// `beside(time)` what else the page does in it. A frame is shown with the screen's next picture.
// `seed` chooses how drawing scatters. Gives every frame, {time, scale, interval}.
function run(pace, seconds, { screen = k60, milliseconds, beside = () => 0, begin = 0, seed = 1 }) {
  const frames = [];
  let random = seed;
  const noise = () => {
    random = (random * 16807) % 2147483647;
    return 0.9 + (0.2 * random) / 2147483647;
  };
  let time = begin;
  let interval = screen;
  while (time < begin + seconds * 1000) {
    const { scale } = pace;
    const busy = milliseconds(scale, time) * noise();
    pace.frame(time, busy);
    frames.push({ time, scale, interval });
    interval = screen * Math.max(1, Math.ceil((busy + beside(time)) / screen));
    time += interval;
  }
  return frames;
}

const changes = (frames) => frames.filter(({ scale }, i) => i > 0 && scale !== frames[i - 1].scale);
const after = (frames, seconds) =>
  frames.filter(({ time }) => time >= frames[0].time + seconds * 1000);
const lateShare = (frames, screen = k60) =>
  frames.filter(({ interval }) => interval > 1.5 * screen).length / frames.length;
const perPixel = (full) => (scale) => full * scale ** 2;

test('a quick machine keeps all pixels', () => {
  const frames = run(new Pace(), 30, { milliseconds: perPixel(12) });
  assert.deepEqual(changes(frames), []);
  assert.equal(frames.at(-1).scale, 1);
});

for (const full of [20, 30, 60, 120])
  test(`where all pixels take ${full} ms, it keeps up within two seconds, with most pixels`, () => {
    const frames = run(new Pace(), 60, { milliseconds: perPixel(full) });
    const settled = after(frames, 2);
    assert.ok(lateShare(settled) < 0.01, `late ${lateShare(settled)}`);
    const { scale } = frames.at(-1);
    const share = (full * scale ** 2) / k60;
    assert.ok(share > 0.55 && share < 0.95, `drawing takes ${share} of the interval`);
  });

test('a much too slow machine gets the smallest scale', () => {
  const frames = run(new Pace(), 40, { milliseconds: perPixel(900) });
  assert.equal(frames.at(-1).scale, kLeastScale);
});

test('each change is small', () => {
  const frames = run(new Pace(), 10, { milliseconds: perPixel(120) });
  for (const { scale, time } of changes(frames)) {
    const before = frames.findLast((one) => one.time < time).scale;
    assert.ok(Math.abs(scale / before - 1) < 0.07, `from ${before} to ${scale}`);
  }
});

test('once settled, the scale does not oscillate', () => {
  for (let full = 14; full < 100; full += 1.7) {
    for (const seed of [1, 77, 4242]) {
      const frames = run(new Pace(), 120, { milliseconds: perPixel(full), seed });
      const late = changes(after(frames, 10));
      assert.ok(late.length <= 6, `${full} ms: ${late.length} changes in 110 s`);
    }
  }
});

test('the picture grows again when there is time', () => {
  const pace = new Pace();
  const frames = run(pace, 40, {
    milliseconds: (scale, time) => (time < 10000 ? 40 : 10) * scale ** 2,
  });
  const then = frames.findLast(({ time }) => time < 10000).scale;
  assert.ok(then < 0.7, `${then}`);
  assert.equal(frames.at(-1).scale, 1);
  const back = frames.find(({ time, scale }) => time > 10000 && scale === 1);
  assert.ok(back.time < 25000, `after ${(back.time - 10000) / 1000} s`);
});

for (const hertz of [75, 120, 144, 240])
  test(`it keeps up with a screen of ${hertz} Hz`, () => {
    const screen = 1000 / hertz;
    const pace = new Pace();
    // A quick start shows the screen's rate.
    run(pace, 2, { screen, milliseconds: perPixel(0.5 * screen) });
    const frames = run(pace, 20, { screen, milliseconds: perPixel(2 * screen), begin: 2000 });
    assert.ok(lateShare(after(frames, 3), screen) < 0.02);
    assert.ok(frames.at(-1).scale > 0.5);
  });

test('if something else keeps the page busy, the picture gets its pixels back', () => {
  const frames = run(new Pace(), 60, { milliseconds: perPixel(4), beside: () => 20 });
  assert.equal(frames.at(-1).scale, 1);
  const fewer = frames.filter(({ scale }) => scale < 1).length / frames.length;
  assert.ok(fewer < 0.25, `${fewer} of the frames had fewer pixels`);
});

test('if showing the picture takes long, it gets fewer pixels', () => {
  const pace = new Pace();
  const frames = run(pace, 30, {
    milliseconds: perPixel(4),
    beside: () => 25 * pace.scale ** 2,
  });
  assert.ok(frames.at(-1).scale < 0.8, `${frames.at(-1).scale}`);
  assert.ok(lateShare(after(frames, 20)) < 0.1);
});

test('a rest does not count as a late frame', () => {
  const pace = new Pace();
  run(pace, 2, { milliseconds: perPixel(5) });
  for (let i = 1; i < 20; ++i) {
    pace.rest();
    const frames = run(pace, 0.3, { milliseconds: perPixel(5), begin: 2000 + i * 900 });
    assert.equal(frames.at(-1).scale, 1);
  }
});

test('the size auto follows the box and the scale, and is never more than 4096 a side', () => {
  const sizeOf = (...wanted) => {
    const { width, height } = layOut(...wanted);
    return `${width}x${height}`;
  };
  assert.equal(sizeOf('auto', 1366, 768), '1366x768');
  assert.equal(sizeOf('auto', 1366, 768, 0.5), '683x384');
  assert.equal(sizeOf('auto', 1366, 768, 0.83), '1134x637');
  assert.equal(sizeOf('auto', 8192, 2048), '4096x1024');
  assert.equal(sizeOf('auto', 5120, 2880), '4096x2304');
  assert.equal(sizeOf('auto', 2880, 5120), '2304x4096');
  assert.equal(sizeOf('100%', 5120, 2880), '4096x2304');
  assert.equal(sizeOf('75%', 1920, 1080), '1440x810');
  assert.equal(sizeOf('640x400', 1920, 1080), '640x400');
  assert.equal(sizeOf('auto', 640, 400, 0.25), '320x200'); // small ones stay readable
  assert.equal(sizeOf('auto', 200, 100, 0.25), '200x100');
});

test('pixels are shown at whole scales if these fit, and filtered otherwise', () => {
  const shown = (...wanted) => layOut(...wanted);
  assert.equal(shown('auto', 1367, 767).isEven, true);
  assert.deepEqual(shown('50%', 1367, 767), {
    width: 684,
    height: 384,
    shownWidth: 1368,
    shownHeight: 768,
    isEven: true,
  });
  const filtered = shown('auto', 1367, 767, 0.94);
  assert.deepEqual([filtered.shownWidth, filtered.shownHeight], [1367, 767]);
  assert.equal(filtered.isEven, false);
  assert.equal(shown('320x200', 640, 400).isEven, true);
  assert.equal(shown('320x200', 500, 312).isEven, false);
});
