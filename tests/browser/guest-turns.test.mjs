// A <ray-caster> in a changing page: faults that are fixed,
// requests that overtake each other, another document.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, withWindows } from './browser.mjs';
import { guestPage, kRoom, openGuest, ready, until, wait } from './guest-page.mjs';
import { kBlue, kGreen, roomScene } from './room.mjs';
import { serve } from './static-server.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const stateIs = (page, state) =>
  until(page, (wanted) => document.querySelector('ray-caster').state === wanted, state);

// Waits until changes of the element have taken effect.
const settled = (page) => page.evaluate(() => new Promise((resolve) => setTimeout(resolve)));

// The colour in the middle of the canvas.
const middle = (page) =>
  page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    const canvas = document.querySelector('ray-caster').shadowRoot.querySelector('canvas');
    return [
      ...canvas
        .getContext('2d')
        .getImageData(canvas.width / 2, canvas.height / 2, 1, 1)
        .data.subarray(0, 3),
    ];
  });

// Counts the errors of the first element, before it is there.
const countErrors = (page) =>
  page.addInitScript(() => {
    window.errors = [];
    document.addEventListener(
      'error',
      ({ target, detail }) => target.localName === 'ray-caster' && window.errors.push(detail),
      { capture: true },
    );
  });
const errorsOf = (page) => page.evaluate(() => window.errors.map(({ code }) => code));
const failing = { expectErrors: true, prepare: countErrors };

const inFocus = (page) =>
  page.evaluate(() => {
    const inside = document.activeElement?.shadowRoot?.activeElement;
    return inside
      ? (inside.classList[inside.classList.length - 1] ?? inside.localName)
      : document.activeElement?.localName;
  });

for (const [name, bad, good] of [
  ['options', 'fov=wide', 'fov=75'],
  ['view', '1,2,0.5,0,0,attic', '3.5,3.5,0.5,0'],
]) {
  test(`a first load with a faulty ${name} shows its picture, and the corrected one takes effect`, async (t) => {
    const { page } = await openGuest(t, browser, {
      body: kRoom.replace('<ray-caster', `<ray-caster ${name}="${bad}"`),
      ...failing,
    });
    await stateIs(page, 'paused');
    const warnings = () =>
      page.evaluate(() =>
        document.querySelector('ray-caster').warnings.map(({ attribute }) => attribute),
      );
    assert.deepEqual(await warnings(), [name]);
    assert.deepEqual(await middle(page), kGreen);
    await page.evaluate(
      async ([attribute, value]) => {
        const element = document.querySelector('ray-caster');
        element.setAttribute(attribute, value);
        await new Promise((resolve) => setTimeout(resolve));
      },
      [name, good],
    );
    assert.deepEqual(await warnings(), []);
    assert.deepEqual(await middle(page), kGreen);
    assert.deepEqual(await errorsOf(page), []);
  });
}

for (const [what, attributes] of [
  ['that is not there', 'scene="nowhere"'],
  ['with an address that is none', 'scene="http://["'],
]) {
  test(`an error about a scene ${what} is reported once, whatever the page then writes about it`, async (t) => {
    const { page, server } = await openGuest(t, browser, { body: '', ...failing });
    await page.evaluate((markup) => {
      document.addEventListener(
        'error',
        ({ target, detail }) => {
          if (target.localName !== 'ray-caster') return;
          target.textContent = detail.message;
          target.label = `${detail.title} (${window.errors.length})`;
        },
        { capture: true },
      );
      document
        .querySelector('main')
        .insertAdjacentHTML('beforeend', `<ray-caster ${markup}></ray-caster>`);
    }, attributes);
    await stateIs(page, 'error');
    await wait(300);
    assert.equal((await errorsOf(page)).length, 1);
    assert.ok(server.asked.filter((path) => path === 'scenes/nowhere.json').length <= 1);
    await page.evaluate(() => {
      document.querySelector('ray-caster').label = 'Another';
    });
    await wait(200);
    assert.equal((await errorsOf(page)).length, 1);
    assert.ok(server.asked.filter((path) => path === 'scenes/nowhere.json').length <= 1);
    // But it can be requested again.
    await page.evaluate(() =>
      Object.assign(document.querySelector('ray-caster'), { scene: 'room', size: 'auto' }),
    );
    await stateIs(page, 'paused');
    await page.evaluate(() => {
      document.querySelector('ray-caster').scene = 'nowhere';
    });
    await stateIs(page, 'error');
  });
}

test('a failed scene that is requested again fails again; the current scene stays', async (t) => {
  const { page } = await openGuest(t, browser, failing);
  await ready(page);
  for (let round = 1; round <= 2; ++round) {
    await page.evaluate(() => {
      document.querySelector('ray-caster').scene = 'nowhere';
    });
    await stateIs(page, 'error');
    assert.equal((await errorsOf(page)).length, round);
    await page.evaluate(() => {
      document.querySelector('ray-caster').scene = 'room';
    });
    await stateIs(page, 'paused');
    assert.deepEqual(await middle(page), kGreen);
  }
});

test('a scene that another request overtakes is never shown', async (t) => {
  const { page } = await openGuest(t, browser, failing);
  await ready(page);
  const slowly = (milliseconds) => async (route) => {
    await wait(milliseconds);
    await route.continue();
  };
  await page.route('**/other.json', slowly(150));
  await page.route('**/tours/*.txt', slowly(700));
  await page.evaluate(async () => {
    const element = document.querySelector('ray-caster');
    element.scene = 'other';
    await new Promise((resolve) => setTimeout(resolve, 60));
    element.tour = 'nowhere';
  });
  await wait(500);
  assert.deepEqual(await middle(page), kGreen, 'the room stays while the tour is on its way');
  await page.waitForFunction(
    () => document.querySelector('ray-caster').world?.title === 'The other room',
  );
  await page.evaluate(() => {
    const element = document.querySelector('ray-caster');
    element.removeAttribute('tour');
    element.scene = 'room';
  });
  await stateIs(page, 'paused');
  assert.deepEqual(await middle(page), kGreen);
  assert.equal(
    await page.evaluate(() => document.querySelector('ray-caster').world.title),
    'The coloured room',
  );
  await page.evaluate(() => {
    document.querySelector('ray-caster').scene = 'other';
  });
  await until(page, () => document.querySelector('ray-caster').world?.title === 'The other room');
  assert.deepEqual(await middle(page), kBlue);
});

test('keyboard focus moves to the error message, and from its button to the cover', async (t) => {
  let isThere = true;
  const { page } = await openGuest(t, browser, {
    ...failing,
    server: {
      files: { 'scenes/third.json': () => (isThere ? JSON.stringify(roomScene()) : null) },
    },
  });
  await ready(page);
  isThere = false;
  await page.keyboard.press('Tab');
  assert.equal(await inFocus(page), 'cover');
  await page.evaluate(() => {
    document.querySelector('ray-caster').scene = 'third';
  });
  await stateIs(page, 'error');
  assert.equal(await inFocus(page), 'message');
  isThere = true;
  await page.keyboard.press('Tab');
  assert.equal(await inFocus(page), 'again');
  await page.keyboard.press('Enter');
  assert.equal(await inFocus(page), 'cover');
  await stateIs(page, 'paused');
  assert.equal(await inFocus(page), 'cover');

  // A focus elsewhere stays there.
  await page.evaluate(() => {
    document.querySelector('main').insertAdjacentHTML('beforeend', '<input>');
    document.querySelector('input').focus();
    document.querySelector('ray-caster').scene = 'nowhere';
  });
  await stateIs(page, 'error');
  assert.equal(await inFocus(page), 'input');
});

test('autoplay waits until the element comes near', async (t) => {
  const { page, server } = await openGuest(t, browser, {
    body: `<p style="height: 4000px">Read on.</p>${kRoom.replace('scene', 'autoplay scene')}`,
  });
  await page.evaluate(() => customElements.whenDefined('ray-caster'));
  await wait(300);
  assert.deepEqual(
    server.asked.filter((path) => /engine\/|scenes\//.test(path)),
    [],
  );
  await page.evaluate(() => document.querySelector('ray-caster').scrollIntoView());
  await stateIs(page, 'playing');
});

test('a tour that was recorded in another scene is left out', async (t) => {
  const tour =
    'slicecast recording 1\nscene other\n100 forward 256\nmark there 0123456789abcdef\nend 100 0123456789abcdef\n';
  const { page } = await openGuest(t, browser, {
    body: kRoom.replace('scene', 'tour="mine" scene'),
    ...failing,
    server: { files: { 'tours/mine.txt': tour } },
  });
  await stateIs(page, 'paused');
  const [{ attribute, message }] = await page.evaluate(
    () => document.querySelector('ray-caster').warnings,
  );
  assert.equal(attribute, 'tour');
  assert.deepEqual(await middle(page), kGreen);
  assert.match(message, /mine\.txt was recorded in the scene other, not in room\./);
  await page.evaluate(() => document.querySelector('ray-caster').removeAttribute('scene'));
  await page.waitForFunction(
    () => document.querySelector('ray-caster').world?.title === 'The other room',
  );
});

test('a scene elsewhere in the page works like one inside the element: with the shipped pictures', async (t) => {
  const { page } = await openGuest(t, browser, { body: '<ray-caster></ray-caster>', ...failing });
  const show = async (scheme, scene) => {
    await page.evaluate(
      ([kind, text]) => {
        window.errors.length = 0;
        document.querySelector('ray-caster').scene =
          kind === 'blob'
            ? URL.createObjectURL(new Blob([text]))
            : `data:application/json,${encodeURIComponent(text)}`;
      },
      [scheme, JSON.stringify(scene)],
    );
  };
  for (const scheme of ['blob', 'data']) {
    await show(scheme, roomScene());
    await until(
      page,
      () =>
        document.querySelector('ray-caster').world !== null &&
        document.querySelector('ray-caster').state === 'paused',
    );
    assert.deepEqual(await middle(page), kGreen);
    await show(scheme, roomScene({ folder: 'nowhere/' }));
    await until(page, () => window.errors.length > 0);
    const [{ code, faults }] = await page.evaluate(() => window.errors);
    assert.equal(code, 'scene');
    assert.equal(faults.length, 5);
    assert.ok(
      faults.every(({ place }) => place.startsWith(`${scheme}: address:1:`)),
      JSON.stringify(faults[0]),
    );
  }
});

test('pause() cancels a press while steering.js is still loading', async (t) => {
  const { page } = await openGuest(t, browser);
  await ready(page);
  let arrive;
  const asked = new Promise((resolve) => {
    page.route('**/ray-caster-steering.js', (route) => {
      arrive = () => route.continue();
      resolve();
    });
  });
  await page.click('ray-caster');
  await asked;
  await page.evaluate(() => document.querySelector('ray-caster').pause());
  assert.equal(
    await page.evaluate(() =>
      document.querySelector('ray-caster').shadowRoot.querySelector('.waiting'),
    ),
    null,
  );
  await arrive();
  await until(
    page,
    () => document.querySelector('ray-caster').shadowRoot.querySelector('.leave') !== null,
  );
  await wait(100);
  assert.equal(await page.evaluate(() => document.querySelector('ray-caster').state), 'paused');
  await page.click('ray-caster');
  await stateIs(page, 'playing');
});

test('a second press while steering.js is still loading changes nothing', async (t) => {
  const { page } = await openGuest(t, browser);
  await ready(page);
  await page.route('**/ray-caster-steering.js', async (route) => {
    await wait(300);
    await route.continue();
  });
  await page.click('ray-caster', { clickCount: 2 });
  await stateIs(page, 'playing');
  await wait(200);
  assert.equal(await page.evaluate(() => document.querySelector('ray-caster').state), 'playing');
});

test('Play in the bar, by a finger, shows the touch controls', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: kRoom.replace('scene', 'controls scene'),
    viewport: { width: 390, height: 844 },
    context: { isMobile: true, hasTouch: true },
  });
  await ready(page);
  const playButton = page.locator('ray-caster').getByRole('button', { name: 'Play', exact: true });
  await playButton.tap();
  await stateIs(page, 'playing');
  assert.equal(await page.locator('ray-caster [data-thumb="walk"]').isVisible(), true);
  assert.equal(
    await page.locator('ray-caster').getByRole('button', { name: 'Leave the picture' }).isVisible(),
    true,
  );
  await page.locator('ray-caster').getByRole('button', { name: 'Leave the picture' }).tap();
  await stateIs(page, 'paused');
});

test('in the document of a frame that it was moved to, the mouse turns the view', async (t) => {
  const frame = guestPage('', { script: '' });
  const { page } = await openGuest(t, await withWindows(t), {
    body: `${kRoom}<iframe name="inner" src="inner.html" width="500" height="400"></iframe>`,
    server: { files: { 'inner.html': frame } },
  });
  await ready(page);
  await page.evaluate(() => {
    const element = document.querySelector('ray-caster');
    document.querySelector('iframe').contentDocument.querySelector('main').append(element);
    window.moved = element;
    return element.whenReady();
  });
  const inner = page.frame('inner');
  await inner.click('ray-caster');
  await until(page, () => window.moved.state === 'playing');
  await inner.click('ray-caster');
  await until(page, () => window.moved.shadowRoot.pointerLockElement !== null);
  const { x, y } = await page.locator('iframe').boundingBox();
  await page.mouse.move(x + 200, y + 200);
  await page.mouse.move(x + 280, y + 200, { steps: 4 });
  await until(page, () => window.moved.currentView.heading > 5);
  await page.evaluate(() => window.moved.pause());
  await until(page, () => window.moved.shadowRoot.pointerLockElement === null);
});

test('a size that was removed while the element was out of the page has no effect', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: '<ray-caster scene="room" size="640x200" style="width: 320px"></ray-caster>',
  });
  await ready(page);
  const height = () =>
    page.evaluate(() => document.querySelector('ray-caster').getBoundingClientRect().height);
  assert.equal(await height(), 100);
  await page.evaluate(async () => {
    const element = document.querySelector('ray-caster');
    element.remove();
    await new Promise((resolve) => setTimeout(resolve, 50));
    element.removeAttribute('size');
    document.querySelector('main').append(element);
    await element.whenReady();
  });
  assert.equal(await height(), 200);
});

test('progress only grows, in share and bytes, and is reported once', async (t) => {
  const { page } = await openGuest(t, browser, {
    prepare: (opened) =>
      opened.addInitScript(() => {
        window.steps = [];
        document.addEventListener(
          'progress',
          ({ target, detail }) =>
            target.localName === 'ray-caster' && window.steps.push([detail.share, detail.bytes]),
          { capture: true },
        );
      }),
  });
  await ready(page);
  const steps = await page.evaluate(() => window.steps);
  assert.ok(steps.length > 5 && steps.at(-1)[0] === 1, JSON.stringify(steps));
  for (let i = 1; i < steps.length; ++i) {
    assert.ok(
      steps[i][0] >= steps[i - 1][0] && steps[i][1] >= steps[i - 1][1],
      JSON.stringify(steps),
    );
    assert.notDeepEqual(steps[i], steps[i - 1]);
  }
});

test('a bar that fails to load is reported once, whatever the page writes about it; another try requests it again', async (t) => {
  let isThere = false;
  const { page, server } = await openGuest(t, browser, {
    body: kRoom.replace('scene', 'controls scene'),
    ...failing,
    server: {
      files: {
        'ray-caster-steering.js': () =>
          isThere
            ? readFileSync(new URL('../../build/web/ray-caster-steering.js', import.meta.url))
            : null,
      },
    },
  });
  await page.evaluate(() => {
    const element = document.querySelector('ray-caster');
    element.addEventListener('error', ({ detail }) => {
      element.textContent = `${detail.message} ${performance.now()}`;
    });
  });
  await stateIs(page, 'error');
  await wait(300);
  assert.deepEqual(await errorsOf(page), ['fetch']);
  assert.equal(await page.evaluate(() => document.querySelector('ray-caster').state), 'error');
  const asked = server.asked.filter((path) => path === 'ray-caster-steering.js').length;
  assert.ok(asked <= 4, `${asked} requests`); // and why it did not come
  isThere = true;
  await page.getByRole('button', { name: 'Try again' }).click();
  await stateIs(page, 'paused');
  await page.locator('ray-caster').getByRole('button', { name: 'Play', exact: true }).waitFor();
});

test('a bar that loads after all clears the error', async (t) => {
  let isThere = false;
  const { page } = await openGuest(t, browser, {
    body: kRoom.replace('scene', 'controls scene'),
    ...failing,
    server: {
      files: {
        'ray-caster-steering.js': () =>
          isThere
            ? readFileSync(new URL('../../build/web/ray-caster-steering.js', import.meta.url))
            : null,
      },
    },
  });
  await stateIs(page, 'error');
  isThere = true;
  await page.hover('ray-caster');
  await stateIs(page, 'paused');
});

test('settings by methods and keys stay, whatever else changes in the element', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: '<ray-caster scene="room" options="fov=90" overlay="minimap" view="4,4,0.6,0"><p>A room</p></ray-caster>',
    ...failing,
  });
  await ready(page);
  const options = () =>
    page.evaluate(async () => {
      const element = document.querySelector('ray-caster');
      await element.whenReady();
      return [element.get('fov'), element.get('minimap'), element.currentView.x];
    });
  assert.deepEqual(await options(), ['90', 'on', 4]);
  await page.evaluate(() => {
    const element = document.querySelector('ray-caster');
    element.set('fov', 60);
    element.set('minimap', false);
    element.look({ x: 2 });
  });
  for (const change of [
    "label = 'Another'",
    "querySelector('p').textContent = 'A hall'",
    'overlay = element.overlay',
  ]) {
    await page.evaluate(
      (act) => new Function('element', `element.${act}`)(document.querySelector('ray-caster')),
      change,
    );
    await settled(page);
    assert.deepEqual(await options(), ['60', 'off', 2], change);
  }
  await page.evaluate(() => {
    document.querySelector('ray-caster').options = 'fov=75';
  });
  await settled(page);
  assert.deepEqual(
    await options(),
    ['75', 'on', 2],
    'a new attribute counts, with those beside it',
  );
  // Partly refused options leave nothing behind once removed
  for (const text of ['fov=90 nosuch=1', 'fov=75']) {
    await page.evaluate((wanted) => {
      document.querySelector('ray-caster').options = wanted;
    }, text);
    await settled(page);
  }
  assert.equal((await options())[0], '75');
  // The same view once more, after none
  for (const view of ['', '4,4,0.6,0']) {
    await page.evaluate((text) => {
      document.querySelector('ray-caster').view = text;
    }, view);
    await settled(page);
  }
  assert.equal((await options())[2], 4);
});

test('play() before it is in the page loads it once it is added', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: '<p style="height: 4000px">Read on.</p><div id="place"></div>',
  });
  const states = await page.evaluate(async () => {
    await customElements.whenDefined('ray-caster');
    const found = [];
    for (const ask of ['whenReady', 'play']) {
      const element = document.createElement('ray-caster');
      element.scene = 'room';
      const asked = element[ask]();
      document.querySelector('#place').append(element);
      await (asked ?? new Promise((resolve) => element.addEventListener('ready', resolve)));
      found.push(element.state);
    }
    return found;
  });
  assert.deepEqual(states, ['paused', 'playing']);
});

test('a scene that goes on after another one failed can still be shared with another element', async (t) => {
  const { page } = await openGuest(t, browser, {
    ...failing,
    server: { files: { 'scenes/broken.json': '{"title": 3}' } },
  });
  await ready(page);
  await page.evaluate(() => {
    document.querySelector('ray-caster').scene = 'broken';
  });
  await stateIs(page, 'error');
  await page.evaluate(() => {
    document.querySelector('ray-caster').scene = 'room';
  });
  await stateIs(page, 'paused');
  const shares = await page.evaluate(async () => {
    const found = [];
    const element = document.createElement('ray-caster');
    element.scene = 'room';
    element.addEventListener('progress', ({ detail }) => found.push(detail.share));
    document.querySelector('main').append(element);
    await element.whenReady();
    return found;
  });
  assert.deepEqual(shares, [0, 0.5, 1], 'no picture is loaded again');
});

test('another try asks the server, whatever the browser has kept', async (t) => {
  let scene = '{"title": 3}';
  const { page, server } = await openGuest(t, browser, {
    ...failing,
    server: {
      headers: { 'Cache-Control': 'max-age=600' },
      files: { 'scenes/room.json': () => scene },
    },
  });
  await stateIs(page, 'error');
  scene = JSON.stringify(roomScene());
  await page.getByRole('button', { name: 'Try again' }).click();
  await stateIs(page, 'paused');
  assert.equal(server.asked.filter((path) => path === 'scenes/room.json').length, 2);
});

test("what else a page's policy refuses is not taken for the cause", async (t) => {
  const other = await serve({ files: { 'scenes/room.json': JSON.stringify(roomScene()) } });
  t.after(() => other.close());
  const { page } = await openGuest(t, browser, {
    body: `<ray-caster scene="${other.address}scenes/room.json" style="width: 320px"></ray-caster>`,
    ...failing,
    head: '<script src="tracker.js"></script>',
    server: {
      headers: { 'Content-Security-Policy': "img-src 'self'" },
      files: {
        'tracker.js': `setInterval(() => { new Image().src = 'http://tracker.invalid/' + Math.random(); }, 1);`,
      },
    },
  });
  await stateIs(page, 'error');
  assert.deepEqual(await errorsOf(page), ['cors']);
});

test('in a template it waits for a window', async (t) => {
  const { page } = await openGuest(t, browser);
  await ready(page);
  await page.evaluate(async () => {
    const element = document.querySelector('ray-caster');
    document.createElement('template').content.append(element);
    await Promise.resolve();
    document.querySelector('main').append(element);
    await element.whenReady();
  });
  assert.deepEqual(await middle(page), kGreen);
  assert.equal(
    await page.evaluate(
      () => document.querySelector('ray-caster').shadowRoot.querySelector('.box').offsetWidth,
    ),
    320,
  );
});
