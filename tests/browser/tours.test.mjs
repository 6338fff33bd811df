// Recordings in the page: a tour is played, somebody takes over, and what is played is recorded and
// saved.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { inState, launch, openPage, openScene, play, player, untilPlayer } from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const tour =
  'slicecast recording 1\nscene other\n100 forward 256\nmark there 0123456789abcdef\n4000 turn 128\nend 4100 0123456789abcdef\n';

const shown = (page) =>
  page.evaluate(() =>
    document.getElementById('mode').hidden ? '' : document.getElementById('mode').textContent,
  );

test('a tour in the address opens its scene and plays, until somebody moves', async (t) => {
  const { page } = await openScene(t, browser, {
    query: '?tour=mine',
    server: { files: { 'tours/mine.txt': tour } },
  });
  assert.equal(await page.title(), 'The other room · Slicecast');
  assert.match(await shown(page), /recorded tour/);
  assert.equal((await player(page)).steps, 0);
  await play(page);
  await untilPlayer(page, (now) => now.y > 4.5 && now.heading > 100);
  assert.equal((await page.evaluate(() => window.slicecast.replay)).steps, 4100);
  await page.keyboard.press('ArrowLeft');
  await page.waitForFunction(() => window.slicecast.replay === null);
  assert.equal(await shown(page), '');
  const { steps } = await player(page);
  const rested = await untilPlayer(page, (now, last) => now.steps > last + 90, steps);
  assert.equal(
    (await untilPlayer(page, (now, last) => now.steps > last + 30, rested.steps)).heading,
    rested.heading,
  );
});

test('the menu links to the tours of scenes', async (t) => {
  const scenes = [
    { file: 'room.json', title: 'The coloured room', about: 'Four walls.' },
    { file: 'other.json', title: 'The other room', about: 'Four walls too.', tour: true },
  ];
  const { page } = await openScene(t, browser, {
    server: { files: { 'scenes/index.json': JSON.stringify(scenes), 'tours/other.txt': tour } },
  });
  await page.click('#open-scenes');
  assert.equal(await page.$$eval('#scene-list .tour', (links) => links.length), 1);
  await page.click('#scene-list .tour');
  await page.waitForFunction(() => document.title.startsWith('The other room'));
  await inState(page, 'paused');
  assert.match(page.url(), /\?tour=other$/);
  assert.match(await shown(page), /recorded tour/);
});

test('shipped tours play in the page and end at the same place as elsewhere', async (t) => {
  const { page } = await openScene(t, browser, {
    query: '?tour=library',
    server: { files: { 'scenes/index.json': '[]' } },
  });
  assert.equal(await page.title(), 'The library · Slicecast');
  await play(page);
  await page.waitForFunction(() => window.slicecast.replay.stepsDone > 240);
  const { isSame } = await page.evaluate(() => window.slicecast.replay);
  assert.equal(isSame, true);
});

test('a faulty tour is refused with its faults, a missing one with its address', async (t) => {
  const files = { 'tours/mine.txt': 'slicecast recording 1\nscene other\n12 forwards 1\n' };
  const faulty = await openPage(t, browser, { query: '?tour=mine', server: { files } });
  await inState(faulty.page, 'trouble');
  assert.equal(await faulty.page.textContent('#trouble-title'), 'The tour cannot be played');
  assert.match(await faulty.page.textContent('#trouble-faults'), /mine\.txt:3:4/);
  const missing = await openPage(t, browser, { query: '?tour=nowhere', expectErrors: true });
  await inState(missing.page, 'trouble');
  assert.match(await missing.page.textContent('#trouble-text'), /tours\/nowhere\.txt/);
  const strange = await openPage(t, browser, { query: '?tour=../x', expectErrors: true });
  await inState(strange.page, 'trouble');
  assert.match(await strange.page.textContent('#trouble-text'), /x/);
});

test('F9 restarts the scene and records it; F9 again saves the recording', async (t) => {
  const { page } = await openScene(t, browser, { context: { acceptDownloads: true } });
  await play(page);
  await page.keyboard.down('w');
  await untilPlayer(page, (now) => now.x > 4);
  await page.keyboard.up('w');
  await page.keyboard.press('F9');
  await page.waitForFunction(
    () => !document.getElementById('mode').hidden && document.body.dataset.state === 'playing',
  );
  assert.match(await shown(page), /Recording/);
  assert.ok((await player(page)).x < 3.6, 'from the start');
  await page.keyboard.down('d');
  await untilPlayer(page, (now) => now.y > 4);
  await page.keyboard.up('d');
  const downloading = page.waitForEvent('download');
  await page.keyboard.press('F9');
  const download = await downloading;
  assert.equal(download.suggestedFilename(), 'room-recording.txt');
  assert.equal(await page.textContent('#toast'), 'Saved: room-recording.txt');
  const text = readFileSync(await download.path(), 'utf8');
  assert.match(
    text,
    /^slicecast recording 1\nscene room\n(set \w+ \w+\n)+(\d+\n)?\d+ strafe 256\n(\d+\n)?end \d+ [0-9a-f]{16}\n$/,
  );
  assert.equal(await shown(page), '');
  // Dropped on the page it is replayed in its scene.
  await page.setInputFiles('#files', {
    name: 'mine.txt',
    mimeType: 'text/plain',
    buffer: Buffer.from(text),
  });
  await page.waitForFunction(() => document.getElementById('mode').textContent.includes('tour'));
  await play(page);
  await page.waitForFunction(() => window.slicecast.replay === null);
  const after = await player(page);
  assert.ok(after.y > 4 && after.x < 3.6, `${after.x}, ${after.y}`);
});

test('a slow tour is overtaken by a scene chosen meanwhile', async (t) => {
  let arrive;
  const { page } = await openPage(t, browser, {
    query: '?tour=mine',
    server: { files: { 'tours/mine.txt': tour } },
    prepare: (newPage) =>
      newPage.route('**/tours/mine.txt', async (route) => {
        await new Promise((resolve) => {
          arrive = resolve;
        });
        await route.continue();
      }),
  });
  await page.waitForFunction(() => window.slicecast !== undefined);
  while (arrive === undefined) await page.waitForTimeout(20);
  await page.evaluate(() => {
    history.pushState(null, '', '?scene=room');
    window.dispatchEvent(new PopStateEvent('popstate'));
  });
  await inState(page, 'paused');
  const came = page.waitForResponse('**/tours/mine.txt');
  arrive();
  await came;
  await page.waitForTimeout(200);
  assert.equal(await page.title(), 'The coloured room · Slicecast');
  assert.equal(await shown(page), '');
});

for (const query of ['?scene=gone', '?tour=gone']) {
  test(`a slow load does not open over an error for ${query}`, async (t) => {
    let arrive;
    const { page } = await openPage(t, browser, {
      query: '?scene=other',
      expectErrors: true,
      prepare: (newPage) =>
        newPage.route('**/scenes/other.json', async (route) => {
          await new Promise((resolve) => {
            arrive = resolve;
          });
          await route.continue();
        }),
    });
    while (arrive === undefined) await page.waitForTimeout(20);
    await page.evaluate((address) => {
      history.pushState(null, '', address);
      window.dispatchEvent(new PopStateEvent('popstate'));
    }, query);
    await inState(page, 'trouble');
    const came = page.waitForResponse('**/scenes/other.json');
    arrive();
    await came;
    await page.waitForTimeout(300);
    assert.equal(await page.evaluate(() => document.body.dataset.state), 'trouble');
  });
}
