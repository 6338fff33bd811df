// A map's cells as a map of Tiled, and back: the same scene.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';

import { shippedScenes } from '../wasm/load.mjs';
import { decode, importModules, make, picture, proposalOf, tryScene } from './load.mjs';

const { exportTmj, makeScene } = await importModules();

// Empty cells may be blanks; they come back as full stops.
const dotted = (rows) => rows.map((row) => row.replaceAll(' ', '.'));
function withoutBlanks(scene) {
  const maps = scene.maps.map((map) => ({
    ...map,
    levels: map.levels.map(dotted),
    ...(map.floor?.tiles && { floor: { ...map.floor, tiles: dotted(map.floor.tiles) } }),
  }));
  return { ...scene, maps };
}

// Only the exported map loses its blanks.
function expectedOf(scene, name) {
  const dottedScene = withoutBlanks(scene);
  const maps = scene.maps.map((map, index) => (map.name === name ? dottedScene.maps[index] : map));
  return { ...scene, maps };
}

async function back(scene, name) {
  const { tmj, pictures } = exportTmj(scene, name);
  const proposal = await proposalOf('map.tmj', JSON.stringify(tmj), Object.fromEntries(pictures));
  return makeScene(proposal);
}

test('every map of every shipped scene comes back as it was', async () => {
  for (const file of shippedScenes) {
    const scene = JSON.parse(await readFile(file, 'utf8'));
    for (const { name } of scene.maps) {
      const made = await back(scene, name);
      const place = `${path.basename(file)}, ${name}`;
      assert.deepEqual(
        made.scene,
        expectedOf({ legend: {}, blueprints: {}, ...scene }, name),
        place,
      );
      assert.deepEqual(made.notTaken, [], place);
      assert.equal(made.pictures.size, 0, place);
    }
  }
});

const kScene = {
  title: 'Two',
  textures: { red: '#c03020', grass: '../textures/grass.png' },
  blueprints: { wall: { faces: 'red' }, step: { top: 0.5, faces: 'grass' } },
  legend: { '#': 'wall', '❤️': 'step' },
  maps: [
    { name: 'other', levels: [['..']], floor: 'grass' },
    {
      name: 'yard',
      legend: { '#': 'step', q: 'wall' },
      levels: [[], ['#q❤️', '.. '], [], ['...', '...']],
      floor: { texture: 'grass', legend: { '#': 'red', g: 'grass' }, tiles: ['#g.', '...'] },
      ceiling: { height: 5, texture: 'red', legend: { '#': 'grass' }, tiles: ['. #', '   '] },
      objects: [],
    },
  ],
  start: { map: 'yard', x: 1.5, y: 1.5, heading: 45 },
};

test('characters of the map, empty levels and open ceilings are kept', async () => {
  const { scene } = await back(kScene, 'yard');
  assert.deepEqual(scene, expectedOf(kScene, 'yard'));
  await tryScene({ scene, pictures: new Map() });
});

test('what is changed in Tiled comes back changed, with new tiles too', async () => {
  const { tmj, pictures } = exportTmj(kScene, 'yard');
  const level = tmj.layers.find(({ name }) => name === 'level 1');
  const [wall] = level.data.slice(1);
  level.data[3] = wall;
  level.data[4] = 1001;
  tmj.tilesets.push({
    firstgid: 1001,
    name: 'quay',
    tilewidth: 16,
    tileheight: 16,
    columns: 1,
    tilecount: 1,
    image: 'own.png',
    imagewidth: 16,
    imageheight: 16,
  });
  const own = picture(16, 16, () => [9, 8, 7, 255]);
  const files = { ...Object.fromEntries(pictures), 'own.png': own };
  const { scene, world } = await make('yard.tmj', JSON.stringify(tmj), files);
  const [above, below] = scene.maps[1].levels[1];
  assert.equal(above, '#q❤️');
  const sign = below[1];
  assert.equal(below, `q${sign}.`);
  assert.ok(!['#', 'q', '.'].includes(sign), 'a character that the map does not use');
  assert.equal(scene.legend[sign], 'quay 0');
  assert.equal(world.maps.length, 2);
});

test('the palette has a picture, in the colours of plain textures', () => {
  const { tmj, pictures } = exportTmj(kScene, 'yard');
  const [{ image, tiles, columns }] = tmj.tilesets;
  const { width, data } = decode(pictures.get(image));
  const { id } = tiles.find(({ properties }) => properties[1].value === 'wall');
  const at = 4 * ((8 + 16 * Math.floor(id / columns)) * width + 16 * (id % columns) + 8);
  assert.deepEqual([...data.slice(at, at + 3)], [0xc0, 0x30, 0x20]);
  const [hash] = tiles.filter(
    ({ type, properties }) => type === 'block' && properties[0].value === '#',
  );
  assert.equal(hash.properties[1].value, 'step', "the map's own legend comes first");
});

test('a map that is not there is an error, and a property that is no scene is told', async () => {
  assert.throws(() => exportTmj(kScene, 'cellar'), /found no map "cellar", expected other, yard/);
  const { tmj, pictures } = exportTmj(kScene, 'yard');
  for (const value of [
    'x',
    '{}',
    '{"scene":{"maps":[]},"map":0}',
    '{"scene":{"maps":[{}]},"map":0}',
  ]) {
    tmj.properties[0].value = value;
    const { notTaken } = await make('m.tmj', JSON.stringify(tmj), Object.fromEntries(pictures));
    assert.match(JSON.stringify(notTaken), /its property \\"slicecast\\" holds no scene/);
  }
});
