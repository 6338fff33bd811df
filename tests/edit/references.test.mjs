// What refers to what in a scene, as the editor draws it: nothing of the schema is unknown, and
// every link of the shipped scenes lies inside its map.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { test } from 'node:test';

import { shippedScenes } from '../wasm/load.mjs';
import { editModules, schemaParts, seededRandom } from './modules.mjs';

const {
  History,
  Links,
  SceneDocument,
  Schema,
  kGiven,
  kReferences,
  linkLines,
  linksOf,
  matchesOf,
  moveChanges,
  namedChange,
  namesOf,
  placesOf,
  printed,
  renameChange,
  sizeOf,
  thingsOf,
  usesOf,
} = await editModules();

const kSchema = JSON.parse(
  readFileSync(new URL('../../assets/scene.schema.json', import.meta.url), 'utf8'),
);
const scenes = shippedScenes.map((file) => [
  path.basename(file, '.json'),
  new SceneDocument(readFileSync(file, 'utf8')),
]);

const all = [...schemaParts(new Schema(kSchema), kSchema)];

test('every text of the schema is a name, refers to one, or is words for people', () => {
  const kWords =
    /(^|\/)(\$schema|comment|data|title|message|text|aim|locked|tiles\/\*|rows\/\*|levels\/.*)$/;
  const texts = all
    .filter(([pattern, , { kinds }]) => {
      const isFree = ({ type, choices, pattern: form }) =>
        type === 'text' && choices === undefined && form === undefined;
      return kinds.some(isFree) && !kWords.test(pattern);
    })
    .map(([pattern]) => pattern.replace(/(\/faces)\/\w+/, '$1/*'));
  const known = [...kReferences, ...kGiven].map(({ pattern }) => pattern);
  assert.deepEqual([...new Set(texts)].sort(), known.sort());
});

for (const [name, scene] of scenes) {
  test(`all names that ${name} uses are given, and it can be renamed throughout`, async () => {
    for (const { what, pattern } of kReferences) {
      const names = new Set(namesOf(scene.value, what));
      for (const [at, used] of matchesOf(scene.value, pattern)) {
        if (typeof used !== 'string' || at.at(-1) === 'comment') continue;
        if (used === 'floor' && /\/on/.test(pattern)) continue;
        assert.ok(names.has(used), `${at.join('/')}: ${used}`);
      }
    }
    // Everything that has a name gets another one; then all is as it was, but for the names.
    const copy = new SceneDocument(scene.text);
    const history = new History(copy);
    const rename = ({ changes, words }) => {
      assert.equal(words, undefined);
      history.do('Rename', changes);
    };
    for (const what of ['textures', 'sprites', 'motions', 'blueprints'])
      for (const one of namesOf(copy.value, what).slice(0, 12))
        rename(renameChange(copy, [what, one], `${one} \u2728`));
    copy.value.maps.forEach(({ name: one }, index) =>
      rename(namedChange(copy, ['maps', index, 'name'], `${one} \u2728`)),
    );
    const back = JSON.parse(copy.text.replaceAll(' \u2728', ''));
    assert.deepEqual(back, scene.value);
    for (const { what, pattern } of kReferences) {
      const names = new Set(namesOf(copy.value, what));
      for (const [at, used] of matchesOf(copy.value, pattern))
        if (typeof used === 'string' && at.at(-1) !== 'comment' && !/\/on/.test(pattern))
          assert.ok(names.has(used), `${at.join('/')}: ${used}`);
    }
    while (history.undo() !== null);
    assert.equal(copy.text, scene.text);
  });

  test(`all links of ${name} lie inside their maps`, () => {
    const { value } = scene;
    const kinds = new Map();
    value.maps.forEach((_, map) => {
      const isInside = (at, x, y) => {
        const { width, depth } = sizeOf(scene, at);
        return x >= 0 && y >= 0 && x <= width && y <= depth;
      };
      for (const link of linksOf(value, map)) {
        const said = `${JSON.stringify(link.path)}`;
        kinds.set(link.kind, (kinds.get(link.kind) ?? new Set()).add(said));
        assert.equal(link.map, map);
        for (const area of (link.areas ?? [link.area]).filter(Boolean)) {
          assert.ok(isInside(map, area.west, area.north), said);
          assert.ok(isInside(map, area.east, area.south), said);
          assert.ok(area.low <= area.high, said);
        }
        // What wanders, paces or moves may be asked to go beyond the edge; it turns there.
        if (link.ends.length > 0 || link.kind === 'find')
          for (const [x, y] of link.points) assert.ok(isInside(map, x, y), said);
        for (const end of link.ends) assert.ok(isInside(end.map, end.x, end.y), said);
        assert.ok(linkLines(value.maps[map].name, [link]).length > 0 || link.text !== '', said);
      }
    });
    const count = (kind) => kinds.get(kind)?.size ?? 0;
    const objects = value.maps.flatMap((map) => map.objects ?? []);
    const portals = value.maps.flatMap((map) => map.portals ?? []);
    const messages = value.maps.flatMap((map) => map.messages ?? []);
    assert.equal(count('portal'), portals.length);
    assert.equal(
      count('find'),
      objects.filter(({ find }) => find).length +
        value.maps.flatMap(({ sow }) => sow ?? []).filter(({ find }) => find).length,
    );
    assert.equal(
      count('message'),
      messages.length + objects.filter(({ message }) => message).length,
    );
    const kindOf = (object) => object.motion?.kind;
    assert.ok(
      count('way') >= objects.filter((object) => kindOf(object) === 'patrol').length,
      'ways of patrols',
    );
    const gates = Object.values(value.blueprints ?? {}).filter(({ gate }) => gate);
    assert.equal(count('gate'), gates.length);
    for (const place of placesOf(value)) {
      const { width, depth } = sizeOf(scene, place.map);
      assert.ok(place.x >= 0 && place.x + place.width <= width, JSON.stringify(place));
      assert.ok(place.y >= 0 && place.y + place.depth <= depth, JSON.stringify(place));
    }
  });
}

test('frames, gates, ways and areas are where they stand', () => {
  const value = {
    textures: { grey: '#808080' },
    motions: { raft: { along: 'x', moves: 'both', to: 2, period: 8 } },
    blueprints: {
      wall: { faces: 'grey' },
      door: { faces: 'grey', gate: { needs: 'shell', approach: 1 } },
      raft: { faces: 'grey', top: 0.5, motion: 'raft' },
    },
    legend: { '#': 'wall', d: 'door', r: 'raft' },
    game: { aim: 'Out', at: { x: 4, y: 1, width: 2 } },
    maps: [
      {
        name: 'yard',
        levels: [['#d####', '#....#', '#.r..#', '######']],
        objects: [
          { sprite: 'shell', x: 2.5, y: 1.5, height: 0.4, find: 'shell' },
          {
            sprite: 'guard',
            x: 1.5,
            y: 1.5,
            height: 0.7,
            motion: {
              kind: 'patrol',
              speed: 1,
              path: [
                { x: 4.5, y: 1.5 },
                { x: 4.5, y: 2.5 },
                { x: 1, y: 1, map: 'hall' },
                { x: 1.5, y: 2.5 },
              ],
            },
          },
        ],
        portals: [
          {
            x: 0,
            y: 1,
            level: 0,
            face: 'east',
            to: { map: 'hall', x: 1, y: 0 },
            turn: 90,
            twoWay: true,
          },
        ],
      },
      { name: 'hall', levels: [['..', '..']] },
    ],
    start: { x: 3, y: 1.5 },
  };
  const scene = new SceneDocument(printed(value, ''));
  const links = new Links(scene);
  const of = (map, kind) => links.of(map).filter((link) => link.kind === kind);
  const [portal] = of(0, 'portal');
  assert.deepEqual(portal.areas, [{ west: 1, east: 1, north: 1, south: 2, low: 0, high: 1 }]);
  // West turned by 90 degrees is north: the way back is a south wall's face towards the north.
  const [incoming] = of(1, 'portal');
  assert.deepEqual(incoming.areas, [{ west: 1, east: 2, north: 1, south: 1, low: 0, high: 1 }]);
  const [gate] = of(0, 'gate');
  assert.deepEqual([gate.area.west, gate.area.east, gate.area.north], [1, 2, 0]);
  assert.deepEqual(
    gate.ends.map(({ path: at, x }) => [at.join('/'), x]),
    [['maps/0/objects/0/find', 2.5]],
  );
  assert.equal(gate.text, 'needs shell; opens when somebody comes near; opens by key');
  const [mover] = of(0, 'mover');
  assert.deepEqual(
    mover.points.map(([x]) => x),
    [2.5, 4.5],
  );
  const [way] = of(0, 'way');
  assert.equal(way.points.length, 4, 'the point of the other map is drawn there');
  assert.equal(way.isClosed, true);
  assert.equal(way.ends.length, 4);
  assert.deepEqual(of(0, 'goal')[0].area.east, 6);
  const before = links.of(0);
  assert.equal(links.of(0), before, 'kept until something changes');
  scene.apply(scene.edits({ map: 0, cells: [{ layer: 0, x: 4, y: 2, sign: 'd' }] }));
  assert.equal(of(0, 'gate').length, 2);
});

test('names that are taken or used are refused in words; a find takes its gates along', () => {
  const scene = new SceneDocument(
    printed(
      {
        textures: { grey: '#808080', red: '#ff0000' },
        blueprints: {
          wall: { faces: 'grey' },
          door: { faces: 'grey', gate: { needs: ['shell', 'shell'] } },
        },
        game: { aim: 'Out', needs: 'shell' },
        maps: [
          { name: 'yard', levels: [['..']], objects: [{ sprite: 'a', x: 1, y: 0, find: 'shell' }] },
          { name: 'hall', levels: [['..']] },
        ],
      },
      '',
    ),
  );
  assert.match(namedChange(scene, ['maps', 0, 'name'], 'hall').words, /another map.*"hall"/);
  assert.match(renameChange(scene, ['textures', 'red'], 'grey').words, /another texture/);
  assert.match(renameChange(scene, ['textures', 'red'], '').words, /1 to 100 characters: found 0/);
  assert.match(
    namedChange(scene, ['textures', 'grey'], undefined).words,
    /used in 2 places, first in blueprints \/ wall \/ faces/,
  );
  assert.equal(namedChange(scene, ['textures', 'red'], undefined).words, undefined);
  const history = new History(scene);
  const find = ['maps', 0, 'objects', 0, 'find'];
  history.do('Change', namedChange(scene, find, 'pearl').changes);
  assert.deepEqual(scene.value.blueprints.door.gate.needs, ['pearl', 'pearl']);
  assert.equal(scene.value.game.needs, 'pearl');
  assert.deepEqual(usesOf(scene.value, 'finds', 'shell'), []);
  assert.deepEqual(namesOf(scene.value, 'gates'), ['door']);
  history.do('Add', [
    { path: ['maps', 0, 'objects', 1], value: { sprite: 'a', x: 0, y: 0, find: 'pearl' } },
  ]);
  history.do('Change', namedChange(scene, find, 'coin').changes);
  assert.equal(scene.value.game.needs, 'pearl', 'another find has that name');
});

test('a scene that is damaged at any place has links or none, but no line to nowhere', () => {
  const text = readFileSync(
    shippedScenes.find((file) => file.includes('wayhouse-hunt')),
    'utf8',
  );
  const random = seededRandom(7);
  for (let round = 0; round < 120; ++round) {
    const value = JSON.parse(text);
    let node = value;
    for (let depth = 0; ; ++depth) {
      const keys = Object.keys(node);
      const key = keys[random(keys.length)];
      if (key === undefined) break;
      const child = node[key];
      const isEnd = typeof child !== 'object' || child === null || (depth > 1 && random(3) === 0);
      if (isEnd) {
        node[key] = [null, 'constructor', -1, {}, [], 1e30][random(6)];
        break;
      }
      node = child;
    }
    if (!Array.isArray(value.maps) || value.maps.length === 0) continue;
    if (!value.maps.every((map) => typeof map === 'object' && map !== null)) continue;
    const links = new Links(new SceneDocument(JSON.stringify(value)));
    value.maps.forEach((_, map) => {
      for (const { from, to } of linkLines('', links.of(map)))
        assert.ok([...from, ...to].every(Number.isFinite));
    });
  }
});

test('what is said by the name of a place is drawn there, and gets its own place when moved', () => {
  const value = {
    textures: { grey: 'grey.png' },
    sprites: { oak: 'oak.png' },
    maps: [
      {
        name: 'yard',
        size: [8, 6],
        levels: [],
        floor: 'grey',
        places: { well: { x: 2.5, y: 3.5 }, oak: { x: 6.5, y: 1.5, z: 1 } },
        portals: [{ x: 1, y: 1, to: { place: 'oak' } }],
        messages: [{ place: 'well', text: 'Cold.' }],
        objects: [
          {
            sprite: 'oak',
            x: 1,
            y: 1,
            motion: { kind: 'patrol', path: ['well', { place: 'oak' }] },
          },
        ],
      },
    ],
    start: { place: 'well' },
  };
  const scene = new SceneDocument(JSON.stringify(value));
  const links = linksOf(scene.value, 0);
  const ends = ({ kind }) => links.find((link) => link.kind === kind);
  assert.deepEqual(ends({ kind: 'portal' }).ends[1].x, 6.5);
  assert.equal(ends({ kind: 'way' }).points.length, 3);
  assert.ok(ends({ kind: 'message' }));
  assert.deepEqual(
    thingsOf(scene, 0).map(({ path }) => path.join('/')),
    ['maps/0/objects/0', 'maps/0/places/well', 'maps/0/places/oak'],
  );
  const history = new History(scene);
  history.do('Move', moveChanges(scene, ['start'], { x: 4, y: 4, z: 0 }));
  assert.deepEqual(scene.value.start, { x: 4, y: 4 });
  history.do('Move', moveChanges(scene, ['maps', 0, 'places', 'well'], { x: 5, y: 5, z: 0 }));
  assert.deepEqual(scene.value.maps[0].places.well, { x: 5, y: 5 });
  history.undo();
  history.undo();
  assert.equal(scene.text, JSON.stringify(value));
});
