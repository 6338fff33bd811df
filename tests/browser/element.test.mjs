// <ray-caster>: scenes, attributes, properties, methods and events, as a page uses them.

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import {
  elementPixel,
  eventsOf,
  inElementState,
  noteEvents,
  openElements,
  ready,
} from './element.mjs';
import { kBlue, kGreen, kRed, roomFiles, roomScene } from './room.mjs';

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const kRoom = '<ray-caster id="a" scene="room" size="160x100"></ray-caster>';
const kRows = '#######\n#.....#\n#..&gt;..#\n#.....#\n#######';

test('a scene from an address, a name, a script inside, or rows', async (t) => {
  const inline = JSON.stringify({
    ...roomScene({ title: 'Inside', folder: 'pictures/' }),
    start: { x: 3.5, y: 3.5, heading: 90 },
  });
  const { page, server } = await openElements(
    t,
    browser,
    `
    <ray-caster id="address" scene="scenes/other.json" loading="eager"></ray-caster>
    <ray-caster id="name" scene="room" loading="eager"></ray-caster>
    <ray-caster id="inline" loading="eager"><script type="application/json">${inline}</script></ray-caster>
    <ray-caster id="rows" loading="eager" label="Typed"><pre slot="rows">${kRows}</pre></ray-caster>
    <ray-caster id="rows-in-script" loading="eager"><script type="text/plain" data-rows>\n#####\n#.^.#\n#####</script></ray-caster>`,
  );
  const titles = {};
  for (const id of ['address', 'name', 'inline', 'rows', 'rows-in-script'])
    titles[id] = (await ready(page, id)).title;
  assert.deepEqual(titles, {
    address: 'The other room',
    name: 'The coloured room',
    inline: 'Inside',
    rows: 'Typed',
    'rows-in-script': 'A map',
  });
  assert.deepEqual(await elementPixel(page, 'address'), kBlue);
  assert.deepEqual(await elementPixel(page, 'name'), kGreen);
  assert.deepEqual(await elementPixel(page, 'inline'), kBlue);
  assert.deepEqual(
    await page.evaluate(() => [
      document.getElementById('rows').currentView.heading,
      document.getElementById('rows-in-script').currentView.heading,
    ]),
    [0, 270],
  );
  for (const file of ['engine/slicecast-simd.wasm', 'scenes/pictures/red.png']) {
    assert.equal(
      server.asked.filter((name) => name === file).length,
      1,
      `${file} is fetched once for all`,
    );
  }
});

test('rows are text between the tags, a pre, or an object; ids and objects share a scene', async (t) => {
  const { page, server } = await openElements(
    t,
    browser,
    `
    <ray-caster id="first" scene="#text" loading="eager"></ray-caster>
    <ray-caster id="text" loading="eager">
      ####
      #v.#
      ####
    </ray-caster>
    <ray-caster id="pre" loading="eager" label="In a pre"><p>Words</p><pre data-rows="colours">${kRows}</pre></ray-caster>
    <ray-caster id="elsewhere" scene="#rows" loading="eager"></ray-caster>
    <script type="text/plain" id="rows" data-rows="colours">${kRows.replace('&gt;', '>')}\n--- legend\n# = #c03020</script>
    <ray-caster id="words" loading="eager">Loading the castle</ray-caster>
    <ray-caster id="lost" scene="#nobody" loading="eager"></ray-caster>
    <ray-caster id="circle" scene="#circle" loading="eager"></ray-caster>`,
    { expectErrors: true },
  );
  const heading = (id) =>
    page.evaluate((one) => document.getElementById(one).currentView.heading, id);
  assert.equal((await ready(page, 'text')).title, 'A map');
  assert.equal(await heading('text'), 90);
  await ready(page, 'first');
  assert.equal(await heading('first'), 90, 'the scene of the element with that id');
  assert.equal((await ready(page, 'pre')).title, 'In a pre');
  await ready(page, 'elsewhere');
  const [red, green, blue] = await elementPixel(page, 'elsewhere');
  assert.ok(red > 2 * green && red > 2 * blue, `the wall is red: ${[red, green, blue]}`);
  const words = await ready(page, 'words');
  assert.equal(words.code, 'address');
  assert.match(words.message, /Found "Loading the castle", expected scene="castle" .* in <pre>/);
  assert.match(
    (await ready(page, 'lost')).message,
    /found "#nobody", expected the id of an element/,
  );
  assert.match((await ready(page, 'circle')).message, /found "#circle", expected the id/);

  // An object: colours need no file; setting it again reads it again.
  const before = server.asked.length;
  const seen = await page.evaluate(async () => {
    const scene = { rows: ['#####', '#>.x#', '#####'], legend: { x: '#c03020' }, colours: true };
    const [a, b] = [0, 1].map(() =>
      Object.assign(document.createElement('ray-caster'), { loading: 'eager', scene: 'room' }),
    );
    Object.assign(a, { scene, size: '160x100' });
    document.body.append(a);
    await a.whenReady();
    b.scene = a.scene;
    document.body.append(b);
    await b.whenReady();
    const found = {
      same: a.scene === scene && b.scene === scene && !b.hasAttribute('scene'),
      middle: a.hits(80).hits.find(({ filled }) => filled.length > 0).blueprint,
      heading: b.currentView.heading,
    };
    scene.rows[1] = '#<.x#';
    b.scene = scene;
    await b.whenReady();
    found.turned = b.currentView.heading;
    found.kept = a.currentView.heading;
    a.scene = { rows: '#>#', fgo: 1 };
    found.faults = await a.whenReady().catch(({ code, faults }) => [code, faults[0].found]);
    a.setAttribute('scene', 'room');
    found.title = (await a.whenReady()).title;
    found.property = a.scene;
    return found;
  });
  assert.deepEqual(seen, {
    same: true,
    middle: 'block x',
    heading: 0,
    turned: 180,
    kept: 0,
    faults: ['scene', 'the key "fgo"'],
    title: 'The coloured room',
    property: 'room',
  });
  const pictures = server.asked.slice(before).filter((name) => name.endsWith('.png'));
  assert.deepEqual(
    pictures.filter((name) => !name.startsWith('scenes/pictures/')),
    [],
  );
});

test('your own pictures are relative to the page, or to base', async (t) => {
  const wall = roomFiles()['scenes/pictures/red.png'];
  const inline = JSON.stringify(roomScene({ folder: '' }));
  const { page, server } = await openElements(
    t,
    browser,
    `
    <ray-caster id="rows" loading="eager" size="160x100">
      #######
      #.>...#
      #######
      --- legend
      # = mine/wall.png
    </ray-caster>
    <ray-caster id="json" loading="eager" base="scenes/pictures/" size="160x100"><script type="application/json">${inline}</script></ray-caster>`,
    { files: { 'mine/wall.png': wall } },
  );
  await ready(page, 'rows');
  const [red, green] = await elementPixel(page, 'rows');
  assert.ok(red > 2 * green, 'a red wall');
  assert.ok(server.asked.includes('mine/wall.png'));
  assert.equal((await ready(page, 'json')).title, 'The coloured room');
});

test('attributes and properties reflect each other, even if set before the element is defined', async (t) => {
  const { page } = await openElements(t, browser, '<ray-caster id="a"></ray-caster>', {
    script: '',
  });
  await page.evaluate(() => {
    window.a = document.getElementById('a');
    window.a.scene = 'other';
    window.a.size = '160x100';
  });
  await page.addScriptTag({ url: 'ray-caster.js', type: 'module' });
  assert.equal((await ready(page, 'a')).title, 'The other room');
  const seen = await page.evaluate(async () => {
    const { a } = window;
    const { apiVersion, errorCodes, RayCaster } = await import('./ray-caster.js');
    const bare = document.createElement('ray-caster');
    const names = RayCaster.observedAttributes;
    const standard = Object.fromEntries(names.map((name) => [name, bare[name]]));
    bare.controls = true;
    bare.autoplay = true;
    bare.view = '1,2,3,4';
    const set = bare.outerHTML;
    bare.controls = bare.view = null;
    bare.autoplay = false;
    return {
      attribute: a.getAttribute('scene'),
      standard,
      set,
      gone: bare.outerHTML,
      apiVersion,
      codes: Object.keys(errorCodes),
      same: a instanceof RayCaster,
      empty: [
        bare.state,
        bare.paused,
        bare.world,
        bare.memory,
        bare.currentView,
        bare.picture,
        bare.error,
        bare.optionList,
      ],
    };
  });
  assert.deepEqual(seen.standard, {
    scene: '',
    view: '',
    size: 'auto',
    controls: null,
    options: '',
    overlay: '',
    autoplay: false,
    sound: false,
    tour: '',
    base: '',
    poster: '',
    loading: 'lazy',
    interaction: 'walk',
    keys: 'all',
    label: '',
    syncwith: '',
    engine: 'auto',
  });
  assert.equal(seen.set, '<ray-caster controls="" autoplay="" view="1,2,3,4"></ray-caster>');
  assert.equal(seen.gone, '<ray-caster></ray-caster>');
  assert.equal(seen.attribute, 'other');
  assert.equal(seen.same, true);
  assert.equal(seen.apiVersion, 1);
  assert.ok(seen.codes.includes('not-ready'));
  assert.deepEqual(seen.empty, ['idle', true, null, 0, null, { width: 0, height: 0 }, null, []]);
});

test('another scene replaces the first only once it has loaded', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  await noteEvents(page, 'a', ['statechange', 'ready', 'progress']);
  await page.route('**/other.json', async (route) => {
    await new Promise((resolve) => setTimeout(resolve, 400));
    await route.continue();
  });
  await page.evaluate(() => {
    document.getElementById('a').scene = 'other';
  });
  await inElementState(page, 'a', 'loading');
  assert.deepEqual(await elementPixel(page, 'a'), kGreen, 'the old picture stays meanwhile');
  assert.equal((await ready(page, 'a')).title, 'The other room');
  assert.deepEqual(await elementPixel(page, 'a'), kBlue);
  const events = await eventsOf(page, 'a');
  assert.deepEqual(
    events.filter(([name]) => name !== 'progress').map(([, { state, title }]) => state ?? title),
    ['loading', 'paused', 'The other room'],
  );
  assert.ok(events.some(([name, { share }]) => name === 'progress' && share === 1));

  // The last request counts, whichever loads first.
  await page.evaluate(() => {
    const a = document.getElementById('a');
    a.scene = 'room';
    setTimeout(() => {
      a.scene = 'other';
    }, 1);
    setTimeout(() => {
      a.scene = 'room';
    }, 50);
  });
  await page.waitForTimeout(600);
  assert.equal((await ready(page, 'a')).title, 'The coloured room');
});

test('view, options, overlays, size, engine and label change while it runs', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  const change = async (attributes) => {
    await page.evaluate(
      (values) => Object.assign(document.getElementById('a'), values),
      attributes,
    );
    return ready(page, 'a');
  };
  const ask = (question) =>
    page.evaluate(
      `(async () => { const a = document.getElementById('a'); return ${question}; })()`,
    );

  await change({ view: '3.5,3.5,0.5,270,0.1' });
  assert.deepEqual(await elementPixel(page, 'a'), kRed);
  assert.deepEqual(await ask('a.currentView'), {
    map: 'room',
    x: 3.5,
    y: 3.5,
    z: 0.5,
    heading: 270,
    look: 0.1,
  });

  await change({ options: 'fov=75 light=off', overlay: 'grid minimap' });
  assert.deepEqual(await ask("['fov', 'light', 'grid', 'minimap'].map((name) => a.get(name))"), [
    '75',
    'off',
    'on',
    'on',
  ]);
  await change({ options: 'light=off', overlay: 'grid' });
  assert.deepEqual(
    await ask("['fov', 'light', 'grid', 'minimap'].map((name) => a.get(name))"),
    ['60', 'off', 'on', 'off'],
    'what is no longer named is as before',
  );
  await change({ options: '', overlay: '' });

  await change({ size: '80x60' });
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.querySelector('canvas').width === 80,
  );
  assert.deepEqual(await ask('a.picture'), { width: 80, height: 60 });
  await change({ size: null });
  await page.waitForFunction(
    () => document.getElementById('a').shadowRoot.querySelector('canvas').width === 320,
  );
  assert.deepEqual(await ask('a.picture'), { width: 320, height: 200 });
  await page.evaluate(() => {
    document.getElementById('a').style.width = '240px';
  });
  await page.waitForFunction(() => document.getElementById('a').picture.width === 240, undefined, {
    polling: 20,
  });

  await change({ engine: 'scalar' });
  assert.deepEqual(await elementPixel(page, 'a'), kRed, 'the other engine shows the same view');

  await change({ label: 'Four walls' });
  const names = await page.evaluate(() =>
    [...document.getElementById('a').shadowRoot.querySelectorAll('canvas, .cover')].map((node) =>
      node.getAttribute('aria-label'),
    ),
  );
  assert.deepEqual(names, ['Four walls', 'Play: Four walls']);
});

test('a scene inside the element may change, or be added later', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" size="160x100"></ray-caster>',
  );
  assert.equal((await ready(page, 'a')).code, 'address');
  await page.evaluate((rows) => {
    document.getElementById('a').innerHTML = `<pre slot="rows">${rows}</pre>`;
  }, kRows);
  assert.equal((await ready(page, 'a')).title, 'A map');
  await page.evaluate(() => {
    document.querySelector('pre').firstChild.data = '####\n#^.#\n####';
  });
  await page.waitForFunction(() => document.getElementById('a').currentView?.heading === 270);
});

// A bad attribute, its warning, and the value of an engine's option afterwards.
const kMistakes = [
  ['view', '1,2', /^view: found "1,2", expected x,y,z,heading/],
  ['view', '3.5,3.5,-4,0', /^The view '3.5,3.5,-4,0' is not above the floor\.$/],
  ['view', '3.5,3.5,0.5,0,0,rom', /^Unknown map 'rom'\. Did you mean 'room'\?$/],
  [
    'size',
    'large',
    /^Found 'large', expected auto, WIDTHxHEIGHT of at most 4096 pixels each, or 10% to 100%\.$/,
  ],
  ['size', '5000x10', /^Found '5000x10', expected auto/],
  ['controls', 'play savee', /^Unknown control 'savee'\. Did you mean 'save'\?$/],
  ['controls', 'stop', /^Unknown control 'stop'\. Expected play, reset, .* or fullscreen\.$/],
  [
    'overlay',
    'minmap, grid',
    /^Unknown overlay 'minmap'\. Did you mean 'minimap'\?$/,
    'grid',
    'on',
  ],
  ['loading', 'egaer', /^Unknown value of loading: 'egaer'\. Did you mean 'eager'\?$/],
  ['keys', 'arrows', /^Unknown value of keys: 'arrows'\. Expected all, move or none\.$/],
  ['engine', 'fast', /^Unknown value of engine: 'fast'\. Expected auto, simd or scalar\.$/],
  ['options', 'fov light=off', /^Option 'fov' takes a number .*, not 'on'\.$/, 'light', 'off'],
  ['options', 'fvo=75, light=off', /^Unknown option 'fvo'\. Did you mean 'fov'\?$/, 'light', 'off'],
  ['tour', 'missing', /tours\/missing\.txt: the server answers 404/],
  ['autopaly', '', /^Unknown attribute 'autopaly'\. Did you mean 'autoplay'\?$/],
];

test('a mistake in an attribute gives a warning, and the rest is drawn', async (t) => {
  const { page } = await openElements(t, browser, '', { expectErrors: true });
  const said = [];
  page.on('console', (message) => message.type() === 'warning' && said.push(message.text()));
  for (const [name, value, message, option, set] of kMistakes) {
    said.length = 0;
    const found = await page.evaluate(
      async ([attribute, slip, which]) => {
        await customElements.whenDefined('ray-caster');
        document.body.innerHTML = '<ray-caster id="a" scene="room" size="160x100"></ray-caster>';
        const a = document.getElementById('a');
        a.setAttribute(attribute, slip);
        const heard = [];
        a.addEventListener('warning', ({ detail }) => heard.push(detail));
        const { title } = await a.whenReady();
        a.label = 'again'; // a warning is not repeated
        await a.whenReady();
        return {
          title,
          heard,
          state: a.state,
          error: a.error,
          warnings: a.warnings,
          value: which ? a.get(which) : null,
        };
      },
      [name, value, option],
    );
    assert.equal(found.title, 'The coloured room', name);
    assert.deepEqual([found.state, found.error], ['paused', null], name);
    assert.equal(found.heard.length, 1, `${name}="${value}"`);
    assert.deepEqual(found.warnings, found.heard);
    assert.equal(found.heard[0].attribute, name);
    assert.match(found.heard[0].message, message);
    if (option) assert.equal(found.value, set, option);
    assert.ok(
      said.some((text) => text.startsWith(`<ray-caster> ${name}: ${found.heard[0].message}`)),
      `the console: ${said}`,
    );
    if (name !== 'overlay') assert.deepEqual(await elementPixel(page, 'a'), kGreen, name);
  }
  assert.deepEqual(
    await page.evaluate(async () => {
      const a = document.getElementById('a');
      a.removeAttribute('autopaly');
      a.label = '';
      await a.whenReady();
      return a.warnings;
    }),
    [],
    'what is mended is no longer there',
  );
});

// A lamp needs baked light, so a lamp without it is a probable mistake.
test('a probable mistake in a scene is a warning, until another scene is shown', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  assert.deepEqual(await page.evaluate(() => document.getElementById('a').warnings), []);
  const warnings = await page.evaluate(async () => {
    const a = document.getElementById('a');
    a.scene = {
      title: 'Dark',
      textures: { wall: '#806040' },
      blueprints: {
        wall: { faces: { all: 'wall', top: { texture: 'wall', lamp: { radius: 3 } } } },
      },
      legend: { '#': 'wall' },
      maps: [{ name: 'map', levels: [['####', '#..#', '####']], floor: 'wall' }],
      start: { x: 1.5, y: 1.5 },
    };
    await a.whenReady();
    return a.warnings;
  });
  assert.deepEqual(
    warnings.map(({ attribute }) => attribute),
    ['scene'],
  );
  assert.match(warnings[0].message, /found a lamp, but no map with "baked"/);
  const later = await page.evaluate(async () => {
    const a = document.getElementById('a');
    a.scene = 'room';
    await a.whenReady();
    return a.warnings;
  });
  assert.deepEqual(later, []);
});

test('unusual but clear spellings give no warning', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    `<ray-caster id="a" scene="room" size=" 160 X 100 " controls="true" keys=" Move " title="x" data-controls="y"
       overlay="minimap, grid" options="fov = 75, light=false; minimapRays" view="3.5, 3.5, 0.5, 0"></ray-caster>`,
  );
  await ready(page, 'a');
  const bar = page.locator('#a').getByRole('button');
  await bar.nth(3).waitFor();
  const buttons = async () =>
    page.evaluate(() =>
      [...document.getElementById('a').shadowRoot.querySelectorAll('[data-name]')].map(
        ({ dataset }) => dataset.name,
      ),
    );
  assert.ok((await buttons()).length >= 5);
  assert.deepEqual(
    await page.evaluate(() => {
      const a = document.getElementById('a');
      const options = ['minimap', 'grid', 'fov', 'light', 'minimapRays'].map((name) => a.get(name));
      return [a.picture, options, a.warnings];
    }),
    [{ width: 160, height: 100 }, ['on', 'on', '75', 'off', 'on'], []],
  );
  const show = async (controls) => {
    await page.evaluate((value) => {
      document.getElementById('a').controls = value;
    }, controls);
    await ready(page, 'a');
    return buttons();
  };
  assert.deepEqual(await show('save,play'), ['play', 'save']);
  assert.deepEqual(await show('false'), []);
});

const kFaults = [
  ['scene', 'http://[', /scene: found "http:\/\/\[", expected an address/, 'address'],
  ['scene', 'missing', /scenes\/missing\.json: the server answers 404/, 'fetch'],
];

test('a missing scene is an error with a code; another value recovers from it', async (t) => {
  const { page } = await openElements(t, browser, kRoom, { expectErrors: true });
  await ready(page, 'a');
  await noteEvents(page, 'a', ['error']);
  for (const [name, value, message, code] of kFaults) {
    const before = await page.evaluate(
      ([which, bad]) => {
        const a = document.getElementById('a');
        const was = a.getAttribute(which);
        a.setAttribute(which, bad);
        return was;
      },
      [name, value],
    );
    const error = await ready(page, 'a');
    assert.match(error.message, message);
    assert.equal(error.code, code);
    const shown = await page.evaluate(() => {
      const { shadowRoot, state, error: own } = document.getElementById('a');
      const sheet = shadowRoot.querySelector('.message');
      return {
        state,
        code: own.code,
        text: sheet.textContent,
        role: sheet.getAttribute('role'),
        isThere: sheet.getBoundingClientRect().height > 0,
      };
    });
    assert.equal(shown.state, 'error');
    assert.equal(shown.code, code);
    assert.equal(shown.role, 'alert');
    assert.ok(shown.isThere && shown.text.includes(error.message));
    await page.evaluate(
      ([which, good]) => {
        const a = document.getElementById('a');
        if (good === null) a.removeAttribute(which);
        else a.setAttribute(which, good);
      },
      [name, before],
    );
    assert.equal((await ready(page, 'a')).title, 'The coloured room', `${name} is mended`);
    assert.equal(await page.evaluate(() => document.getElementById('a').error), null);
  }
  assert.deepEqual(
    (await eventsOf(page, 'a')).map(([, { code }]) => code),
    kFaults.map((fault) => fault[3]),
  );
});

test('a scene with faults lists them all with their places, and can be tried again', async (t) => {
  let text = JSON.stringify({ ...roomScene(), start: { x: 99, y: 3.5, heading: 'east' } });
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="scenes/bad.json"></ray-caster>',
    { files: { 'scenes/bad.json': () => text } },
  );
  const error = await ready(page, 'a');
  assert.equal(error.code, 'scene');
  assert.ok(
    error.faults.length >= 1 &&
      error.faults.every(
        ({ place, found, expected }) =>
          place.startsWith('bad.json:1:') && found !== '' && expected !== '',
      ),
  );
  assert.equal(
    await page.evaluate(
      () => document.getElementById('a').shadowRoot.querySelectorAll('.message li').length,
    ),
    error.faults.length,
  );
  text = JSON.stringify(roomScene());
  await page.locator('#a').getByRole('button', { name: 'Try again' }).click();
  await inElementState(page, 'a', 'paused');
});

test('methods that need a scene throw before it has loaded, and whenReady loads it', async (t) => {
  const { page } = await openElements(t, browser, `<div style="height: 5000px"></div>${kRoom}`);
  const refusals = await page.evaluate(async () => {
    await customElements.whenDefined('ray-caster');
    const a = document.getElementById('a');
    const calls = {
      reset: [],
      step: [],
      set: ['fov', 70],
      get: ['fov'],
      look: ['1,1,1,1'],
      snapshot: [],
      pixels: [],
      hits: [0],
      trace: [0],
      cast: [{ x: 1, y: 1, heading: 0 }],
      pick: [1, 1],
      project: [1, 1, 1],
      cells: [],
      blueprints: [],
      setCell: [null, 0, 1, 1, '.'],
      setCells: [null, []],
      mark: [[]],
      update: ['{}'],
      findMistakes: ['{}'],
    };
    const codes = {};
    for (const [name, values] of Object.entries(calls)) {
      try {
        await a[name](...values);
      } catch (error) {
        codes[name] =
          error instanceof Error && error.message.startsWith(`${name}()`)
            ? error.code
            : String(error);
      }
    }
    return codes;
  });
  assert.deepEqual([...new Set(Object.values(refusals))], ['not-ready']);
  assert.equal(Object.keys(refusals).length, 19);
  assert.equal(
    await page.evaluate(() => document.getElementById('a').state),
    'idle',
    'far away nothing is loaded',
  );
  const { title, maps, memory } = await ready(page, 'a');
  assert.equal(title, 'The coloured room');
  assert.deepEqual(maps, [{ name: 'room', width: 7, depth: 7, levels: 1 }]);
  assert.ok(
    memory > 1e6 && memory === (await page.evaluate(() => document.getElementById('a').memory)),
  );
});

test('the methods step, look, reset, set, get, and those for pictures, hits and traces', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  const seen = await page.evaluate(async () => {
    const a = document.getElementById('a');
    const failure = (act) => {
      try {
        return act();
      } catch (error) {
        return `${error.code}: ${error.message}`;
      }
    };
    const start = a.currentView;
    a.step(120, { forward: 1 });
    const walked = a.currentView;
    a.reset();
    const back = a.currentView;
    const looked = a.look({ heading: 90 });
    const turned = a.currentView;
    const refused = a.look('3.5,3.5,-2,0');
    a.look({ look: 0.5 });
    a.look('3.5,3.5,0.5,90');
    const kept = a.currentView.look;
    a.look({ ...turned });
    a.set('fov', 80);
    a.set('light', false);
    const picture = await createImageBitmap(await a.snapshot({ width: 64, height: 40 }));
    const canvas = new OffscreenCanvas(64, 40);
    canvas.getContext('2d').drawImage(picture, 0, 0);
    return {
      start,
      walked,
      back,
      looked,
      turned,
      refused,
      kept,
      options: [
        a.get('fov'),
        a.get('light'),
        a.optionList.find(({ name }) => name === 'fov').value,
        a.optionList.length > 20,
      ],
      badOption: failure(() => a.set('fov', 'wide')),
      noOption: failure(() => a.get('colour')),
      badStep: failure(() => a.step(1, { sideways: 1 })),
      badViews: [{ x: 'three' }, { north: 1 }, null, { map: 3 }, { look: 9 }].map((view) =>
        failure(() => a.look(view)),
      ),
      badColumn: failure(() => a.hits(1.5)),
      middle: [...canvas.getContext('2d').getImageData(32, 20, 1, 1).data.subarray(0, 3)],
      type: (await a.snapshot()).type,
      jpeg: (await a.snapshot({ type: 'image/jpeg' })).type,
      tooLarge: await a.snapshot({ width: 9000 }).catch((error) => error.message),
      badType: await a.snapshot({ type: 'image/tiff' }).catch((error) => error.message),
      hit: a.hits(80).hits[0].blueprint,
      noHit: a.hits(160),
      paused: a.paused,
    };
  });
  assert.ok(seen.walked.x > seen.start.x + 0.5);
  assert.deepEqual(seen.back, seen.start);
  assert.equal(seen.looked, true);
  assert.deepEqual(seen.turned, { ...seen.start, heading: 90 });
  assert.equal(seen.refused, false);
  assert.equal(seen.kept, 0.5);
  assert.deepEqual(seen.options, ['80', 'off', '80', true]);
  assert.match(seen.badOption, /^option: .*fov/);
  assert.match(seen.noOption, /^option: Unknown option 'colour'/);
  assert.match(seen.badStep, /sideways/);
  assert.match(seen.badViews[0], /^address: look: found x three, expected a number/);
  assert.match(seen.badViews[1], /found north 1, expected a view with some of x, y/);
  assert.match(seen.badViews[2], /found null, expected a view/);
  assert.match(seen.badViews[3], /found map 3, expected the name of a map/);
  assert.match(seen.badViews[4], /^address: look: found look 9, expected a number from -4 to 4/);
  assert.match(seen.badColumn, /hits: found column 1.5, expected a whole number/);
  assert.deepEqual(seen.middle, kBlue);
  assert.deepEqual([seen.type, seen.jpeg], ['image/png', 'image/jpeg']);
  assert.match(seen.tooLarge, /found width 9000, expected a whole number from 1 to 4096/);
  assert.match(seen.badType, /found type image\/tiff/);
  assert.equal(seen.hit, 'wall');
  assert.equal(seen.noHit, null);
  assert.equal(seen.paused, true);
  // Changes while paused are on the canvas.
  assert.deepEqual(await elementPixel(page, 'a'), kBlue);
});

test('events about pictures, the view, and portals', async (t) => {
  const room = roomScene();
  const scene = {
    ...room,
    maps: [
      { ...room.maps[0], portals: [{ x: 5, y: 3, to: { map: 'cellar', x: 1, y: 3 } }] },
      { ...room.maps[0], name: 'cellar' },
    ],
  };
  const { page } = await openElements(t, browser, kRoom, {
    files: { 'scenes/room.json': JSON.stringify(scene) },
  });
  const found = await ready(page, 'a');
  if (found.code !== undefined) assert.fail(JSON.stringify(found.faults));
  await noteEvents(page, 'a', ['framechange', 'viewchange', 'portal']);
  await page.evaluate(() => document.getElementById('a').step(40, { forward: 1 }));
  await page.waitForFunction(() => window.noted.a.some(([name]) => name === 'framechange'));
  const events = await eventsOf(page, 'a');
  assert.deepEqual(
    events.map(([name]) => name),
    ['viewchange', 'framechange'],
    'many steps by hand are one picture',
  );
  assert.ok(events[0][1].view.x > 3.5);
  assert.equal(events[1][1].steps, 40);
  await page.evaluate(() => document.getElementById('a').step(200, { forward: 1 }));
  await page.waitForFunction(() => window.noted.a.some(([name]) => name === 'portal'));
  const portal = (await eventsOf(page, 'a')).find(([name]) => name === 'portal');
  assert.deepEqual(portal[1], { from: 'room', to: 'cellar' });
  // Nothing bubbles out of the element.
  assert.equal(
    await page.evaluate(async () => {
      let heard = 0;
      for (const name of ['framechange', 'viewchange', 'statechange', 'error'])
        document.body.addEventListener(name, () => {
          heard += 1;
        });
      const a = document.getElementById('a');
      a.size = 'none';
      await a.whenReady().catch(() => {});
      return heard;
    }),
    0,
  );
});

test('a tour plays when play begins, and can start again', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" tour="castle" size="160x100"></ray-caster>',
    {
      // Frames of a sixtieth of a second each, however long they take: so both runs see the same
      // steps. The second one of a row is longer by a third of a step, which is owed from then on;
      // else two steps would end just where a frame does, now before it and now after.
      prepare: (opened) =>
        opened.addInitScript(() => {
          const ask = window.requestAnimationFrame.bind(window);
          let time = performance.now();
          let isWithin = false;
          let count = 0; // of frames in a row
          window.requestAnimationFrame = (act) => {
            if (!isWithin) count = 0;
            return ask(() => {
              time += 1000 / 60 + (++count === 2 ? 1000 / 360 : 0);
              isWithin = true;
              act(time);
              isWithin = false;
            });
          };
        }),
    },
  );
  assert.equal((await ready(page, 'a')).title, 'The castle in the lake');
  // Where the eye is after each number of steps that is seen
  const play = () =>
    page.evaluate(async () => {
      const a = document.getElementById('a');
      const places = [];
      await new Promise((resolve) => {
        let first = null; // the world's time goes on over a reset
        a.addEventListener('framechange', function note({ detail: { steps } }) {
          first ??= steps;
          places.push(
            [steps - first, a.currentView.x, a.currentView.y, a.currentView.heading].join(),
          );
          if (steps < first + 240) return;
          a.removeEventListener('framechange', note);
          resolve();
        });
        a.play();
      });
      a.pause();
      a.reset();
      return places;
    });
  const start = await page.evaluate(() => document.getElementById('a').currentView);
  const once = await play();
  assert.deepEqual(await page.evaluate(() => document.getElementById('a').currentView), start);
  const again = await play();
  assert.ok(
    new Set(once.map((place) => place.split(',').slice(1).join())).size > 3,
    'the eye moves',
  );
  const steps = (places) => new Map(places.map((place) => [place.split(',', 1)[0], place]));
  const common = [...steps(once)].filter(([count]) => steps(again).has(count));
  assert.ok(common.length > 100, `${common.length} of ${once.length} and ${again.length}`);
  assert.deepEqual(
    common.map(([, place]) => place),
    common.map(([count]) => steps(again).get(count)),
  );
});

test('trace() of one slice, and of the picture', async (t) => {
  const { page } = await openElements(t, browser, kRoom);
  await ready(page, 'a');
  const seen = await page.evaluate(() => {
    const a = document.getElementById('a');
    const slice = a.trace(80);
    const frame = a.trace();
    return {
      slice: Object.keys(slice),
      frame: Object.keys(frame),
      column: slice.column,
      none: a.trace(160),
      hits: slice.hits.map(({ blueprint, depth }) => [blueprint, Math.round(depth * 10)]),
      hit: a.hits(80).hits.map(({ blueprint, depth }) => [blueprint, Math.round(depth * 10)]),
    };
  });
  assert.equal(seen.column, 80);
  assert.equal(seen.none, null);
  assert.deepEqual(seen.hits, seen.hit);
  assert.deepEqual(seen.hits[0], ['wall', 25]);
  assert.ok(
    seen.slice.includes('tiles') && seen.frame.includes('totals'),
    `${seen.slice} / ${seen.frame}`,
  );
});

test('reset goes back to the view of the attribute', async (t) => {
  const { page } = await openElements(
    t,
    browser,
    '<ray-caster id="a" scene="room" view="2.5,3.5,0.5,0"></ray-caster>',
  );
  await ready(page, 'a');
  const places = await page.evaluate(() => {
    const a = document.getElementById('a');
    a.step(120, { forward: 1 });
    const walked = a.currentView.x;
    a.reset();
    return [walked > 3, a.currentView.x];
  });
  assert.deepEqual(places, [true, 2.5]);
});
