// Maps of numbers and of characters, as people paste them from programs and courses.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { make, proposalOf, refused } from './load.mjs';

const kRows = ['####', '#.a#', '#..#', '####'];
const levelsOf = async (text) => (await make('map.txt', text)).scene.maps[0].levels;

const kNumbers = [
  [1, 1, 1, 1],
  [1, 0, 2, 1],
  [1, 0, 0, 1],
  [1, 1, 1, 1],
];
const rowsIn = (open, end, between = ', ') =>
  kNumbers.map((row) => `  ${open}${row.join(between)}${end}`).join(',\n');

test('numbers in the brackets of any language', async () => {
  const texts = {
    c: `#define W 4\nint worldMap[4][4]=\n{\n${rowsIn('{', '}', ',')}\n};\n`,
    'c, one list': `int mapX=4, mapY=4;\nint map[]=           //the map array\n{\n${kNumbers.map((row) => ` ${row.join(',')},`).join('\n')}\n};`,
    cpp: `std::vector<std::vector<int>> level = {\n${rowsIn('{', '}')}}; // 4 x 4`,
    js: `export const map = [\n${rowsIn('[', ']')},\n];`,
    python: `# the map, {1} is a wall\ngrid = [\n${rowsIn('[', ']')}]\n`,
    'python, tuples': `grid = (${rowsIn('(', ')')})`,
    lua: `local map = { -- west to east\n${rowsIn('{', '}')} }`,
    json: JSON.stringify(kNumbers),
    rust: `const MAP: [[u8; 4]; 4] = [\n${rowsIn('[', ']')}];`,
    'rows without a bracket around': rowsIn('[', ']'),
    rows: kNumbers.map((row) => row.join(' ')).join('\n'),
    csv: kNumbers.map((row) => row.join(',')).join('\r\n'),
    tabs: `${kNumbers.map((row) => row.join('\t')).join('\n')}\n`,
    digits: kNumbers.map((row) => row.join('')).join('\n'),
    hexadecimal: `{${rowsIn('{', '}').replaceAll('2', '0x02')}}`,
    'texts of digits': `[${kNumbers.map((row) => `"${row.join('')}"`).join(',\n')}]`,
  };
  for (const [language, text] of Object.entries(texts))
    assert.deepEqual(await levelsOf(text), [kRows], language);
});

test('several matrices are levels', async () => {
  const upper = kNumbers.map((row) => row.map((one) => (one === 2 ? 0 : one)));
  const expected = [kRows, ['####', '#..#', '#..#', '####']];
  assert.deepEqual(await levelsOf(JSON.stringify([kNumbers, upper])), expected);
  const text = [kNumbers, upper].map((rows) => rows.map((row) => row.join(' ')).join('\n'));
  assert.deepEqual(await levelsOf(text.join('\n\n')), expected);
});

test('each number has a kind that a dialog may change', async () => {
  const change = ({ kinds }) => {
    assert.deepEqual(
      kinds.map(({ name, use, count }) => [name, use, count]),
      [
        ['1', 'by layer', 12],
        ['0', 'empty', 3],
        ['2', 'by layer', 1],
      ],
    );
    Object.assign(kinds[2], { show: '#C03020', top: 0.5 });
    kinds[0].show = 'hedge';
  };
  const { scene } = await make('map.txt', JSON.stringify(kNumbers), {}, change);
  assert.deepEqual(scene.blueprints[scene.legend.a], {
    top: 0.5,
    faces: {
      all: '#c03020',
      north: { texture: '#c03020', light: 0.76 },
      east: { texture: '#c03020', light: 0.86 },
      west: { texture: '#c03020', light: 0.94 },
    },
  });
  assert.equal(scene.textures.hedge, '../textures/hedge.png');
});

test('without a nought the commonest number inside is empty', async () => {
  const { proposal } = await make('map.txt', '[[5,5,5,5],[5,7,7,5],[5,8,7,5],[5,5,5,5]]');
  assert.deepEqual(
    proposal.kinds.map(({ name, use }) => [name, use]),
    [
      ['5', 'by layer'],
      ['7', 'empty'],
      ['8', 'by layer'],
    ],
  );
});

test('rows of characters, with the start where courses put it', async () => {
  const plain = await make('map.txt', '\n  ####\n  #.N#\n  #..#\n  ####\n');
  assert.deepEqual(plain.scene.maps[0].levels, [['####', '#..#', '#..#', '####']]);
  assert.deepEqual(plain.scene.start, { x: 2.5, y: 1.5, heading: 270 });
  const cub = await make('map.cub', '1111\n1E01\n1001\n1111');
  assert.deepEqual(cub.scene.start, { x: 1.5, y: 1.5, heading: 0 });
  const code = await make('map.js', 'const rows = [\n  "####",\n  "#@.#",\n  "####",\n];');
  assert.deepEqual([code.scene.start.x, code.scene.start.y], [1.5, 1.5]);
  const listed = await make('map.js', "[['#','#','#'],['#','.','#'],['#','#','#']]");
  assert.deepEqual(listed.scene.maps[0].levels, [['###', '#.#', '###']]);
  const spaced = await make('map.txt', '1 1 1 1\n1 0 N 1\n1, 12, 0, 1,\n1 1 1 1\n');
  assert.deepEqual(spaced.scene.maps[0].levels, [['####', '#..#', '#a.#', '####']]);
  assert.deepEqual([spaced.scene.start.x, spaced.scene.start.y], [2.5, 1.5]);
  const signs = await make('map.txt', '🧱🧱🧱\n🧱..\n🧱🧱🧱');
  assert.deepEqual(signs.scene.maps[0].levels, [['###', '#..', '###']]);
});

test('without a start the player stands in the largest room, and looks along it', async () => {
  const { scene } = await make('map.txt', '########\n#....#.#\n#....#.#\n########');
  assert.deepEqual(scene.start, { x: 3.5, y: 1.5, heading: 180 });
});

test('short rows are filled up, and told', async () => {
  const { scene, notTaken } = await make('map.txt', '####\n#\n####');
  assert.deepEqual(scene.maps[0].levels, [['####', '#...', '####']]);
  assert.match(JSON.stringify(notTaken), /1 short rows are filled up/);
});

test('what holds no map is refused', async () => {
  await refused('map.txt', '', {}, /map\.txt: found "", expected rows of a map/);
  await refused('map.txt', '   \n\n', {}, /expected rows of a map/);
  const many = Array.from({ length: 600 }, (_, index) => `${index} ${index}`).join('\n');
  await refused('map.txt', many, {}, /found 600 different numbers or characters/);
});

test('no text makes it crash or wait', async () => {
  const hostile = [
    '['.repeat(1e5),
    '{'.repeat(20),
    ']'.repeat(1e5),
    '/*'.repeat(5e5),
    '"'.repeat(1e5 + 1),
    `'${'"'.repeat(1e5)}`,
    '"\\'.repeat(1e5),
    '1 '.repeat(1e5),
    `${'1'.repeat(1e5)}x`,
    '-'.repeat(1e5),
    '\n'.repeat(1e5),
    ` ${' \n'.repeat(1e5)}x`,
    '[1,2],'.repeat(1e5),
    '0x'.repeat(1e5),
    '{ "a'.repeat(1e4),
    '1.5e9 NaN {{Infinity,2},{3,4}}',
    '__proto__\nconstructor',
    '[["__proto__","constructor"],["toString","a"]]',
  ];
  const begin = performance.now();
  for (const text of hostile)
    await proposalOf('map.txt', text).catch((error) => assert.equal(error.name, 'ImportError'));
  assert.ok(performance.now() - begin < 20_000);
  await make('map.txt', '__proto__\nconstructor');
});
