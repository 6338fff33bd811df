// Hotspots, views
// that move together, interaction, and pages that load nothing before a click.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { frames, launch } from './browser.mjs';
import { inElementState, openElements, ready } from './element.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// From (2.5, 3.5) one looks east: a block at (5, 3), and the wall behind it at x = 8.
const kYard = `
#########
#.......#
#.......#
#.>..b..#
#.......#
#.......#
#########
--- colours`.replaceAll('>', '&gt;');

// Where the hotspots are, in parts of the element's box; null for those that do not show.
const spots = (page) =>
  page.evaluate(() => {
    const a = document.getElementById('a');
    const box = a.getBoundingClientRect();
    return Object.fromEntries(
      [...a.querySelectorAll('[data-at]')].map((child) => {
        const { x, y, width, height } = child.getBoundingClientRect();
        const isShown =
          child.assignedSlot !== null &&
          getComputedStyle(child.assignedSlot.parentElement).visibility === 'visible';
        return [
          child.id,
          isShown
            ? [(x + width / 2 - box.x) / box.width, (y + height / 2 - box.y) / box.height]
            : null,
        ];
      }),
    );
  });

test('hotspots stand on their places, follow the view, hide when covered, and can be pressed', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    `<ray-caster id="a" size="320x200" style="width: 640px"><pre>${kYard}</pre>
       <button id="ahead" data-at="5,3.5,0.5">On the block</button>
       <button id="left" data-at="5, 2.3, 0.5">Left of it</button>
       <button id="covered" data-at="7,3.5,0.5">Behind it</button>
       <button id="above" data-at="7,3.5,1.9">Above it</button>
       <button id="back" data-at="1.2,3.5,0.5">Behind one's back</button>
       <button id="elsewhere" data-at="5,3.5,0.5,cellar">In another map</button>
       <a id="wrong" data-at="here">Nowhere</a><p>Words</p></ray-caster>`,
    { context: { reducedMotion: 'reduce' } },
  );
  await ready(page, 'a');
  await page.waitForFunction(
    () => document.getElementById('ahead').assignedSlot?.parentElement.className === 'hotspot',
  );
  // 60 degrees from left to right
  const d = 0.5 / Math.tan(Math.PI / 6);
  const eye = await page.evaluate(() => document.getElementById('a').currentView);
  const at = (x, y, z) => {
    const depth = x - eye.x;
    return [0.5 + ((y - eye.y) / depth) * d, 0.5 - (((z - eye.z) / depth) * d * 320) / 200];
  };
  const close = (found, expected, name) =>
    found.forEach((one, axis) =>
      assert.ok(Math.abs(one - expected[axis]) < 0.004, `${name}: ${found}, not ${expected}`),
    );
  const seen = await spots(page);
  close(seen.ahead, at(5, 3.5, 0.5), 'ahead');
  close(seen.left, at(5, 2.3, 0.5), 'left');
  close(seen.above, at(7, 3.5, 1.9), 'above');
  assert.deepEqual(
    ['covered', 'back', 'elsewhere', 'wrong'].filter((id) => seen[id] !== null),
    [],
  );
  assert.deepEqual(await page.evaluate(() => document.getElementById('a').warnings), [
    { attribute: 'data-at', message: "Found 'here', expected x,y,z or x,y,z,map." },
  ]);

  // From behind the block it is the other way round.
  await page.evaluate(() => document.getElementById('a').look('7,2.2,0.5,100'));
  await frames(page);
  const turned = await spots(page);
  assert.deepEqual([turned.ahead, turned.left], [null, null]);
  assert.ok(turned.covered !== null);

  // They can be pressed, and so can the picture beside them.
  await page.evaluate(() => {
    document.getElementById('a').look('2.5,3.5,0.5,0');
    document.getElementById('ahead').addEventListener('click', () => {
      document.title = 'pressed';
    });
  });
  await frames(page);
  await page.click('#ahead');
  assert.equal(await page.title(), 'pressed');
  assert.equal(await page.evaluate(() => document.getElementById('a').state), 'paused');

  // Moved, taken away, added.
  await page.evaluate(() => {
    document.getElementById('ahead').dataset.at = '8,2,0.5';
    document.getElementById('left').remove();
    const label = Object.assign(document.createElement('span'), { id: 'new', textContent: 'New' });
    label.dataset.at = '8,5,0.5';
    document.getElementById('a').append(label);
  });
  await frames(page);
  const moved = await spots(page);
  close(moved.ahead, at(8, 2, eye.z), 'moved');
  assert.ok(moved.new !== null);
  assert.ok(!('left' in moved));
  assert.equal(
    await page.locator('#a').getByText('Words', { exact: true }).isVisible(),
    false,
    'other children stay hidden',
  );
});

test('two views move together, whichever is moved', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    `<ray-caster id="first" scene="room" size="64x40" syncwith="#second" options="method=classic"></ray-caster>
     <ray-caster id="second" scene="room" size="64x40" view="2.5,4.5,0.6,30"></ray-caster>
     <ray-caster id="third" scene="room" size="64x40" syncwith="#first"></ray-caster>
     <ray-caster id="alone" scene="room" size="64x40" syncwith="#nobody"></ray-caster>`,
  );
  for (const id of ['first', 'second', 'third', 'alone']) await ready(page, id);
  const areAt = (x, heading) =>
    page.waitForFunction(
      ([east, turn]) =>
        ['first', 'second', 'third'].every((id) => {
          const view = document.getElementById(id).currentView;
          return view.x === east && view.heading === turn;
        }),
      [x, heading],
    );
  await areAt(2.5, 30);
  for (const [id, x, heading] of [
    ['second', 3.5, 60],
    ['first', 1.75, 200],
    ['third', 4.25, 90],
  ]) {
    await page.waitForTimeout(250);
    await page.evaluate(
      ([which, east, turn]) => document.getElementById(which).look({ x: east, heading: turn }),
      [id, x, heading],
    );
    await areAt(x, heading);
  }
  const found = await page.evaluate(() => {
    const { currentView, warnings } = document.getElementById('alone');
    return [currentView.x, warnings];
  });
  assert.deepEqual(found, [
    3.5,
    [{ attribute: 'syncwith', message: "'#nobody' finds no other <ray-caster>." }],
  ]);
  // No longer.
  await page.evaluate(() => {
    document.getElementById('first').syncwith = '';
  });
  await ready(page, 'first');
  await page.waitForTimeout(250);
  await page.evaluate(() => document.getElementById('second').look({ heading: 10 }));
  await frames(page, 6);
  assert.equal(await page.evaluate(() => document.getElementById('first').currentView.heading), 90);
});

test('the follower shows the view in the same frame, and draws it once', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    `<ray-caster id="first" scene="room" size="64x40" syncwith="#second"></ray-caster>
     <ray-caster id="second" scene="room" size="64x40" view="2.5,4.5,0.6,30"></ray-caster>`,
  );
  for (const id of ['first', 'second']) await ready(page, id);
  await page.waitForTimeout(250);
  // The headings that each has drawn, by the frame's time, while one of them is turned.
  const turned = (id, plays) =>
    page.evaluate(
      async ([leader, isPlaying]) => {
        const elements = ['first', 'second'].map((name) => document.getElementById(name));
        const life = new AbortController();
        const drawn = elements.map((element) => {
          const headings = [];
          element.addEventListener(
            'framechange',
            () =>
              headings.push(
                `${document.timeline.currentTime} ${Math.round(element.currentView.heading)}`,
              ),
            { signal: life.signal },
          );
          return headings;
        });
        for (const element of elements) element[isPlaying ? 'play' : 'pause']();
        for (let i = 0; i < 12; ++i) {
          document.getElementById(leader).look({ heading: 40 + i });
          await new Promise(requestAnimationFrame);
        }
        life.abort();
        return drawn.map((headings) => headings.filter((line) => / 4[4-9]$/.test(line)));
      },
      [id, plays],
    );
  for (const plays of [false, true]) {
    for (const id of ['second', 'first']) {
      const [first, second] = await turned(id, plays);
      assert.deepEqual(first, second, `${id} leads`);
      assert.equal(first.length, 6, `${first}`);
      await page.waitForTimeout(250);
    }
  }
});

test('interaction="none" shows no play sign and ignores presses, keys and touch', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    `<ray-caster id="a" scene="room" size="160x100" interaction="none"></ray-caster>
     <ray-caster id="bar" scene="room" size="160x100" interaction="none" keys="all" controls="play"></ray-caster>
     <button id="next">Next</button>`,
  );
  await ready(page, 'a');
  assert.equal(await page.locator('#a .glyph').isVisible(), false);
  await page.click('#a', { position: { x: 100, y: 60 } });
  await page.keyboard.press('ArrowLeft');
  await frames(page, 6);
  const state = () =>
    page.evaluate(() => {
      const { state: now, currentView } = document.getElementById('a');
      return [now, currentView.heading, document.activeElement.localName];
    });
  assert.deepEqual(await state(), ['paused', 0, 'body']);
  await page.keyboard.press('Tab');
  assert.notEqual(await page.evaluate(() => document.activeElement.id), 'a', 'Tab passes it by');
  assert.equal(
    await page.evaluate(() => {
      const { x, y, width, height } = document.getElementById('a').getBoundingClientRect();
      const { shadowRoot } = document.getElementById('a');
      const top = shadowRoot.elementFromPoint(x + width / 2, y + height / 2);
      return getComputedStyle(top).touchAction;
    }),
    'auto',
    'a finger scrolls the page',
  );
  // The bar's buttons act on the world: it runs, and the player stays.
  await page.locator('#bar').getByRole('button', { name: 'Play' }).click();
  await inElementState(page, 'bar', 'playing');
  await page.keyboard.down('ArrowLeft');
  await frames(page, 10);
  await page.keyboard.up('ArrowLeft');
  assert.equal(await page.evaluate(() => document.getElementById('bar').currentView.heading), 0);
  // It may change.
  await page.evaluate(() => {
    document.getElementById('a').interaction = 'walk';
  });
  await ready(page, 'a');
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  await page.evaluate(() => {
    document.getElementById('a').interaction = 'none';
  });
  await inElementState(page, 'a', 'paused');
});

test('interaction="look" looks around, but does not walk', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="room" size="160x100" interaction="look"></ray-caster>',
  );
  await ready(page, 'a');
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  const view = () => page.evaluate(() => document.getElementById('a').currentView);
  const start = await view();
  for (const key of ['w', 'a', 'Space', 'PageUp', 'v', 'ArrowRight']) await page.keyboard.down(key);
  await page.waitForFunction(() => document.getElementById('a').currentView.heading > 5);
  for (const key of ['w', 'a', 'Space', 'PageUp', 'v', 'ArrowRight']) await page.keyboard.up(key);
  await page.keyboard.press('m');
  const now = await view();
  assert.deepEqual([now.x, now.y, now.z], [start.x, start.y, start.z]);
  assert.equal(await page.evaluate(() => document.getElementById('a').get('minimap')), 'on');
});

test('loading="click" fetches nothing before a click', async (t) => {
  const { page, server } = await openElements(
    t,
    browser,
    `<ray-caster id="a" scene="room" size="160x100" loading="click" controls poster="favicon.svg"><b data-at="3,3,1">Here</b></ray-caster>
     <ray-caster id="asked" scene="room" size="160x100" loading="click"></ray-caster>`,
  );
  await page.waitForFunction(() => customElements.get('ray-caster') !== undefined);
  await page.hover('#a');
  await page.waitForTimeout(400);
  assert.deepEqual(
    server.asked.filter((name) => !['host.html', 'favicon.svg', 'ray-caster.js'].includes(name)),
    [],
  );
  assert.equal(await page.evaluate(() => document.getElementById('a').state), 'idle');
  await page.click('#a');
  await inElementState(page, 'a', 'playing');
  assert.equal(await page.evaluate(() => document.getElementById('asked').state), 'idle');
  assert.equal((await ready(page, 'asked')).title, 'The coloured room');
});
