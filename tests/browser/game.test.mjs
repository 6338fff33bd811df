// A scene that is a game: the page's display, its messages and best times, and the element's
// events.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { inState, launch, openScene, play, untilPlayer } from './browser.mjs';
import { roomScene } from './room.mjs';
import { png } from './png.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// The room with a coin between the player and the east wall, and the goal before that wall.
function files() {
  const scene = roomScene({ title: 'A room with a coin' });
  scene.sprites = { coin: 'pictures/coin.png' };
  scene.game = {
    aim: 'Take the coin to the wall.',
    at: { x: 5, y: 3 },
    message: 'Well done.',
  };
  scene.maps[0].objects = [
    { sprite: 'coin', x: 4.4, y: 3.5, height: 0.4, find: { kind: 'coin', message: 'A coin!' } },
  ];
  return {
    'scenes/room.json': JSON.stringify(scene),
    'scenes/pictures/coin.png': png(8, () => [230, 200, 50]),
  };
}

const textOf = (page, id) => page.evaluate((name) => document.getElementById(name).textContent, id);
const listen = (page) =>
  page.evaluate(() => {
    window.told = [];
    for (const name of ['message', 'find', 'goal'])
      window.slicecast.addEventListener(name, ({ detail }) =>
        window.told.push({ event: name, ...detail }),
      );
  });

async function walkToTheGoal(page) {
  await page.keyboard.down('w');
  await page.waitForFunction(() => window.slicecast.game.reached);
  await page.keyboard.up('w');
}

test('the display shows the aim, the finds and the time, and keeps the best one', async (t) => {
  const { page } = await openScene(t, browser, { server: { files: files() } });
  await listen(page);
  assert.equal(await page.isVisible('#game'), true);
  assert.equal(await textOf(page, 'game-aim'), 'Take the coin to the wall.');
  assert.equal(await textOf(page, 'game-count'), '◇');
  assert.equal(await textOf(page, 'game-time'), '0:00.0');

  await play(page);
  const { steps } = await page.evaluate(() => window.slicecast.player);
  await untilPlayer(page, (state, begun) => state.steps > begun + 60, steps);
  assert.equal(
    await page.evaluate(() => window.slicecast.game.begun),
    false,
    'time waits for the first input',
  );
  await walkToTheGoal(page);
  assert.equal(await textOf(page, 'message'), 'Well done.');
  await page.waitForFunction(() => document.getElementById('game-count').textContent === '◆');
  const { steps: taken } = await page.evaluate(() => window.slicecast.game);
  await page.waitForFunction(() =>
    document.getElementById('game-time').textContent.endsWith(', your best time'),
  );
  assert.equal(
    await page.evaluate(() => localStorage.getItem('slicecast.best-times')),
    JSON.stringify({ 'room.json': taken }),
  );
  const told = await page.evaluate(() => window.told);
  assert.deepEqual(
    told.map(({ event, text, finds, of }) => ({ event, text, finds, of })),
    [
      { event: 'find', text: 'A coin!', finds: 1, of: 1 },
      { event: 'goal', text: 'Well done.', finds: 1, of: 1 },
    ],
  );
  assert.equal(told[0].name, 'coin');
  assert.ok(told[1].seconds > 0);

  // The next visit shows it; a slower game does not change it
  await page.reload();
  await inState(page, 'paused');
  assert.match(await textOf(page, 'game-time'), /^0:00\.0, best 0:0\d\.\d$/);
  await play(page);
  await page.keyboard.down('s');
  await page.waitForFunction(() => window.slicecast.game.seconds > 1.5);
  await page.keyboard.up('s');
  await walkToTheGoal(page);
  await page.waitForFunction(() =>
    /, best /.test(document.getElementById('game-time').textContent),
  );
  assert.equal(
    await page.evaluate(() => localStorage.getItem('slicecast.best-times')),
    JSON.stringify({ 'room.json': taken }),
  );
});

test('where nothing can be stored, the game is the same', async (t) => {
  const { page } = await openScene(t, browser, {
    server: { files: files() },
    prepare: (page) =>
      page.addInitScript(() => {
        Object.defineProperty(window, 'localStorage', {
          get() {
            throw new DOMException('no', 'SecurityError');
          },
        });
      }),
  });
  await play(page);
  await walkToTheGoal(page);
  await page.waitForFunction(() =>
    document.getElementById('game-time').textContent.endsWith(', your best time'),
  );
});

test('a scene without a game shows none', async (t) => {
  const { page } = await openScene(t, browser);
  assert.equal(await page.isVisible('#game'), false);
  assert.equal(await page.evaluate(() => window.slicecast.game), null);
});
