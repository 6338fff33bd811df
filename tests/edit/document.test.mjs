// The document of the editor: the text stays to the letter but for what is changed, every change
// can be undone, and the value is always what the text says.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';

import { shippedScenes } from '../wasm/load.mjs';
import { editModules, seededRandom } from './modules.mjs';

const { SceneDocument, History, cellChanges, kindsOf, printed, sizeOf } = await editModules();

const kRoom = `{
  "title": "A room",
  "blueprints": { "wall": { "faces": "grey" } },
  "legend": {"#": "wall"},

  "maps": [
    { "name": "room", "levels": [
        [ "####",   "#..#",
          "####" ], [] ], "floor": "grey" }
  ],
  "start": { "x": 1.5, "y": 1.5 }
}
`;

// The text between what two texts have in common at their ends.
function difference(before, after) {
  let from = 0;
  while (from < before.length && before[from] === after[from]) ++from;
  let back = 0;
  const most = Math.min(before.length, after.length) - from;
  while (back < most && before.at(-1 - back) === after.at(-1 - back)) ++back;
  return [before.slice(from, before.length - back), after.slice(from, after.length - back)];
}

function opened(text) {
  const scene = new SceneDocument(text);
  return { scene, history: new History(scene) };
}

test('a cell changes one letter, a value its own text', () => {
  const { scene, history } = opened(kRoom);
  history.do('Place', [{ map: 0, cells: [{ layer: 0, x: 1, y: 1, sign: '#' }] }]);
  assert.deepEqual(difference(kRoom, scene.text), ['.', '#']);
  assert.equal(scene.value.maps[0].levels[0][1], '##.#');
  assert.equal(scene.sign(0, 0, 1, 1), '#');
  const before = scene.text;
  history.do('Move', [{ path: ['start', 'x'], value: 2.25 }]);
  assert.deepEqual(difference(before, scene.text), ['1.', '2.2']);
  history.undo();
  history.undo();
  assert.equal(scene.text, kRoom);
  history.redo();
  history.redo();
  assert.equal(scene.value.start.x, 2.25);
});

test('keys and elements are added and removed as those around them', () => {
  const { scene, history } = opened(kRoom);
  const change = (path, value, how = {}) => {
    const before = scene.text;
    history.do('Change', [{ path, value, ...how }]);
    return difference(before, scene.text);
  };
  assert.deepEqual(change(['legend', 'o'], 'wall'), ['', ', "o": "wall"']);
  assert.deepEqual(change(['start', 'heading'], 90), ['', ', "heading": 90']);
  assert.deepEqual(change(['haze'], '#ffffff'), ['', ',\n  "haze": "#ffffff"']);
  assert.deepEqual(change(['maps', 0, 'objects', 0], { sprite: 'a', x: 1 }), [
    '',
    ', "objects": [{ "sprite": "a", "x": 1 }]',
  ]);
  assert.deepEqual(change(['maps', 0, 'objects', 0], { sprite: 'b' }, { insert: true }), [
    '',
    'b" }, { "sprite": "',
  ]);
  assert.deepEqual(
    scene.value.maps[0].objects.map(({ sprite }) => sprite),
    ['b', 'a'],
  );
  change(['maps', 0, 'objects', 0], undefined);
  change(['maps', 0, 'objects', 0], undefined);
  assert.deepEqual(scene.value.maps[0].objects, []);
  change(['title'], undefined);
  assert.equal(Object.hasOwn(scene.value, 'title'), false);
  change(['legend', '#'], undefined);
  change(['legend', 'o'], undefined);
  assert.deepEqual(scene.value.legend, {});
  while (history.undo() !== null);
  assert.equal(scene.text, kRoom);
});

test('levels and floors are made where a cell needs them', () => {
  const { scene, history } = opened(kRoom);
  const put = (cells) => history.do('Place', cellChanges(scene, 0, cells));
  put([{ layer: 1, x: 0, y: 0, sign: '#' }]);
  assert.deepEqual(scene.rows(0, 1), ['#...', '....', '....']);
  put([{ layer: 4, x: 3, y: 2, sign: '#' }]);
  assert.deepEqual(scene.value.maps[0].levels.slice(2), [[], [], ['....', '....', '...#']]);
  put([{ layer: 'floor', x: 0, y: 0, sign: 'f' }]);
  assert.equal(scene.value.maps[0].floor.texture, 'grey');
  assert.deepEqual(scene.rows(0, 'floor'), ['f...', '....', '....']);
  put([{ layer: 0, x: 4, y: 0, sign: '#' }]);
  put([{ layer: 32, x: 0, y: 0, sign: '#' }]);
  assert.deepEqual(sizeOf(scene, 0), { width: 4, depth: 3, levels: 5 }, 'outside: nothing');
  while (history.undo() !== null);
  assert.equal(scene.text, kRoom);
});

test('filled and repeated levels have rows, which are written out where a cell changes', () => {
  const text = `{
  "blueprints": { "wall": { "faces": "grey" } },
  "legend": { "#": "wall", "o": "wall" },
  "maps": [{ "name": "tower", "size": [4, 3], "levels": [
    { "fill": "#", "rows": ["    ", " ..o"] },
    { "repeat": 2, "levels": [
      [],
      { "fill": [{ "character": "o", "x": 1, "y": 1, "width": 9, "depth": 1 }] }
    ] },
    [ "...#", "....", "...." ]
  ] }],
  "start": { "x": 1.5, "y": 1.5 }
}
`;
  const { scene, history } = opened(text);
  assert.deepEqual(sizeOf(scene, 0), { width: 4, depth: 3, levels: 6 });
  const rows = () =>
    Array.from({ length: sizeOf(scene, 0).levels }, (_, level) => scene.rows(0, level));
  const ring = ['....', '.ooo', '....'];
  const before = [['####', '#..o', '####'], [], ring, [], ring, ['...#', '....', '....']];
  assert.deepEqual(rows(), before);
  const put = (cells) => history.do('Place', cellChanges(scene, 0, cells));
  put([{ layer: 5, x: 0, y: 0, sign: 'o' }]);
  assert.deepEqual(difference(text, scene.text), ['.', 'o'], 'a row below a repetition');
  put([{ layer: 2, x: 1, y: 1, sign: 'o' }]);
  assert.equal(history.length, 1, 'what stands there is not written');
  put([{ layer: 3, x: 0, y: 2, sign: '#' }]);
  const after = before.with(3, ['....', '....', '#...']).with(5, ['o..#', '....', '....']);
  assert.deepEqual(rows(), after);
  assert.deepEqual(scene.value.maps[0].levels.slice(1), after.slice(1));
  assert.deepEqual(scene.value.maps[0].levels[0].rows, ['    ', ' ..o'], 'not touched');
  put([
    { layer: 0, x: 3, y: 2, sign: '.' },
    { layer: 7, x: 0, y: 0, sign: '#' },
  ]);
  assert.deepEqual(rows().slice(0, 1), [['####', '#..o', '###.']]);
  assert.deepEqual(rows().slice(6), [[], ['#...', '....', '....']]);
  while (history.undo() !== null);
  assert.equal(scene.text, text);
});

test('signs of several code points and escapes in rows are one cell each', () => {
  const text = kRoom
    .replace('"#": "wall"', '"#": "wall", "🇩🇪": "wall", "\\"": "wall"')
    .replace('"#..#"', '"#\\u002e🇩🇪\\""');
  const { scene, history } = opened(text);
  assert.equal(scene.sign(0, 0, 2, 1), '🇩🇪');
  history.do('Place', cellChanges(scene, 0, [{ layer: 0, x: 1, y: 1, sign: '"' }]));
  assert.equal(scene.value.maps[0].levels[0][1], '#"🇩🇪"');
  history.do('Place', cellChanges(scene, 0, [{ layer: 0, x: 2, y: 1, sign: '.' }]));
  assert.equal(scene.value.maps[0].levels[0][1], '#"."');
  history.undo();
  history.undo();
  assert.equal(scene.text, text);
});

test('while the text is no JSON, the value is the last good one', () => {
  const { scene, history } = opened(kRoom);
  const at = kRoom.indexOf('"start"');
  scene.apply([{ offset: at, length: 1, content: '' }]);
  assert.equal(scene.mistake.offset >= at, true);
  assert.equal(scene.value.start.x, 1.5);
  history.undo();
  assert.equal(scene.mistake, null);
  assert.equal(scene.text, kRoom);
  assert.throws(() => new SceneDocument('{ "maps": [ }'), SyntaxError);
  assert.throws(() => new SceneDocument('{} // a note'), SyntaxError);
});

test('cells are told one by one, other changes as a whole', () => {
  const { scene, history } = opened(kRoom);
  const told = [];
  scene.listen(({ cells, isWhole }) => told.push(isWhole ? 'whole' : cells));
  history.do(
    'Place',
    cellChanges(scene, 0, [
      { layer: 0, x: 1, y: 1, sign: '#' },
      { layer: 0, x: 2, y: 1, sign: '#' },
      { layer: 0, x: 0, y: 2, sign: '.' },
    ]),
  );
  history.do('Move', [{ path: ['start', 'x'], value: 2 }]);
  history.undo();
  history.undo();
  const back = (x, y, sign) => ({ map: 0, layer: 0, x, y, sign });
  assert.deepEqual(told, [
    [back(1, 1, '#'), back(2, 1, '#'), back(0, 2, '.')],
    'whole',
    'whole',
    [back(1, 1, '.'), back(2, 1, '.'), back(0, 2, '#')],
  ]);
});

// Every path to a number, a text or a truth, but for rows.
function leavesOf(value, at = []) {
  if (typeof value !== 'object' || value === null) return [at];
  return Object.entries(value).flatMap(([key, child]) =>
    ['levels', 'tiles'].includes(key)
      ? []
      : leavesOf(child, [...at, Array.isArray(value) ? Number(key) : key]),
  );
}

for (const file of shippedScenes) {
  test(`only what is changed differs in ${path.basename(file)}, and undo gives its bytes`, () => {
    const before = readFileSync(file, 'utf8');
    const { scene, history } = opened(before);
    const random = seededRandom(before.length);
    for (let round = 0; round < 100; ++round) {
      const text = scene.text;
      if (random(2) === 0) {
        const map = random(scene.value.maps.length);
        const { width, depth, levels } = sizeOf(scene, map);
        const kinds = kindsOf(scene, map);
        const cells = Array.from({ length: 1 + random(5) }, () => ({
          layer: random(levels),
          x: random(width),
          y: random(depth),
          sign: random(3) === 0 ? '.' : kinds[random(kinds.length)].sign,
        }));
        history.do('Place', cellChanges(scene, map, cells));
        for (const { layer, x, y, sign } of cells) {
          const isLast = cells.findLast(
            (cell) => cell.layer === layer && cell.x === x && cell.y === y,
          );
          if (isLast.sign === sign) assert.equal(scene.sign(map, layer, x, y), sign);
        }
      } else {
        const leaves = leavesOf(scene.value);
        const at = leaves[random(leaves.length)];
        const value = [12.5, 'something else', true, undefined][random(4)];
        const wanted = structuredClone(scene.value);
        const parent = at.slice(0, -1).reduce((node, key) => node[key], wanted);
        if (value !== undefined) parent[at.at(-1)] = value;
        else if (Array.isArray(parent)) parent.splice(at.at(-1), 1);
        else delete parent[at.at(-1)];
        history.do('Change', [{ path: at, value }]);
        assert.deepEqual(scene.value, wanted);
        const [lost] = difference(text, scene.text);
        assert.ok(lost.length < 400, lost);
      }
      if (round % 20 === 19) assert.deepEqual(scene.value, JSON.parse(scene.text));
    }
    const after = scene.text;
    while (history.undo() !== null);
    assert.equal(scene.text, before);
    while (history.redo() !== null);
    assert.equal(scene.text, after);
  });
}

test('ten thousand edits, and back to the same bytes', () => {
  const before = readFileSync(
    shippedScenes.find((file) => file.endsWith('wayhouse.json')),
    'utf8',
  );
  const { scene, history } = opened(before);
  const random = seededRandom(7);
  for (let round = 0; round < 10_000; ++round) {
    const map = random(scene.value.maps.length);
    const { width, depth, levels } = sizeOf(scene, map);
    const kinds = kindsOf(scene, map);
    const sign = random(2) === 0 ? '.' : kinds[random(kinds.length)].sign;
    history.do(
      'Place',
      cellChanges(scene, map, [
        { layer: random(levels), x: random(width), y: random(depth), sign },
      ]),
    );
    if (random(4) === 0) history.undo();
  }
  assert.deepEqual(scene.value, JSON.parse(scene.text));
  while (history.undo() !== null);
  assert.equal(scene.text, before);
});

test('a stroke in a map of 256 x 256 x 8 takes milliseconds, and so does undoing a fill', () => {
  const row = '.'.repeat(256);
  const levels = Array.from({ length: 8 }, () => Array.from({ length: 256 }, () => row));
  const text = printed(
    {
      blueprints: { wall: { faces: 'a' } },
      legend: { '#': 'wall' },
      maps: [{ name: 'large', levels }],
    },
    '',
  );
  const { scene, history } = opened(text);
  const timed = (act) => {
    const begin = performance.now();
    act();
    return performance.now() - begin;
  };
  const strokes = Array.from({ length: 40 }, (_, x) =>
    timed(() =>
      history.do('Place', cellChanges(scene, 0, [{ layer: 4, x, y: 100, sign: '#' }]), 'one'),
    ),
  ).sort((one, other) => one - other);
  // The least, because the machine may be busy. Of 8 ms the engine and the picture take the rest.
  assert.ok(strokes[0] < 4, `${strokes[0]} ms`);
  const cells = Array.from({ length: 65536 }, (_, index) => ({
    layer: 5,
    x: index % 256,
    y: index >> 8,
    sign: '#',
  }));
  history.do('Fill', cellChanges(scene, 0, cells));
  const undone = Math.min(
    ...Array.from({ length: 3 }, () => {
      const taken = timed(() => history.undo());
      history.redo();
      return taken;
    }),
  );
  assert.ok(undone < 50, `${undone} ms`);
});

test('values are printed on one line if they fit, rows always below each other', () => {
  assert.equal(
    printed({ top: 0.5, faces: { all: 'a' } }, ''),
    '{ "top": 0.5, "faces": { "all": "a" } }',
  );
  assert.equal(
    printed({ levels: [['##', '..'], []] }, '  '),
    '{\n    "levels": [\n      [\n        "##",\n        ".."\n      ],\n      []\n    ]\n  }',
  );
  assert.equal(printed([], ''), '[]');
  assert.equal(printed({}, ''), '{}');
});
