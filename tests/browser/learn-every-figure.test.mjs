// Every figure of every chapter, in a real page: it opens as the build has drawn it, each handle
// and control moves it and can be taken back, and its address brings a moved figure back.

import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { launch, openPage } from './browser.mjs';

const kModules = new URL('../../build/learn/', import.meta.url); // where the build has put them
const kLearn = new URL('../../web/learn/', import.meta.url);
const hasFigures = (folder) =>
  readFileSync(new URL(`${folder}/index.md`, kLearn), 'utf8').includes('\n::: figure ');
const kFolders = readdirSync(kLearn)
  .filter((folder) => /^\d\d-/.test(folder) && hasFigures(folder))
  .sort();
const kHandlePixels = 44;
const kAddressMilliseconds = 400; // figures write it a little after the last change
const kPolicy =
  "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; img-src 'self' blob: data:";

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

// ---- In the page

// Goes into the page as window.figures.
function inPage() {
  const kWalkHead = 'TileBorder(border − eye) ÷ rayDepthEngine';
  const plain = (text) => (text ?? '').replace(/\s+/g, ' ').trim();
  const figureOf = (name) => document.getElementById(name);
  const textOf = (node) => plain(node?.textContent);

  // What a figure says in words: the same in the page and in what the build has written.
  function told(root, name) {
    const figure = root.getElementById(name);
    return {
      says: textOf(figure.querySelector('.fig-says')),
      numbers: [...root.querySelectorAll(`output[data-number^="${name}."]`)].map(
        (output) => `${output.dataset.number} ${textOf(output)}`,
      ),
      panels: [...figure.querySelectorAll('.fig-panel.fig-panel .fig-body')].flatMap((body) => {
        const panel = body.closest('.fig-panel');
        if (panel.hidden || body.querySelector('.fig-frame, .fig-svg') !== null) return [];
        return [textOf(body)];
      }),
      titles: [...figure.querySelectorAll('.fig-panel:not([hidden]) > .fig-title')].map(textOf),
      controls: [...figure.querySelectorAll('[data-control]:not([hidden]) output')].map(textOf),
    };
  }

  // Everything that can be seen of a figure, except its pictures.
  function seen(name) {
    const figure = figureOf(name);
    const copy = figure.querySelector('.fig').cloneNode(true);
    const kUnseen = '.fig-spoken, .fig-tools, canvas, ray-caster, [hidden]';
    for (const node of copy.querySelectorAll(kUnseen)) node.remove();
    for (const node of copy.querySelectorAll('.held')) node.classList.remove('held');
    const inputs = [...figure.querySelectorAll('input')]
      .filter((input) => input.closest('[hidden]') === null)
      .map((input) => `${input.value} ${input.checked}`);
    return `${copy.innerHTML}\n${inputs.join()}\n${told(document, name).numbers.join()}`;
  }

  const drawn = () =>
    new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));

  async function pixelsOf(address) {
    const blob = await (await fetch(address)).blob();
    const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none' });
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const context = canvas.getContext('2d');
    context.drawImage(bitmap, 0, 0);
    return context.getImageData(0, 0, bitmap.width, bitmap.height);
  }

  function picture(frame) {
    const sides = [...frame.querySelectorAll('ray-caster, canvas')].map((node) => {
      const canvas = node.shadowRoot?.querySelector('canvas') ?? node;
      return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    });
    const [whole, right] = sides;
    if (right === undefined) return whole;
    const share = parseFloat(frame.style.getPropertyValue('--split')) / 100;
    const from = Math.round(share * whole.width);
    for (let y = 0; y < whole.height; ++y) {
      const at = 4 * (y * whole.width + from);
      whole.data.set(right.data.subarray(at, 4 * (y + 1) * whole.width), at);
    }
    return whole;
  }

  // How many pixels of the figure's pictures differ from those of the build: a list of complaints.
  async function pictureFaults(built, name) {
    const faults = [];
    const images = built.getElementById(name).querySelectorAll('.fig-frame img');
    const panels = [...images].map((image) => [image, image.closest('.fig-panel').dataset.panel]);
    for (const [image, key] of panels) {
      const frame = figureOf(name).querySelector(`[data-panel="${key}"] .fig-frame`);
      if (frame.closest('.fig-panel').hidden) continue;
      const expected = await pixelsOf(image.getAttribute('src'));
      const found = picture(frame);
      const sizes = [found, expected].map(({ width, height }) => `${width}x${height}`);
      if (sizes[0] !== sizes[1]) faults.push(`${name} ${key}: ${sizes.join(' is not ')}`);
      else {
        const [left, right] = [found, expected].map(({ data }) => new Uint32Array(data.buffer));
        const count = left.reduce((sum, colour, at) => sum + (colour === right[at] ? 0 : 1), 0);
        if (count > 0) faults.push(`${name} ${key}: ${count} pixels differ`);
      }
    }
    return faults;
  }

  // Whatever can be worked, by selectors that stay good while the figure changes.
  function parts(name) {
    const figure = figureOf(name);
    const isShown = (node) => node.closest('[hidden]') === null && node.checkVisibility();
    const all = (selector) => [...figure.querySelectorAll(selector)].filter(isShown);
    return {
      handles: all('.fig-handle').map((node) => {
        const { width, height } = node.getBoundingClientRect();
        const panel = node.closest('[data-panel]').dataset.panel;
        const { handle, axis } = node.dataset;
        return {
          selector: `#${name} [data-panel="${panel}"] [data-handle="${handle}"]`,
          width,
          height,
          axis,
          role: node.getAttribute('role'),
          label: node.getAttribute('aria-label'),
        };
      }),
    };
  }

  // The kit's tables of the walk that are shown, against what the element itself answers.
  // `opening`: {column, step} of each when it opens; the address tells what is so no longer.
  function tableFaults(name, opening) {
    const faults = [];
    const query = decodeURIComponent(location.search).slice(1).split('&');
    const own = query.find((part) => part.startsWith(`${name}=`)) ?? '';
    const told = (field) => new RegExp(`\\b${field}:(\\d*)`).exec(own)?.[1];
    for (const table of figureOf(name).querySelectorAll('[data-panel]:not([hidden]) .fig-table')) {
      if (textOf(table.querySelector('thead')) !== kWalkHead) continue;
      const caster = figureOf(name).querySelector('ray-caster');
      const column = told('column') ?? opening[name].column;
      const step = told('step') ?? opening[name].step;
      const walk = caster.trace(Number(column)).walk.slice(1);
      const expected = walk.slice(0, step === '' ? walk.length : Number(step));
      const rows = [...table.querySelectorAll('tbody tr')];
      if (rows.length !== expected.length || rows.length === 0)
        faults.push(`${name}: ${rows.length} rows, expected ${expected.length}`);
      rows.forEach((row, index) => {
        const { axis, depth } = expected[index] ?? {};
        const [, border, , , engine] = [...row.children].map(textOf);
        const isRight =
          border.includes(`${axis} =`) && engine.replace('= ', '') === depth?.toFixed(6);
        if (!isRight) faults.push(`${name}: ${border} ${engine} is not ${axis} ${depth}`);
      });
    }
    return faults;
  }

  // Brings every figure to life, as a reader who scrolls through the page.
  async function scroll(names) {
    for (const name of names) {
      const figure = figureOf(name);
      figure.scrollIntoView({ block: 'center' });
      while (figure.querySelector('.fig.live') === null) await drawn();
    }
    await drawn();
  }

  const kept = new Map();
  const keep = (name, as) => void kept.set(as, seen(name));
  // Whether a figure looks as when it was kept, once it has been drawn.
  async function isKept(name, as) {
    await drawn();
    return seen(name) === kept.get(as);
  }
  const reset = (name) => figureOf(name).querySelector('[data-tool=reset]')?.click();
  const builtPage = async () =>
    new DOMParser().parseFromString(await (await fetch(location.pathname)).text(), 'text/html');

  window.figures = { told, drawn, pictureFaults, tableFaults, parts, scroll };
  Object.assign(window.figures, { keep, isKept, reset, builtPage });
}

// ---- From outside

async function openChapter(t, name) {
  const { page } = await openPage(t, browser, {
    query: `learn/${name}.html`,
    server: {
      headersOf: (file) =>
        file.endsWith('run.html') ? {} : { 'Content-Security-Policy': kPolicy },
    },
    viewport: { width: 1280, height: 900 },
    context: { hasTouch: true },
  });
  const names = await see(page);
  return { page, names };
}

// Brings all figures to life; returns their names.
async function see(page) {
  await page.evaluate(inPage);
  const names = await page.$$eval('[data-figure]', (all) => all.map(({ id }) => id));
  await page.evaluate((all) => window.figures.scroll(all), names);
  return names;
}

// The figure's moving parts, each with what is wrong when it is used.
class Hands {
  faults = [];

  constructor(page, name) {
    this.page = page;
    this.name = name;
  }

  keep(as = 'opening') {
    return this.page.evaluate(([name, key]) => window.figures.keep(name, key), [this.name, as]);
  }

  isKept(as = 'opening') {
    return this.page.evaluate(([name, key]) => window.figures.isKept(name, key), [this.name, as]);
  }

  parts() {
    return this.page.evaluate((name) => window.figures.parts(name), this.name);
  }

  fault(text) {
    this.faults.push(`${this.name}: ${text}`);
  }

  // Resets, and expects the opening again.
  async reset(after) {
    await this.page.evaluate((name) => window.figures.reset(name), this.name);
    if (!(await this.isKept())) {
      this.fault(`after ${after}, Reset does not bring the opening back`);
      await this.keep();
    }
  }

  // Uses the keys in turn until one moves something; says whether one did.
  async press(keys) {
    for (const key of keys) {
      await this.page.keyboard.press(key);
      if (!(await this.isKept())) return true;
    }
    return false;
  }

  async useHandle({ selector, axis, role, label, width, height }) {
    if (role !== 'slider' || !label) this.fault(`${selector} does not say what it is`);
    if (Math.min(width, height) < kHandlePixels) this.fault(`${selector}: ${width} x ${height}`);
    await this.page.$eval(selector, (node) => node.focus());
    if (!(await this.press(arrowsOf(axis)))) this.fault(`${selector} (${label}) does nothing`);
    await this.page.keyboard.press('Escape');
    if (await this.isKept()) return;
    this.fault(`Escape does not take back ${selector}`);
    await this.reset(label);
  }

  async useInputs(selector, keys) {
    const all = await this.page.$$(`#${this.name} ${selector}`);
    for (const [index, input] of all.entries()) {
      if (!(await input.isVisible())) continue;
      await input.focus();
      if (!(await this.press(keys))) this.fault(`${selector} ${index} does nothing`);
      await this.reset(`${selector} ${index}`);
    }
  }

  // Presses each button and switch; one that has nothing to do yet, after another or a slider.
  async useButtons(selector) {
    const visible = async (which) => {
      const all = await this.page.$$(`#${this.name} ${which}`);
      const isVisible = await Promise.all(all.map((node) => node.isVisible()));
      return all.filter((_, index) => isVisible[index]);
    };
    const click = (button) => button.evaluate((node) => node.click());
    const all = await visible(selector);
    for (const [index, button] of all.entries()) {
      if (!(await button.isVisible())) continue;
      await click(button);
      let isMoved = !(await this.isKept());
      const others = isMoved ? [] : [...all, ...(await visible('input[type=range]'))];
      for (const other of others) {
        if (isMoved || other === button) continue;
        await click(other);
        await other.focus();
        await this.page.keyboard.press('ArrowLeft');
        await this.page.evaluate(() => window.figures.drawn());
        await this.keep('moved');
        await click(button);
        isMoved = !(await this.isKept('moved'));
      }
      if (!isMoved) this.fault(`${selector} ${index} does nothing`);
      await this.reset(`${selector} ${index}`);
    }
  }

  async drag({ selector }, touch = null) {
    const place = () =>
      this.page.$eval(selector, (node) =>
        ['style', 'aria-valuenow', 'aria-valuetext'].map((key) => node.getAttribute(key)).join(),
      );
    const before = await place();
    await this.page.$eval(selector, (node) => node.scrollIntoView({ block: 'center' }));
    const { x, y, width, height } = await this.page.locator(selector).boundingBox();
    const [fromX, fromY] = [x + width / 2, y + height / 2];
    for (const sign of [1, -1]) {
      const to = [fromX + 34 * sign, fromY + 26 * sign];
      await (touch === null ? mouseDrag : touchDrag)(this.page, [fromX, fromY], to, touch);
      await this.page.evaluate(() => window.figures.drawn());
      if ((await place()) !== before) break;
      if (sign < 0) this.fault(`${selector} cannot be dragged`);
    }
    await this.reset(`dragging ${selector}`);
  }
}

const arrowsOf = (axis) =>
  axis === 'y'
    ? ['ArrowUp', 'ArrowDown']
    : ['ArrowRight', 'ArrowLeft', ...(axis === 'x' ? [] : ['ArrowUp', 'ArrowDown'])];

async function mouseDrag(page, [x, y], [toX, toY]) {
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(toX, toY, { steps: 2 });
  await page.mouse.up();
}

async function touchDrag(page, [x, y], [toX, toY], client) {
  const send = (type, ...touchPoints) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints });
  await send('touchStart', { x, y });
  await send('touchMove', { x: (x + toX) / 2, y: (y + toY) / 2 });
  await send('touchMove', { x: toX, y: toY });
  await send('touchEnd');
}

// Moves whatever the figure has, and leaves it moved.
async function leaveMoved(page, name) {
  const { handles } = await page.evaluate((which) => window.figures.parts(which), name);
  for (const { selector, axis } of handles.slice(0, 3)) {
    const handle = await page.$(selector);
    if (!(await handle?.isVisible())) continue;
    await handle.focus();
    await page.keyboard.press(arrowsOf(axis)[0]);
  }
  const range = await page.$(`#${name} [data-control]:not([hidden]) input[type=range]`);
  await range?.focus();
  if (range !== null) await page.keyboard.press('ArrowLeft');
  const choice = `#${name} [data-control]:not([hidden]) input[type=radio]:not(:checked)`;
  await page.evaluate((selector) => document.querySelector(selector)?.click(), choice);
}

const allTold = (page, names) =>
  page.evaluate(async (all) => {
    await window.figures.drawn();
    return all.map((name) => window.figures.told(document, name));
  }, names);

const tableFaults = (page, names, openings) =>
  page.evaluate(
    ([all, each]) => all.flatMap((name) => window.figures.tableFaults(name, each)),
    [names, openings],
  );

// {name: {column, step}}: what figures show of a walk when they open.
async function openingsOf(folder, names) {
  const entries = names.map(async (name) => {
    const { default: figure } = await import(new URL(`${folder}/${name}.js`, kModules));
    const { column = (figure.size?.[0] ?? 480) >> 1, step = null } = figure.state ?? {};
    return [name, { column, step: step ?? '' }];
  });
  return Object.fromEntries(await Promise.all(entries));
}

for (const folder of kFolders) {
  const chapter = folder.slice(3);
  test(`${chapter}: every figure opens as built, moves, and comes back`, async (t) => {
    const { page, names } = await openChapter(t, chapter);
    const address = await page.evaluate(() => location.href);

    const openings = await openingsOf(folder, names);
    const opening = await allTold(page, names);
    const { built, pictures } = await page.evaluate(async (all) => {
      const root = await window.figures.builtPage();
      const faults = [];
      for (const name of all) faults.push(...(await window.figures.pictureFaults(root, name)));
      return { built: all.map((name) => window.figures.told(root, name)), pictures: faults };
    }, names);
    assert.deepEqual(opening, built);
    assert.deepEqual(pictures, []);
    assert.deepEqual(await tableFaults(page, names, openings), []);

    const touch = await page.context().newCDPSession(page);
    const faults = [];
    let isTouched = false;
    for (const name of names) {
      const hands = new Hands(page, name);
      await hands.keep();
      const { handles } = await hands.parts();
      for (const handle of handles) await hands.useHandle(handle);
      if (handles.length > 0) {
        await hands.drag(handles[0]);
        if (!isTouched) await hands.drag(handles.at(-1), touch);
        isTouched = true;
      }
      await hands.useInputs('[data-control] input[type=range]', ['ArrowRight', 'ArrowLeft']);
      await hands.useInputs('.fig-scrubbed', ['ArrowRight', 'ArrowLeft']);
      await hands.useButtons('[data-control] :is([type=checkbox], [type=radio]:not(:checked))');
      await hands.useButtons('[data-control] button');
      await hands.useButtons('.fig-body :is(button, [data-change]):not([aria-pressed=true])');
      faults.push(...hands.faults);
    }
    assert.deepEqual(faults, []);
    assert.deepEqual(await allTold(page, names), opening);
    await page.waitForTimeout(kAddressMilliseconds);
    assert.equal(await page.evaluate(() => location.href), address);

    for (const name of names) await leaveMoved(page, name);
    const moved = await allTold(page, names);
    await page.waitForTimeout(kAddressMilliseconds);
    assert.deepEqual(await tableFaults(page, names, openings), []);
    await page.reload();
    assert.notEqual(await page.evaluate(() => location.href), address);
    await see(page);
    assert.deepEqual(await allTold(page, names), moved);
  });
}
