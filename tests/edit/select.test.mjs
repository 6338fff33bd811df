// Selecting, moving, turning, copying and pasting parts of worlds, without a page.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

import { editModules, seededRandom } from './modules.mjs';

const {
  allBlocks,
  allOf,
  boxAround,
  boxEdges,
  carryChanges,
  cellOf,
  cellsOfPart,
  clearChanges,
  columnsOf,
  differences,
  Editor,
  History,
  isSame,
  joinedCells,
  keyOf,
  kStill,
  kTurns,
  kindsOf,
  outlineOf,
  partOf,
  pasteChanges,
  printed,
  sameKind,
  SceneDocument,
  select,
  shiftedEdges,
  stamp,
  transformed,
  transformOf,
  turnedPart,
} = await editModules();

const kScenes = new URL('../../assets/scenes/', import.meta.url);
const shipped = readdirSync(kScenes)
  .filter((file) => file !== 'index.json')
  .map((file) => [file, readFileSync(new URL(file, kScenes), 'utf8')]);

const kYard = {
  textures: { grey: '#808080', red: '#c03020', file: '../textures/brick.png' },
  sprites: { oak: '../sprites/oak.png', cat: { file: '../sprites/cat.png', views: 4 } },
  motions: { slide: { along: 'x', moves: 'both', to: 1 } },
  blueprints: {
    wall: { faces: 'grey' },
    'west roof': { top: [0, 1], rise: 'west', faces: 'red' },
    door: { faces: { all: 'grey', north: 'file' }, motion: 'slide', gate: {} },
  },
  legend: { '#': 'wall', '/': 'west roof', D: 'door' },
  maps: [
    {
      name: 'yard',
      levels: [
        ['......', '.#D...', './....', '......', '......', '......'],
        ['......', '.#....', '......', '......', '......', '......'],
      ],
      floor: 'grey',
      objects: [
        { sprite: 'oak', x: 1.5, y: 2.25, z: 0.5, height: 1 },
        { sprite: 'cat', x: 2.5, y: 1.5, z: 1, height: 0.3 },
        { sprite: 'oak', x: 5.5, y: 5.5, height: 2, comment: 'far away' },
      ],
      baked: { ambient: '#404040', lamps: [{ x: 1.5, y: 1.5, z: 1.5, colour: '#ffffff' }] },
      portals: [
        { x: 1, y: 1, level: 0, face: 'south', to: { x: 4, y: 4, level: 0 }, turn: 90 },
        { x: 5, y: 0, to: { map: 'yard', x: 1, y: 2 } },
      ],
    },
  ],
  start: { x: 2.5, y: 2.5, heading: 0 },
};

function opened(value = kYard, tool = select) {
  const scene = new SceneDocument(typeof value === 'string' ? value : printed(value, ''));
  const history = new History(scene);
  return { scene, history, editor: new Editor(scene, history, tool) };
}

const box = (west, north, east, south, low = 0, high = low) => {
  const cells = new Set();
  for (let level = low; level <= high; ++level)
    for (let y = north; y <= south; ++y)
      for (let x = west; x <= east; ++x) cells.add(keyOf({ level, x, y }));
  return cells;
};

const at = (x, y, { level = 0, isFloor = false } = {}) => ({
  map: 0,
  mapName: 'yard',
  cell: isFloor ? null : { level, x, y },
  before: { level: isFloor ? level : level + 1, x, y },
  face: 'top',
  point: [x + 0.5, y + 0.5, level],
  thing: null,
});

test('keys of cells are one to one, also outside maps', () => {
  const random = seededRandom(7);
  for (let count = 0; count < 1000; ++count) {
    const cell = { level: random(60) - 30, x: random(9000) - 4000, y: random(9000) - 4000 };
    assert.deepEqual(cellOf(keyOf(cell)), cell);
  }
});

test('an outline has the edges of the set, in runs, and none within', () => {
  assert.equal(outlineOf(box(0, 0, 0, 0)).length, 12);
  assert.equal(outlineOf(box(0, 0, 5, 3, 0, 2)).length, 12, 'one line an edge');
  const said = (edges) => edges.map((edge) => JSON.stringify(edge)).sort();
  const one = box(2, 3, 5, 3, 1, 2);
  const moved = shiftedEdges(outlineOf(box(0, 0, 3, 0, 0, 1)), { level: 1, x: 2, y: 3 });
  assert.deepEqual(said(boxEdges(boxAround(one))), said(outlineOf(one)));
  assert.deepEqual(said(moved), said(outlineOf(one)));
  const corner = new Set([...box(0, 0, 1, 0), ...box(0, 1, 0, 1)]);
  assert.equal(outlineOf(corner).length, 6 + 6 + 6);
  const touching = new Set([...box(0, 0, 0, 0), ...box(1, 1, 1, 1)]);
  const upright = outlineOf(touching).filter(({ from, to }) => from[2] !== to[2]);
  assert.equal(upright.length, 7, 'the edge that both share is there');
});

test('boxes, kinds and what is joined are selected, added to, and taken out', () => {
  const { editor, scene } = opened();
  const size = () => editor.selection?.cells.size ?? 0;
  const drag = (from, to, wheel = 0, options) => {
    editor.press(from, options);
    editor.point(to);
    if (wheel !== 0) editor.turn(wheel);
    editor.release();
  };
  drag(at(1, 1), at(2, 3, { isFloor: true }));
  assert.equal(size(), 6);
  drag(at(4, 4, { isFloor: true }), at(4, 5, { isFloor: true }), 1);
  assert.equal(size(), 4, 'the wheel adds a level');
  editor.isWhole = true;
  drag(at(0, 0, { isFloor: true }), at(1, 0, { isFloor: true }));
  assert.equal(size(), 6);
  editor.isWhole = false;
  drag(at(4, 4), at(4, 4), 0, { removes: true });
  assert.equal(size(), 5);
  editor.choose({ selection: null, way: 'same kind' });
  drag(at(1, 1), at(1, 1));
  assert.deepEqual(editor.selection.cells, sameKind(scene, 0, { level: 0, x: 1, y: 1 }));
  assert.equal(size(), 2);
  assert.equal(joinedCells(scene, 0, { level: 0, x: 1, y: 1 }).size, 2, 'one above the other');
  assert.equal(joinedCells(scene, 0, { level: 0, x: 1, y: 2 }).size, 1);
  assert.equal(allBlocks(scene, 0).size, 4);
  assert.equal(
    allOf(scene, 0).size,
    4 + 5,
    'with things, the start, and ends of portals in free cells',
  );
  assert.equal(columnsOf(scene, { map: 0, cells: box(3, 3, 3, 3) }).cells.size, 2);
  editor.choose({ way: 'box' });
  assert.equal(editor.way, 'box');
});

test('what is selected is dragged with all that stands in it, and undone at once', () => {
  const { editor, scene, history } = opened();
  const before = scene.text;
  editor.choose({ selection: { map: 0, cells: box(1, 1, 2, 2, 0, 1) } });
  editor.press(at(1, 1));
  editor.point(at(3, 2));
  assert.equal(scene.text, before, 'only at the end');
  editor.release();
  assert.deepEqual(scene.rows(0, 0), ['......', '......', '...#D.', '.../..', '......', '......']);
  assert.equal(scene.rows(0, 1)[2], '...#..');
  const { objects, baked, portals } = scene.value.maps[0];
  assert.deepEqual(
    objects.map(({ x, y }) => [x, y]),
    [
      [3.5, 3.25],
      [4.5, 2.5],
      [5.5, 5.5],
    ],
  );
  assert.equal(baked.lamps[0].x, 3.5);
  assert.deepEqual([portals[0].x, portals[0].y, portals[0].to.x], [3, 2, 4]);
  assert.deepEqual(portals[1].to, { map: 'yard', x: 3, y: 3 }, 'what leads there follows');
  assert.equal(scene.value.start.x, 4.5);
  assert.deepEqual(editor.selection.cells, box(3, 2, 4, 3, 0, 1));
  assert.equal(history.length, 1);
  history.undo();
  assert.equal(scene.text, before);
});

test('over the border what is outside is left out', () => {
  const { scene, history } = opened();
  const cells = box(1, 1, 2, 2, 0, 1);
  const transform = transformOf(boxAround(cells), kStill, { level: 0, x: -2, y: 0 });
  history.do('Move', carryChanges(scene, 0, cells, transform));
  assert.deepEqual(scene.rows(0, 0)[1], 'D.....');
  assert.equal(scene.value.maps[0].objects.length, 2);
  assert.deepEqual(scene.value.maps[0].baked.lamps, []);
  assert.equal(scene.value.maps[0].portals.length, 0, 'one went, the other led to nothing');
});

test('four turns and two mirrors in place are the identity, and kinds are not made anew', () => {
  const { scene, history } = opened();
  const before = structuredClone(scene.value);
  let cells = box(1, 1, 2, 3, 0, 1);
  const turn = (how) => {
    const transform = transformOf(boxAround(cells), how);
    history.do('Turn', carryChanges(scene, 0, cells, transform));
    cells = transformed(cells, transform);
  };
  turn(kTurns.right);
  const turned = kindsOf(scene, 0).map(({ name }) => name);
  assert.deepEqual(turned, ['wall', 'west roof', 'door', 'door, turned', 'north roof']);
  const door = scene.value.blueprints['door, turned'];
  assert.deepEqual(door.faces, { all: 'grey', east: 'file' });
  assert.equal(scene.value.motions[door.motion].along, 'y');
  assert.equal(scene.value.maps[0].objects[1].heading, 90, 'a sprite with sides turns along');
  assert.equal(scene.value.maps[0].objects[0].heading, undefined);
  assert.equal(scene.value.start.heading, 90);
  assert.equal(scene.value.maps[0].portals[0].face, 'west');
  for (let count = 0; count < 3; ++count) turn(kTurns.right);
  const kinds = Object.keys(scene.value.blueprints).length;
  for (let count = 0; count < 4; ++count) turn(kTurns.left);
  assert.equal(Object.keys(scene.value.blueprints).length, kinds, 'no more kinds than directions');
  for (const mirror of ['west-east', 'north-south'])
    for (const how of [mirror, mirror]) turn(kTurns[how]);
  assert.ok(isSame(withoutHeading(scene.value.maps), withoutHeading(before.maps)));
  assert.ok(isSame(scene.value.start, before.start));
});

// What was turned may say a heading or a turn that is the usual one.
function withoutHeading(maps) {
  const [{ portals, ...rest }] = structuredClone(maps);
  for (const object of rest.objects) if (object.heading === 0) delete object.heading;
  for (const portal of portals) if (portal.turn === 0) delete portal.turn;
  return { ...rest, portals };
}

test('a part of every map turns four times into itself, and pastes where it was', () => {
  for (const [file, text] of shipped) {
    const scene = new SceneDocument(text);
    scene.value.maps.forEach((map, index) => {
      const cells = allBlocks(scene, index);
      const part = partOf(scene, index, cells);
      let turned = part;
      for (let count = 0; count < 4; ++count) turned = turnedPart(turned, kTurns.right);
      assert.equal(turned.cells.length, part.cells.length);
      const isLike = (one, other) =>
        ['level', 'x', 'y'].every((axis) => one[axis] === other[axis]) &&
        kindOfPart(turned, one) === kindOfPart(part, other);
      assert.ok(
        turned.cells.every((cell, cellIndex) => isLike(cell, part.cells[cellIndex])),
        `${file}, ${map.name}`,
      );
      assert.equal(turned.portals.length, part.portals.length);
      // Where it was: blocks and kinds are there already.
      const { from } = boxAround(cells);
      const changes = pasteChanges(scene, index, { ...part, objects: [], lamps: [] }, from);
      assert.deepEqual(changes, [], `${file}, ${map.name}`);
      assert.deepEqual(cellsOfPart({ ...part, objects: [], lamps: [] }, from), cells);
    });
  }
});

const kindOfPart = ({ legend, blueprints }, { sign }) => sorted(blueprints[legend[sign]]);

const sorted = (value) =>
  JSON.stringify(value, (_, one) =>
    typeof one === 'object' && one !== null && !Array.isArray(one)
      ? Object.fromEntries(Object.entries(one).sort(([a], [b]) => (a < b ? -1 : 1)))
      : one,
  );

test('a part brings what it needs into another world, under names that are free', () => {
  const from = opened();
  const part = partOf(from.scene, 0, box(1, 1, 2, 2, 0, 1), 'home');
  const other = opened({
    textures: { grey: '#000000', crimson: '#c03020' },
    blueprints: { wall: { faces: 'grey' } },
    legend: { '#': 'wall', a: 'wall' },
    maps: [{ name: 'field', levels: [Array(8).fill('........')], floor: 'grey', objects: [] }],
    start: { x: 1, y: 1 },
  });
  const { scene, history } = other;
  const before = scene.text;
  const change = () => pasteChanges(scene, 0, part, { level: 0, x: 3, y: 4 }, 'away');
  history.do('Paste', change());
  const { textures, blueprints, sprites, motions, maps } = scene.value;
  assert.deepEqual(textures, {
    grey: '#000000',
    crimson: '#c03020',
    'grey 2': '#808080',
    file: '../textures/brick.png',
  });
  assert.deepEqual(blueprints['wall 2'], { faces: 'grey 2' });
  assert.deepEqual(blueprints['west roof'], { top: [0, 1], rise: 'west', faces: 'crimson' });
  assert.deepEqual(motions, kYard.motions);
  assert.deepEqual(sprites, kYard.sprites);
  assert.deepEqual(
    maps[0].objects.map(({ x, y, z }) => [x, y, z]),
    [
      [3.5, 5.25, 0.5],
      [4.5, 4.5, 1],
    ],
  );
  assert.equal(maps[0].portals, undefined, 'it led out of the part');
  assert.equal(maps[0].baked, undefined);
  const names = new Map(kindsOf(scene, 0).map(({ sign, name }) => [sign, name]));
  assert.deepEqual([...scene.rows(0, 0)[4]].map((sign) => names.get(sign)).filter(Boolean), [
    'wall 2',
    'door',
  ]);
  const kinds = Object.keys(blueprints).length;
  history.do('Paste', change());
  assert.equal(Object.keys(scene.value.blueprints).length, kinds, 'a second one brings nothing');
  history.undo();
  history.undo();
  assert.equal(scene.text, before);
});

test('within its world a part keeps its portals, and where they lead', () => {
  const { scene, history } = opened();
  const part = partOf(scene, 0, new Set([...box(1, 1, 1, 1), ...box(4, 4, 4, 4)]), 'home');
  assert.equal(part.portals[0].to.map, undefined, 'the exit is in the part');
  history.do('Paste', pasteChanges(scene, 0, part, { level: 0, x: 2, y: 2 }, 'home'));
  assert.deepEqual(scene.value.maps[0].portals.at(-1), {
    x: 2,
    y: 2,
    level: 0,
    face: 'south',
    to: { level: 0, x: 5, y: 5 },
    turn: 90,
  });
});

test('a stamp follows the pointer, turned, and is put by a click', () => {
  const { editor, scene } = opened();
  const part = partOf(scene, 0, box(1, 1, 2, 2), 'home');
  editor.choose({ tool: stamp, brush: { part, turn: kTurns.right, name: null } });
  editor.point(at(3, 4, { isFloor: true }));
  assert.equal(editor.touched.size, 4, 'three blocks, and the thing on the door');
  editor.press(at(3, 4, { isFloor: true }));
  editor.release();
  const signs = [4, 5].map((y) => [...scene.rows(0, 0)[y]].slice(3, 5).join(''));
  const names = new Map(kindsOf(scene, 0).map(({ sign, name }) => [sign, name]));
  assert.deepEqual(
    signs.map((row) => [...row].map((sign) => names.get(sign))),
    [
      ['north roof', 'wall'],
      [undefined, 'door, turned'],
    ],
  );
});

test('removing takes blocks, things and portals, and only those', () => {
  const { scene, history } = opened();
  history.do('Remove', clearChanges(scene, 0, box(1, 1, 2, 2)));
  assert.equal(scene.rows(0, 0).join('').replaceAll('.', ''), '');
  assert.equal(scene.rows(0, 1)[1], '.#....');
  const { objects, portals, baked } = scene.value.maps[0];
  assert.deepEqual(
    objects.map(({ x }) => x),
    [5.5],
  );
  assert.equal(portals.length, 1);
  assert.equal(baked.lamps.length, 1, 'the lamp hangs a level higher');
});

test('members of lists are removed together, wherever they stand', () => {
  const text = '{ "list": [0, 1,\n  2, 3, 4, 5] }';
  for (let bits = 1; bits < 64; ++bits) {
    const gone = [0, 1, 2, 3, 4, 5].filter((index) => bits & (1 << index));
    const scene = new SceneDocument(text);
    const history = new History(scene);
    history.do('Remove', [{ path: ['list'], removed: gone }]);
    assert.equal(scene.mistake, null, scene.text);
    assert.deepEqual(
      scene.value.list,
      [0, 1, 2, 3, 4, 5].filter((index) => !gone.includes(index)),
    );
    history.undo();
    assert.equal(scene.text, text);
  }
});

test('differences set only what differs, and remove from lists', () => {
  const before = { list: [{ a: 1 }, { a: 2, b: 3 }, { a: 4 }], gone: 1, rows: ['..', '..'] };
  const { scene, history } = opened({ ...kYard, comment: before });
  const after = { list: [undefined, { a: 2, b: 5, c: 1 }, undefined], rows: ['...'], more: {} };
  history.do('Change', differences(before, after, ['comment']));
  assert.deepEqual(scene.value.comment, {
    list: [{ a: 2, b: 5, c: 1 }],
    rows: ['...'],
    more: {},
  });
});
