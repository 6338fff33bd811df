// The program in a real window, under a virtual display.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, describe, test } from 'node:test';

import { eventually, noScreen, program, root, Screen } from './screen.mjs';

const scene = join(root, 'assets/scenes/first-walk.json');
const { title, start } = JSON.parse(readFileSync(scene, 'utf8'));
const kWidth = 320;
const kHeight = 200;

// What a session draws natively after a number of steps and a turn, without any window: bytes R, G,
// B.
function expectedPicture(width, height, turnDegrees = 0) {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-'));
  try {
    const pictures = join(folder, 'picture');
    const input = `120 0 0 0 0 0 0 0 0\n1 0 0 0 0 0 ${turnDegrees} 0 0`;
    const result = spawnSync(
      join(root, 'build/native/tests/slicecast-replay'),
      [scene, width, height, pictures].map(String),
      { input },
    );
    assert.equal(result.status, 0);
    const bytes = readFileSync(pictures).subarray(width * height * 4);
    return Buffer.from(bytes.filter((_, i) => i % 4 !== 3));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

// The lines of a tour as far as its first mark, which tells the pose there.
function headOf(tour) {
  const lines = tour.split('\n');
  const end = lines.findIndex((line) => line.startsWith('mark '));
  const pose = lines[end].split(' ').pop();
  const head = lines.slice(0, end);
  const steps = head.reduce((sum, line) => sum + (/^\d/.test(line) ? parseInt(line, 10) : 0), 0);
  return [...head, `end ${steps} ${pose}`, ''];
}

// The picture, each pixel as a square of n x n.
function enlarged(picture, width, height, n) {
  const large = Buffer.alloc(picture.length * n * n);
  for (let y = 0, to = 0; y < height * n; ++y) {
    for (let x = 0; x < width * n; ++x, to += 3) {
      const from = 3 * (Math.floor(y / n) * width + Math.floor(x / n));
      picture.copy(large, to, from, from + 3);
    }
  }
  return large;
}

describe('the window', { skip: noScreen }, () => {
  let screen;
  before(async () => {
    screen = await Screen.open(800, 600);
  });
  after(() => screen?.close());

  // One window at a time, so that none covers another.
  async function withWindow(args, use) {
    const started = await screen.start(args);
    try {
      await use(started);
      if (started.ended === undefined) {
        started.keys('Escape');
        await eventually('the end', () => started.ended !== undefined);
        assert.equal(started.ended, 0, started.errors);
      }
      assert.equal(started.errors, '');
    } finally {
      started.kill();
    }
  }

  const shows = (started, picture, what) =>
    eventually(what, () => started.picture().equals(picture));

  test('shows the scene under its title, byte for byte, and Escape ends it', () =>
    withWindow([scene, '--size', `${kWidth}x${kHeight}`], async (started) => {
      assert.equal(started.title, title);
      const { width, height } = started.place;
      assert.deepEqual({ width, height }, { width: kWidth, height: kHeight });
      await shows(started, expectedPicture(kWidth, kHeight), 'the picture of the start');
    }));

  test('a recording is played to its end, and recorded again', async () => {
    const folder = mkdtempSync(join(tmpdir(), 'slicecast-'));
    try {
      const again = join(folder, 'again.txt');
      const tour = join(folder, 'tour.txt');
      const head = headOf(readFileSync(join(root, 'assets/tours/castle.txt'), 'utf8'));
      writeFileSync(tour, head.join('\n'));
      await withWindow(
        ['--size', `${kWidth}x${kHeight}`, '--replay', tour, '--record', again],
        async (started) => {
          assert.equal(started.title, 'The castle in the lake (recording) (replay)');
          await eventually('the end', () => !started.title.includes('(replay)'), 60);
        },
      );
      // Idle steps may follow, until the window was closed.
      const wanted = head.slice(2, -2);
      const played = readFileSync(again, 'utf8').split('\n');
      assert.deepEqual(played.slice(4, 4 + wanted.length), wanted);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });

  // Nothing can be written into /proc, whoever one is.
  test('F9 in a folder that cannot be written records into the home folder, and says so', async () => {
    const home = mkdtempSync(join(tmpdir(), 'slicecast-home-'));
    const started = await screen.start([scene, '--size', `${kWidth}x${kHeight}`], {
      cwd: '/proc',
      env: { HOME: home },
    });
    try {
      const plain = expectedPicture(kWidth, kHeight);
      await shows(started, plain, 'the picture of the start');
      started.keys('F9');
      await eventually('the recording', () => started.title.includes('(recording)'));
      const place = join(home, 'first-walk-recording.txt');
      const told = `cannot be written: No such file or directory; the recording goes to "${place}"`;
      await eventually('the place', () => started.errors.includes(told));
      await eventually('the message', () => !started.picture().equals(plain));
      started.keys('F9');
      await eventually('the end', () => !started.title.includes('(recording)'));
      assert.match(readFileSync(place, 'utf8'), /first-walk/);
    } finally {
      started.kill();
      rmSync(home, { recursive: true });
    }
  });

  test('F9 records nothing where nothing can be written, and says so at once', async () => {
    const started = await screen.start([scene, '--size', `${kWidth}x${kHeight}`], {
      cwd: '/proc',
      env: { HOME: '/proc' },
    });
    try {
      const plain = expectedPicture(kWidth, kHeight);
      await shows(started, plain, 'the picture of the start');
      started.keys('F9');
      await eventually('the message', () => !started.picture().equals(plain));
      const told = 'cannot record: "first-walk-recording.txt" cannot be written';
      await eventually('the reason', () => started.errors.includes(told));
      assert.ok(!started.title.includes('(recording)'), started.title);
    } finally {
      started.kill();
    }
  });

  test('without a scene it opens the first one of the list', () =>
    withWindow(['--size', `${kWidth}x${kHeight}`], async (started) => {
      const [opening] = JSON.parse(readFileSync(join(root, 'assets/scenes/index.json'), 'utf8'));
      assert.equal(
        started.title,
        JSON.parse(readFileSync(join(root, 'assets/scenes', opening.file), 'utf8')).title,
      );
    }));

  test('the number pad turns to a heading', () =>
    withWindow([scene, '--size', `${kWidth}x${kHeight}`], async (started) => {
      started.keys('KP_8');
      await shows(
        started,
        expectedPicture(kWidth, kHeight, 270 - start.heading),
        'the view to the north',
      );
    }));

  test('a held key moves, and a pause stands still', () =>
    withWindow([scene, '--size', `${kWidth}x${kHeight}`], async (started) => {
      const first = expectedPicture(kWidth, kHeight);
      await shows(started, first, 'the picture of the start');
      started.keys('space');
      await eventually('a jump', () => !started.picture().equals(first));
      await shows(started, first, 'the ground again');
      started.keys('p');
      await eventually('the pause in the title', () => started.title === `${title} (paused)`);
      started.keys('space', 'Right');
      await new Promise((done) => setTimeout(done, 300));
      assert.ok(started.picture().equals(first));
      started.keys('p');
      await eventually('the title without the pause', () => started.title === title);
      screen.xdotool('keydown', 'Right');
      await eventually('a turn', () => !started.picture().equals(first));
      screen.xdotool('keyup', 'Right');
    }));

  test('help, frame rate and map are shown and hidden', () =>
    withWindow([scene, '--size', `${kWidth}x${kHeight}`], async (started) => {
      const plain = expectedPicture(kWidth, kHeight);
      await shows(started, plain, 'the picture of the start');
      for (const key of ['i', 'm']) {
        started.keys(key);
        await eventually(`something after ${key}`, () => !started.picture().equals(plain));
        started.keys(key);
        await shows(started, plain, `the plain picture after ${key} again`);
      }
      // Help has several pages in so small a picture, none of which reaches its edges.
      const edges = (picture) => {
        const rows = [0, 1, kHeight - 2, kHeight - 1];
        return Buffer.concat(
          rows.map((row) => picture.subarray(row * kWidth * 3, (row + 1) * kWidth * 3)),
        );
      };
      let before = plain;
      let pages = 0;
      do {
        started.keys('h');
        before = await eventually('another page of help', () => {
          const now = started.picture();
          return !now.equals(before) && now;
        });
        assert.ok(edges(before).equals(edges(plain)));
        ++pages;
      } while (!before.equals(plain));
      assert.ok(pages > 2, `${pages - 1} pages`);
    }));

  test('a click takes the mouse, Escape gives it back', () =>
    withWindow([scene, '--size', `${kWidth}x${kHeight}`], async (started) => {
      const plain = expectedPicture(kWidth, kHeight);
      await shows(started, plain, 'the picture of the start');
      screen.xdotool('mousemove', '--window', started.window, 100, 100);
      screen.xdotool('mousemove_relative', 20, 0);
      await new Promise((done) => setTimeout(done, 200));
      assert.ok(started.picture().equals(plain), 'a free mouse does not turn');
      screen.xdotool('click', 1);
      await eventually('a turn by the mouse', () => {
        screen.xdotool('mousemove_relative', 7, 0);
        return !started.picture().equals(plain);
      });
      started.keys('Escape', 'r', 'KP_8');
      await shows(
        started,
        expectedPicture(kWidth, kHeight, 270 - start.heading),
        'the view to the north',
      );
    }));

  test('a larger window enlarges a picture of fixed size by a whole number, with black around it', () =>
    withWindow([scene, '--size', `${kWidth}x${kHeight}`], async (started) => {
      screen.xdotool('windowsize', '--sync', started.window, 700, 500);
      screen.xdotool('windowmove', '--sync', started.window, 0, 0);
      const expected = enlarged(expectedPicture(kWidth, kHeight), kWidth, kHeight, 2);
      const { x, y } = started.place;
      await eventually('twice the size', () =>
        screen
          .picture({ x: x + 30, y: y + 50, width: 2 * kWidth, height: 2 * kHeight })
          .equals(expected),
      );
      for (const edge of [
        { x, y, width: 30, height: 500 },
        { x, y, width: 700, height: 50 },
      ])
        assert.ok(screen.picture(edge).every((byte) => byte === 0));
    }));

  test('without a size the picture fills the window, whatever its size', () =>
    withWindow([scene], async (started) => {
      screen.xdotool('windowsize', '--sync', started.window, 411, 333);
      screen.xdotool('windowmove', '--sync', started.window, 5, 5);
      await eventually('the size', () => started.place.width === 411);
      await shows(started, expectedPicture(411, 333), 'a picture of the new size');
    }));

  test('options of the command line act', () =>
    withWindow(
      [scene, '--size', `${kWidth}x${kHeight}`, '--fov', '90', '--set', 'textures=off'],
      async (started) => {
        const plain = expectedPicture(kWidth, kHeight);
        await eventually('a picture', () => started.picture().some((byte) => byte !== 0));
        assert.ok(!started.picture().equals(plain));
      },
    ));
});

function run(args, environment = {}, options = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, args, {
    encoding: 'utf8',
    env: { ...process.env, ...environment },
    ...options,
  });
  return { status, stdout, stderr, error };
}

test('--help lists options and keys', () => {
  const { status, stdout } = run(['--help']);
  assert.equal(status, 0);
  for (const word of [
    '--size',
    '--fov',
    '--map',
    '--fullscreen',
    '--set',
    '--threads',
    'Number pad',
  ])
    assert.ok(stdout.includes(word), word);
});

test('a scene at fault ends it with all faults', () => {
  const { status, stderr } = run([join(root, 'tests/scene/broken/several-faults.json')]);
  assert.equal(status, 1);
  assert.ok(stderr.trim().split('\n').length > 1, stderr);
  assert.match(stderr, /several-faults\.json:\d+:\d+/);
});

test('what cannot be is refused with the reason', () => {
  for (const [args, reason] of [
    [['nothing-of-that-name.json'], /nothing-of-that-name\.json/],
    [[scene, '--size', '0x10'], /0x10/],
    [[scene, '--size', 'large'], /large/],
    [[scene, '--fov', '500'], /500/],
    [[scene, '--threads', '0'], /"0" is not a number of threads; expected 1 to 64/],
    [[scene, '--threads', 'all'], /"all" is not a number of threads/],
    [[scene, '--set', 'colour'], /OPTION=VALUE/],
    [[scene, '--set', 'colour=red'], /colour/],
    [[scene, '--map', 'cellar'], /there is no map "cellar"; expected "courtyard"/],
  ]) {
    const { status, stderr } = run(args, { SDL_VIDEODRIVER: 'none' });
    assert.notEqual(status, 0, args.join(' '));
    assert.match(stderr, reason);
  }
  const { status, stderr } = run([scene], { SDL_VIDEODRIVER: 'none' });
  assert.equal(status, 1);
  assert.match(stderr, /cannot use a screen/);
});

// SDL falls back to drivers that show nothing; they are used if asked for, as here at last.
test('without a display it says so and ends', { skip: process.platform !== 'linux' }, () => {
  const none = { DISPLAY: undefined, WAYLAND_DISPLAY: undefined, XDG_RUNTIME_DIR: undefined };
  for (const driver of [undefined, '']) {
    const environment = { ...none, SDL_VIDEODRIVER: driver };
    const { status, stderr } = run([scene], environment, { timeout: 20000 });
    assert.equal(status, 1, stderr);
    assert.match(stderr, /^slicecast: cannot use a screen: /m);
  }
  const { error } = run([scene], { ...none, SDL_VIDEODRIVER: 'dummy' }, { timeout: 1500 });
  assert.equal(error?.code, 'ETIMEDOUT', 'it plays until it is stopped');
});

test('a recording that cannot be written is refused before it is played', () => {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-'));
  try {
    for (const [file, reason] of [
      [
        join(folder, 'missing', 'walk.txt'),
        /--record: ".*walk\.txt" cannot be written: No such file/,
      ],
      [folder, /--record: ".*" is a folder; expected the name of a file/],
    ]) {
      const environment = { SDL_VIDEODRIVER: 'dummy' };
      const { status, stderr } = run([scene, '--record', file], environment, { timeout: 20000 });
      assert.equal(status, 1, stderr);
      assert.match(stderr, reason);
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});
