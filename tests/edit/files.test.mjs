// Files that worlds come from and go to: nothing that was not changed differs, nothing hostile gets
// further than a message.

import assert from 'node:assert/strict';
import { Buffer } from 'node:buffer';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import process from 'node:process';
import { test } from 'node:test';
import vm from 'node:vm';
import { deflateRawSync, inflateRawSync } from 'node:zlib';

import { editModules, seededRandom } from './modules.mjs';

const {
  beginningOf,
  bytesIn,
  bytesOfDense,
  Changed,
  denseText,
  differencesOf,
  frameFor,
  History,
  htmlFile,
  merged,
  openFiles,
  picturesOf,
  pictureSizeOf,
  Saving,
  SceneDocument,
  tagFor,
  textIn,
  wordsIn,
} = await editModules();
const { strToU8, zipSync } = createRequire(new URL('../../tools/package.json', import.meta.url))(
  'fflate',
);
const kPlayer = readFileSync(new URL('../../build/web/edit/player.bin', import.meta.url));
const pageOf = (bytes) => new TextDecoder('utf-16le').decode(bytes);
const kPicture = readFileSync(new URL('../../assets/textures/brick.png', import.meta.url));
const utf8 = (text) => new TextEncoder().encode(text);

// ---- Texts

for (const [what, text] of Object.entries({
  plain: '{\n  "a": 1\n}\n',
  'without an end of line': '{ "a": 1 }',
  'of Windows': '{\r\n  "a": "ü"\r\n}\r\n\r\n',
  'with a mark': '\uFEFF{\r\n}\r\n',
  'with mixed line ends': '{\r\n  "a": 1,\n "b": "\\r"\r}\n',
})) {
  test(`a text ${what} comes out as it went in`, () => {
    const { text: inside, form } = textIn(utf8(text));
    assert.ok(!inside.startsWith('\uFEFF'));
    assert.equal(Buffer.from(bytesIn(inside, form)).toString(), text);
  });
}

test('what is added to a text of Windows has its line ends', () => {
  const { text, form } = textIn(utf8('{\r\n}\r\n'));
  assert.equal(text, '{\n}\n');
  const bytes = bytesIn('{\n  "a": 1\n}\n', form);
  assert.equal(Buffer.from(bytes).toString(), '{\r\n  "a": 1\r\n}\r\n');
});

test('bytes that are no text are refused', () => {
  assert.throws(() => textIn(Uint8Array.of(0x7b, 0xff, 0x7d)), /no UTF-8, expected a text/);
});

test('differences of lines are found, and nothing else', () => {
  assert.deepEqual(differencesOf('a\nb', 'a\nb'), []);
  assert.deepEqual(differencesOf('a\nb\nc\nd', 'a\nx\nc\nd\ne'), [
    { one: { from: 2, lines: ['b'] }, other: { from: 2, lines: ['x'] } },
    { one: { from: 5, lines: [] }, other: { from: 5, lines: ['e'] } },
  ]);
  const random = seededRandom(7);
  for (let round = 0; round < 200; ++round) {
    const lines = () => Array.from({ length: random(12) }, () => 'abc'[random(3)]);
    const [one, other] = [lines(), lines()];
    const made = [...one];
    for (const place of differencesOf(one.join('\n'), other.join('\n')).reverse())
      made.splice(place.one.from - 1, place.one.lines.length, ...place.other.lines);
    assert.equal(made.join('\n'), other.join('\n'));
  }
});

test('changes of both sides make one text, unless they meet', () => {
  const base = 'a\nb\nc\nd\ne';
  assert.equal(merged(base, 'A\nb\nc\nd\ne', 'a\nb\nc\nx\ny\ne'), 'A\nb\nc\nx\ny\ne');
  assert.equal(merged(base, 'a\nc\nd\ne', 'a\nb\nc\nd\ne\nf'), 'a\nc\nd\ne\nf');
  assert.equal(merged(base, 'A\nb\nc\nd\nE', 'A\nb\nC\nd\ne'), 'A\nb\nC\nd\nE');
  for (const [mine, theirs] of [
    ['A\nb\nc\nd\ne', 'x\nb\nc\nd\ne'],
    ['A\nb\nc\nd\ne', 'a\nB\nc\nd\ne'],
    ['a\nb\nm\nc\nd\ne', 'a\nb\nt\nc\nd\ne'],
    ['a\nc\nd\ne', 'a\nb\nt\nc\nd\ne'],
  ])
    assert.equal(merged(base, mine, theirs), null, `${mine} ${theirs}`);
});

// ---- Saving

function fileWith(text) {
  const file = {
    name: 'my.json',
    bytes: utf8(text),
    get tag() {
      return Buffer.from(file.bytes).toString('base64');
    },
    read: async () => ({ bytes: file.bytes, tag: file.tag }),
    ifReadable: () => file.read(),
    async write(bytes, tag) {
      if (tag !== null && tag !== file.tag) throw new Changed();
      file.bytes = bytes;
      return file.tag;
    },
    get text() {
      return Buffer.from(file.bytes).toString();
    },
  };
  return file;
}

async function savingTo(text, choose = () => assert.fail('nobody is to be asked')) {
  const home = fileWith(text);
  const { bytes, tag } = await home.read();
  const { text: inside, form } = textIn(bytes);
  const scene = new SceneDocument(inside);
  const history = new History(scene);
  const asked = [];
  const saving = new Saving(scene, history, {
    ...{ home, form, tag, savedText: inside },
    choose: async (texts) => {
      asked.push(texts);
      return choose(texts);
    },
  });
  const rename = (title) => history.do('Rename', [{ path: ['title'], value: title }]);
  return { home, scene, history, saving, rename, asked };
}

const kText = '{\r\n  "title": "One",\r\n  "maps": []\r\n}';

test('a save writes what was changed, and nothing else', async () => {
  const { home, saving, rename } = await savingTo(`\uFEFF${kText}`);
  assert.equal(saving.isUnsaved, false);
  rename('Two');
  assert.equal(saving.isUnsaved, true);
  assert.equal(await saving.save(), 'saved');
  assert.equal(home.text, `\uFEFF${kText.replace('One', 'Two')}`);
  assert.equal(saving.isUnsaved, false);
});

test('a file that has changed outside is shown, and what is chosen happens', async () => {
  for (const choice of ['mine', 'theirs', null]) {
    const { home, scene, history, saving, rename, asked } = await savingTo(kText, () => choice);
    rename('Mine');
    home.bytes = utf8('{ "title": "Theirs", "maps": [] }\n');
    await saving.save();
    assert.equal(asked.length, 1);
    assert.match(asked[0].mine, /"Mine"/);
    assert.match(asked[0].theirs, /"Theirs"/);
    assert.equal(scene.value.title, choice === 'theirs' ? 'Theirs' : 'Mine');
    assert.match(home.text, choice === 'mine' ? /"Mine"/ : /"Theirs"/);
    assert.equal(saving.isUnsaved, choice === null);
    if (choice !== 'theirs') continue;
    history.undo();
    assert.equal(scene.value.title, 'Mine', 'nothing is lost');
    rename('Third');
    await saving.save();
    assert.equal(home.text, '{\n  "title": "Third",\n  "maps": []\n}', 'in the form of the file');
  }
});

test('a file that has what is here needs no choice', async () => {
  const { home, saving, rename, scene } = await savingTo(kText);
  rename('Two');
  home.bytes = utf8(scene.text);
  assert.equal(await saving.save(), 'saved');
  assert.equal(saving.isUnsaved, false);
});

test('what others saved is taken without changes here; with changes one is asked if one wants', async () => {
  const choices = [null, 'both'];
  const { home, saving, rename, scene, history, asked } = await savingTo(
    '{\n  "title": "One",\n  "maps": [],\n  "start": {}\n}',
    () => choices.shift(),
  );
  home.bytes = utf8(home.text.replace('One', 'Theirs'));
  assert.equal(await saving.settle(), 'taken');
  assert.equal(scene.value.title, 'Theirs');
  assert.equal(saving.isUnsaved, false);
  rename('Mine');
  home.bytes = utf8(home.text.replace('{}', '{ "x": 1 }'));
  await saving.settle();
  assert.deepEqual([asked.length, saving.isOvertaken, scene.value.title], [0, true, 'Mine']);
  await saving.decide();
  assert.deepEqual([saving.isOvertaken, scene.value.title], [true, 'Mine']);
  await saving.decide();
  assert.equal(saving.isOvertaken, false);
  assert.deepEqual(scene.value, { title: 'Mine', maps: [], start: { x: 1 } });
  assert.equal(await saving.save(), 'saved');
  assert.match(home.text, /Mine[^]*"x": 1/);
  history.undo();
  assert.deepEqual(scene.value.start, {}, 'nothing is lost');
});

test('both are not offered where they are no scene together', async () => {
  const { home, saving, rename, asked } = await savingTo(kText, () => null);
  rename('Mine');
  home.bytes = utf8(kText.replace('"maps": []', '"maps": ['));
  await saving.settle();
  await saving.decide();
  assert.equal(asked[0].both, null);
});

test('a text with a mistake is not saved', async () => {
  const { home, scene, saving } = await savingTo(kText);
  scene.apply([{ offset: 0, length: 1, content: '' }]);
  await assert.rejects(saving.save(), /has a mistake/);
  assert.equal(home.text, kText);
});

test('a file that cannot be written is not taken for the world’s', async () => {
  const { saving, home } = await savingTo(kText);
  const other = { name: 'other.json', write: () => Promise.reject(new Error('No.')) };
  await assert.rejects(saving.saveTo(other), /No\./);
  assert.equal(saving.home, home);
});

test('on return there is what is newest, and a change of both sides is known', () => {
  const home = {};
  const world = { text: 'disk', tag: 'now', home, isRead: true };
  const kept = (text, tag, isSaved) => ({ text, base: { tag, isSaved } });
  const begin = (one) => beginningOf(world, one);
  assert.deepEqual(begin(null), { text: 'disk', savedText: 'disk', tag: 'now' });
  assert.deepEqual(begin(kept('old', 'then', true)), begin(null), 'it was saved');
  assert.deepEqual(begin(kept('mine', 'now', false)), {
    text: 'mine',
    savedText: 'disk',
    tag: 'now',
  });
  assert.deepEqual(begin(kept('mine', 'then', false)), {
    text: 'mine',
    savedText: null,
    tag: 'then',
  });
  const { base, ...mine } = kept('mine', 'then', false);
  assert.equal(begin({ ...mine, base: { ...base, savedText: 'old' } }).savedText, 'old');
  assert.equal(beginningOf({ text: 'new' }, kept('mine')).text, 'mine', 'without a file');
});

// ---- Files that are opened

const fileOf = (name, content) =>
  new File([typeof content === 'string' ? utf8(content) : content], name);
const kScene = '{ "maps": [{ "name": "a" }] }';
const zipOf = (files) =>
  fileOf(
    'world.zip',
    zipSync(
      Object.fromEntries(
        Object.entries(files).map(([name, content]) => [
          name,
          typeof content === 'string' ? strToU8(content) : content,
        ]),
      ),
    ),
  );

test('a zip gives its scene, with pictures named from the scene’s folder', async () => {
  const world = await openFiles([
    zipOf({
      'yard/scenes/yard.json': `\uFEFF${kScene}`,
      'yard/scenes/mine.png': kPicture,
      'yard/textures/brick.png': kPicture,
      'yard/scenes/.DS_Store': 'x',
      '__MACOSX/yard/scenes/mine.png': 'x',
    }),
  ]);
  assert.equal(world.name, 'yard');
  assert.equal(world.text, kScene);
  assert.equal(world.form.hasMark, true);
  assert.deepEqual([...world.pictures.keys()], ['mine.png', '../textures/brick.png']);
});

for (const name of ['../evil.json', 'a/../../evil.png', '/etc/evil.png', 'C:evil.png', 'a\\b.png'])
  test(`a zip that names ${name} is refused`, async () => {
    await assert.rejects(
      openFiles([zipOf({ 'yard.json': kScene, [name]: 'x' })]),
      /names a file ".*", expected one in its own folder/,
    );
  });

test('zips that unpack to too much are refused early', async () => {
  const bomb = zipOf({ 'yard.json': kScene, 'a.png': new Uint8Array(200 << 20) });
  const before = process.memoryUsage().rss;
  await assert.rejects(openFiles([bomb]), /too large: found more than 64 MB/);
  assert.ok(process.memoryUsage().rss - before < 160 << 20);
  const crowd = Object.fromEntries(Array.from({ length: 4001 }, (_, at) => [`${at}.png`, 'x']));
  await assert.rejects(openFiles([zipOf(crowd)]), /more than 4000 files/);
});

test('what is no scene is refused in words', async () => {
  for (const [file, message] of [
    [fileOf('a.json', '{'), /a\.json is no JSON/],
    [fileOf('a.json', '[1]'), /found a list, expected/],
    [fileOf('a.json', 'null'), /has no maps/],
    [fileOf('a.json', Uint8Array.of(0xff)), /no UTF-8/],
    [zipOf({ 'a.png': kPicture }), /expected a scene/],
    [fileOf('a.zip', 'nothing'), /expected a scene|damaged|invalid/],
    [{ name: 'a.json', size: 2 ** 27 + 1 }, /too large: found 129 MB, expected 128 MB at most/],
    [{ name: 'a.png', size: 2 ** 26 + 1 }, /too large: found 65 MB/],
  ])
    await assert.rejects(openFiles([file]), message);
  await assert.rejects(openFiles([]), /no file/);
});

// ---- One HTML file

test('dense text holds any bytes', () => {
  const random = seededRandom(5);
  for (let length = 0; length < 300; ++length) {
    const bytes = Uint8Array.from({ length }, () => random(256));
    assert.deepEqual(bytesOfDense(denseText(bytes)), bytes);
    assert.deepEqual(bytesOfDense(denseText(bytes.fill(255))), bytes);
    assert.deepEqual(bytesOfDense(denseText(bytes.fill(0))), bytes);
  }
  const text = denseText(Uint8Array.from({ length: 1 << 16 }, () => random(256)));
  assert.match(text, /^[\u4000-\ubfff]+$/);
  assert.ok(2 * text.length < 1.07 * (1 << 16));
});

const kHostile = [
  '</title><script>alert(1)</script>',
  '</script><!-- <script>',
  '\u2028\u2029"\'`${1}$&$1',
  '{{world}}{{parts}}',
  '<img src=x onerror=alert(1)>',
];

for (const hostile of kHostile) {
  test(`the HTML file holds ${JSON.stringify(hostile)} as a text`, async () => {
    const scene = {
      title: hostile,
      textures: { [hostile]: `${hostile}.png`, unused: 'unused.png', red: '#ff0000' },
      maps: [{ name: hostile, floor: hostile, sky: { panorama: `${hostile}2.png` } }],
    };
    const file = await htmlFile({
      player: kPlayer,
      text: JSON.stringify(scene),
      readPicture: async (name) => (name === 'unused.png' ? null : kPicture),
      deflate: deflateRawSync,
    });
    const html = pageOf(file);
    const elements = (text) => text.match(/<(?!\/)[a-z!][^>\s]*/gi);
    assert.deepEqual(elements(html), elements(pageOf(kPlayer)), 'no element more');
    const title = /<title>([^]*?)<\/title>/.exec(html)[1];
    assert.equal(
      title.replace(/&(lt|gt|amp|quot|#39);/g, (_, name) => {
        return { lt: '<', gt: '>', amp: '&', quot: '"', '#39': "'" }[name];
      }),
      hostile,
    );
    const packed = /id="world">\n([^<]*)\n<\/script>/.exec(html)[1];
    const bytes = inflateRawSync(bytesOfDense(packed)).subarray(1);
    const head = JSON.parse(bytes.subarray(0, bytes.indexOf(0)));
    assert.equal(head.title, hostile);
    assert.equal(JSON.parse(head.text).maps[0].floor, hostile);
    assert.deepEqual(
      head.pictures.map(([file]) => file),
      [`${hostile}.png`, `${hostile}2.png`],
    );
    assert.deepEqual(bytes.subarray(-kPicture.length), kPicture);
  });
}

test('scenes that cannot become a file are told apart', async () => {
  const make = (text) =>
    htmlFile({ player: kPlayer, text, readPicture: async () => null, deflate: deflateRawSync });
  await assert.rejects(make('{'), /no JSON/);
  await assert.rejects(make('{}'), /no maps/);
  await assert.rejects(make('null'), /no maps/);
  await assert.rejects(
    make('{ "textures": { "a": "a.png" }, "maps": [{ "floor": "a" }] }'),
    /picture "a\.png" is not there/,
  );
});

test('the player names its libraries with their licences, and fits its limit', () => {
  assert.ok(kPlayer.length < 425_000, `${kPlayer.length}`);
  const page = pageOf(kPlayer);
  const packed = /id="texts">\n([^<]*)\n<\/script>/.exec(page)[1];
  const texts = inflateRawSync(bytesOfDense(packed)).toString();
  for (const name of ['Slicecast', 'RapidJSON', 'stb_image', 'SDL', 'musl'])
    assert.ok(texts.includes(name), name);
  assert.ok(texts.split('Permission is hereby granted').length > 3);
  const script = /<script>\n([^]*?)\n<\/script>/.exec(page)[1];
  new vm.Script(script); // throws if it is none
});

test('pictures and words of a scene', () => {
  const scene = {
    textures: { a: 'a.png', b: { file: 'b.png', frames: 2 }, c: '#fff' },
    sprites: { d: { file: 'd.png' } },
    blueprints: { wall: { faces: { all: 'a' } } },
    maps: [{ sky: { panorama: 'e.png' } }, { sky: '#fff' }],
  };
  assert.deepEqual(picturesOf(scene), ['a.png', 'b.png', 'd.png', 'e.png']);
  const words = wordsIn(scene);
  assert.deepEqual([words.has('a'), words.has('b'), words.has('d')], [true, false, false]);
});

// ---- Pictures and texts to copy

test('pictures are known by their bytes', () => {
  assert.deepEqual(pictureSizeOf(kPicture), { type: 'PNG', width: 128, height: 128 });
  const gif = Buffer.from('GIF89a\x20\x00\x10\x00\x00\x00', 'latin1');
  assert.deepEqual(pictureSizeOf(gif), { type: 'GIF', width: 32, height: 16 });
  const jpeg = Buffer.from('ffd8ffe000040000ffc2001108012c019003', 'hex');
  assert.deepEqual(pictureSizeOf(jpeg), { type: 'JPEG', width: 400, height: 300 });
  const webp = Buffer.alloc(30);
  webp.write('RIFF', 0);
  webp.write('WEBPVP8X', 8);
  webp.writeUIntLE(99, 24, 3);
  webp.writeUIntLE(49, 27, 3);
  assert.deepEqual(pictureSizeOf(webp), { type: 'WebP', width: 100, height: 50 });
});

test('what is no picture, or too large a one, is refused', () => {
  assert.throws(() => pictureSizeOf(utf8('<svg xmlns="...">')), /an SVG, which may hold scripts/);
  assert.throws(() => pictureSizeOf(utf8('BM')), /another kind of file/);
  assert.throws(() => pictureSizeOf(new Uint8Array()), /another kind of file/);
  assert.throws(() => pictureSizeOf(Buffer.from('ffd8ff', 'hex')), /damaged/);
  const large = Buffer.from(kPicture);
  large.writeUInt32BE(20000, 16);
  assert.throws(() => pictureSizeOf(large), /20000 × 128 pixels/);
  large.writeUInt32BE(12000, 16);
  large.writeUInt32BE(12000, 20);
  assert.throws(() => pictureSizeOf(large), /12000 × 12000 pixels, expected at most 64 million/);
});

test('a title in a tag or a frame stays a title', () => {
  for (const title of kHostile)
    for (const text of [tagFor({ name: 'a', title }), frameFor({ name: 'a', title })]) {
      assert.equal(text.match(/<(?!\/)/g).length, text.includes('iframe') ? 1 : 2, text);
      assert.equal(text.split('"').length % 2, 1);
    }
});
