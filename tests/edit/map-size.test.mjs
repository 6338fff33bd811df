// Maps that change their size, levels and names, with all that lies in them.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

import { editModules } from './modules.mjs';

const {
  differences,
  History,
  isSame,
  kPlaces,
  lossesOf,
  printed,
  resized,
  SceneDocument,
  sizeOfMap,
  withLevel,
  withMap,
  withoutLevel,
  withoutMap,
} = await editModules();

const kAssets = new URL('../../assets/', import.meta.url);
const read = (file) => readFileSync(new URL(file, kAssets), 'utf8');
const shipped = readdirSync(new URL('scenes/', kAssets))
  .filter((file) => file !== 'index.json')
  .map((file) => [file, JSON.parse(read(`scenes/${file}`))]);

// Every coordinate and every name of a map in the schema, as paths.
function placesOfSchema() {
  const schema = JSON.parse(read('scene.schema.json'));
  const kRefs = /\/(tileNumber|tileCount|levelNumber|areaHeight)$/;
  const kWords = /(west|north)(ern)? edge|name of a map|height of the feet|height above the floor/i;
  const found = new Set();
  const walk = (node, path, seen) => {
    if (typeof node !== 'object' || node === null) return;
    const { $ref, description = '', items, properties = {} } = node;
    const key = path.split('.').at(-1);
    const isPlace =
      kRefs.test($ref ?? '') ||
      kWords.test(description) ||
      ['map', 'x', 'y', 'z', 'level'].includes(key);
    const isLeaf = properties.x === undefined && items === undefined;
    if (isPlace && isLeaf && !/rows|plan|path\[\]$/.test(path)) found.add(path);
    if ($ref !== undefined && !seen.includes($ref))
      walk(schema.definitions[$ref.replace('#/definitions/', '')], path, [...seen, $ref]);
    for (const [name, one] of Object.entries(properties))
      walk(one, path === '' ? name : `${path}.${name}`, seen);
    if (items !== undefined) walk(items, `${path}[]`, seen);
    for (const list of ['anyOf', 'allOf', 'oneOf'])
      for (const one of node[list] ?? []) walk(one, path, seen);
    if (typeof node.additionalProperties === 'object')
      walk(node.additionalProperties, `${path}.*`, seen);
  };
  walk(schema, '', []);
  return [...found].sort();
}

test('all places that a scene can say are known', () => {
  const known = Object.entries(kPlaces).flatMap(([path, { keys }]) =>
    keys.map((key) => `${path.replaceAll('{}', '.*')}.${key}`),
  );
  const other = ['maps[].sow[].above']; // over the ground, wherever that is
  const isWritten = (path) => path.includes('.fill[]'); // as rows, before a map changes its size
  assert.deepEqual(
    placesOfSchema().filter((path) => !other.includes(path) && !isWritten(path)),
    known.sort(),
  );
});

// Heights of 0 and the like may be said where they were not.
const plain = (value) =>
  JSON.parse(JSON.stringify(value, (key, one) => (key === 'z' && one === 0 ? undefined : one)));

test('grown and shrunk again, every map of every scene is what it was', () => {
  const more = { west: 3, north: 2, east: 1, south: 4 };
  const less = { west: -3, north: -2, east: -1, south: -4 };
  for (const [file, value] of shipped) {
    value.maps.forEach((map, index) => {
      const grown = resized(value, index, more);
      const { width, depth } = sizeOfMap(map);
      assert.deepEqual(sizeOfMap(grown.maps[index]), { width: width + 4, depth: depth + 6 });
      assert.deepEqual(lossesOf(value, grown), []);
      assert.deepEqual(resized(grown, index, less), value, `${file}, ${map.name}`);
      if (map.levels.length === 32) return;
      for (const at of [0, 1, map.levels.length]) {
        const higher = withLevel(value, index, at);
        assert.equal(higher.maps[index].levels.length, map.levels.length + 1);
        const back = withoutLevel(higher, index, at);
        assert.deepEqual(plain(back), plain(value), `${file}, ${map.name}, level ${at}`);
      }
    });
  }
});

const kScene = {
  textures: { grey: '#808080' },
  blueprints: { wall: { faces: 'grey' } },
  legend: { '#': 'wall' },
  maps: [
    {
      name: 'yard',
      levels: [
        ['#...', '....', '...#'],
        ['....', '.#..', '....'],
      ],
      floor: { texture: 'grey', legend: { g: 'grey' }, tiles: ['g...', '....', '....'] },
      ceiling: { height: 2, texture: 'grey', tiles: ['    ', ' .. ', '    '] },
      objects: [
        { sprite: 'oak', x: 0.5, y: 0.5, z: 1, height: 1 },
        {
          sprite: 'cat',
          x: 2.5,
          y: 1.5,
          height: 1,
          motion: {
            kind: 'patrol',
            path: [
              { x: 0.5, y: 1.5 },
              { map: 'cave', x: 1.5, y: 1.5 },
            ],
          },
        },
      ],
      baked: { ambient: '#404040', lamps: [{ x: 3.5, y: 2.5, z: 1.5 }] },
      messages: [{ text: 'Here', x: 0, y: 0, width: 3, depth: 2, bottom: 0, top: 1 }],
      portals: [
        { x: 0, y: 0, face: 'south', to: { map: 'cave', x: 1, y: 1 } },
        { x: 3, y: 2, to: { x: 2, y: 0 } },
      ],
    },
    {
      name: 'cave',
      levels: [['....', '....', '....']],
      floor: 'grey',
      portals: [{ x: 0, y: 0, level: 0, to: { map: 'yard', x: 0, y: 1, level: 1 }, twoWay: true }],
      objects: [
        {
          sprite: 'cat',
          x: 1,
          y: 1,
          height: 1,
          motion: { kind: 'patrol', path: [{ map: 'yard', x: 3.5, y: 1.5, z: 1 }] },
        },
      ],
    },
  ],
  game: { at: { x: 3, y: 2 } },
  start: { x: 1.5, y: 1.5, heading: 90 },
};

test('what lies in a map moves along, wherever it is said; what is outside goes', () => {
  const grown = resized(kScene, 0, { west: 2, north: 1, east: 0, south: 0 });
  const [yard, cave] = grown.maps;
  assert.deepEqual(yard.levels[0], ['......', '..#...', '......', '.....#']);
  assert.deepEqual(yard.floor.tiles[1], '..g...');
  assert.deepEqual(yard.ceiling.tiles[0], '      ');
  assert.deepEqual([yard.objects[0].x, yard.objects[0].y], [2.5, 1.5]);
  assert.deepEqual(yard.objects[1].motion.path, [
    { x: 2.5, y: 2.5 },
    { map: 'cave', x: 1.5, y: 1.5 },
  ]);
  assert.deepEqual([yard.baked.lamps[0].x, yard.messages[0].x, yard.messages[0].y], [5.5, 2, 1]);
  assert.deepEqual(yard.portals[0], { x: 2, y: 1, face: 'south', to: { map: 'cave', x: 1, y: 1 } });
  assert.deepEqual(yard.portals[1], { x: 5, y: 3, to: { x: 4, y: 1 } });
  assert.deepEqual(cave.portals[0].to, { map: 'yard', x: 2, y: 2, level: 1 });
  assert.deepEqual(cave.objects[0].motion.path[0], { map: 'yard', x: 5.5, y: 2.5, z: 1 });
  assert.deepEqual([grown.start.x, grown.game.at.x, grown.game.at.y], [3.5, 5, 3]);

  const small = resized(kScene, 0, { west: -1, north: 0, east: -1, south: -1 });
  assert.deepEqual(small.maps[0].levels, [
    ['..', '..'],
    ['..', '#.'],
  ]);
  assert.deepEqual(lossesOf(kScene, small), [
    '1 object',
    '1 lamp',
    '3 portals',
    '2 blocks',
    'the place of the goal',
  ]);
  assert.deepEqual(small.maps[0].messages[0], { ...kScene.maps[0].messages[0], width: 2 });
  assert.deepEqual(small.maps[0].objects[1].motion.path[0], { x: 0.5, y: 1.5 }, 'stays within');
  assert.equal(small.maps[1].portals[0], undefined);
});

test('a level is put in and taken out, and heights follow', () => {
  const higher = withLevel(kScene, 0, 1);
  const [yard, cave] = higher.maps;
  assert.deepEqual(
    yard.levels.map((level) => level.length),
    [3, 0, 3],
  );
  assert.deepEqual([yard.objects[0].z, yard.objects[1].z], [2, undefined]);
  assert.deepEqual([yard.ceiling.height, yard.baked.lamps[0].z], [3, 2.5]);
  assert.deepEqual(yard.messages[0], kScene.maps[0].messages[0]);
  assert.deepEqual(yard.portals, kScene.maps[0].portals);
  assert.equal(cave.portals[0].to.level, 2);
  assert.equal(cave.objects[0].motion.path[0].z, 2);
  const raised = withLevel(kScene, 0, 0);
  assert.equal(raised.start.z, 1);
  assert.equal(raised.maps[0].portals[0].level, 1);
  assert.equal(raised.maps[0].portals[0].to.level, 0, 'the cave stays where it is');
  const lower = withoutLevel(kScene, 0, 0);
  assert.deepEqual(lower.maps[0].levels, [kScene.maps[0].levels[1]]);
  assert.equal(lower.maps[0].portals[0], undefined, 'its block is gone');
  assert.deepEqual([lower.maps[0].objects[0].z, lower.maps[0].ceiling.height], [0, 1]);
});

test('a map goes with what leads to it, and the start comes to another one', () => {
  const value = withoutMap(kScene, 0);
  assert.deepEqual(lossesOf(kScene, value), [
    '2 objects',
    '1 lamp',
    '1 message',
    '3 portals',
    '3 blocks',
    'the place of the goal',
  ]);
  assert.deepEqual(value.start, { map: 'cave', x: 2, y: 1.5 });
  const scene = new SceneDocument(printed(kScene, ''));
  const history = new History(scene);
  const before = scene.text;
  history.do('Remove', differences(scene.value, value, []));
  assert.deepEqual(
    scene.value.maps.map(({ name }) => name),
    ['cave'],
  );
  assert.deepEqual(scene.value.maps[0].portals, []);
  assert.equal(scene.value.maps[0].objects[0].motion, undefined);
  assert.deepEqual(scene.value.game, {});
  history.undo();
  assert.equal(scene.text, before);
});

test('a new map lies in the light of another one, without its lamps', () => {
  const value = withMap(kScene, { name: 'den', width: 5, depth: 2, floor: 'grey' }, 0);
  assert.deepEqual(value.maps[2], {
    name: 'den',
    levels: [['.....', '.....']],
    floor: 'grey',
    baked: { ambient: '#404040' },
  });
});

test('as changes of the text they touch only what differs, and are undone', () => {
  for (const [file] of shipped) {
    const text = read(`scenes/${file}`);
    const scene = new SceneDocument(text);
    const history = new History(scene);
    const grown = resized(scene.value, 0, { west: 1, north: 1, east: 0, south: 0 });
    history.do('Size', differences(scene.value, grown, []));
    assert.ok(isSame(scene.value, JSON.parse(JSON.stringify(grown))), file);
    const small = resized(scene.value, 0, { west: -6, north: -6, east: -5, south: -5 });
    history.do('Size', differences(scene.value, small, []));
    const left = JSON.parse(
      JSON.stringify(small, (_, one) =>
        Array.isArray(one) ? one.filter((x) => x !== undefined) : one,
      ),
    );
    assert.ok(isSame(scene.value, left), file);
    history.undo();
    history.undo();
    assert.equal(scene.text, text, file);
  }
});
