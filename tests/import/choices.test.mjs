// What a person may choose in the dialog, and what the scene becomes by it.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { importModules, make, proposalOf, tilesPicture } from './load.mjs';

const choices = await importModules();
const {
  groupsOf,
  keepChoices,
  kindUses,
  layersOfKinds,
  makeScene,
  outsideOf,
  seenAs,
  setKindUse,
  setLayerUse,
  summaryOf,
} = choices;

const kSide = 4;
const layer = (name, gids) => ({ name, type: 'tilelayer', width: 4, height: 4, data: gids });
const all = (gid) => Array(kSide * kSide).fill(gid);
const rim = all(0).map((_, at) => (at % 4 === 0 || at % 4 === 3 || at < 4 || at > 11 ? 1 : 0));
const object = (id, type, x, y, more = {}) => ({
  id,
  type,
  name: '',
  x,
  y,
  width: 16,
  height: 16,
  ...more,
});
const kMap = JSON.stringify({
  type: 'map',
  orientation: 'orthogonal',
  width: kSide,
  height: kSide,
  tilewidth: 16,
  tileheight: 16,
  tilesets: [
    {
      firstgid: 1,
      name: 'town',
      tilewidth: 16,
      tileheight: 16,
      columns: 3,
      tilecount: 6,
      image: 'town.png',
      imagewidth: 48,
      imageheight: 32,
    },
  ],
  layers: [
    layer('Ground', all(2)),
    { name: 'House', type: 'group', layers: [layer('Walls', rim), layer('Upper', rim)] },
    {
      name: 'Things',
      type: 'objectgroup',
      objects: [
        object(1, 'tree', 16, 16),
        object(2, 'oak', 32, 32),
        object(3, 'crate', 400, 16),
        object(4, 'player', 32, 16),
      ],
    },
  ],
});
const kFiles = { 'town.png': tilesPicture() };
const proposed = () => proposalOf('town.tmj', kMap, kFiles);

test('the dialog says what was found, by groups', async () => {
  const proposal = await proposed();
  assert.equal(summaryOf(proposal), 'Tiled, 4 × 4 tiles, 4 layers, 2 kinds of tiles, 4 objects');
  assert.deepEqual(groupsOf(proposal.layers), [
    { name: '', layers: [0] },
    { name: 'House', layers: [1, 2] },
  ]);
  const text = await proposalOf('a.txt', '1 1\n1 0');
  assert.equal(summaryOf(text), 'Text with numbers, 2 × 2 tiles, 1 layer, 2 kinds of tiles');
});

test('a layer may become a ceiling above the blocks, and blocks again', async () => {
  const proposal = await proposed();
  const [, walls, upper] = proposal.layers;
  assert.deepEqual([walls.level, upper.level], [0, 1]);
  setLayerUse(proposal, upper, 'ceiling');
  assert.equal(upper.level, 1, 'it lies on the walls');
  upper.level = 2.5;
  const { scene } = await makeScene(proposal);
  assert.equal(scene.maps[0].ceiling.height, 2.5);
  assert.equal(scene.maps[0].levels.length, 1);
  setLayerUse(proposal, upper, 'level');
  assert.equal((await makeScene(proposal)).scene.maps[0].levels.length, 3);
  upper.level = 400;
  setLayerUse(proposal, upper, 'level');
  assert.equal(upper.level, 31, 'the highest there is');
  setLayerUse(proposal, walls, 'ceiling');
  assert.equal(walls.level, 32);
});

test('a kind says what its layers make of it, and may be something else', async () => {
  const proposal = await proposed();
  const layers = layersOfKinds(proposal);
  const wall = proposal.kinds.findIndex(({ count }) => count === 24);
  assert.deepEqual(
    kindUses(proposal.kinds[wall], layers[wall]).map(([use, words]) => `${use}: ${words}`),
    [
      'by layer: Block (layer)',
      'block: Block',
      'floor: Floor',
      'sprite: Upright picture',
      'start: Start',
      'empty: Nothing',
    ],
  );
  setLayerUse(proposal, proposal.layers[2], 'floor');
  assert.match(kindUses(proposal.kinds[wall], layers[wall])[0][1], /^As its layers$/);
  assert.deepEqual(seenAs(proposal.kinds[wall], layers[wall]), ['block', 'floor']);
  setKindUse(proposal.kinds[wall], 'empty');
  assert.deepEqual(seenAs(proposal.kinds[wall], layers[wall]), ['empty']);
  const { scene, notTaken } = await makeScene(proposal);
  assert.deepEqual(scene.maps[0].levels, [Array(4).fill('....')]);
  assert.match(JSON.stringify(notTaken), /left out, at 24 places/);
});

test('numbers that were empty become blocks with a look', async () => {
  const change = ({ kinds }) => {
    const nought = kinds.find(({ name }) => name === '0');
    assert.equal(nought.use, 'empty');
    setKindUse(nought, 'block');
    assert.ok(!kindUses(nought, new Set()).some(([use]) => use === 'sprite'));
  };
  const { scene } = await make('map.txt', '1 1 1\n1 0 1\n1 1 1', {}, change);
  const [, row] = scene.maps[0].levels[0];
  const { faces } = scene.blueprints[scene.legend[row[1]]];
  assert.match(scene.textures[faces.all], /^\.\.\/textures\/[\w-]+\.png$/);
});

test('classes become shipped sprites: by their name, or as chosen', async () => {
  const proposal = await proposed();
  const byName = (name) => proposal.classes.find((row) => row.name === name);
  assert.deepEqual(
    proposal.classes.map(({ name, use, sprite }) => [name, use, sprite]),
    [
      ['tree', 'object', null],
      ['oak', 'object', 'oak'],
      ['crate', 'object', null],
      ['player', 'start', null],
    ],
  );
  byName('tree').sprite = 'pine';
  byName('crate').sprite = 'fountain';
  const { scene, notTaken } = await makeScene(proposal);
  assert.deepEqual(
    scene.maps[0].objects.map(({ sprite, height, width }) => [sprite, height, width]),
    [
      ['pine', 2.8, undefined],
      ['oak', 3.2, undefined],
      ['fountain', 1.1, undefined],
    ],
  );
  assert.deepEqual(scene.sprites.fountain, { file: '../sprites/fountain.png', frames: 6, rate: 8 });
  assert.equal(outsideOf(proposal), 1);
  assert.match(JSON.stringify(notTaken), /object 3 .*moved to its edge/);
  proposal.outside = 'leave out';
  const without = await makeScene(proposal);
  assert.equal(without.scene.maps[0].objects.length, 2);
  assert.match(JSON.stringify(without.notTaken), /outside the map, and so left out/);
});

test('choices stay when pictures are added', async () => {
  const bare = await proposalOf('town.tmj', kMap);
  assert.match(JSON.stringify(bare.notTaken), /town.png/);
  setLayerUse(bare, bare.layers[1], 'leave out');
  bare.kinds[0].top = 0.5;
  bare.classes[0].sprite = 'oak';
  bare.outside = 'leave out';
  const whole = await proposed();
  keepChoices(bare, whole);
  assert.equal(whole.layers[1].use, 'leave out');
  assert.equal(whole.kinds[0].top, 0.5);
  assert.equal(whole.classes[0].sprite, 'oak');
  assert.equal(whole.outside, 'leave out');
  assert.ok(whole.pictures[0].bytes.length > 0);
});
