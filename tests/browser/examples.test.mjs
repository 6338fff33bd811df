// The lessons: each can be read and tried, and its figures show the engine's own numbers.

import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { launch, openPage } from './browser.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const kLessons = ['one-ray', 'walls-and-floor', 'heights-and-hits'];
const kDesktop = { width: 1280, height: 720 };
const kPhone = { width: 390, height: 844 };

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// With every picture drawn, also those further down.
async function openLesson(t, name, options = {}) {
  const opened = await openPage(t, browser, {
    query: `examples/${name}.html`,
    viewport: kDesktop,
    ...options,
  });
  await opened.page.evaluate(() =>
    Promise.all([...document.querySelectorAll('ray-caster')].map((caster) => caster.whenReady())),
  );
  await opened.page.waitForFunction(() =>
    [...document.querySelectorAll('svg.drawn')].every((svg) => svg.childElementCount > 0),
  );
  return opened;
}

// Moves a slider as a user would, and waits for the effect.
async function slide(page, id, value) {
  await page.evaluate(
    ([name, wanted]) => {
      const input = document.getElementById(name);
      input.value = String(wanted);
      input.dispatchEvent(new Event('input', { bubbles: true }));
    },
    [id, value],
  );
  await page.evaluate(
    () => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))),
  );
}

const texts = (page, selector) =>
  page.evaluate(
    (wanted) => [...document.querySelectorAll(wanted)].map((element) => element.textContent),
    selector,
  );
const number = (text) => Number(text.replace('= ', '').replace('−', '-'));
const near = (found, expected, digits) =>
  assert.ok(
    Math.abs(found - expected) <= 0.5001 * 10 ** -digits,
    `found ${found}, expected ${expected}`,
  );

for (const name of kLessons) {
  for (const [device, viewport, colorScheme] of [
    ['desktop', kDesktop, 'light'],
    ['phone', kPhone, 'dark'],
  ]) {
    test(`${name} on a ${device}, ${colorScheme}: pictures are drawn, nothing overflows, axe finds nothing`, async (t) => {
      const { page } = await openLesson(t, name, {
        viewport,
        context: { colorScheme, isMobile: viewport === kPhone },
      });
      assert.ok(
        await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
        'it scrolls sideways',
      );
      const flat = await page.evaluate(() =>
        [...document.querySelectorAll('ray-caster')]
          .filter((caster) => {
            const canvas = caster.shadowRoot.querySelector('canvas');
            const pixels = new Uint32Array(
              canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer,
            );
            return new Set(pixels).size < 50;
          })
          .map((caster) => caster.id),
      );
      assert.deepEqual(flat, []);
      await page.addScriptTag({ path: kAxe });
      const { violations } = await page.evaluate(() =>
        window.axe.run(document, { resultTypes: ['violations'] }),
      );
      assert.deepEqual(
        violations.map(
          ({ id, nodes }) =>
            `${id}: ${nodes.map(({ html, failureSummary }) => `${html} ${failureSummary}`).join('; ')}`,
        ),
        [],
      );
    });
  }
}

test('the list links to the lessons, and works without scripts', async (t) => {
  const { page, server } = await openPage(t, browser, {
    query: 'examples/index.html',
    viewport: kPhone,
  });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  const addresses = await page.evaluate(() =>
    [...document.querySelectorAll('a[href]')].map(({ href }) => href),
  );
  for (const name of kLessons)
    assert.ok(addresses.includes(`${server.address}examples/${name}.html`), name);
  for (const address of new Set(addresses))
    assert.equal((await page.request.get(address)).status(), 200, address);
  assert.equal(
    await page.evaluate(() => [...document.images].every(({ naturalWidth }) => naturalWidth > 0)),
    true,
  );
  await page.addScriptTag({ path: kAxe });
  assert.deepEqual(
    await page.evaluate(async () => (await window.axe.run()).violations.map(({ id }) => id)),
    [],
  );
});

test('without JavaScript a lesson is text and pictures', async (t) => {
  for (const name of kLessons) {
    const { page } = await openPage(t, browser, {
      query: `examples/${name}.html`,
      viewport: kDesktop,
      context: { javaScriptEnabled: false },
    });
    const posters = await page.locator('ray-caster > img').all();
    assert.ok(posters.length > 0);
    for (const poster of posters) {
      await poster.scrollIntoViewIfNeeded();
      assert.ok((await poster.boundingBox()).width > 300, name);
    }
    for (const address of await page
      .locator('ray-caster > img')
      .evaluateAll((images) => images.map(({ src }) => src))) {
      assert.equal((await page.request.get(address)).status(), 200, address);
    }
    assert.equal(await page.isVisible('input[type=range]'), false, 'nothing that does nothing');
  }
});

test('posters are the pictures that the engine draws', async (t) => {
  for (const name of kLessons) {
    const { page } = await openLesson(t, name);
    const different = await page.evaluate(async () => {
      const pixels = async (blob) => {
        const image = await createImageBitmap(blob);
        const copy = new OffscreenCanvas(image.width, image.height).getContext('2d');
        copy.drawImage(image, 0, 0);
        return copy.getImageData(0, 0, image.width, image.height);
      };
      const names = [];
      for (const caster of document.querySelectorAll('ray-caster[poster]')) {
        const poster = await pixels(await (await fetch(caster.poster)).blob());
        const now = await pixels(
          await caster.snapshot({ width: poster.width, height: poster.height }),
        );
        if (poster.data.some((byte, index) => byte !== now.data[index])) names.push(caster.poster);
      }
      return names;
    });
    assert.deepEqual(different, [], 'node tools/lesson-posters.mjs draws them anew');
  }
});

test('one ray: plan, rulers and table show the engine’s walk', async (t) => {
  const { page } = await openLesson(t, 'one-ray');
  for (const [heading, share] of [
    [11, 0.5],
    [-40, 0.9],
    [150, 0.1],
    [90, 0.5],
  ]) {
    await slide(page, 'heading', heading);
    await slide(
      page,
      'column',
      await page.evaluate(
        (part) => Math.floor(part * document.getElementById('hall').picture.width),
        share,
      ),
    );
    const { walk, blueprint } = await page.evaluate(() => {
      const caster = document.getElementById('hall');
      const { walk: tiles, hits } = caster.trace(Number(document.getElementById('column').value));
      return { walk: tiles, blueprint: hits[0].blueprint };
    });
    assert.deepEqual(
      (await texts(page, '#depths td:last-child')).map(number),
      walk.slice(1).map(({ depth }) => Number(depth.toFixed(6))),
    );
    assert.ok(
      (await texts(page, '#depths td:last-child')).every((text) => text.startsWith('= ')),
      'the page’s quotient is the engine’s',
    );
    assert.deepEqual(
      (await texts(page, '#depths td:nth-child(2)')).map((text) => text[0]),
      walk.slice(1).map(({ axis }) => axis),
    );
    const lit = await page.evaluate(() =>
      [...document.querySelectorAll('#plan .lit')].map((tile) => [
        Number(tile.getAttribute('x')),
        Number(tile.getAttribute('y')),
      ]),
    );
    assert.deepEqual(
      lit,
      walk.map(({ tile }) => tile),
    );
    assert.equal(
      (await texts(page, '#rulers .across-mark, #rulers .along-mark')).length,
      walk.length - 1,
    );
    assert.match(
      await page.textContent('#plan-says'),
      new RegExp(`through ${walk.length} tiles and meets a ${blueprint}`),
    );
  }
});

test('one ray: the walk can be followed tile by tile, and the plan follows the picture', async (t) => {
  const { page } = await openLesson(t, 'one-ray');
  await slide(page, 'shown', 3);
  assert.deepEqual(await texts(page, '#plan .order'), ['1', '2', '3']);
  assert.equal(await page.textContent('output[for=shown]'), '3 tiles');
  await page.evaluate(() => document.getElementById('hall').step(60, { forward: 1 }));
  await page.waitForFunction(
    () => Number(document.querySelector('#plan .eye').getAttribute('cx')) > 1.8,
  );
  assert.equal(await page.locator('#plan .lit').count(), 3);
});

test('walls: the height for a depth is the one that the engine projects', async (t) => {
  const { page } = await openLesson(t, 'walls-and-floor');
  for (const depth of [1, 3, 7.5]) {
    await slide(page, 'depth', depth);
    const { rows, d } = await page.evaluate(() => {
      const caster = document.getElementById('near');
      const {
        hits: [hit],
        projectionDistance,
      } = caster.trace(Math.floor(caster.picture.width / 2));
      return { rows: hit.bottomFrontRow - hit.topFrontRow, d: projectionDistance };
    });
    near(rows, d / depth, 2);
    assert.match(await page.textContent('#height-sum'), new RegExp(`= ${rows.toFixed(1)}$`));
    assert.equal(await page.textContent('output[for=depth]'), `${depth.toFixed(2)} units`);
  }
});

test('walls: distance and depth of a slice, and what each makes of the wall', async (t) => {
  const { page } = await openLesson(t, 'walls-and-floor');
  await slide(page, 'slice', 20);
  const { hit, d } = await page.evaluate(() => {
    const { hits, projectionDistance } = document.getElementById('flat').trace(20);
    return { hit: hits[0], d: projectionDistance };
  });
  near(Number(await page.textContent('#length-depth')), hit.depth, 3);
  near(Number(await page.textContent('#length-distance')), hit.rawDepth, 3);
  near(Number(await page.textContent('#rows-depth')), hit.bottomFrontRow - hit.topFrontRow, 1);
  near(Number(await page.textContent('#rows-distance')), d / hit.rawDepth, 1);
  assert.ok(hit.rawDepth > 1.2 * hit.depth);
});

// The row in which the sky ends, in a column.
const topOfWall = (page, id, share) =>
  page.evaluate(
    ([name, part]) => {
      const canvas = document.getElementById(name).shadowRoot.querySelector('canvas');
      const { data } = canvas
        .getContext('2d')
        .getImageData(Math.floor(part * canvas.width), 0, 1, canvas.height);
      for (let row = 0; row < canvas.height; ++row) {
        if (data[4 * row] > data[4 * row + 2] + 20) return row; // brick is redder than any sky
      }
      return -1;
    },
    [id, share],
  );

test('walls: the switch chooses how the old picture is made', async (t) => {
  const { page } = await openLesson(t, 'walls-and-floor');
  const bend = async (id) => (await topOfWall(page, id, 0.02)) - (await topOfWall(page, id, 0.5));
  assert.ok(Math.abs(await bend('flat')) <= 1, 'the engine’s edge is straight');
  assert.ok((await bend('old')) > 10, 'fish eye');
  for (const [value, isStraight] of [
    ['equalAnglesCorrected', true],
    ['plane', true],
    ['equalAngles', false],
  ]) {
    await page.check(`[name=projection][value=${value}]`);
    assert.equal(
      await page.evaluate(() => document.getElementById('old').get('classic.projection')),
      value,
    );
    await page.waitForTimeout(50);
    assert.equal(Math.abs(await bend('old')) <= 1, isStraight, value);
  }
  await slide(page, 'turn', 20);
  await slide(page, 'fov', 70);
  const found = await page.evaluate(() =>
    [document.getElementById('flat'), document.getElementById('old')].map((caster) => [
      caster.currentView.heading,
      caster.get('fov'),
    ]),
  );
  assert.deepEqual(found, [
    [290, '70'],
    [290, '70'],
  ]);
});

test('walls: the depth of a row of the floor is the one that the engine drew', async (t) => {
  const { page } = await openLesson(t, 'walls-and-floor');
  const { run, height } = await page.evaluate(() => {
    const caster = document.getElementById('floor');
    const { runs, size } = caster.trace(Math.floor(caster.picture.width / 2));
    return { run: runs.find(({ what }) => what === 'floor'), height: size[1] };
  });
  for (const texel of run.texels) {
    await slide(page, 'row', texel.row);
    assert.equal(await page.textContent('output[for=row]'), `${texel.row} of ${height}`);
    near(Number(/= ([\d.]+)$/.exec(await page.textContent('#floor-sum'))[1]), texel.depth, 2);
  }
  await slide(page, 'row', 0);
  assert.match(await page.textContent('#floor-sum'), /never/);
});

test('heights: strip, side view and list show every run of the slice', async (t) => {
  const { page } = await openLesson(t, 'heights-and-hits');
  for (const share of [0.5, 0.3, 0.8]) {
    await slide(
      page,
      'column',
      await page.evaluate(
        (part) => Math.floor(part * document.getElementById('yard').picture.width),
        share,
      ),
    );
    const { hits, runs, height } = await page.evaluate(() => {
      const caster = document.getElementById('yard');
      const slice = caster.trace(Number(document.getElementById('column').value));
      return { hits: slice.hits, runs: slice.runs, height: slice.size[1] };
    });
    assert.equal(
      runs.reduce((sum, { first, last }) => sum + last - first + 1, 0),
      height,
    );
    assert.deepEqual(
      (await texts(page, '#strip text.soft')).sort(),
      runs.map(({ first, last }) => (first === last ? `${first}` : `${first}–${last}`)).sort(),
    );
    assert.equal(await page.locator('#side .wedge').count(), runs.length);
    assert.equal(await page.locator('#side .solid').count(), hits.length);
    const rows = await page.evaluate(() =>
      [...document.querySelectorAll('#hits tbody tr')].map((row) =>
        [...row.cells].map((cell) => cell.textContent),
      ),
    );
    assert.deepEqual(
      rows.map(([block, tile, level, , into]) => [block, tile, level, into]),
      hits.map((hit) => [
        hit.blueprint,
        hit.tile.join(', '),
        String(hit.level),
        hit.depth.toFixed(2),
      ]),
    );
    runs.forEach((run, index) => {
      if (run.hit !== null)
        assert.ok(
          rows[run.hit].at(-1).includes(`${index + 1}: ${run.what} ${run.first}–${run.last}`),
          `run ${index + 1}`,
        );
    });
  }
});

test('heights: fewer runs leave rows open', async (t) => {
  const { page } = await openLesson(t, 'heights-and-hits');
  await slide(page, 'filled', 2);
  assert.equal(await page.locator('#strip .run').count(), 2);
  assert.equal(await page.locator('#side .wedge').count(), 2);
  assert.equal(await page.locator('#hits tr.now').count(), 1);
  await slide(page, 'filled', 0);
  assert.equal(await page.locator('#strip .run').count(), 0);
});
