// The element matches the table of its interface, row by row:
// web/element/api.json against the class in Chromium.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';

import { launch } from './browser.mjs';
import { roomFiles, roomScene } from './room.mjs';
import { serve } from './static-server.mjs';

const axeFile = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const table = JSON.parse(
  readFileSync(new URL('../../web/element/api.json', import.meta.url), 'utf8'),
);
const names = (rows) => rows.map(({ name }) => name);
const sorted = (list) => [...list].sort();

// What every custom element has for the browser's sake, and the focus that it hands on.
const kCallbacks = [
  'connectedCallback',
  'disconnectedCallback',
  'connectedMoveCallback',
  'adoptedCallback',
  'attributeChangedCallback',
];
const kOfEveryElement = ['constructor', 'focus'];

// A way through a portal, with a message, a find and the goal on it.
const portalScene = {
  ...roomScene(),
  sprites: { coin: 'pictures/yellow.png' },
  game: { aim: 'Go east.' },
  maps: ['room', 'next'].map((name) => ({
    ...roomScene().maps[0],
    name,
    ...(name === 'room' && {
      portals: [{ x: 4, y: 3, to: { map: 'next', x: 2, y: 3 } }],
      objects: [{ sprite: 'coin', x: 3.9, y: 3.5, height: 0.2, find: { kind: 'coin' } }],
      messages: [{ text: 'Here.', x: 3, y: 3 }],
    }),
  })),
};

const kPage = `<!doctype html><title>The table</title><style>ray-caster { display: block; width: 320px; height: 200px }</style>
<script type="module">
  import * as slicecast from './ray-caster.js';
  window.slicecast = slicecast;
</script>`;

let browser;
let server;
let page;

before(async () => {
  browser = await launch();
  server = await serve({
    files: {
      ...roomFiles(),
      'table.html': kPage,
      'scenes/portal.json': JSON.stringify(portalScene),
      'scenes/broken.json': '{"title": 7}',
    },
  });
  page = await browser.newPage({ viewport: { width: 800, height: 600 } });
  await page.goto(`${server.address}table.html`);
  await page.waitForFunction(() => window.slicecast !== undefined);
});

after(async () => {
  await browser?.close();
  await server?.close();
});

test('the module exports what the table lists', async () => {
  assert.deepEqual(
    await page.evaluate(() => Object.keys(slicecast).sort()),
    sorted(names(table.exports)),
  );
  assert.equal(await page.evaluate(() => slicecast.apiVersion), table.apiVersion);
  assert.deepEqual(
    await page.evaluate(() => Object.keys(slicecast.errorCodes).sort()),
    sorted(table.errorCodes),
  );
  assert.ok(
    await page.evaluate((tag) => customElements.get(tag) === slicecast.RayCaster, table.tag),
  );
});

test('the class has no public members that the table does not list', async () => {
  const found = await page.evaluate(() => ({
    prototype: Object.getOwnPropertyNames(slicecast.RayCaster.prototype),
    statics: Object.getOwnPropertyNames(slicecast.RayCaster).filter(
      (name) => !['length', 'name', 'prototype'].includes(name),
    ),
    instance: Object.getOwnPropertyNames(document.createElement('ray-caster')),
  }));
  const listed = [...names(table.attributes), ...names(table.properties), ...names(table.methods)];
  assert.deepEqual(
    sorted(found.prototype.filter((name) => !kCallbacks.includes(name))),
    sorted([...listed, ...kOfEveryElement]),
  );
  assert.deepEqual(sorted(found.statics), sorted(['observedAttributes', ...names(table.statics)]));
  assert.deepEqual(found.instance, []);
});

test('each attribute is observed and reflected', async () => {
  assert.deepEqual(
    await page.evaluate(() => [...slicecast.RayCaster.observedAttributes].sort()),
    sorted(names(table.attributes)),
  );
  for (const { name, type, values, default: standard } of table.attributes) {
    const value = type === 'boolean' ? true : (values?.at(-1) ?? '1,2,3,4');
    const found = await page.evaluate(
      ([attribute, given]) => {
        const element = document.createElement('ray-caster');
        const without = element[attribute];
        element[attribute] = given;
        const asAttribute = element.getAttribute(attribute);
        const other = document.createElement('ray-caster');
        other.setAttribute(attribute, given === true ? '' : given);
        const asProperty = other[attribute];
        other.removeAttribute(attribute);
        return { without, asAttribute, asProperty, again: other[attribute] };
      },
      [name, value],
    );
    assert.deepEqual(
      found,
      {
        without: standard,
        asAttribute: value === true ? '' : value,
        asProperty: value,
        again: standard,
      },
      name,
    );
  }
});

test('each property is read-only, and exists from the beginning', async () => {
  for (const { name, readonly, default: standard } of table.properties) {
    const found = await page.evaluate((property) => {
      const { get, set } = Object.getOwnPropertyDescriptor(slicecast.RayCaster.prototype, property);
      return {
        isRead: typeof get === 'function',
        isWritten: typeof set === 'function',
        without: document.createElement('ray-caster')[property],
      };
    }, name);
    assert.deepEqual(found, { isRead: true, isWritten: !readonly, without: standard }, name);
  }
});

test("each method has the table's parameters, and needs a scene if the table says so", async () => {
  for (const { name, parameters, needsScene = false } of table.methods) {
    const found = await page.evaluate(async (method) => {
      const element = document.createElement('ray-caster');
      const call = async () => element[method]('fov', '60');
      const code =
        method === 'whenReady'
          ? null
          : await call().then(
              () => null,
              (error) => error.code,
            );
      return { length: element[method].length, needsScene: code === 'not-ready' };
    }, name);
    const withoutDefault = parameters.findIndex((row) => row.default !== undefined);
    assert.deepEqual(
      found,
      { length: withoutDefault < 0 ? parameters.length : withoutDefault, needsScene },
      name,
    );
  }
});

test('each method returns what the table says', async () => {
  const kinds = await page.evaluate(async () => {
    const element = document.body.appendChild(
      Object.assign(document.createElement('ray-caster'), { scene: 'room', size: '64x40' }),
    );
    const ready = await element.whenReady();
    const column = 32;
    const box = element.getBoundingClientRect();
    const kindOf = (value) =>
      value instanceof Blob ? 'Blob' : value === null ? 'null' : typeof value;
    const found = {
      enter: kindOf(element.enter({})),
      play: kindOf(element.play()),
      pause: kindOf(element.pause()),
      seek: kindOf(element.seek(0)),
      reset: kindOf(element.reset()),
      step: kindOf(element.step(2, { forward: 1 })),
      set: kindOf(element.set('fov', 70)),
      get: kindOf(element.get('fov')),
      look: kindOf(element.look('2.5,2.5,0.6,90')),
      land: kindOf(element.land()),
      snapshot: kindOf(await element.snapshot({ width: 32, height: 20 })),
      timeDrawing: kindOf(element.timeDrawing({ width: 32, height: 20 })),
      pixels: kindOf(element.pixels()),
      hits: kindOf(element.hits(column)),
      trace: kindOf(element.trace(column)),
      cast: kindOf(element.cast({ x: 2.5, y: 2.5, heading: 0 })),
      pick: kindOf(element.pick(box.left + 1, box.top + 1)),
      project: kindOf(element.project(2.5, 3.5, 0.5)),
      cells: kindOf(element.cells('room', 0)),
      blueprints: kindOf(element.blueprints()),
      tryOldWay: kindOf(element.tryOldWay(0)),
      setCell: kindOf(element.setCell(null, 0, 4, 4, '.')),
      setCells: kindOf(element.setCells(null, [])),
      mark: kindOf(element.mark([])),
      update: kindOf(await element.update('{}')),
      findMistakes: kindOf(await element.findMistakes('{}')),
      whenReady: kindOf(ready),
      record: kindOf(element.record('room')),
      takeRecording: kindOf(element.takeRecording()),
      reload: kindOf(element.reload({})),
    };
    element.remove();
    return found;
  });
  const expected = {
    void: 'undefined',
    string: 'string',
    boolean: 'boolean',
    number: 'number',
    'Promise<Blob>': 'Blob',
  };
  assert.deepEqual(
    kinds,
    Object.fromEntries(
      table.methods.map(({ name, returns: { type } }) => [
        name,
        expected[type] ?? (type.startsWith("'") ? 'string' : 'object'),
      ]),
    ),
  );
});

test('each event is sent with the details of its type, and does not bubble', async () => {
  const heard = await page.evaluate(async (events) => {
    const found = {};
    const hear = (element) =>
      events.forEach((name) =>
        element.addEventListener(name, (event) => {
          found[name] = {
            isCustom: event instanceof CustomEvent,
            bubbles: event.bubbles,
            composed: event.composed,
            detail: { ...event.detail },
          };
        }),
      );
    const add = (scene) => {
      const element = Object.assign(document.createElement('ray-caster'), { scene, size: '64x40' });
      hear(element);
      return document.body.appendChild(element);
    };
    const walker = add('portal');
    await walker.whenReady();
    walker.step(240, { forward: 1 });
    walker.record('portal');
    walker.enter();
    while (!walker.entered) await new Promise((resolve) => setTimeout(resolve, 50));
    walker.addEventListener('request', (event) => event.preventDefault());
    walker.shadowRoot
      .querySelector('canvas')
      .dispatchEvent(new KeyboardEvent('keydown', { code: 'KeyH', bubbles: true, composed: true }));
    walker.keys = 'arrows';
    const broken = add('broken');
    await broken.whenReady().catch(() => {});
    for (let wait = 0; events.some((name) => !Object.hasOwn(found, name)) && wait < 40; ++wait)
      await new Promise((resolve) => setTimeout(resolve, 50));
    walker.remove();
    broken.remove();
    return found;
  }, names(table.events));
  for (const { name, detail } of table.events) {
    const { fields } = table.types.find((shape) => shape.name === detail);
    assert.ok(Object.hasOwn(heard, name), `${name} never came`);
    assert.deepEqual(
      { ...heard[name], detail: sorted(Object.keys(heard[name].detail)) },
      { isCustom: true, bubbles: false, composed: false, detail: sorted(names(fields)) },
      name,
    );
  }
  const fault = table.types.find((shape) => shape.name === 'Fault');
  assert.deepEqual(sorted(Object.keys(heard.error.detail.faults[0])), sorted(names(fault.fields)));
});

test('slots, parts and custom properties are those of the table', async () => {
  const found = await page.evaluate(async () => {
    const add = (attributes) => {
      const element = Object.assign(document.createElement('ray-caster'), attributes);
      document.body.append(element);
      return element;
    };
    const ready = add({ scene: 'room', controls: '', poster: 'favicon.svg' });
    const broken = add({ scene: 'broken' });
    ready.innerHTML = '<b data-at="4,3,0.5">Here</b>';
    await ready.whenReady();
    while (ready.querySelector('b').assignedSlot === null) await new Promise(requestAnimationFrame);
    await broken.whenReady().catch(() => {});
    while (ready.shadowRoot.querySelector('.controls') === null)
      await new Promise(requestAnimationFrame);
    const { validate } = WebAssembly;
    WebAssembly.validate = undefined;
    const unable = add({ scene: 'room', engine: 'scalar' });
    await unable.whenReady().catch(() => {});
    WebAssembly.validate = validate;
    const inside = (selector) =>
      [ready, broken, unable].flatMap((element) => [
        ...element.shadowRoot.querySelectorAll(selector),
      ]);
    const rules = ready.shadowRoot.adoptedStyleSheets
      .flatMap((sheet) => [...sheet.cssRules].map((rule) => rule.cssText))
      .join('\n');
    const result = {
      parts: [...new Set(inside('[part]').flatMap((node) => [...node.part]))],
      slots: [...new Set(inside('slot').map(({ name }) => name))],
      properties: [...new Set(rules.match(/--ray-caster-[\w-]+/g))],
    };
    for (const element of [ready, broken, unable]) element.remove();
    return result;
  });
  assert.deepEqual(sorted(found.parts), sorted(names(table.cssParts)));
  assert.deepEqual(sorted(found.slots), sorted(names(table.slots)));
  assert.deepEqual(sorted(found.properties), sorted(names(table.cssProperties)));
});

test('the documentation names every row, its examples run, and axe finds nothing in it', async (t) => {
  const complaints = [];
  const opened = await browser.newPage({ viewport: { width: 1280, height: 720 } });
  t.after(() => opened.close());
  opened.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  opened.on('pageerror', (error) => complaints.push(String(error)));
  await opened.goto(`${server.address}element.html`);
  const states = await opened.evaluate(() =>
    Promise.all(
      [...document.querySelectorAll('ray-caster')].map((element) =>
        element.whenReady().then(
          () => element.state,
          (error) => error.message,
        ),
      ),
    ),
  );
  assert.ok(states.length > 4);
  assert.deepEqual([...new Set(states)], ['paused']);
  const kinds = {
    attribute: table.attributes,
    property: table.properties,
    method: table.methods,
    event: table.events,
    part: table.cssParts,
    css: table.cssProperties,
  };
  for (const [kind, rows] of Object.entries(kinds)) {
    for (const name of names(rows))
      assert.equal(
        await opened.evaluate((id) => document.getElementById(id)?.localName, `${kind}-${name}`),
        'tr',
        name,
      );
  }
  assert.ok(
    (await opened.locator('#option-fov').count()) === 1 &&
      (await opened.locator('#error-cors').count()) === 1,
  );
  for (const details of await opened.locator('details').all())
    await details.evaluate((one) => {
      one.open = true;
    });
  await opened.addScriptTag({ path: axeFile });
  const violations = await opened.evaluate(async () =>
    (await axe.run()).violations.map(({ id, nodes }) => [id, nodes.length, nodes[0].html]),
  );
  assert.deepEqual(violations, []);
  assert.deepEqual(complaints, []);
});
