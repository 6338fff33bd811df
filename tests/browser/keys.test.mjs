// Keys, focus and the mouse, as real presses in a real browser.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import {
  frames,
  inState,
  launch,
  openScene,
  pictureHash,
  play,
  playAtOneSize,
  player,
  untilPlayer,
  withWindows,
} from './browser.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// Waits until the player has neither moved nor turned for 50 milliseconds.
function atRest(page) {
  return page.waitForFunction(
    () => {
      const { x, y, z, heading, look } = window.slicecast.player;
      const now = [x, y, z, heading, look].join();
      const still = now === window.before;
      window.before = now;
      return still;
    },
    undefined,
    { polling: 50 },
  );
}

const focused = (page) => page.evaluate(() => document.activeElement.id);

test('walking, stepping aside and turning move the player and change the picture', async (t) => {
  const { page } = await openScene(t, browser);
  await playAtOneSize(page);
  const startPicture = await pictureHash(page);
  const moves = [
    ['KeyW', (now, before) => now.x > before.x + 0.3],
    ['KeyS', (now, before) => now.x < before.x - 0.3],
    ['KeyD', (now, before) => now.y > before.y + 0.3],
    ['KeyQ', (now, before) => now.y < before.y - 0.3],
    ['ArrowRight', (now, before) => now.heading > before.heading + 10 && now.heading < 180],
    ['ArrowUp', (now, before) => now.look > before.look + 0.05],
    ['PageDown', (now, before) => now.z < before.z - 0.1],
    ['Space', (now, before) => now.z > before.z + 0.1],
  ];
  for (const [key, condition] of moves) {
    const before = await player(page);
    await page.keyboard.down(key);
    await untilPlayer(page, condition, before);
    await page.keyboard.up(key);
    await atRest(page);
  }
  assert.notEqual(await pictureHash(page), startPicture);
});

test('V flies, and Page Up and Space rise', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.keyboard.press('v');
  await untilPlayer(page, (now) => now.flying);
  await page.keyboard.down('PageUp');
  await untilPlayer(page, (now) => now.z > 1.2);
  await page.keyboard.up('PageUp');
  const { z } = await player(page);
  await page.keyboard.down('Space');
  await untilPlayer(page, (now, from) => now.z > from + 0.5, z);
  await page.keyboard.up('Space');
});

test("the game's keys do not scroll", async (t) => {
  const { page } = await openScene(t, browser);
  await page.evaluate(() => {
    document.documentElement.style.overflow = document.body.style.overflow = 'auto';
    document.body.style.height = '5000px';
  });
  await play(page);
  for (const key of ['ArrowDown', 'ArrowDown', 'Space', 'PageDown', 'End'])
    await page.keyboard.press(key);
  await frames(page, 10);
  assert.equal(await page.evaluate(() => scrollY), 0);
  // The proof that there was something to scroll
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press('PageDown');
  await page.waitForFunction(() => scrollY > 0);
});

test('a text box in the page gets its letters, and the player stays', async (t) => {
  const { page } = await openScene(t, browser);
  await page.evaluate(() => {
    const box = document.createElement('input');
    box.id = 'text-box';
    document.body.append(box);
  });
  await play(page);
  await page.focus('#text-box');
  await inState(page, 'paused');
  const before = await player(page);
  await page.keyboard.type('wasd hfimp v');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Space');
  assert.equal(await page.inputValue('#text-box'), 'wasd hfimp  v');
  assert.deepEqual(await player(page), before);
  assert.equal(await page.isVisible('#keys'), false);
});

test('Tab moves on from the canvas to the buttons, with a ring around them', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  assert.equal(await focused(page), 'picture');
  await page.keyboard.press('Tab');
  assert.equal(await focused(page), 'open-scenes');
  await inState(page, 'paused');
  const order = [];
  for (let i = 0; i < 8; ++i) {
    const ring = await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle);
    order.push(`${await focused(page)} ${ring}`);
    await page.keyboard.press('Tab');
  }
  assert.deepEqual(order, [
    'open-scenes solid',
    'open-lessons solid',
    'open-edit solid',
    'open-lab solid',
    'open-keys solid',
    'open-settings solid',
    'open-share solid',
    'full-screen solid',
  ]);
  assert.equal(await focused(page), 'play');
  await page.keyboard.press('Enter');
  await inState(page, 'playing');
  assert.equal(await focused(page), 'picture');
});

test("the browser's own shortcuts still work", async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.evaluate(() => {
    window.taken = {};
    window.addEventListener('keydown', (event) => {
      window.taken[
        `${event.ctrlKey ? 'Ctrl ' : ''}${event.altKey ? 'Alt ' : ''}${event.metaKey ? 'Meta ' : ''}${event.code}`
      ] = event.defaultPrevented;
    });
  });
  for (const keys of [
    'Control+a',
    'Control+p',
    'Alt+d',
    'Meta+w',
    'F5',
    'w',
    'ArrowUp',
    'Shift+w',
  ]) {
    if (keys === 'F5')
      await page.evaluate(() =>
        window.slicecast.shadowRoot.querySelector('canvas').dispatchEvent(
          new KeyboardEvent('keydown', {
            code: 'F5',
            key: 'F5',
            bubbles: true,
            cancelable: true,
            composed: true,
          }),
        ),
      );
    else await page.keyboard.press(keys);
  }
  const taken = await page.evaluate(() => window.taken);
  assert.equal(taken['Ctrl KeyA'], false);
  assert.equal(taken['Ctrl KeyP'], false);
  assert.equal(taken['Alt KeyD'], false);
  assert.equal(taken['Meta KeyW'], false);
  assert.equal(taken.F5, false);
  assert.equal(taken.KeyW, undefined); // the picture's own do not reach the page
  assert.equal(taken.ArrowUp, undefined);
});

test('Escape leaves the canvas and pauses play', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.keyboard.press('Escape');
  await inState(page, 'paused');
  assert.equal(await page.evaluate(() => window.slicecast.entered), false);
  const before = await player(page);
  await page.keyboard.press('w');
  await frames(page, 20);
  assert.deepEqual(await player(page), before);
  assert.equal(await page.textContent('#play'), 'Continue');
  await page.keyboard.press('Enter');
  await inState(page, 'playing');
});

test('a key held while the focus leaves is not held when it returns', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  const { heading } = await player(page);
  await page.keyboard.down('ArrowRight');
  await untilPlayer(page, (now, before) => now.heading > before + 5, heading);
  await page.evaluate(() => document.getElementById('open-keys').focus());
  await inState(page, 'paused');
  await page.evaluate(() => window.slicecast.shadowRoot.querySelector('canvas').focus());
  await inState(page, 'playing');
  const { steps } = await player(page);
  await untilPlayer(page, (now, before) => now.steps > before + 30, steps);
  const rested = await player(page);
  await untilPlayer(page, (now, before) => now.steps > before + 30, rested.steps);
  assert.equal((await player(page)).heading, rested.heading);
});

test('P pauses and goes on', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.keyboard.press('p');
  await inState(page, 'paused');
  assert.equal(await page.isVisible('#pause-title'), true);
  const { steps } = await player(page);
  await frames(page, 10);
  assert.equal((await player(page)).steps, steps);
  await page.keyboard.press('p');
  await inState(page, 'playing');
  await untilPlayer(page, (now, before) => now.steps > before, steps);
});

test('H shows the keys in a table, Escape brings the game back', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.keyboard.press('h');
  await page.waitForSelector('#keys[open]');
  const rows = await page.$$eval('#key-tables tbody tr', (all) =>
    all.map((row) => [row.querySelectorAll('kbd').length, row.querySelector('td').textContent]),
  );
  assert.ok(rows.length >= 12);
  assert.ok(rows.every(([keys, text]) => keys > 0 && text !== ''));
  await page.keyboard.press('Escape');
  await page.waitForSelector('#keys:not([open])', { state: 'attached' });
  await inState(page, 'playing');
  assert.equal(await focused(page), 'picture');
  // H also works while the canvas does not have the focus, and H closes the table too
  await page.keyboard.press('Escape');
  await inState(page, 'paused');
  await page.keyboard.press('h');
  await page.waitForSelector('#keys[open]');
  await page.keyboard.press('h');
  await page.waitForSelector('#keys:not([open])', { state: 'attached' });
});

test('keys are in groups, and named as on the own keyboard', async (t) => {
  const { page } = await openScene(t, browser, {
    prepare: (opened) =>
      opened.addInitScript(() => {
        const french = new Map([
          ['KeyW', 'z'],
          ['KeyA', 'q'],
          ['KeyZ', 'w'],
          ['Semicolon', 'm'],
          ['Equal', 'ß'], // no single letter above it
        ]);
        Object.defineProperty(navigator, 'keyboard', {
          value: { getLayoutMap: async () => french },
        });
      }),
  });
  await page.keyboard.press('h');
  await page.waitForSelector('#keys[open]');
  const groups = await page.$$eval('#key-tables table', (tables) =>
    tables.map((table) => [
      table.caption.textContent,
      Object.fromEntries(
        [...table.querySelectorAll('tbody tr')].map((row) => [
          row.querySelector('td').textContent,
          [...row.querySelectorAll('kbd')].map((key) => key.textContent).join(' '),
        ]),
      ),
    ]),
  );
  assert.deepEqual(
    groups.map(([title]) => title),
    ['Moving', 'Looking', 'Gates', 'Light', 'To see how it works', 'The picture'],
  );
  const lines = Object.assign({}, ...groups.map(([, own]) => own));
  assert.equal(lines['walk ahead and back'], 'Z S');
  assert.equal(lines['sound on or off'], 'M');
  assert.equal(lines['share this view'], 'W');
  assert.match(lines['stronger and weaker mirrors'], /^\+ -/);
});

test('I shows the frame rate', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  assert.equal(await page.isVisible('#rate'), false);
  await page.keyboard.press('i');
  await page.waitForFunction(() =>
    /^[1-9]\d* fps · \d+\.\d ms · \d+ × \d+$/.test(document.getElementById('rate').textContent),
  );
  assert.equal(await page.isVisible('#rate'), true);
});

test('F enters and leaves full screen', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.fullscreenElement === document.documentElement);
  await page.waitForFunction(
    () => document.getElementById('full-screen').textContent === 'Leave full screen',
  );
  await page.keyboard.press('f');
  await page.waitForFunction(() => document.fullscreenElement === null);
});

test('Play captures the mouse when a mouse presses it, not by key or finger', async (t) => {
  const open = async (context) => {
    const { page } = await openScene(t, browser, {
      context,
      prepare: (newPage) =>
        newPage.addInitScript(() => {
          window.asked = [];
          Element.prototype.requestPointerLock = async function () {
            window.asked.push(this.localName);
          };
        }),
    });
    return page;
  };
  const asked = async (page) => {
    await inState(page, 'playing');
    await frames(page);
    return page.evaluate(() => window.asked);
  };
  const byMouse = await open({});
  await byMouse.click('#play');
  assert.deepEqual(await asked(byMouse), ['canvas']);
  const byKey = await open({});
  await play(byKey);
  assert.deepEqual(await asked(byKey), []);
  const byFinger = await open({ hasTouch: true });
  await byFinger.tap('#play');
  assert.deepEqual(await asked(byFinger), []);
});

test('the focus returns to what opened a dialog', async (t) => {
  const { page } = await openScene(t, browser);
  for (const name of ['scenes', 'keys', 'settings', 'share']) {
    await page.press(`#open-${name}`, 'Enter');
    await page.waitForSelector(`#${name}[open]`);
    await page.keyboard.press('Escape');
    await page.waitForSelector(`#${name}:not([open])`, { state: 'attached' });
    assert.equal(await page.evaluate(() => document.activeElement.id), `open-${name}`);
  }
});

test('a click locks the pointer, the mouse looks around, Escape releases it', async (t) => {
  const { page } = await openScene(t, await withWindows(t));
  await page.mouse.click(320, 100);
  await inState(page, 'playing');
  await page.waitForFunction(() => document.pointerLockElement === window.slicecast);
  const before = await player(page);
  await page.mouse.move(420, 100, { steps: 5 });
  const turned = await untilPlayer(
    page,
    (now, heading) => now.heading > heading + 5 && now.heading < 180,
    before.heading,
  );
  await page.mouse.move(420, 60, { steps: 5 });
  await untilPlayer(page, (now, look) => now.look > look + 0.02, turned.look);
  await page.keyboard.press('Escape');
  await page.waitForFunction(() => document.pointerLockElement === null);
});

test('a slow or hidden tab causes neither jumps nor stuck keys', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);

  // Evaluated within the page, so that no time passes in between
  await page.evaluate(() => {
    window.stepsDuring = async (act) => {
      const before = window.slicecast.player.steps;
      act();
      for (let frame = 0; frame < 2; ++frame) await new Promise(requestAnimationFrame);
      return window.slicecast.player.steps - before;
    };
    window.setHidden = (hidden) => {
      Object.defineProperty(document, 'hidden', { configurable: true, get: () => hidden });
      Object.defineProperty(document, 'visibilityState', {
        configurable: true,
        get: () => (hidden ? 'hidden' : 'visible'),
      });
      document.dispatchEvent(new Event('visibilitychange', { bubbles: true }));
    };
  });

  // One frame that takes a second and a half: lost time is not made up.
  const slow = await page.evaluate(() =>
    window.stepsDuring(() => {
      const end = performance.now() + 1500;
      while (performance.now() < end);
    }),
  );
  assert.ok(slow <= 36, `${slow} steps in two frames`);

  // Hidden, with a key held
  const before = await player(page);
  await page.keyboard.down('ArrowRight');
  await untilPlayer(page, (now, heading) => now.heading > heading + 5, before.heading);
  assert.equal(await page.evaluate(() => window.stepsDuring(() => window.setHidden(true))), 0);
  await page.waitForTimeout(700);
  const shown = await page.evaluate(() => window.stepsDuring(() => window.setHidden(false)));
  assert.ok(shown <= 24, `${shown} steps in two frames`);
  const { steps } = await player(page);
  await untilPlayer(page, (now, last) => now.steps > last + 40, steps);
  const rested = await player(page);
  await untilPlayer(page, (now, last) => now.steps > last + 30, rested.steps);
  assert.equal((await player(page)).heading, rested.heading, 'the key is no longer held');
  await page.keyboard.up('ArrowRight');
  await page.keyboard.press('Numpad2');
  await untilPlayer(page, (now) => now.heading === 90);
});

test('Ctrl walks slowly; with W it would close the tab, so the browser asks first', async (t) => {
  const { page } = await openScene(t, browser);
  await play(page);
  const asked = async (keys) => {
    let answer = false;
    const listen = (dialog) => {
      answer = dialog.type() === 'beforeunload';
      dialog.dismiss();
    };
    page.on('dialog', listen);
    for (const key of keys) await page.keyboard.down(key);
    const left = await page.evaluate(
      () => !window.dispatchEvent(new Event('beforeunload', { cancelable: true })),
    );
    for (const key of keys) await page.keyboard.up(key);
    page.off('dialog', listen);
    return left || answer;
  };
  assert.equal(await asked(['Control']), true);
  assert.equal(await asked(['KeyW']), false);
  await page.keyboard.down('Control');
  await page.evaluate(() => document.activeElement.blur());
  assert.equal(await asked([]), false);
});
