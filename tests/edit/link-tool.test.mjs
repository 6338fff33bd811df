// The tools Links and Thing, without a page: what is made is a scene that the engine takes.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { load } from '../../build/web/node/index.js';
import { editModules } from './modules.mjs';

const modules = await editModules();
const { Editor, History, SceneDocument, handlesOf, printed } = modules;

const kYard = ['########', '#......#', '#..#...#', '#......#', '#......#', '########'];
const kHigh = ['########', '#......#', '#......#', '#...##.#', '#......#', '########'];

function opened(tool, way) {
  const scene = new SceneDocument(
    printed(
      {
        title: 'Two maps',
        textures: { grey: '#808080', leaf: '#308030' },
        sprites: {
          guard: { file: '../sprites/guard.png', views: 4 },
          'guard walking': { file: '../sprites/guard-walking.png', frames: 6, rate: 7, views: 4 },
          shell: { file: '../sprites/shell.png', frames: 8, rate: 6 },
        },
        blueprints: { wall: { faces: 'grey' }, hedge: { faces: 'leaf' } },
        legend: { '#': 'wall', h: 'hedge' },
        maps: [
          {
            name: 'yard',
            levels: [kYard, []],
            floor: 'grey',
            objects: [
              { sprite: 'guard', x: 2.5, y: 3.5, height: 0.7 },
              { sprite: 'shell', x: 5.5, y: 1.5, height: 0.3 },
            ],
            baked: { lamps: [{ x: 4, y: 4, z: 0.8, radius: 3 }] },
          },
          { name: 'hall', levels: [kYard, [], kHigh, []], floor: 'grey' },
        ],
        start: { x: 1.5, y: 1.5 },
      },
      '',
    ),
  );
  const history = new History(scene);
  const editor = new Editor(scene, history, modules[tool]);
  if (way !== undefined) editor.choose({ way });
  const words = [];
  editor.listen((what, said) => what === 'words' && words.push(said));
  return { scene, history, editor, words, value: () => scene.value };
}

const kStep = { north: [0, -1], south: [0, 1], west: [-1, 0], east: [1, 0] };

// As the picture makes it of a block's face.
function block(x, y, face, { level = 0, map = 0, thing = null } = {}) {
  const [east, south] = kStep[face] ?? [0, 0];
  const up = { top: 1, bottom: -1 }[face] ?? 0;
  return {
    map,
    mapName: ['yard', 'hall'][map],
    cell: { level, x, y },
    before: { level: level + up, x: x + east, y: y + south },
    face,
    point: [x + 0.5, y + 0.5, level + 1],
    thing,
  };
}
const floor = (x, y, { map = 0, thing = null } = {}) => ({
  ...block(Math.floor(x), Math.floor(y), 'top', { map, thing }),
  cell: null,
  before: { level: 0, x: Math.floor(x), y: Math.floor(y) },
  point: [x, y, 0],
});
const click = (editor, target, options) => {
  editor.press(target, options);
  editor.release();
};
// The engine throws for what it does not take.
async function isSound(scene) {
  const running = await load(JSON.parse(scene.text));
  running.step(2);
  running.free();
}

const kSides = ['north', 'east', 'south', 'west'];
const fronts = { north: [3, 5], south: [3, 0], east: [0, 3], west: [7, 3] }; // walls of the yard

test('portals of all sides and turns join two maps, and the engine takes them', async () => {
  for (const one of kSides) {
    for (const other of kSides) {
      const { scene, editor, words, value } = opened('link', 'portal');
      click(editor, block(...fronts[one], one));
      assert.equal(editor.pending.kind, 'portal');
      click(editor, block(...fronts[other], other, { map: 1 }));
      assert.deepEqual(words, []);
      const [portal] = value().maps[0].portals;
      assert.equal(portal.twoWay, true);
      assert.equal(editor.pending, null);
      assert.deepEqual(editor.edited, ['maps', 0, 'portals', 0]);
      await isSound(scene);
      // The way back is where one has clicked.
      const far = handlesOf(scene, 1, null).find(({ kind }) => kind === 'portal');
      const [x, y] = fronts[other];
      assert.ok(Math.abs(far.x - x - 0.5) <= 0.5 && Math.abs(far.y - y - 0.5) <= 0.5);
    }
  }
});

test('tiles and tops make portals too; what does not fit is refused in words', async () => {
  const tiles = opened('link', 'portal');
  click(tiles.editor, floor(2.5, 1.5));
  click(tiles.editor, floor(5.5, 4.5, { map: 1 }));
  assert.deepEqual(tiles.value().maps[0].portals[0], {
    x: 2,
    y: 1,
    level: 0,
    to: { map: 'hall', x: 5, y: 4, level: 0 },
    twoWay: true,
  });
  await isSound(tiles.scene);
  const flat = opened('link', 'portal');
  click(flat.editor, block(3, 2, 'top'));
  click(flat.editor, block(4, 3, 'bottom', { map: 1, level: 2 }));
  assert.equal(flat.value().maps[0].portals[0].face, 'top');
  await isSound(flat.scene);
  const { editor, words, value } = opened('link', 'portal');
  const before = value();
  click(editor, block(0, 3, 'east'));
  click(editor, block(0, 3, 'east'));
  click(editor, block(3, 2, 'top'));
  click(editor, block(0, 0, 'west'));
  assert.match(words[0], /^Both ends are the same/);
  assert.match(words[1], /^Found a side and a top/);
  assert.match(words[2], /outside the map/);
  assert.equal(value(), before, 'nothing has changed');
  assert.equal(editor.pending.kind, 'portal', 'the first end stays');
  editor.cancel();
  assert.equal(editor.pending, null);
});

test('an end of a portal is dragged, and right click removes it', async () => {
  const { scene, editor, value, history } = opened('link', 'portal');
  click(editor, block(0, 3, 'east'));
  click(editor, block(0, 2, 'east', { map: 1 }));
  const path = ['maps', 0, 'portals', 0];
  editor.press(block(0, 3, 'east', { thing: path }));
  editor.point(block(3, 5, 'north'));
  editor.release();
  assert.deepEqual(value().maps[0].portals[0], {
    x: 3,
    y: 5,
    level: 0,
    face: 'north',
    to: { map: 'hall', x: 1, y: 2, level: 0 },
    turn: 270,
    twoWay: true,
  });
  await isSound(scene);
  editor.choose({ map: 1 });
  editor.press(block(0, 2, 'east', { map: 1, thing: [...path, 'to'] }));
  editor.point(block(4, 5, 'north', { map: 1 }));
  editor.release();
  assert.deepEqual(value().maps[0].portals[0].to, { map: 'hall', x: 4, y: 4, level: 0 });
  await isSound(scene);
  click(editor, floor(1, 1, { thing: [...path, 'to'] }), { removes: true });
  assert.deepEqual(value().maps[0].portals, []);
  history.undo();
  assert.equal(value().maps[0].portals.length, 1);
});

test('a block becomes a gate, opens by a find or another gate, is plain again', async () => {
  const { scene, editor, words, value } = opened('link', 'gate');
  click(editor, block(3, 2, 'south'));
  assert.equal(scene.rows(0, 0)[2].slice(0, 3), '#..');
  const name = 'wall gate';
  assert.deepEqual(value().blueprints[name].gate, { approach: 1.2, hold: 2 });
  assert.deepEqual(editor.edited, ['blueprints', name, 'gate']);
  click(editor, floor(5.5, 1.5, { thing: ['maps', 0, 'objects', 1] }));
  assert.equal(value().maps[0].objects[1].find, 'shell');
  assert.equal(value().blueprints[name].gate.needs, 'shell');
  click(editor, floor(4.5, 4.5));
  assert.equal(editor.pending, null);
  await isSound(scene);
  // Another one follows the first.
  click(editor, block(6, 0, 'south'));
  const second = 'wall gate 2';
  assert.deepEqual(value().blueprints[second].gate, { approach: 1.2, hold: 2 });
  click(editor, block(3, 2, 'south'));
  assert.deepEqual(value().blueprints[second].gate, { hold: 2, follows: name });
  await isSound(scene);
  click(editor, block(6, 0, 'south'), { removes: true });
  click(editor, block(3, 2, 'south'), { removes: true });
  assert.deepEqual(scene.rows(0, 0), kYard);
  editor.cancel();
  click(editor, floor(1.5, 1.5));
  assert.match(words.at(-1), /^Click a block to make it a gate/);
});

test('a gate of two blocks sinks as a whole, and one walks over it', async () => {
  const { scene, editor, history, value } = opened('link', 'gate');
  const walls = [0, 1].flatMap((level) =>
    [1, 2, 3, 4, 5, 6].map((x) => ({ layer: level, x, y: 2, sign: '#' })),
  );
  history.do('Wall', [
    { path: ['maps', 0, 'levels', 1], value: kYard },
    { map: 0, cells: walls },
  ]);
  click(editor, block(1, 2, 'north'));
  click(editor, floor(1.5, 1.5));
  click(editor, block(1, 2, 'north', { level: 1 }));
  assert.equal(Object.values(value().motions).at(-1).to, -2);
  history.do('Start', [{ path: ['start', 'heading'], value: 90 }]);
  const running = await load(JSON.parse(scene.text));
  running.step(240, { forward: 1 });
  assert.ok(running.currentView.y > 4, `${running.currentView.y}`);
  running.free();
});

test('a way is clicked point by point, gets points in between, and loses them', async () => {
  const { scene, editor, value, history } = opened('link', 'way');
  const guard = ['maps', 0, 'objects', 0];
  click(editor, floor(2.5, 3.5, { thing: guard }));
  click(editor, floor(5.5, 3.5));
  click(editor, floor(5.5, 4.5));
  click(editor, floor(5.5, 2.5, { map: 1 }));
  assert.equal(value().maps[0].objects[0].motion.path[2].map, 'hall');
  assert.equal(editor.removeEdited(), true);
  assert.equal(value().maps[0].objects.length, 2, 'Delete takes the last point, not the figure');
  assert.equal(value().maps[0].objects[0].motion.path.length, 2);
  click(editor, floor(1.5, 2.5));
  history.undo();
  click(editor, floor(2.5, 4.5));
  click(editor, floor(2.5, 4.5));
  assert.equal(editor.pending, null, 'a double click ends');
  assert.deepEqual(value().maps[0].objects[0].motion, {
    kind: 'patrol',
    speed: 0.9,
    path: [
      { x: 5.5, y: 3.5 },
      { x: 5.5, y: 4.5 },
      { x: 2.5, y: 4.5 },
    ],
    sprites: { walk: 'guard walking' },
  });
  const points = () => value().maps[0].objects[0].motion.path.map(({ x, y }) => [x, y]);
  click(editor, floor(4, 4.5));
  assert.deepEqual(points()[2], [4, 4.5], 'on the segment from the second to the third');
  const at = [...guard, 'motion', 'path', 2];
  editor.press(floor(4, 4.5, { thing: at }));
  editor.point(floor(4, 3.75));
  editor.release();
  const path = () => value().maps[0].objects[0].motion.path;
  assert.deepEqual(path()[2], { x: 4, y: 3.75 });
  click(editor, floor(4, 3.75, { thing: at }), { removes: true });
  assert.equal(points().length, 3);
  for (let count = 0; count < 3; ++count)
    click(editor, floor(1, 1, { thing: [...guard, 'motion', 'path', 0] }), { removes: true });
  assert.equal(value().maps[0].objects[0].motion, undefined);
  // A block moves as far as one clicks.
  editor.cancel();
  click(editor, block(3, 2, 'south'));
  click(editor, floor(5.5, 2.5));
  assert.deepEqual(value().motions, {
    'wall that moves': { along: 'x', moves: 'both', to: 2, period: 4, shape: 'stop-and-go' },
  });
  await isSound(scene);
});

test('messages and the goal are areas that one drags', async () => {
  const { scene, editor, value } = opened('link', 'message');
  editor.press(floor(4.5, 4.5));
  editor.point(floor(5.5, 3.5));
  assert.ok(editor.marks.length > 0);
  editor.release();
  assert.deepEqual(value().maps[0].messages, [
    { text: 'Something to read.', x: 4, y: 3, width: 2, depth: 2 },
  ]);
  assert.deepEqual(editor.edited, ['maps', 0, 'messages', 0]);
  const corner = handlesOf(scene, 0, editor.edited).find(({ path }) => path.at(-1) === 'width');
  editor.press(floor(corner.x, corner.y, { thing: corner.path }));
  editor.point(floor(6.5, 4.5));
  editor.release();
  assert.equal(value().maps[0].messages[0].width, 3);
  assert.deepEqual(editor.edited, ['maps', 0, 'messages', 0], 'the form stays');
  editor.choose({ way: 'goal' });
  editor.press(floor(1.5, 4.5, { map: 1 }));
  editor.release();
  assert.deepEqual(value().game.at, { map: 'hall', x: 1, y: 4 });
  assert.deepEqual(editor.edited, ['game']);
  editor.press(floor(2, 5, { map: 1, thing: ['game', 'at', 'width'] }));
  editor.point(floor(3.5, 4.5, { map: 1 }));
  editor.release();
  assert.deepEqual([value().game.at.width, value().game.at.x], [3, 1]);
  assert.deepEqual(editor.edited, ['game'], 'with its texts');
  await isSound(scene);
});

test('things turn by the wheel, are dragged by their handles, copied and removed', () => {
  const { scene, editor, value } = opened('thing');
  const at = (thing, x = 1.5, y = 1.5) => floor(x, y, { thing });
  editor.point(at(['start']));
  assert.equal(editor.turn(1), true);
  assert.equal(value().start.heading, 15);
  editor.point(at(['maps', 0, 'baked', 'lamps', 0]));
  assert.equal(editor.turn(-1), true);
  assert.equal(value().maps[0].baked.lamps[0].z, 0.7);
  editor.point(at(['maps', 0, 'objects', 1]));
  assert.equal(editor.turn(1), false, 'a sprite that looks alike from all sides');
  const drag = (handle, x, y) => {
    editor.press(at(handle));
    editor.point(floor(x, y));
    editor.release();
  };
  drag(['start', 'heading'], 1.5, 4.5);
  assert.equal(value().start.heading, 90);
  assert.deepEqual(editor.edited, ['start']);
  drag(['maps', 0, 'baked', 'lamps', 0, 'radius'], 6, 4);
  assert.equal(value().maps[0].baked.lamps[0].radius, 2);
  const heading = handlesOf(scene, 0, ['maps', 0, 'objects', 0])[0];
  assert.deepEqual(heading.path, ['maps', 0, 'objects', 0, 'heading']);
  editor.choose({ edited: ['maps', 0, 'objects', 1] });
  editor.duplicate();
  assert.deepEqual(value().maps[0].objects[2], { sprite: 'shell', x: 6.5, y: 1.5, height: 0.3 });
  assert.deepEqual(editor.edited, ['maps', 0, 'objects', 2]);
  assert.equal(editor.removeEdited(), true);
  assert.equal(value().maps[0].objects.length, 2);
  assert.equal(editor.edited, null);
});

test('finds, messages and the goal are put as things', async () => {
  const { scene, editor, value } = opened('thing');
  editor.choose({ thing: { find: 'crystal' } });
  click(editor, floor(4.5, 4.5));
  assert.deepEqual(value().maps[0].objects[2], {
    sprite: 'crystal',
    height: 0.34,
    glow: true,
    find: 'crystal',
    x: 4.5,
    y: 4.5,
  });
  assert.equal(value().sprites.crystal.frames, 8);
  editor.choose({ thing: 'message' });
  click(editor, floor(2.5, 1.5));
  editor.choose({ thing: 'goal' });
  click(editor, floor(3.5, 1.5));
  assert.deepEqual(value().maps[0].messages[0], { text: 'Something to read.', x: 2, y: 1 });
  assert.deepEqual(value().game.at, { x: 3, y: 1 });
  await isSound(scene);
});

test('the picture shows links with their tools, and else what is pointed at or edited', () => {
  const { editor } = opened('link', 'gate');
  click(editor, block(3, 2, 'south'));
  editor.choose({ way: 'message', edited: null });
  click(editor, floor(5.5, 4.5));
  const gate = '#f0a34a';
  const message = '#7fc4e8';
  const shown = () => {
    const colours = new Set(editor.marks.map(({ colour }) => colour));
    return [gate, message, '#ffffff'].filter((colour) => colours.has(colour));
  };
  editor.choose({ edited: null });
  editor.point(null);
  assert.deepEqual(shown(), [gate, message]);
  editor.choose({ tool: modules.place });
  assert.deepEqual(shown(), []);
  editor.point(block(6, 0, 'south'));
  assert.deepEqual(shown(), []);
  editor.point(block(3, 2, 'south'));
  assert.deepEqual(shown(), [gate]);
  editor.point(null);
  editor.choose({ edited: ['maps', 0, 'messages', 0] });
  assert.deepEqual(shown(), ['#ffffff'], 'what is edited is white');
});
