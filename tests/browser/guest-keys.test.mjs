// Keys, focus, wheel and touch are left to the page until somebody gives them to
// <ray-caster>, and it gives them back.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { kRoom, openGuest, ready, stateOf, until, wait } from './guest-page.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const tall = '<p style="height: 3000px">Read on.</p>';
const middle = { position: { x: 160, y: 100 } };

const scrolled = (page) => page.evaluate(() => window.scrollY);
const headingOf = (page, selector = 'ray-caster') =>
  page.evaluate((which) => document.querySelector(which).currentView.heading, selector);
const focused = (page) =>
  page.evaluate(() => document.activeElement.id || document.activeElement.localName);

async function activate(page, selector = 'ray-caster') {
  await page.click(selector, middle);
  await until(page, (which) => document.querySelector(which).state === 'playing', selector);
}

async function hold(page, key, milliseconds = 250) {
  await page.keyboard.down(key);
  await wait(milliseconds);
  await page.keyboard.up(key);
}

test('arrows scroll the page unless somebody plays; then they turn the eye', async (t) => {
  const { page } = await openGuest(t, browser, { body: `${kRoom}${tall}` });
  await ready(page);
  await hold(page, 'ArrowDown');
  await until(page, () => window.scrollY > 0);
  assert.equal(await headingOf(page), 0);
  await page.evaluate(() => window.scrollTo(0, 0));

  await activate(page);
  const before = await scrolled(page);
  await hold(page, 'ArrowRight');
  await until(page, () => document.querySelector('ray-caster').currentView.heading > 5);
  for (const key of ['ArrowDown', 'ArrowUp', 'Space', 'PageDown', 'Home'])
    await hold(page, key, 60);
  assert.equal(await scrolled(page), before);

  // Escape leaves, and arrows scroll the page again.
  await page.keyboard.press('Escape');
  await page.keyboard.press('Escape'); // the first one may have given the pointer back
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  const heading = await headingOf(page);
  await hold(page, 'ArrowDown');
  await until(page, () => window.scrollY > 0);
  assert.equal(await headingOf(page), heading);
});

test('a text box in the page works, and the element gets none of its keys', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<label>Name <input id="text"></label>${kRoom}`,
  });
  await ready(page);
  await activate(page);
  await hold(page, 'KeyW', 60);
  await page.keyboard.press('Escape');
  await page.click('#text');
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  const before = await page.evaluate(() => ({
    ...document.querySelector('ray-caster').currentView,
  }));
  await page.keyboard.type('wasd maps, 12 tiles');
  await page.keyboard.press('ArrowLeft');
  assert.equal(await page.inputValue('#text'), 'wasd maps, 12 tiles');
  assert.deepEqual(
    await page.evaluate(() => ({ ...document.querySelector('ray-caster').currentView })),
    before,
  );
});

test('a text box works while an element plays', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<input id="text" aria-label="Name">${kRoom.replace('scene', 'autoplay scene')}`,
  });
  await ready(page);
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
  await page.click('#text');
  await page.keyboard.type('wasd maps');
  assert.equal(await page.inputValue('#text'), 'wasd maps');
  assert.equal(await stateOf(page), 'playing');
  assert.equal(await headingOf(page), 0);
});

const three = [1, 2, 3]
  .map(
    (number) =>
      `<ray-caster id="rc${number}" scene="room" loading="eager" controls style="width: 320px"></ray-caster>`,
  )
  .join('');

test('Tab moves through several elements, forward and back', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<a id="first" href="#x">first</a>${three}<a id="last" href="#y">last</a>`,
    viewport: { width: 800, height: 900 },
  });
  await ready(page);
  const walk = async (key, from, to) => {
    await page.focus(`#${from}`);
    const seen = [];
    for (let i = 0; i < 40 && seen.at(-1) !== to; ++i) {
      await page.keyboard.press(key);
      const id = await focused(page);
      if (id !== seen.at(-1)) seen.push(id);
    }
    return seen;
  };
  assert.deepEqual(await walk('Tab', 'first', 'last'), ['rc1', 'rc2', 'rc3', 'last']);
  assert.deepEqual(await walk('Shift+Tab', 'last', 'first'), ['rc3', 'rc2', 'rc1', 'first']);

  // During play too: Tab leaves the picture, which ends steering.
  await activate(page, '#rc2');
  await page.keyboard.press('Tab');
  for (let i = 0; i < 10 && (await focused(page)) === 'rc2'; ++i) await page.keyboard.press('Tab');
  assert.equal(await focused(page), 'rc3');
  await until(page, () => document.querySelector('#rc2').state === 'paused');
});

test('Enter plays, without a mouse; Escape leaves and the focus stays', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: `<a id="first" href="#x">first</a>${kRoom}<a id="last" href="#y">last</a>`,
  });
  await ready(page);
  await page.focus('#first');
  await page.keyboard.press('Tab');
  assert.equal(await focused(page), 'ray-caster');
  await hold(page, 'KeyD', 100); // before it has the keys
  assert.equal(await stateOf(page), 'paused');
  await page.keyboard.press('Enter');
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
  await hold(page, 'ArrowRight');
  await until(page, () => document.querySelector('ray-caster').currentView.heading > 5);
  await page.keyboard.press('Escape');
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  assert.equal(await focused(page), 'ray-caster');
  await page.keyboard.press('Tab');
  assert.equal(await focused(page), 'last');
});

test('Space on the cover plays too, and does not scroll', async (t) => {
  const { page } = await openGuest(t, browser, { body: `${kRoom}${tall}` });
  await ready(page);
  await page.keyboard.press('Tab');
  await page.keyboard.press('Space');
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
  assert.equal(await scrolled(page), 0);
});

test('only the element that somebody plays gets keys', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: three,
    viewport: { width: 800, height: 900 },
  });
  await ready(page);
  await activate(page, '#rc2');
  await hold(page, 'ArrowRight');
  await until(page, () => document.querySelector('#rc2').currentView.heading > 5);
  assert.deepEqual([await headingOf(page, '#rc1'), await headingOf(page, '#rc3')], [0, 0]);
});

test("the browser's keys still work", async (t) => {
  const { page } = await openGuest(t, browser, {});
  await ready(page);
  await activate(page);
  const kept = await page.evaluate(() => {
    const found = [];
    let target = document.activeElement;
    while (target.shadowRoot?.activeElement) target = target.shadowRoot.activeElement;
    for (const [code, modifiers] of [
      ['Tab', {}],
      ['KeyF', { ctrlKey: true }],
      ['KeyR', { metaKey: true }],
      ['ArrowLeft', { altKey: true }],
      ['F5', {}],
      ['F12', {}],
    ]) {
      const event = new KeyboardEvent('keydown', {
        code,
        key: code.replace('Key', ''),
        bubbles: true,
        composed: true,
        cancelable: true,
        ...modifiers,
      });
      target.dispatchEvent(event);
      if (event.defaultPrevented) found.push(code);
    }
    return found;
  });
  assert.deepEqual(kept, []);
});

for (const [keys, moves, shows] of [
  ['all', true, true],
  ['move', true, false],
  ['none', false, false],
]) {
  test(`keys="${keys}": ${moves ? 'they move' : 'none moves'}, ${shows ? 'and' : 'none'} changes options`, async (t) => {
    const { page } = await openGuest(t, browser, {
      body: `${kRoom.replace('scene', `keys="${keys}" scene`)}${tall}`,
    });
    await ready(page);
    await activate(page);
    const option = () => page.evaluate(() => document.querySelector('ray-caster').get('minimap'));
    const before = await option();
    await hold(page, 'KeyM', 60);
    await hold(page, 'ArrowRight', 300);
    if (moves)
      await until(page, () => document.querySelector('ray-caster').currentView.heading > 5);
    else assert.equal(await headingOf(page), 0);
    assert.equal((await option()) !== before, shows);
    await page.keyboard.press('Escape');
    await page.keyboard.press('Escape');
    await until(page, () => document.querySelector('ray-caster').state === 'paused');
  });
}

test('the wheel scrolls the page, before and during play', async (t) => {
  const { page } = await openGuest(t, browser, { body: `${kRoom}${tall}` });
  await ready(page);
  await page.hover('ray-caster', middle);
  await page.mouse.wheel(0, 60);
  await until(page, () => window.scrollY > 0);
  assert.equal(await stateOf(page), 'paused');
});

const phone = {
  viewport: { width: 390, height: 844 },
  context: { isMobile: true, hasTouch: true },
};

test('a finger on the picture scrolls the page; a tap plays, and a button leaves', async (t) => {
  const { page, context } = await openGuest(t, browser, {
    body: `<ray-caster scene="room"></ray-caster>${tall}`,
    ...phone,
  });
  await ready(page);
  const session = await context.newCDPSession(page);
  const box = await page.locator('ray-caster').boundingBox();
  const swipe = async () => {
    const x = box.x + box.width / 2;
    const y = box.y + box.height - 20;
    await session.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] });
    for (let i = 1; i <= 6; ++i)
      await session.send('Input.dispatchTouchEvent', {
        type: 'touchMove',
        touchPoints: [{ x, y: y - 20 * i }],
      });
    await session.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
    await wait(150);
  };
  await swipe();
  await until(page, () => window.scrollY > 40);
  assert.equal(await stateOf(page), 'paused');
  await wait(500); // it rolls on for a while
  await page.evaluate(() => window.scrollTo(0, 0));

  await page.tap('ray-caster');
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
  const before = await scrolled(page);
  await swipe();
  assert.equal(await scrolled(page), before);
  const leave = page.getByRole('button', { name: /leave/i });
  await leave.tap();
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  await page.evaluate(() => window.scrollTo(0, 0));
  await swipe();
  await until(page, () => window.scrollY > 40);
});

// The visible colours along the element's edge, as one text.
async function edge(page, selector = 'ray-caster') {
  const picture = await page
    .locator(selector)
    .screenshot({ animations: 'disabled', caret: 'hide' });
  return page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    return [...context.getImageData(20, 1, image.width - 40, 1).data].join();
  }, picture.toString('base64'));
}

test('the focus is visible: a ring on the cover, and on the picture during play', async (t) => {
  const { page } = await openGuest(t, browser, {});
  await ready(page);
  const plain = await edge(page);
  await page.keyboard.press('Tab');
  assert.notEqual(await edge(page), plain);
  await page.keyboard.press('Enter');
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
  await wait(100);
  assert.notEqual(await edge(page), plain);
  await page.keyboard.press('Escape');
  await page.keyboard.press('Tab');
  await page.evaluate(() => document.activeElement.blur());
  await until(page, () => document.querySelector('ray-caster').state === 'paused');
  assert.equal(await edge(page), plain);
});

test('with reduced motion, autoplay waits', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: kRoom.replace('scene', 'autoplay scene'),
    context: { reducedMotion: 'reduce' },
  });
  await ready(page);
  await wait(300);
  assert.equal(await stateOf(page), 'paused');
  await page.evaluate(() => document.querySelector('ray-caster').play());
  await until(page, () => document.querySelector('ray-caster').state === 'playing');
});

test('for screen readers: a name, and a live text when the player has come to rest', async (t) => {
  const { page } = await openGuest(t, browser, {
    body: kRoom.replace('scene', 'label="A room with four colours" scene'),
  });
  await ready(page);
  const live = () => {
    const texts = [
      ...document.querySelector('ray-caster').shadowRoot.querySelectorAll('[aria-live]'),
    ].map((element) => element.textContent);
    return texts.find((text) => /Facing/.test(text)) ?? '';
  };
  assert.equal(
    await until(page, live),
    'The coloured room. Facing east. Ahead: wall at 2.5 units. To the left: wall at 2.5 units. To the right: wall at 2.5 units.',
  );
  const snapshot = await page.locator('main').ariaSnapshot();
  assert.match(snapshot, /A room with four colours/);
  await activate(page);
  await hold(page, 'ArrowRight', 400);
  await until(page, () =>
    [
      ...document.querySelector('ray-caster').shadowRoot.querySelectorAll('[aria-live="polite"]'),
    ].some(
      (element) => /Facing/.test(element.textContent) && !/Facing east\./.test(element.textContent),
    ),
  );
});
