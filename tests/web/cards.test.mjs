// What a link to a page of the built site shows elsewhere: a title, a description and a picture.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { root } from '../wasm/load.mjs';

const kSite = join(root, 'build/web');

const isRedirect = (page) => page.includes('http-equiv="refresh"');
const pagesIn = (folder) =>
  readdirSync(folder, { recursive: true }).filter(
    (file) =>
      file.endsWith('.html') &&
      // Frames of the tutorial's editor
      !file.startsWith(join('learn', 'write')) &&
      !isRedirect(readFileSync(join(folder, file), 'utf8')),
  );

function cardOf(folder, file) {
  const page = readFileSync(join(folder, file), 'utf8');
  const tags = page.matchAll(
    /<meta (?:property|name)="((?:og|twitter):[^"]*)" content="([^"]*)">/g,
  );
  return Object.fromEntries([...tags].map(([, name, content]) => [name, content]));
}

const sizeOf = (png) => [png.readUInt32BE(16), png.readUInt32BE(20)];

test('every page has a card, with a picture that exists and has the size it says', () => {
  const pages = pagesIn(kSite);
  assert.ok(pages.length > 40, `${pages.length} pages`);
  for (const file of pages) {
    const card = cardOf(kSite, file);
    assert.ok(card['og:title']?.length > 3, file);
    assert.equal(card['twitter:card'], 'summary_large_image', file);
    const picture = join(kSite, dirname(file), card['og:image']);
    assert.ok(existsSync(picture), `${file}: ${card['og:image']}`);
    const size = [Number(card['og:image:width']), Number(card['og:image:height'])];
    assert.ok(size[0] >= 480 && size[1] >= 200, `${file}: ${size}`);
    const real = sizeOf(readFileSync(picture));
    assert.ok(Math.abs(real[0] / real[1] - size[0] / size[1]) < 0.02, `${file}: ${real}`);
    assert.ok(card['og:image:alt'].length > 0, file);
  }
  for (const file of ['index.html', 'embed.html', 'docs/play.html', 'learn/mirrors.html'])
    assert.ok(cardOf(kSite, file)['og:description']?.length > 20, file);
  assert.equal(cardOf(kSite, 'index.html')['og:image'], 'card.png');
  assert.equal(cardOf(kSite, 'learn/index.html')['og:image'], 'pictures/index.png');
});

test('with the address of the site, all addresses are full, also the second time', (t) => {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-cards-'));
  t.after(() => rmSync(folder, { recursive: true }));
  cpSync(kSite, folder, { recursive: true });
  const address = 'https://host.example/slicecast/';
  const make = (...more) =>
    execFileSync(process.execPath, [join(root, 'tools/cards.mjs'), folder, ...more]);
  make(address);
  make(address);
  const play = cardOf(folder, 'index.html');
  assert.equal(play['og:image'], `${address}card.png`);
  assert.equal(play['og:url'], address);
  const chapter = cardOf(folder, 'learn/mirrors.html');
  assert.match(
    chapter['og:image'],
    /^https:\/\/host\.example\/slicecast\/learn\/pictures\/.*\.png$/,
  );
  assert.equal(chapter['og:url'], `${address}learn/mirrors.html`);
  const text = readFileSync(join(folder, 'index.html'), 'utf8');
  assert.equal(text.match(/og:title/g).length, 1);
  assert.throws(
    () => make('host.example'),
    ({ stderr }) => /found the address 'host\.example', expected one like https:/.test(stderr),
  );
});
