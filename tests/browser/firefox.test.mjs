// The element in a second browser engine: Firefox, driven over WebDriver BiDi. The same pixels as
// in Chromium and under Node, played by keys, and left again.

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { accessSync, constants } from 'node:fs';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import puppeteer from 'puppeteer-core';

import { htmlFile } from '../../web/edit/files/html-file.js';
import { launch } from './browser.mjs';
import { hashHeadless } from './headless.mjs';
import { roomFiles } from './room.mjs';
import { serve } from './static-server.mjs';

const kStartMilliseconds = 60000; // a first start makes a profile
const kWaitMilliseconds = 15000;
const kPage = `<!doctype html><html lang="en"><title>Another engine</title>
<style>ray-caster { display: block; width: 320px; height: 200px } p { height: 3000px }</style>
<script type="module" src="ray-caster.js"></script>
<ray-caster scene="room" size="320x200"></ray-caster><button id="next">Next</button><p></p></html>`;

function findFirefox() {
  const places = [
    process.env.SLICECAST_FIREFOX,
    ...(process.env.PATH ?? '')
      .split(path.delimiter)
      .flatMap((folder) => ['firefox-esr', 'firefox'].map((name) => path.join(folder, name))),
    '/Applications/Firefox.app/Contents/MacOS/firefox',
  ];
  return places.find((place) => {
    try {
      accessSync(place ?? '', constants.X_OK);
      return true;
    } catch {
      return false;
    }
  });
}

const executablePath = findFirefox();
const skip =
  executablePath === undefined &&
  'there is no Firefox; tools/setup installs it where the system has a package, or SLICECAST_FIREFOX names it';
let browser;
let server;
let page;
const complaints = [];

before(async () => {
  if (skip) return;
  server = await serve({ files: { ...roomFiles(), 'firefox.html': kPage } });
  browser = await puppeteer.launch({
    browser: 'firefox',
    executablePath,
    headless: true,
    timeout: kStartMilliseconds,
  });
  page = await browser.newPage();
  page.setDefaultTimeout(kWaitMilliseconds);
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  await page.setViewport({ width: 800, height: 600 });
  await page.goto(`${server.address}firefox.html`);
  await page.waitForFunction(() => document.querySelector('ray-caster').state === 'paused');
});

after(async () => {
  await browser?.close();
  await server?.close();
});

const hashOf = async () => {
  const canvas = document.querySelector('ray-caster').shadowRoot.querySelector('canvas');
  const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', data));
  return `${canvas.width}x${canvas.height} ${[...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('')}`;
};

const state = () => page.evaluate(() => document.querySelector('ray-caster').state);
const view = () => page.evaluate(() => document.querySelector('ray-caster').currentView);

test('the first picture has the bytes that Node draws', { skip }, async () => {
  assert.equal(await page.evaluate(hashOf), await hashHeadless('room.json', roomFiles(), 320, 200));
});

test('the same steps lead to the same picture as in Chromium', { skip }, async () => {
  const walk = () =>
    document.querySelector('ray-caster').step(90, { forward: 1, turn: 0.4, jump: true });
  const chromium = await launch();
  try {
    const other = await chromium.newPage();
    await other.goto(`${server.address}firefox.html`);
    await other.waitForFunction(() => document.querySelector('ray-caster').state === 'paused');
    await other.evaluate(walk);
    await page.evaluate(walk);
    assert.deepEqual(
      await view(),
      await other.evaluate(() => document.querySelector('ray-caster').currentView),
    );
    assert.equal(await page.evaluate(hashOf), await other.evaluate(hashOf));
  } finally {
    await chromium.close();
  }
});

test(
  'it is played by keys after a click, without scrolling the page; Escape leaves, Tab moves on',
  { skip },
  async () => {
    await page.mouse.click(160, 100);
    await page.waitForFunction(() => document.querySelector('ray-caster').state === 'playing');
    const { heading } = await view();
    await page.keyboard.down('ArrowDown');
    await page.keyboard.down('ArrowRight');
    await page.waitForFunction(
      (before) => document.querySelector('ray-caster').currentView.heading !== before,
      {},
      heading,
    );
    await page.keyboard.up('ArrowRight');
    await page.keyboard.up('ArrowDown');
    assert.equal(await page.evaluate(() => scrollY), 0);

    await page.keyboard.press('Escape');
    await page.waitForFunction(() => document.querySelector('ray-caster').state === 'paused');
    await page.keyboard.press('Tab');
    await page.waitForFunction(() => document.activeElement?.id === 'next');
    await page.keyboard.press('ArrowDown');
    await page.waitForFunction(() => scrollY > 0);
    assert.equal(await state(), 'paused');
  },
);

test(
  'a slip is warned of, a child stands on its place, another view follows, none is not touched',
  { skip },
  async () => {
    const found = await page.evaluate(async () => {
      const first = document.querySelector('ray-caster');
      const other = document.createElement('ray-caster');
      Object.assign(other, { scene: 'room', size: '64x40', loading: 'eager', id: 'other' });
      Object.assign(other, { options: 'fvo=75, light=off', interaction: 'none' });
      other.innerHTML = '<b data-at="5.9,3.5,0.5">Here</b>';
      document.body.append(other);
      await other.whenReady();
      first.look('2.5,3.5,0.5,0');
      other.syncwith = 'ray-caster';
      const until = async (isSo) => {
        for (let wait = 0; wait < 100 && !isSo(); ++wait)
          await new Promise((resolve) => setTimeout(resolve, 50));
        return isSo();
      };
      const result = {
        warnings: other.warnings.map(({ message }) => message),
        light: other.get('light'),
        follows: await until(() => other.currentView.x === 2.5),
        stands: await until(
          () => other.querySelector('b').assignedSlot?.parentElement.className === 'hotspot',
        ),
        isShut: other.shadowRoot.querySelector('.cover').getClientRects().length === 0,
      };
      other.remove();
      return result;
    });
    assert.deepEqual(found, {
      warnings: ["Unknown option 'fvo'. Did you mean 'fov'?"],
      light: 'off',
      follows: true,
      stands: true,
      isShut: true,
    });
  },
);

test('the editor adds a block and takes it back', { skip }, async () => {
  await page.evaluate(() => localStorage.setItem('slicecast edit tour', 'yes'));
  await page.goto(`${server.address}edit.html?template=meadow`);
  await page.waitForFunction(() => document.body.dataset.state === 'ready');
  const state = () =>
    page.evaluate(async () => {
      const { caster, editor, scene, sync } = window.slicecastEditor;
      await sync.settled();
      const rows = scene.rows(editor.map, 0).map((row) => row.replaceAll(' ', '.'));
      const drawn = caster.cells(editor.mapName)[0].map((row) => row.replaceAll(' ', '.'));
      return { text: scene.text, isDrawn: drawn.join() === rows.join() };
    });
  const { text } = await state();
  const { x, y, width, height } = await (await page.$('#picture')).boundingBox();
  await page.mouse.click(x + width / 2, y + 0.7 * height);
  const built = await state();
  assert.notEqual(built.text, text);
  assert.ok(built.isDrawn);
  await page.keyboard.down('Control');
  await page.keyboard.press('z');
  await page.keyboard.up('Control');
  assert.deepEqual(await state(), { text, isDrawn: true });
});

test('one HTML file plays from a disk', { skip }, async (t) => {
  const folder = await mkdtemp(path.join(tmpdir(), 'slicecast-firefox-'));
  t.after(() => rm(folder, { recursive: true }));
  const file = path.join(folder, 'room.html');
  const player = await readFile(new URL('../../build/web/edit/player.bin', import.meta.url));
  const files = roomFiles();
  const html = await htmlFile({
    player,
    text: files['scenes/room.json'],
    readPicture: async (name) => Buffer.from(files[path.posix.join('scenes', name)]),
    deflate: deflateRawSync,
  });
  await writeFile(file, html);
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => document.activeElement.localName === 'ray-caster');
  const before = await page.evaluate(() => document.querySelector('ray-caster').currentView);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.querySelector('ray-caster').entered);
  await page.keyboard.down('w');
  await page.waitForFunction(
    ({ x, y }) => {
      const now = document.querySelector('ray-caster').currentView;
      return Math.hypot(now.x - x, now.y - y) > 0.3;
    },
    {},
    before,
  );
  await page.keyboard.up('w');
});

test('there were no errors on the console', { skip }, () => assert.deepEqual(complaints, []));
