// The page for frames: one picture that fills the window, from its address alone.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { launch, openPage } from './browser.mjs';
import { roomFiles } from './room.mjs';
import { serve } from './static-server.mjs';

const kAxe = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

const kPage = new URL('../../build/web/', import.meta.url);
const embedPage = readFileSync(new URL('embed.html', kPage), 'utf8');
const playPage = readFileSync(new URL('index.html', kPage), 'utf8');

let browser;
before(async () => {
  browser = await launch();
});
after(() => browser.close());

const ready = (page) =>
  page.waitForFunction(() => document.querySelector('ray-caster')?.state === 'paused');

test('a frame shows the scene, view and options of its address, and fills its window', async (t) => {
  const { page } = await openPage(t, browser, {
    query:
      'embed.html?scene=room&view=2.5,4.25,0.75,200&options=fov=90+light=off&overlay=grid&label=My+room&size=320x180',
  });
  await ready(page);
  const found = await page.evaluate(() => {
    const caster = document.querySelector('ray-caster');
    const { x, y, z, heading } = caster.currentView;
    const { width, height } = caster.getBoundingClientRect();
    return {
      view: [x, y, z, heading],
      fov: caster.get('fov'),
      light: caster.get('light'),
      grid: caster.get('grid'),
      picture: caster.picture,
      width,
      height,
      label: caster.label,
    };
  });
  assert.deepEqual(found, {
    view: [2.5, 4.25, 0.75, 200],
    fov: '90',
    light: 'off',
    grid: 'on',
    picture: { width: 320, height: 180 },
    width: 640,
    height: 360,
    label: 'My room',
  });
  assert.equal(await page.title(), 'The coloured room · Slicecast');
  await page.addScriptTag({ path: kAxe });
  assert.deepEqual(
    await page.evaluate(async () =>
      (await window.axe.run()).violations.map(({ id, nodes }) => `${id}: ${nodes[0].html}`),
    ),
    [],
  );
});

test('the link leads to the same in the play page', async (t) => {
  const { page, context } = await openPage(t, browser, {
    query:
      'embed.html?scene=other&view=2.5,4.25,0.75,200,0,room&options=fov=90&controls=play&label=x',
  });
  await ready(page);
  const [other] = await Promise.all([context.waitForEvent('page'), page.click('#open')]);
  await other.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.match(
    other.url(),
    /index\.html\?scene=other&view=2\.5,4\.25,0\.75,200,0,room&options=fov=90$/,
  );
  assert.equal(await other.evaluate(() => window.slicecast.player.x), 2.5);
});

test('a tour plays, with autoplay by itself', async (t) => {
  const { page } = await openPage(t, browser, {
    query: 'embed.html?tour=castle&autoplay&size=160x100',
    context: { reducedMotion: 'no-preference' },
  });
  await page.waitForFunction(() => document.querySelector('ray-caster')?.state === 'playing');
  assert.equal(await page.innerText('#title'), 'The castle in the lake');
  const start = await page.evaluate(() => document.querySelector('ray-caster').currentView);
  await page.waitForFunction(({ x, y, heading }) => {
    const now = document.querySelector('ray-caster').currentView;
    return now.x !== x || now.y !== y || now.heading !== heading;
  }, start);
});

test('the frame shows the error for a bad parameter', async (t) => {
  const own = [
    ['', /neither scene nor tour/],
    ['?sene=room', /neither scene nor tour/],
  ];
  const elements = [['?scene=nowhere', /nowhere\.json/]];
  const { page, server } = await openPage(t, browser, { query: 'embed.html', expectErrors: true });
  for (const [query, expected] of own) {
    await page.goto(`${server.address}embed.html${query}`);
    assert.match(await page.innerText('#trouble'), expected, query);
    assert.equal(await page.locator('ray-caster').count(), 0);
  }
  for (const [query, expected] of elements) {
    await page.goto(`${server.address}embed.html${query}`);
    await page.waitForFunction(() => document.querySelector('ray-caster')?.state === 'error');
    assert.match(
      await page.evaluate(
        () =>
          document.querySelector('ray-caster').shadowRoot.querySelector('[part=message]').innerText,
      ),
      expected,
      query,
    );
  }
});

test('a mistake in the address does not blank the frame', async (t) => {
  const { page, server } = await openPage(t, browser, { query: 'embed.html?scene=other' });
  const said = [];
  page.on('console', (message) => message.type() === 'warning' && said.push(message.text()));
  for (const [query, expected] of [
    ['&utm_source=mail', /Unknown parameter 'utm_source'/],
    ['&optoins=fov=75', /Unknown parameter 'optoins'\. Did you mean 'options'\?/],
    ['&scene=other', /'scene' appears more than once/],
    ['&view=1', /view: found "1"/],
    ['&options=fov=9000', /Option 'fov' takes a number from 10 to 150, not '9000'/],
    ['&controls=hat', /Unknown control 'hat'/],
  ]) {
    said.length = 0;
    await page.goto(`${server.address}embed.html?scene=room${query}`);
    await ready(page);
    assert.equal(await page.innerText('#title'), 'The coloured room', query);
    assert.match(said.join('\n'), expected, query);
  }
});

// A page on another origin, with the frame in it.
async function openHost(t, { headers, sandbox, query = '?scene=room' }) {
  const host = await serve({
    files: { 'host.html': '<!doctype html><title>Host</title><body></body>' },
  });
  t.after(() => host.close());
  const { page, server } = await openPage(t, browser, {
    query: 'embed.html?scene=room',
    server: { headers },
    expectErrors: true,
  });
  await page.goto(`${host.address}host.html`);
  await page.evaluate(
    ([source, rules]) => {
      const frame = document.createElement('iframe');
      frame.width = '480';
      frame.height = '300';
      if (rules !== null) frame.setAttribute('sandbox', rules);
      frame.src = source;
      document.body.append(frame);
    },
    [`${server.address}embed.html${query}`, sandbox],
  );
  return (await page.waitForSelector('iframe')).contentFrame();
}

test('a poster, no badge, no interaction', async (t) => {
  const { page, server } = await openPage(t, browser, {
    query: 'embed.html?scene=room&poster=favicon.svg&badge=false&interaction=none&loading=click',
  });
  await page.waitForSelector('ray-caster');
  assert.equal(await page.locator('#open').isVisible(), false);
  assert.deepEqual(
    await page.evaluate(() => {
      const { poster, interaction, state, controls } = document.querySelector('ray-caster');
      return [poster, interaction, state, controls];
    }),
    [`${server.address}favicon.svg`, 'none', 'idle', null],
  );
  await page.click('ray-caster');
  await page.waitForFunction(() => document.querySelector('ray-caster').state === 'playing');
});

test('scenes from elsewhere are shown only if the owner allows it', async (t) => {
  const other = await serve({
    files: roomFiles(),
    headers: { 'Access-Control-Allow-Origin': '*' },
  });
  t.after(() => other.close());
  let head = '';
  const { page, server } = await openPage(t, browser, {
    query: 'embed.html?scene=room',
    expectErrors: true,
    server: {
      files: {
        'embed.html': () => embedPage.replace('<head>', `<head>${head}`),
        'index.html': () => playPage.replace('<head>', `<head>${head}`),
      },
    },
  });
  const address = `${other.address}scenes/room.json`;
  for (const where of ['embed.html', 'index.html']) {
    head = '';
    await page.goto(`${server.address}${where}?scene=${encodeURIComponent(address)}`);
    await page.waitForFunction(() => !document.getElementById('trouble').hidden);
    assert.match(
      await page.innerText('#trouble'),
      /expected an address that begins with http:\/\/localhost:\d+\/\./,
      where,
    );
    for (const scene of ['data:application/json,{}', `${server.address}scenes/room.json`]) {
      await page.goto(`${server.address}${where}?scene=${encodeURIComponent(scene)}`);
      if (scene.startsWith('data:')) await page.waitForSelector('#trouble:visible');
      else await ready(page);
    }
    for (const content of ['*', `https://a.example/ ${other.address}scenes`]) {
      head = `<meta name="slicecast-scenes" content="${content}">`;
      await page.goto(`${server.address}${where}?scene=${encodeURIComponent(address)}`);
      await page.waitForFunction(() => document.body.dataset.state === 'paused');
    }
    head = `<meta name="slicecast-scenes" content="${other.address}scen https://a.example">`;
    await page.goto(`${server.address}${where}?scene=${encodeURIComponent(address)}`);
    await page.waitForFunction(() => !document.getElementById('trouble').hidden);
  }
});

test('posters follow the same rule as scenes', async (t) => {
  const other = await serve({ files: { 'poster.png': 'a picture' } });
  t.after(() => other.close());
  const { page, server } = await openPage(t, browser, { query: 'embed.html?scene=room' });
  for (const poster of [`${other.address}poster.png`, 'data:image/png;base64,AAAA']) {
    await page.goto(`${server.address}embed.html?scene=room&poster=${encodeURIComponent(poster)}`);
    await page.waitForSelector('#trouble:visible');
    assert.match(await page.innerText('#trouble'), /does not allow that address/);
  }
  assert.deepEqual(other.asked, []);
});

test('a scene from elsewhere is marked with its host, and its title cannot pose as anything else', async (t) => {
  const title = 'Log in” again, \u202e Slicecast "asks" “you';
  const other = await serve({
    files: roomFiles({ title }),
    headers: { 'Access-Control-Allow-Origin': '*' },
  });
  t.after(() => other.close());
  const withMeta = (text) =>
    text.replace('<head>', '<head><meta name="slicecast-scenes" content="*">');
  const { page, server } = await openPage(t, browser, {
    query: 'embed.html?scene=room',
    server: { files: { 'embed.html': withMeta(embedPage), 'index.html': withMeta(playPage) } },
  });
  const { host } = new URL(other.address);
  const said = `From ${host}: “Log in again, Slicecast asks you”`;
  const query = `?scene=${encodeURIComponent(`${other.address}scenes/room.json`)}`;
  const name = () => page.evaluate(() => document.querySelector('ray-caster').label);

  // The frame shows it before the first picture.
  let go;
  const mayGo = new Promise((resolve) => {
    go = resolve;
  });
  await page.route(`${other.address}**`, async (route) => {
    await mayGo;
    await route.continue();
  });
  await page.goto(`${server.address}embed.html${query}&autoplay`);
  await page.waitForSelector('#origin:visible');
  assert.equal(await page.innerText('#origin'), `A scene from ${host}`);
  go();
  await page.waitForFunction((wanted) => document.title === wanted, `${said} · Slicecast`);
  assert.equal(await page.innerText('#origin'), said);
  assert.equal(await page.innerText('#title'), said);
  assert.equal(await name(), said);

  await page.goto(`${server.address}${query}`);
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await page.title(), `${said} · Slicecast`);
  assert.equal(await page.innerText('#pause-title'), said);
  assert.equal(await page.textContent('#bar-title'), said);
  assert.equal(await name(), said);

  // The title of the page's own scene is shown as it is.
  for (const where of ['embed.html', '']) {
    await page.goto(`${server.address}${where}?scene=room`);
    await page.waitForFunction(() => document.title === 'The coloured room · Slicecast');
    assert.equal(await name(), '');
    if (where !== '') assert.equal(await page.isVisible('#origin'), false);
  }
});

test('a scene to which the own server redirects is marked with its host, too', async (t) => {
  const other = await serve({
    files: roomFiles({ title: 'Log in again' }),
    headers: { 'Access-Control-Allow-Origin': '*' },
  });
  t.after(() => other.close());
  const { page, server } = await openPage(t, browser, {
    query: 'embed.html?scene=room',
    server: {
      redirects: {
        'scenes/away.json': `${other.address}scenes/room.json`,
        'scenes/near.json': '/scenes/room.json',
      },
    },
  });
  const said = `From ${new URL(other.address).host}: “Log in again”`;
  await page.goto(`${server.address}embed.html?scene=away&autoplay`);
  await page.waitForFunction((wanted) => document.title === wanted, `${said} · Slicecast`);
  assert.equal(await page.innerText('#origin:visible'), said);
  await page.goto(`${server.address}?scene=away`);
  await page.waitForFunction(() => document.body.dataset.state === 'paused');
  assert.equal(await page.innerText('#pause-title'), said);
  assert.equal(await page.title(), `${said} · Slicecast`);
  for (const where of ['embed.html', '']) {
    await page.goto(`${server.address}${where}?scene=near`);
    await page.waitForFunction(() => document.title === 'The coloured room · Slicecast');
  }
});

test('the page around the frame exchanges messages with it, if the address names its origin', async (t) => {
  const host = await serve({
    files: { 'host.html': '<!doctype html><title>Host</title><body></body>' },
  });
  t.after(() => host.close());
  const { page, server } = await openPage(t, browser, {
    query: 'embed.html?scene=room',
    expectErrors: true,
  });
  await page.goto(`${host.address}host.html`);
  const talk = (query, isHeard) =>
    page.evaluate(
      async ([source, origin, isHeard]) => {
        const heard = [];
        window.onmessage = ({ data, origin: from }) => heard.push({ ...data, from });
        const frame = Object.assign(document.createElement('iframe'), { src: source });
        document.body.replaceChildren(frame);
        await new Promise((resolve) => {
          frame.onload = resolve;
        });
        const say = (message) => frame.contentWindow.postMessage({ slicecast: 1, ...message }, '*');
        const until = async (what) => {
          for (let wait = 0; wait < 200 && !heard.some(what); ++wait)
            await new Promise((resolve) => setTimeout(resolve, 50));
          return heard.find(what) ?? null;
        };
        say({ id: 1, call: 'whenReady' });
        const ready = await (isHeard
          ? until(({ id }) => id === 1)
          : new Promise((resolve) => setTimeout(() => resolve(null), 1500)));
        if (ready === null) return heard;
        say({ id: 2, call: 'look', arguments: ['2.5,4.5,0.5,90'] });
        say({ id: 3, set: 'options', value: 'fov=75' });
        say({ id: 4, get: 'currentView' });
        say({ id: 5, call: 'set', arguments: ['fvo', 1] });
        say({ id: 6, call: 'remove' });
        say({ id: 7, set: 'scene', value: 'https://elsewhere.example/x.json' });
        say({ id: 8, call: 'snapshot', arguments: [{ width: 32, height: 20 }] });
        await until(({ id }) => id === 8);
        say({ id: 9, call: 'get', arguments: ['fov'] });
        await until(({ id }) => id === 9);
        return {
          answers: Object.fromEntries(
            heard
              .filter(({ id }) => id >= 1)
              .map(({ id, result, error }) => [
                id,
                error ?? (result instanceof Blob ? 'a picture' : result),
              ]),
          ),
          events: heard.filter(({ event }) => event).map(({ event }) => event),
          origins: [...new Set(heard.map(({ from }) => from))].map((from) => from === origin),
        };
      },
      [
        `${server.address}embed.html?scene=room&size=64x40${query}`,
        new URL(server.address).origin,
        isHeard,
      ],
    );
  const { answers, events, origins } = await talk(
    `&origin=${encodeURIComponent(new URL(host.address).origin)}`,
    true,
  );
  assert.equal(answers[1].title, 'The coloured room');
  assert.equal(answers[2], true);
  assert.equal(answers[3], null);
  assert.deepEqual([answers[4].x, answers[4].heading], [2.5, 90]);
  assert.deepEqual(answers[5], {
    code: 'option',
    message: "Unknown option 'fvo'. Did you mean 'fov'?",
  });
  assert.match(answers[6].message, /^Expected call with one of play, pause/);
  assert.equal(answers[7].code, 'address');
  assert.equal(answers[8], 'a picture');
  assert.equal(answers[9], '75');
  assert.ok(events.includes('ready') && events.includes('statechange'));
  assert.deepEqual(origins, [true]);
  for (const query of ['', '&origin=https%3A%2F%2Felsewhere.example', '&origin=null', '&origin=*'])
    assert.deepEqual(await talk(query, false), [], `nobody else is told: ${query}`);
});

test('it works in a frame of another origin', async (t) => {
  const frame = await openHost(t, { headers: {}, sandbox: null });
  await ready(frame);
});

test('it works sandboxed with scripts alone if its host allows any origin', async (t) => {
  const frame = await openHost(t, {
    headers: { 'Access-Control-Allow-Origin': '*' },
    sandbox: 'allow-scripts',
  });
  await ready(frame);
  assert.equal(await frame.evaluate(() => self.origin), 'null');
  assert.equal(await frame.getAttribute('#open', 'target'), '_self', 'a sandbox opens no windows');
});

test('sandboxed, if its host does not allow that, it says what to do', async (t) => {
  const frame = await openHost(t, { headers: {}, sandbox: 'allow-scripts' });
  await frame.waitForFunction(() => !document.getElementById('trouble').hidden);
  assert.match(
    await frame.evaluate(() => document.getElementById('trouble').innerText),
    /Access-Control-Allow-Origin: \*/,
  );
});
