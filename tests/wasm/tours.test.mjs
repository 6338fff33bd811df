// The recorded tours, played through the functions of the page's module: at every mark the
// WebAssembly with SIMD, the one without, and the native program agree in the state and in every
// byte of the picture.

import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { test } from 'node:test';

import { flavours, loadModule, root, Session, shippedTours } from './load.mjs';

const kWidth = 256;
const kHeight = 144;

const sceneOf = (scene) => join(root, 'assets/scenes', `${scene}.json`);

function playNatively(scene, tour) {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-'));
  try {
    const pictures = join(folder, 'pictures');
    const result = spawnSync(
      join(root, 'build/native/tests/slicecast-replay'),
      [sceneOf(scene), kWidth, kHeight, pictures, tour].map(String),
      { encoding: 'utf8' },
    );
    assert.equal(result.status, 0, result.stderr ?? String(result.error));
    const bytes = readFileSync(pictures);
    const size = kWidth * kHeight * 4;
    return result.stdout
      .trim()
      .split('\n')
      .map((fingerprint, i) => ({
        fingerprint,
        picture: bytes.subarray(i * size, (i + 1) * size),
      }));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('there are at least five tours', () => assert.ok(shippedTours.length >= 5));

for (const tour of shippedTours) {
  for (const flavour of flavours) {
    test(`the tour ${basename(tour)} is the same natively and in WebAssembly (${flavour})`, async () => {
      const session = new Session(await loadModule(flavour));
      const { scene, steps, marks, faults } = session.readRecording(readFileSync(tour), tour);
      assert.deepEqual(faults, []);
      assert.deepEqual(session.load(sceneOf(scene)), []);
      assert.ok(session.replay());
      const native = playNatively(scene, tour);
      assert.equal(native.length, marks.length + 1);
      let done = 0;
      [...marks, { name: 'the end', step: steps }].forEach(({ name, step }, i) => {
        assert.equal(session.replayStep(step - done), step - done);
        done = step;
        assert.equal(session.state().fingerprint, native[i].fingerprint, `the state at ${name}`);
        assert.ok(
          session.draw(kWidth, kHeight).equals(native[i].picture),
          `the picture at ${name}`,
        );
      });
      assert.equal(session.replayStep(1), 0);
      assert.deepEqual(session.replayState(), {
        steps,
        stepsDone: steps,
        isSame: true,
        isSeeking: false,
      });
      session.free();
    });
  }
}

// The same game as natively in tests/tours.
test('the tour of the hunt finds everything and reaches the goal', async () => {
  const tour = join(root, 'assets/tours/wayhouse-hunt.txt');
  const session = new Session(await loadModule('simd'));
  const { scene, steps } = session.readRecording(readFileSync(tour), tour);
  assert.deepEqual(session.load(sceneOf(scene)), []);
  assert.ok(session.replay());
  assert.deepEqual(
    (({ finds, of, hasGoal, begun, reached }) => ({ finds, of, hasGoal, begun, reached }))(
      session.game(),
    ),
    { finds: 0, of: 4, hasGoal: true, begun: false, reached: false },
  );
  assert.equal(session.replayStep(steps), steps);
  const news = session.news();
  assert.deepEqual(
    news.filter(({ kind }) => kind === 'find').map(({ name, finds }) => `${finds} ${name}`),
    ['1 shell', '2 lantern', '3 moonflower', '4 crystal'],
  );
  assert.equal(news.at(-1).kind, 'goal');
  assert.deepEqual(session.news(), []);
  // Back before the first find, and forth again
  const { fingerprint } = session.state();
  assert.ok(session.seekReplay(0));
  assert.equal(session.game().finds, 0);
  assert.ok(session.seekReplay(steps));
  assert.equal(session.state().fingerprint, fingerprint);
  assert.deepEqual(session.replayState(), {
    steps,
    stepsDone: steps,
    isSame: true,
    isSeeking: false,
  });
  const { finds, reached, steps: taken, seconds } = session.game();
  assert.deepEqual({ finds, reached, seconds }, { finds: 4, reached: true, seconds: taken / 120 });
  session.free();
});

test('a recording can be read and replayed', async () => {
  const session = new Session(await loadModule('simd'));
  assert.equal(session.replay(), false);
  assert.equal(session.replayState(), null);
  assert.equal(session.takeRecording(), '');
  session.load(sceneOf('first-walk'));
  session.record('first-walk');
  session.step([1, 0, 0, 0, 0, 0.123456, 0, 1], 50);
  session.module._slicecast_setFlying(session.address, 1);
  session.step([0, 0.3, 0, 0, 1, 0, 0, 0], 70);
  const { fingerprint } = session.state();
  const text = session.takeRecording();
  assert.match(
    text,
    /^slicecast recording 1\nscene first-walk\nset speed 1\nset bob on\n50 forward 256 turn-degrees 126 jump\nfly on\n70 strafe 77 fly 256\nend 120 [0-9a-f]{16}\n$/,
  );
  assert.equal(session.takeRecording(), '', 'it has ended');

  const again = new Session(await loadModule('scalar'));
  assert.deepEqual(again.readRecording(text, 'x').faults, []);
  assert.equal(again.replay(), false, 'there is no game yet');
  again.load(sceneOf('first-walk'));
  assert.deepEqual(again.readRecording(text, 'x').faults, []);
  assert.ok(again.replay());
  assert.equal(again.replayStep(1000), 120);
  assert.equal(again.state().fingerprint, fingerprint);
});

test('a faulty recording is not half loaded', async () => {
  const session = new Session(await loadModule('simd'));
  session.load(sceneOf('first-walk'));
  const { scene, faults } = session.readRecording(
    'slicecast recording 1\nscene first-walk\n12 forwards 1\n',
    'mine.txt',
  );
  assert.equal(scene, undefined);
  assert.deepEqual(
    faults.map(({ file, line, column, found }) => [file, line, column, found]),
    [
      ['mine.txt', 3, 4, '"forwards"'],
      ['mine.txt', 4, 1, 'the end of the file'],
    ],
  );
  assert.equal(session.replay(), false);
});
