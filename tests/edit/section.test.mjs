// The section of the side view, without a page: what it cuts, with which heights, and what a drag
// of an edge, of the ceiling and of things does to the document.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { editModules } from './modules.mjs';

const {
  behind,
  blocksIn,
  ceilingDrag,
  cellIn,
  countOf,
  edgeAt,
  edgeDrag,
  Editor,
  History,
  kindOf,
  kStep,
  lengthOf,
  place,
  portalsIn,
  printed,
  profileOf,
  SceneDocument,
  sizeOf,
  thingDrag,
  thingsIn,
  withEdge,
} = await editModules();

const kScenes = fileURLToPath(new URL('../../assets/scenes', import.meta.url));

function opened() {
  const scene = new SceneDocument(
    printed(
      {
        textures: { grey: '#808080' },
        sprites: { tree: '#208020' },
        blueprints: {
          wall: { faces: 'grey' },
          half: { top: 0.5, faces: 'grey' },
          raised: { bottom: 0.25, top: 0.75, faces: 'grey' },
          ramp: { top: [0, 1], rise: 'east', faces: 'grey' },
          pane: { plan: [0, 0, 1, 0.1], faces: 'grey' },
        },
        legend: { '#': 'wall', h: 'half', r: 'raised', '/': 'ramp', '-': 'pane' },
        maps: [
          {
            name: 'yard',
            levels: [
              ['#.h/-', '#r...', '.....'],
              ['.....', '....h', '.....'],
            ],
            floor: 'grey',
            ceiling: { height: 3, texture: 'grey' },
            objects: [
              { sprite: 'tree', x: 1.5, y: 0.5, height: 2 },
              { sprite: 'tree', x: 2.5, y: 2.6, z: 1, height: 2 },
            ],
            baked: { lamps: [{ x: 0.5, y: 1.5, z: 2 }] },
            portals: [
              { x: 3, y: 0, face: 'west', to: { x: 1, y: 0 } },
              { x: 0, y: 2, to: { x: 4, y: 2, level: 1 } },
              { x: 2, y: 2, level: 1, face: 'north', to: { map: 'far', x: 0, y: 0 } },
            ],
          },
          { name: 'far', levels: [['..']], floor: 'grey' },
        ],
        start: { x: 4.5, y: 0.5 },
      },
      '',
    ),
  );
  const history = new History(scene);
  return { scene, history, editor: new Editor(scene, history, place) };
}

const kRow = { axis: 'x', at: 0 };
const shapeOf = ({ along, level, name, profile: { from, to, bottom, top, isCut } }) => [
  along,
  level,
  name,
  [from, to],
  bottom,
  top,
  isCut,
];

test('a section has the true heights of halves, raised blocks and slopes', () => {
  const { scene } = opened();
  assert.deepEqual(blocksIn(scene, 0, kRow).map(shapeOf), [
    [0, 0, 'wall', [0, 1], [0, 0], [1, 1], true],
    [2, 0, 'half', [0, 1], [0, 0], [0.5, 0.5], true],
    [3, 0, 'ramp', [0, 1], [0, 0], [0, 1], true],
    [4, 0, 'pane', [0, 1], [0, 0], [1, 1], false],
  ]);
  // The ramp rises across a section from north to south: its middle is cut.
  assert.deepEqual(blocksIn(scene, 0, { axis: 'y', at: 3 }).map(shapeOf), [
    [0, 0, 'ramp', [0, 1], [0, 0], [0.5, 0.5], true],
  ]);
  assert.deepEqual(blocksIn(scene, 0, { axis: 'y', at: 4 }).map(shapeOf), [
    [0, 0, 'pane', [0, 0.1], [0, 0], [1, 1], true],
    [1, 1, 'half', [0, 1], [0, 0], [0.5, 0.5], true],
  ]);
  assert.deepEqual(
    behind(scene, 0, { axis: 'x', at: 2 }).map(({ along, level, name, row }) => [
      along,
      level,
      name,
      row,
    ]),
    [
      [0, 0, 'wall', 1],
      [1, 0, 'raised', 1],
      [2, 0, 'half', 0],
      [3, 0, 'ramp', 0],
      [4, 0, 'pane', 0],
      [4, 1, 'half', 1],
    ],
  );
});

test('slopes, parts of a tile and halves along a diagonal', () => {
  const west = { top: [0.2, 0.8], rise: 'west', plan: [0.25, 0, 0.75, 1], faces: 'grey' };
  const { top, ends } = profileOf(west, 'x');
  assert.deepEqual(
    top.map((height) => Math.round(height * 100) / 100),
    [0.65, 0.35],
  );
  assert.deepEqual(ends, [1, 0]);
  assert.equal(profileOf(west, 'y').ends, null);
  const vault = { bottom: [0.2, 0.8], rise: 'south', faces: 'grey' };
  assert.deepEqual(profileOf(vault, 'y').bottom, [0.2, 0.8]);
  assert.deepEqual(profileOf(vault, 'x').bottom, [0.5, 0.5]);
  const range = (diagonal, axis) => {
    const { from, to } = profileOf({ diagonal, faces: 'grey' }, axis);
    return [from, to];
  };
  assert.deepEqual(range('north-east', 'x'), [0.5, 1]);
  assert.deepEqual(range('north-east', 'y'), [0, 0.5]);
  assert.deepEqual(range('south-west', 'x'), [0, 0.5]);
  assert.deepEqual(range('south-west', 'y'), [0.5, 1]);
});

test('what stands near the section, and the portals on it', () => {
  const { scene } = opened();
  assert.deepEqual(
    thingsIn(scene, 0, kRow).map(({ kind, along, z, away }) => [kind, along, z, away]),
    [
      ['object', 1.5, 0, 0],
      ['lamp', 0.5, 2, 1],
      ['start', 4.5, 0.6, 0],
    ],
  );
  assert.deepEqual(portalsIn(scene, 0, kRow), [
    { along: 3, level: 0, side: 'from', exit: { along: 1, level: 0 } },
  ]);
  assert.deepEqual(portalsIn(scene, 0, { axis: 'x', at: 2 }), [
    { along: 0, level: 0, side: 'whole', exit: { along: 4, level: 1 } },
    { along: 2, level: 1, side: 'front', exit: null },
  ]);
  assert.deepEqual(portalsIn(scene, 0, { axis: 'y', at: 2 })[0].side, 'from');
});

test('every cell of every shipped scene is in one section of each direction', () => {
  for (const file of readdirSync(kScenes).filter((name) => name !== 'index.json')) {
    const scene = new SceneDocument(readFileSync(`${kScenes}/${file}`, 'utf8'));
    scene.value.maps.forEach((_, map) => {
      const { width, depth, levels } = sizeOf(scene, map);
      if (width * depth * levels > 40_000) return; // seconds
      let count = 0;
      for (let level = 0; level < levels; ++level)
        for (let y = 0; y < depth; ++y)
          for (let x = 0; x < width; ++x)
            if (kindOf(scene, map, scene.sign(map, level, x, y)) !== null) count += 1;
      for (const axis of ['x', 'y']) {
        let found = 0;
        for (let at = 0; at < countOf(scene, map, { axis }); ++at)
          for (const { along, level, sign, profile, blueprint } of blocksIn(scene, map, {
            axis,
            at,
          })) {
            found += 1;
            const { x, y } = cellIn({ axis, at }, along, level);
            assert.equal(scene.sign(map, level, x, y), sign);
            const heights = [profile.bottom, profile.top].flat();
            assert.ok(
              heights.every((height) => height >= 0 && height <= 1),
              file,
            );
            const tops = [blueprint.top ?? 1].flat();
            assert.ok(Math.max(...profile.top) <= Math.max(...tops), `${file} ${sign}`);
            assert.ok(profile.from < profile.to);
          }
        assert.equal(found, count, `${file} ${map} ${axis}`);
      }
    });
  }
});

test('the nearest edge is found, also at both ends of a slope', () => {
  const half = profileOf({ top: 0.5 }, 'x');
  assert.deepEqual(edgeAt(half, 0.5, 0.4), {
    edge: 'top',
    index: null,
    distance: 0.09999999999999998,
  });
  assert.equal(edgeAt(half, 0.5, 0.1).edge, 'bottom');
  assert.equal(edgeAt(half, 0.5, 0.9).edge, 'top');
  const ramp = profileOf({ top: [0, 1], rise: 'west' }, 'x');
  assert.deepEqual([edgeAt(ramp, 0.1, 0.9).index, edgeAt(ramp, 0.9, 0.1).index], [1, 0]);
  assert.equal(edgeAt(ramp, 0.25, 0.75).distance, 0);
});

test('an edge keeps the block a block', () => {
  assert.deepEqual(withEdge({ faces: 'a' }, 'top', null, 0.5), { faces: 'a', top: 0.5 });
  assert.deepEqual(withEdge({ faces: 'a', top: 0.5 }, 'top', null, 1), { faces: 'a' });
  assert.equal(withEdge({ faces: 'a', top: 0.5 }, 'bottom', null, 0.5), null);
  const ramp = { top: [0, 1], rise: 'east', faces: 'a' };
  assert.deepEqual(withEdge(ramp, 'top', 0, 0.3).top, [0.3, 1]);
  assert.deepEqual(ramp.top, [0, 1], 'not in place');
  assert.equal(withEdge(ramp, 'top', null, 0.3), null, 'it rises across the section');
  assert.equal(withEdge(ramp, 'top', 1, 0), null, 'nothing would be left');
  assert.equal(withEdge(ramp, 'bottom', null, 0.2), null, 'above the top at one end');
  assert.deepEqual(withEdge({ ...ramp, top: [0.5, 1] }, 'bottom', null, 0.2).bottom, 0.2);
});

test('a drag of an edge leaves one kind, and is undone at once', () => {
  const { scene, history, editor } = opened();
  const before = scene.text;
  const [block] = blocksIn(scene, 0, kRow);
  const drag = edgeDrag(
    editor,
    { cell: cellIn(kRow, 0, 0), kind: block, edge: 'top', index: null },
    0.95,
  );
  for (const z of [0.9, 0.8, 0.62, 0.55, 0.33]) drag.move([0.5, z], kStep);
  drag.end();
  assert.deepEqual(Object.keys(scene.value.blueprints), [
    'wall',
    'half',
    'raised',
    'ramp',
    'pane',
    'wall up to 0.4',
  ]);
  assert.equal(kindOf(scene, 0, scene.sign(0, 0, 0, 0)).blueprint.top, 0.4);
  assert.equal(history.undoLabel, 'Shape');
  history.undo();
  assert.equal(scene.text, before);
  assert.equal(history.undoLabel, null);

  // A kind that looks so is taken; Escape takes all back.
  const other = edgeDrag(
    editor,
    { cell: cellIn(kRow, 0, 0), kind: block, edge: 'top', index: null },
    1,
  );
  other.move([0.5, 0.5], kStep);
  assert.equal(scene.sign(0, 0, 0, 0), 'h');
  other.move([0.5, -3], kStep);
  assert.equal(scene.text, before, 'no height is left');
  other.move([0.5, 0.7], kStep);
  other.cancel();
  assert.equal(scene.text, before);
});

test('a slope, the ceiling and things are dragged', () => {
  const { scene, history, editor } = opened();
  const ramp = blocksIn(scene, 0, kRow).find(({ name }) => name === 'ramp');
  const cell = cellIn(kRow, ramp.along, 0);
  const slope = edgeDrag(editor, { cell, kind: ramp, edge: 'top', index: 1 }, 1);
  slope.move([3.9, 0.58], kStep);
  slope.end();
  const made = kindOf(scene, 0, scene.sign(0, 0, 3, 0));
  assert.deepEqual(
    [made.name, made.blueprint.top, made.blueprint.rise],
    ['ramp 2', [0, 0.6], 'east'],
  );

  const ceiling = ceilingDrag(editor, 3);
  ceiling.move([1, 3.47], kStep);
  ceiling.move([1, -4], kStep);
  assert.equal(scene.value.maps[0].ceiling.height, 0.1, 'above the floor');
  ceiling.move([1, 3.46], 0.01);
  ceiling.end();
  assert.equal(scene.value.maps[0].ceiling.height, 3.46);

  const lamp = thingsIn(scene, 0, kRow).find(({ kind }) => kind === 'lamp');
  const drag = thingDrag(editor, kRow, lamp, [0.6, 2.1]);
  drag.move([2.6, 1.42], kStep);
  drag.end();
  assert.deepEqual(scene.value.maps[0].baked.lamps, [{ x: 2.5, y: 1.5, z: 1.3 }]);
  const start = thingsIn(scene, 0, kRow).find(({ kind }) => kind === 'start');
  const far = thingDrag(editor, kRow, start, [4.5, 0.6]);
  far.move([40, 2.6], kStep);
  far.end();
  const { x, z } = scene.value.start;
  assert.ok(x < lengthOf(scene, 0, kRow) && x > 4.8);
  assert.equal(z, 2);
  for (let count = 0; count < 4; ++count) history.undo();
  assert.equal(history.undoLabel, null, 'one for each drag');
});
