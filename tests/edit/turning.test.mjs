// Turning and mirroring of blueprints, motions, headings and portals.

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';

import { editModules } from './modules.mjs';

const {
  composed,
  isSame,
  kStill,
  kTurns,
  turnedBlueprint,
  turnedCorner,
  turnedFace,
  turnedHeading,
  turnedMotion,
  turnedName,
  turnedPoint,
  turnedPortal,
} = await editModules();
const { right, left } = kTurns;
const kMirrors = [kTurns['west-east'], kTurns['north-south']];
const kScenes = new URL('../../assets/scenes/', import.meta.url);

const times = (count, act, value) =>
  Array.from({ length: count }).reduce((last) => act(last), value);

test('four turns and two mirrors give back every blueprint and motion of every scene', () => {
  let count = 0;
  for (const file of readdirSync(kScenes)) {
    const scene = JSON.parse(readFileSync(new URL(file, kScenes), 'utf8'));
    for (const [turnedOne, all] of [
      [turnedBlueprint, scene.blueprints],
      [turnedMotion, scene.motions],
    ]) {
      for (const [name, one] of Object.entries(all ?? {})) {
        count += 1;
        const same = (turned, what) =>
          assert.ok(isSame(turned, one), `${file}, ${name}, ${what}: ${JSON.stringify(turned)}`);
        same(
          times(4, (last) => turnedOne(last, right), one),
          'four turns',
        );
        for (const mirror of kMirrors)
          same(
            times(2, (last) => turnedOne(last, mirror), one),
            'two mirrors',
          );
        same(turnedOne(turnedOne(one, right), left), 'right and left');
        // Both mirrors are half a turn.
        assert.ok(
          isSame(
            turnedOne(turnedOne(one, kMirrors[0]), kMirrors[1]),
            times(2, (last) => turnedOne(last, right), one),
          ),
          name,
        );
      }
    }
  }
  assert.ok(count > 300, `${count}`);
});

test('sides, corners, slopes, plans and faces turn clockwise', () => {
  assert.deepEqual(
    ['north', 'east', 'south', 'west', 'top'].map((face) => turnedFace(face, right)),
    ['east', 'south', 'west', 'north', 'top'],
  );
  assert.equal(turnedCorner('north-west', right), 'north-east');
  assert.equal(turnedCorner('north-west', kTurns['north-south']), 'south-west');
  assert.deepEqual(turnedPoint([1, 0], right), [0, 1]);
  assert.deepEqual(
    turnedBlueprint(
      {
        top: [0, 0.5],
        rise: 'west',
        plan: [0.7, 0, 1, 0.2],
        faces: { all: 'a', north: 'n', top: 't' },
      },
      right,
    ),
    {
      top: [0, 0.5],
      rise: 'north',
      plan: [0.8, 0.7, 1, 1],
      faces: { all: 'a', east: 'n', top: 't' },
    },
  );
  assert.deepEqual(composed(right, left), kStill);
  assert.deepEqual(composed(right, right), composed(...kMirrors));
});

test('a cut keeps its look, also one that it has from a side', () => {
  const half = { diagonal: 'north-west', faces: { all: 'a', south: 's', north: 'n' } };
  const turned = turnedBlueprint(half, right); // north-east; its cut still faces the south
  assert.deepEqual(turned, {
    diagonal: 'north-east',
    faces: { all: 'a', west: 's', east: 'n', diagonal: 's' },
  });
  assert.deepEqual(turnedBlueprint(turned, left), half);
});

test('motions along an axis change it, and their sign where it points the other way', () => {
  const cart = { along: 'x', moves: 'both', to: 9, period: 36 };
  assert.deepEqual(turnedMotion(cart, right), { ...cart, along: 'y' });
  assert.deepEqual(turnedMotion(cart, left), { ...cart, along: 'y', to: -9 });
  const door = { along: 'y', moves: 'north', from: 0, to: 0.9 };
  assert.deepEqual(turnedMotion(door, kTurns['north-south']), {
    ...door,
    moves: 'south',
    to: -0.9,
  });
  const lift = { moves: 'top', to: 2 };
  assert.equal(turnedMotion(lift, right), lift);
});

test('headings turn, and are mirrored', () => {
  assert.equal(turnedHeading(350, right), 80);
  assert.equal(turnedHeading(30, kTurns['west-east']), 150);
  assert.equal(turnedHeading(30, kTurns['north-south']), 330);
  assert.equal(turnedHeading(-90, left), 180);
});

test('names turn their sides, others say that they were turned', () => {
  assert.equal(turnedName('west roof', right), 'north roof');
  assert.equal(turnedName('bridge rail 0.5 east north', right), 'bridge rail 0.5 south east');
  assert.equal(turnedName('lamp', right), 'lamp, turned');
  assert.equal(turnedName('lamp, turned 2', right), 'lamp, turned');
});

test('a portal leads the same way out when one of its ends is turned', () => {
  const portal = { face: 'east', turn: 90 }; // goes in to the west, comes out to the north
  assert.equal(turnedPortal(portal, right, kStill), 0, 'in to the north, out to the north');
  assert.equal(turnedPortal(portal, kStill, right), 180, 'in to the west, out to the east');
  assert.equal(turnedPortal(portal, right, right), 90);
  assert.equal(turnedPortal(portal, kTurns['west-east'], kTurns['west-east']), 270);
  assert.equal(turnedPortal({ face: 'east' }, kTurns['west-east'], kStill), 180);
  assert.equal(turnedPortal({}, right, right), 0);
  assert.equal(turnedPortal({}, right, kStill), 270);
});

test('all directions that a scene can say are known', () => {
  const schema = JSON.parse(readFileSync(new URL('../scene.schema.json', kScenes), 'utf8'));
  const found = [];
  const walk = (node, path) => {
    if (typeof node !== 'object' || node === null) return;
    const words = [node.enum ?? [], Object.keys(node.properties ?? {})].flat().map(String);
    const isDirection =
      words.some((word) => /^(north|east|south|west|90)\b/.test(word)) ||
      (node.enum?.includes('x') ?? false) ||
      /^(heading|azimuth|plan)$/.test(path.split('.').at(-1)) ||
      /\b(clockwise|compass|direction)\b/.test(node.description ?? '');
    if (isDirection) found.push(path);
    for (const [name, one] of Object.entries(node.properties ?? {})) walk(one, `${path}.${name}`);
    for (const list of ['anyOf', 'allOf', 'oneOf'])
      for (const one of node[list] ?? []) walk(one, path);
    walk(node.items, `${path}[]`);
    walk(node.additionalProperties, `${path}.*`);
  };
  for (const [name, one] of Object.entries(schema.definitions)) walk(one, name);
  assert.deepEqual([...new Set(found)].sort(), [
    'blueprint.diagonal',
    'blueprint.faces',
    'blueprint.plan',
    'blueprint.rise',
    'clouds.speed', // the sky stays
    'moon.azimuth',
    'motion.along',
    'motion.moves',
    'object.heading',
    'objectKind.heading', // of objects in rows, which no selection takes along
    'objectMotion.heading',
    'objectMotion.kind', // "wander: changes direction"
    'place.heading', // named places stay, too
    'portal.face',
    'portal.turn',
    'start.heading',
    'sun.azimuth',
    'sunlight.azimuth',
  ]);
});
