// Painting the tiles of floors and ceilings, and drawing lines, without a page.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { editModules } from './modules.mjs';

const { Editor, History, line, paint, printed, SceneDocument, textureOfSign, tileChanges } =
  await editModules();

function opened(tool, map = {}) {
  const scene = new SceneDocument(
    printed(
      {
        textures: { grass: '#308030', sand: '#d0c080', wood: '#805030' },
        blueprints: { wall: { faces: 'wood' } },
        legend: { '#': 'wall' },
        maps: [
          { name: 'yard', levels: [['....', '.#..', '....', '....']], floor: 'grass', ...map },
        ],
        start: { x: 0.5, y: 0.5 },
      },
      '',
    ),
  );
  const history = new History(scene);
  return { scene, history, editor: new Editor(scene, history, tool) };
}

const onFloor = (x, y) => ({
  map: 0,
  mapName: 'yard',
  cell: null,
  before: { level: 0, x, y },
  face: 'top',
  point: [x + 0.5, y + 0.5, 0],
  thing: null,
});
const inPlan = (x, y, level = 0) => ({
  ...onFloor(x, y),
  cell: { level, x, y },
  before: { level, x, y },
});

const textureAt = (scene, layer, x, y) =>
  textureOfSign(scene.value.maps[0][layer], layer, scene.sign(0, layer, x, y));

test('a drag over the floor paints its tiles, in a stroke that is undone at once', () => {
  const { scene, history, editor } = opened(paint);
  const before = scene.text;
  editor.choose({ texture: 'sand' });
  editor.press(onFloor(0, 0));
  editor.point(onFloor(3, 0)); // faster than its tiles
  editor.point(onFloor(3, 1));
  editor.release();
  const { floor } = scene.value.maps[0];
  assert.deepEqual(floor, {
    texture: 'grass',
    legend: { s: 'sand' },
    tiles: ['ssss', '...s', '....', '....'],
  });
  assert.equal(textureAt(scene, 'floor', 3, 1), 'sand');
  assert.equal(textureAt(scene, 'floor', 2, 1), 'grass');
  editor.press(onFloor(1, 0), { removes: true });
  editor.release();
  assert.equal(scene.rows(0, 'floor')[0], 's.ss');
  editor.choose({ texture: 'grass' });
  editor.press(onFloor(2, 0));
  editor.release();
  assert.equal(scene.rows(0, 'floor')[0], 's..s', "the floor's own texture needs no sign");
  for (let count = 0; count < 3; ++count) history.undo();
  assert.equal(scene.text, before);
});

test('in the plan the floor is painted where nothing stands, and a block where one does', () => {
  const { scene, editor } = opened(paint);
  editor.choose({ texture: 'sand' });
  editor.press(inPlan(2, 1));
  editor.point(inPlan(1, 1));
  editor.release();
  assert.equal(scene.rows(0, 'floor')[1], '..s.');
  assert.notEqual(scene.rows(0, 0)[1], '.#..');
  editor.press(inPlan(0, 0, 1));
  editor.release();
  assert.equal(scene.rows(0, 'floor')[0], '....', 'not from a higher level');
  editor.choose({ way: 'floor' });
  editor.press(inPlan(1, 1));
  editor.release();
  assert.equal(scene.rows(0, 'floor')[1], '.ss.', 'also under a block');
});

test('a first tile of a ceiling makes one that is open elsewhere; later ones have a legend', () => {
  const { scene, editor } = opened(paint);
  editor.choose({ texture: 'wood', way: 'ceiling' });
  editor.press(inPlan(1, 1));
  editor.point(inPlan(2, 1));
  editor.release();
  editor.choose({ texture: 'sand' });
  editor.press(inPlan(3, 3));
  editor.release();
  assert.deepEqual(scene.value.maps[0].ceiling, {
    height: 1,
    texture: 'wood',
    tiles: ['    ', ' .. ', '    ', '   s'],
    legend: { s: 'sand' },
  });
  assert.equal(textureAt(scene, 'ceiling', 0, 0), null, 'the sky');
  assert.equal(textureAt(scene, 'ceiling', 1, 1), 'wood');
});

test('a known sign of the layer is used, and what lies outside is left out', () => {
  const floor = { texture: 'grass', legend: { '~': 'sand' }, tiles: Array(4).fill('....') };
  const { scene, history } = opened(paint, { floor });
  const places = [-1, 0, 3, 4].map((x) => ({ x, y: 0 }));
  history.do('Paint', tileChanges(scene, 0, 'floor', places, 'sand'));
  assert.deepEqual(scene.value.maps[0].floor, {
    ...floor,
    tiles: ['~..~', '....', '....', '....'],
  });
  assert.deepEqual(tileChanges(scene, 0, 'floor', [{ x: 9, y: 0 }], 'wood'), []);
});

test('a line goes from end to end, and the wheel lifts the second one', () => {
  const { scene, editor } = opened(line);
  editor.press(onFloor(0, 3));
  editor.point(onFloor(3, 3));
  assert.equal(editor.touched.size, 4);
  editor.turn(1);
  editor.release();
  assert.deepEqual([scene.rows(0, 0)[3], scene.rows(0, 1)[3]], ['##..', '..##']);
  editor.press({ ...onFloor(0, 3), cell: { level: 0, x: 0, y: 3 } }, { removes: true });
  editor.point({ ...onFloor(1, 3), cell: { level: 0, x: 1, y: 3 } });
  editor.release();
  assert.equal(scene.rows(0, 0)[3], '....');
});
