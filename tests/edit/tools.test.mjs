// The tools of the editor, without a page: what a stroke over targets does to the document.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { editModules } from './modules.mjs';

const modules = await editModules();
const { Editor, History, SceneDocument, kindsOf, printed, targetOf } = modules;

const kRows = ['######', '#....#', '#.ww.#', '#.ww.#', '#....#', '######'];

function opened(tool) {
  const scene = new SceneDocument(
    printed(
      {
        textures: { grey: '#808080', red: '#c03020' },
        blueprints: { wall: { faces: 'grey' }, 'low wall': { top: 0.5, faces: 'red' } },
        legend: { '#': 'wall', w: 'low wall' },
        maps: [{ name: 'yard', levels: [kRows], floor: 'grey' }],
        start: { x: 1.5, y: 1.5 },
      },
      '',
    ),
  );
  const history = new History(scene);
  const editor = new Editor(scene, history, modules[tool]);
  return { scene, history, editor, rows: (level = 0) => scene.rows(0, level) };
}

// As a view makes it of a block's face, or of the floor.
function at(x, y, { level = 0, face = 'top', object = null } = {}) {
  const sides = { north: [0, -1], south: [0, 1], west: [-1, 0], east: [1, 0] };
  const [east, south] = sides[face] ?? [0, 0];
  const up = { top: 1, bottom: -1 }[face] ?? 0;
  return {
    map: 0,
    mapName: 'yard',
    cell: { level, x, y },
    before: { level: level + up, x: x + east, y: y + south },
    face,
    point: [x + 0.5, y + 0.5, level + 1],
    object,
  };
}
const floor = (x, y) => ({ ...at(x, y), cell: null, before: { level: 0, x, y } });

test('place puts blocks against faces, a drag puts a line, and a stroke is undone at once', () => {
  const { scene, history, editor, rows } = opened('place');
  const before = scene.text;
  editor.choose({ sign: 'w' });
  editor.press(floor(1, 1));
  editor.point(floor(4, 1));
  editor.release();
  assert.equal(rows()[1], '#wwww#', 'also where the pointer was too fast');
  editor.press(at(0, 0));
  editor.release();
  assert.equal(rows(1)[0], 'w.....');
  editor.press(at(2, 2), { removes: true });
  editor.point(at(3, 2));
  editor.release();
  assert.equal(rows()[2], '#....#');
  assert.equal(history.length, 3);
  for (let count = 0; count < 3; ++count) history.undo();
  assert.equal(scene.text, before);
  editor.press(floor(1, 1));
  editor.cancel();
  assert.equal(scene.text, before);
  assert.equal(editor.stroke, null);
});

test('marks show the cell where a block would stand, and what would be removed', () => {
  const { editor } = opened('place');
  editor.point(floor(1, 1));
  assert.equal(editor.marks.length, 12);
  assert.ok(
    editor.marks.every(({ from, to }) =>
      [...from, ...to].every((number) => number >= 0 && number <= 2),
    ),
  );
  editor.point(at(2, 2));
  assert.equal(editor.marks.length, 16, 'the cell and the face');
  editor.point(null);
  assert.deepEqual(editor.marks, []);
});

test('box makes solid, hollow and open boxes; the wheel sets the height', () => {
  const count = (rows) => rows.join('').replaceAll(/[^w]/g, '').length;
  for (const [way, counts] of [
    ['solid', [16, 16, 16]],
    ['hollow', [16, 12, 16]],
    ['walls', [12, 12, 12]],
  ]) {
    const { editor, rows } = opened('box');
    editor.choose({ sign: 'w', way });
    editor.press(floor(1, 1));
    editor.point(floor(4, 4));
    assert.equal(rows()[1], kRows[1], 'nothing before the end');
    assert.equal(editor.marks.length, 12);
    editor.turn(1);
    editor.turn(2);
    editor.release();
    const walls = way === 'walls' ? 4 : 0; // of the scene, in the middle
    assert.deepEqual(
      [0, 1, 2].map((level) => count(rows(level))),
      [counts[0] + walls, counts[1], counts[2]],
      way,
    );
  }
});

test('a box past the map is clipped to it, shown so, and words say why', () => {
  const { editor, rows } = opened('box');
  const most = () => Math.max(...editor.marks.flatMap(({ from, to }) => [...from, ...to]));
  editor.choose({ sign: 'w', way: 'walls' });
  editor.press(floor(2, 1));
  editor.point(floor(9, 4));
  assert.equal(most(), 6);
  assert.match(editor.about, /^The map ends here\. .*Size/);
  editor.release();
  assert.deepEqual(rows().slice(1, 5), ['#.wwww', '#.ww.w', '#.ww.w', '#.wwww'], 'with all walls');
  editor.point(floor(1, 3));
  assert.match(editor.about, /^Drag from corner/);
  for (const tool of ['place', 'line', 'fill', 'select']) {
    editor.choose({ tool: modules[tool] });
    editor.point(floor(9, 4));
    assert.match(editor.about, /^The map ends here/, tool);
    assert.deepEqual(editor.marks, [], tool);
  }
  editor.point(at(1, 1, { level: 31 }));
  editor.choose({ tool: modules.place });
  assert.match(editor.about, /level 31/);
});

test('what a click would choose is named', () => {
  const { editor, scene, history } = opened('thing');
  history.do('Lamp', [
    {
      path: ['maps', 0, 'baked'],
      value: { lamps: [{ x: 2.5, y: 1.5, z: 1, colour: '#ffffff', radius: 3 }] },
    },
    { path: ['maps', 0, 'messages'], value: [{ text: 'A long text '.repeat(9), x: 1, y: 1 }] },
  ]);
  const edited = ['maps', 0, 'baked', 'lamps', 0];
  editor.choose({ edited });
  for (const { path } of modules.handlesOf(scene, 0, edited)) {
    editor.point({ ...floor(1, 1), thing: path });
    assert.match(
      editor.about,
      /^(Lamp|Start of|Message: A long text|Reach)[^.]*\. .*Drag/,
      String(path),
    );
  }
});

test('fill takes what is joined and alike, replace the whole map', () => {
  const filled = opened('fill');
  filled.editor.choose({ sign: 'w' });
  filled.editor.press(floor(1, 1));
  filled.editor.release();
  assert.deepEqual(filled.rows(), ['######', '#wwww#', '#wwww#', '#wwww#', '#wwww#', '######']);
  filled.editor.press(at(0, 0), { removes: true });
  filled.editor.release();
  assert.equal(filled.rows()[0], '......');
  const replaced = opened('replace');
  const said = [];
  replaced.editor.listen((what, words) => what === 'words' && said.push(words));
  replaced.editor.choose({ sign: 'w' });
  replaced.editor.point(at(0, 0));
  assert.match(replaced.editor.about, /changes 20 blocks of "wall" .* into "low wall"/);
  replaced.editor.press(at(0, 0));
  replaced.editor.release();
  assert.deepEqual(replaced.rows(), ['wwwwww', 'w....w', 'w.ww.w', 'w.ww.w', 'w....w', 'wwwwww']);
  replaced.editor.press(at(1, 1));
  replaced.editor.release();
  assert.equal(replaced.history.length, 1, 'nothing by a click on nothing');
  assert.match(said[0], /^20 blocks of "wall" changed into "low wall"/);
  assert.match(said[1], /^Click a block/);
});

test('paint gives a block a kind of its own, and finds one that looks so already', () => {
  const { scene, editor, rows, history } = opened('paint');
  const before = scene.text;
  editor.choose({ texture: 'red' });
  editor.press(at(2, 0, { face: 'south' }));
  editor.point(at(3, 0, { face: 'south' }));
  editor.release();
  const [, , painted] = rows()[0];
  assert.notEqual(painted, '#');
  assert.equal(rows()[0], `##${painted}${painted}##`, 'one kind for both');
  const kind = kindsOf(scene, 0).find(({ sign }) => sign === painted);
  assert.deepEqual(kind.blueprint, { faces: { all: 'grey', south: 'red' } });
  assert.equal(kind.name, 'wall, red');
  editor.isWhole = true;
  editor.press(at(2, 0, { face: 'south' }));
  editor.release();
  assert.deepEqual(kindsOf(scene, 0).find(({ sign }) => sign === rows()[0][2]).blueprint, {
    faces: 'red',
  });
  history.undo();
  history.undo();
  assert.equal(scene.text, before);
});

test('shape raises and lowers, and finds the kind that has that height', () => {
  const { scene, editor, rows } = opened('shape');
  editor.point(at(2, 2));
  for (let notch = 0; notch < 5; ++notch) editor.turn(1);
  const raised = kindsOf(scene, 0).find(({ sign }) => sign === rows()[2][2]);
  assert.deepEqual(raised.blueprint, { faces: 'red' });
  assert.equal(editor.turn(1), true);
  assert.deepEqual(rows()[2][2], raised.sign, 'not beyond the cell');
  for (let notch = 0; notch < 5; ++notch) editor.turn(-1);
  assert.equal(rows()[2], '#.ww.#', 'the kind that it was');
  editor.point(at(2, 2, { face: 'bottom' }));
  editor.turn(2);
  const lifted = kindsOf(scene, 0).find(({ sign }) => sign === rows()[2][2]);
  assert.deepEqual(lifted.blueprint, { bottom: 0.2, top: 0.5, faces: 'red' });
  assert.equal(lifted.name, 'low wall from 0.2 to 0.5');
});

test('picking chooses the block, and what is gone is chosen no more', () => {
  const { scene, history, editor } = opened('place');
  editor.pick(at(2, 2));
  assert.equal(editor.sign, 'w');
  editor.pick(at(1, 1));
  assert.equal(editor.sign, 'w', 'nothing stands there');
  history.do('Remove', [{ path: ['legend', 'w'], value: undefined }]);
  assert.equal(editor.sign, '#');
  assert.equal(scene.value.legend.w, undefined);
});

test('a pick of the picture becomes a target', () => {
  const { scene } = opened('place');
  const pick = {
    map: 'yard',
    point: [1, 2, 1],
    face: 'west',
    level: 1,
    tile: [3, 4],
    object: null,
    what: 'side',
  };
  const { cell, before } = targetOf(pick, scene);
  assert.deepEqual(
    [cell, before],
    [
      { level: 1, x: 3, y: 4 },
      { level: 1, x: 2, y: 4 },
    ],
  );
  const onFloor = targetOf({ ...pick, what: 'floor', level: null, face: null }, scene);
  assert.deepEqual(
    [onFloor.cell, onFloor.before, onFloor.face],
    [null, { level: 0, x: 3, y: 4 }, 'top'],
  );
  const below = targetOf(
    { ...pick, what: 'ceiling', level: null, face: null, point: [1, 2, 3] },
    scene,
  );
  assert.deepEqual(below.before, { level: 2, x: 3, y: 4 });
  assert.equal(targetOf({ ...pick, face: 'bottom', level: 0 }, scene).before, null);
  assert.equal(targetOf({ ...pick, point: null }, scene), null);
  assert.equal(targetOf({ ...pick, map: 'elsewhere' }, scene), null);
});

test('on the plan a thing keeps its height over the ground, also on steps and walls', () => {
  const { scene, history, editor } = opened('thing');
  const lamp = { x: 1.5, y: 1.5, z: 0.8, colour: '#ffffff', radius: 3 };
  history.do('Put', [
    { path: ['maps', 0, 'objects'], value: [{ sprite: 'tree', x: 1.5, y: 1.5, height: 1 }] },
    { path: ['maps', 0, 'baked'], value: { lamps: [lamp] } },
    ...modules.cellChanges(scene, 0, [{ layer: 1, x: 0, y: 3, sign: '#' }]),
  ]);
  const over = (thing, x, y) => ({
    ...at(x, y),
    point: [x + 0.5, y + 0.5, 0],
    view: 'plan',
    thing,
  });
  const heights = (path) => {
    const z = () => path.reduce((node, key) => node[key], scene.value).z ?? 0;
    editor.press(over(path, 1, 1));
    const found = [
      [2, 2],
      [5, 2],
      [0, 3],
      [4, 4],
    ].map((place) => {
      editor.point(over(path, ...place));
      return z();
    });
    editor.release();
    return found;
  };
  assert.deepEqual(heights(['maps', 0, 'objects', 0]), [0.5, 1, 2, 0]);
  assert.deepEqual(heights(['maps', 0, 'baked', 'lamps', 0]), [1.3, 1.8, 2.8, 0.8]);
});

test('the ground is the floor, a slope, or the top below a height', () => {
  const { scene, history } = opened('place');
  const slope = { top: [0, 1], rise: 'east', faces: 'grey' };
  history.do('Put', [
    { path: ['blueprints', 'slope'], value: slope },
    { path: ['legend', '/'], value: 'slope' },
    ...modules.cellChanges(scene, 0, [
      { layer: 0, x: 3, y: 1, sign: '/' },
      { layer: 2, x: 1, y: 1, sign: '#' },
    ]),
  ]);
  const ground = (x, y, z) => modules.groundAt(scene, 0, { x, y, z });
  assert.equal(ground(3.25, 1.5, 0), 0.25);
  assert.deepEqual(
    [0, 1.9, 2.5, 3, 9].map((z) => ground(1.5, 1.5, z)),
    [0, 0, 3, 3, 3],
  );
});

test('a pool has walls of the chosen block with water in them, a pond is in the floor', () => {
  const { scene, history, editor, rows } = opened('box');
  const before = scene.text;
  const names = () => Object.fromEntries(kindsOf(scene, 0).map(({ sign, name }) => [sign, name]));
  const name = (level, x, y) => names()[scene.sign(0, level, x, y)];
  editor.choose({ sign: '#', way: 'pool' });
  editor.press(floor(1, 1));
  editor.point(floor(4, 4));
  editor.turn(1);
  editor.release();
  assert.deepEqual([name(0, 1, 1), name(0, 2, 2)], ['wall', 'water below']);
  assert.deepEqual([name(1, 1, 1), name(1, 2, 2)], ['wall up to 0.5', 'water']);
  const { water, top } = scene.value.blueprints.water;
  assert.ok(water && top < 0.5, 'below the rim');
  history.undo();
  editor.choose({ way: 'pond' });
  editor.press(floor(1, 1));
  editor.point(floor(2, 2));
  editor.release();
  const pond = scene.value.maps[0].floor;
  assert.equal(pond.legend[pond.tiles[2][1]], pond.water);
  assert.equal(rows()[2], '#..w.#', 'nothing stands in it');
  editor.press(floor(1, 1), { removes: true });
  editor.point(floor(2, 2));
  editor.release();
  assert.ok(scene.value.maps[0].floor.tiles.every((row) => row === '......'));
  while (history.undo() !== null);
  assert.equal(scene.text, before);
});
