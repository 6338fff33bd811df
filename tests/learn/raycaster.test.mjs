// The reader's raycaster against the engine: every state, its checks, and its faults.

import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { check as isLaidOut, resolveConfig } from 'prettier';

import { check, expectations } from '../../web/learn/raycaster/checks.js';
import { difference, firstDifference, taught } from '../../web/learn/raycaster/compare.js';
import { faults, faultyText } from '../../web/learn/raycaster/faults.js';
import { asModule, engineOptions, functionsOf, sceneOf } from '../../web/learn/raycaster/states.js';
import { worldNumbers } from '../../web/learn/raycaster/world-numbers.js';
import { drawn, lookAt, openScene, program, root, states } from './reader.mjs';

const kSize = { width: 480, height: 300 };
const kSmall = { width: 160, height: 100 };
const kLeast = 0.999;
const chapters = Array.from({ length: states.chapters }, (_, i) => i + 1);

const opened = new Map();
async function sceneNamed(name) {
  if (!opened.has(name)) opened.set(name, await openScene(name));
  return opened.get(name);
}

const view = (x, y, z, heading, look = 0, map = 'yard') => ({ x, y, z, heading, look, map });

// Where each chapter is compared.
const walking = [
  view(1.6, 6.7, 0.5, 345),
  view(4.5, 6.2, 0.5, 290),
  view(8.5, 4.5, 0.5, 10),
  view(12.5, 2.5, 0.5, 130),
  view(9.2, 1.3, 0.5, 205.5),
  view(2.4, 7.35, 0.25, 20), // a wall that is taller than the picture
];
const looking = [view(3.6, 6.6, 0.5, 20, 0.15), view(9.5, 7.2, 0.5, 260, -0.2)];
const heights = [
  view(7.4, 7.5, 0.5, 235, 0.12),
  view(9.4, 3.5, 0.5, 200, 0.1),
  view(7.4, 6.4, 0.5, 310),
];
const flying = [view(8, 5, 3.5, 200, -0.4), view(13.2, 7.4, 2.2, 225, -0.25)];
const inside = [view(12.4, 4.4, 0.5, 175), view(13.5, 6.1, 0.5, 280, 0.1)];
const corner = [view(5, 5, 0.5, 45, 0, undefined), view(5, 5, 0.5, 230, 0, undefined)];

function viewsOf(chapter) {
  if (chapter < 9) return walking;
  if (chapter < 12) return [...walking, ...looking];
  if (chapter < 13) return [...heights, ...looking];
  if (chapter < 22) return [...heights, ...looking, ...flying, ...inside];
  return corner;
}

function expectedOf({ engine }, chapter, size = kSmall) {
  const trace = (columns) => engine.trace(columns, size);
  return JSON.parse(JSON.stringify(expectations(chapter, { size, trace })));
}

// The checks that fail, and the share of equal pixels, in the chapter's views.
async function judge(chapter, text, { size = kSmall, views = viewsOf(chapter) } = {}) {
  const scene = await sceneNamed(sceneOf(chapter));
  const { engine, world } = scene;
  const functions = program(text);
  const found = { failed: [], least: 1, all: 0 };
  for (const place of views) {
    const { eye, picture } = lookAt(scene, place, { chapter, size });
    const mine = drawn(functions, world, eye, size);
    const traces = engine.trace({ first: 0, last: size.width - 1 }, size);
    const mask = taught(chapter, traces, size, world);
    const told = difference(mine, picture, mask);
    found.all += told.all;
    if (told.share < found.least) {
      const context = { mine, engine: picture, mask, traces, functions, world, eye };
      Object.assign(found, { least: told.share, place, why: firstDifference(chapter, context) });
    }
    const expected = expectedOf(scene, chapter, size);
    found.failed.push(...check(chapter, functions, expected, world).filter(({ ok }) => !ok));
  }
  return found;
}

test('every answer is a program, and passes its own checks and the comparison', async (t) => {
  for (const chapter of chapters) {
    const text = states.answer(chapter);
    const found = await judge(chapter, text);
    t.diagnostic(
      `chapter ${chapter}: ${states.lines(chapter)} lines, ` +
        `${(100 * found.least).toFixed(3)} % equal in the worst of ${viewsOf(chapter).length} views, ` +
        `${(found.all / viewsOf(chapter).length / 160).toFixed(1)} % of pixels compared`,
    );
    assert.deepEqual(found.failed, [], `chapter ${chapter}`);
    assert.ok(found.least >= kLeast, `chapter ${chapter}: ${found.why?.says}`);
    if (chapter >= 4) assert.ok(found.all > 0);
  }
});

test('every start runs, and something of it is to be mended', async (t) => {
  for (const chapter of chapters) {
    const text = states.start(chapter);
    assert.match(text, /Yours to mend/);
    const found = await judge(chapter, text, { views: viewsOf(chapter).slice(0, 3) });
    const [first] = found.failed;
    t.diagnostic(`chapter ${chapter}: ${first?.says ?? found.why?.says}`);
    assert.ok(first || found.least < kLeast, `the start of chapter ${chapter} has no fault`);
    // What the chapter does not ask for is right.
    const yours = states.newIn(chapter).filter(({ isYours }) => isYours);
    assert.ok(yours.length > 0);
    for (const { name, where, what, lines } of yours) {
      assert.ok(where.includes(name) && what.length > 20 && lines.includes(name), name);
      const right = states.functionText(chapter, name);
      assert.notEqual(functionsOf(text).find((each) => each.name === name).text, right);
    }
  }
});

test('every fault is found', async (t) => {
  for (const [name, { chapter, says }] of Object.entries(faults)) {
    assert.match(says, /\.$/);
    const found = await judge(chapter, faultyText(states, name));
    const share = `${(100 * found.least).toFixed(2)} % equal`;
    t.diagnostic(`${name}: ${share}; ${found.failed[0]?.says ?? found.why?.says}`);
    assert.ok(found.failed.length > 0 || found.least < kLeast, `${name} is not found: ${share}`);
  }
});

test('a program with a fault is a module that exports draw', async () => {
  const text = asModule(faultyText(states, 'mirrored', 12));
  const module = await import(`data:text/javascript,${encodeURIComponent(text)}`);
  assert.equal(typeof module.draw, 'function');
  assert.throws(() => faultyText(states, 'no-detail', 6), /does not occur once/);
  assert.throws(() => faultyText(states, 'nothing'), /no fault/);
});

test('a program that throws, or lacks a function, is told so', async () => {
  const scene = await sceneNamed('yard-1.json');
  lookAt(scene, walking[0], { chapter: 4, size: kSmall });
  const expected = expectedOf(scene, 4);
  const functions = program(states.answer(4));
  functions.rowOf = () => {
    throw new Error('x is not defined');
  };
  delete functions.slopeOf;
  functions.rayOf = () => undefined;
  functions.walkGrid = () => null;
  const failed = check(4, functions, expected, scene.world).filter(({ ok }) => !ok);
  const says = Object.fromEntries(failed.map((each) => [each.name, each.says]));
  assert.equal(says.rowOf, '`rowOf` stops with "x is not defined".');
  assert.equal(says.slopeOf, '`slopeOf` is not there.');
  assert.match(says.rayOf, /^`rayOf`, column \d+, x: yours nothing, engine -?[\d.]+$/);
  assert.match(says.walkGrid, /^`walkGrid`, column \d+, tile 0 of the way: yours nothing, engine /);
});

test('a mirror is checked: its eye, its rows, and what is below it', async () => {
  const scene = await sceneNamed('yard-7.json');
  lookAt(scene, heights[0], { chapter: 18, size: kSmall });
  const expected = expectedOf(scene, 18);
  const failing = (text) =>
    check(18, program(text), expected, scene.world)
      .filter(({ ok }) => !ok)
      .map(({ says }) => says);
  assert.match(failing(states.start(18)).join('\n'), /^`reflect`, where the mirror shows a wall: /);
  for (const [find, put] of [
    [', lowest: height };', ' };'],
    ['2 * height - eye.z', 'eye.z'],
    ['up: -view.up', 'up: view.up'],
    ['part.first = Math.max(slice.first, Math.round(Math.min(from, to)));', ''],
    ['part.last = Math.min(slice.last, Math.round(Math.max(from, to)));', ''],
  ]) {
    const text = states.answer(18).replace(find, put);
    assert.notEqual(text, states.answer(18));
    assert.match(failing(text).join('\n'), /^`reflect`, /, find);
  }
});

test('a check finds what no pixel of the view shows', async () => {
  for (const [chapter, sceneName, name, find, put] of [
    [13, 'yard-2.json', 'planesOf', 'faces.bottom, under: true }', 'faces.bottom }'],
    [15, 'yard-4.json', 'objectsOf', '.sort((a, b) => a.depth - b.depth)', ''],
    [15, 'yard-4.json', 'objectsOf', 'if (depth > 0 && u', 'if (u'],
    [19, 'yard.json', 'eyeBeyond', ' + to.level - level }', ' }'],
    [
      22,
      'corner.json',
      'walkGrid',
      ': eye.x - tile.x) / Math.abs(ray.x)',
      ': tile.x - eye.x) / ray.x',
    ],
  ]) {
    const scene = await sceneNamed(sceneName);
    lookAt(scene, heights[0], { chapter, size: kSmall });
    const text = states.answer(chapter).replace(find, put);
    assert.notEqual(text, states.answer(chapter), find);
    const failed = check(chapter, program(text), expectedOf(scene, chapter), scene.world);
    const says = failed.filter(({ ok }) => !ok).map((each) => each.says);
    assert.match(says.join('\n'), new RegExp(`^\`${name}\`, `), find);
  }
});

test('what is right in another way passes', async () => {
  const scene = await sceneNamed('yard-4.json');
  for (const place of [heights[0], flying[0]]) {
    lookAt(scene, place, { chapter: 15, size: kSmall });
    const text = states
      .answer(15)
      .replace(
        'Math.round((x * forward.x + y * forward.y) * 65536) / 65536',
        'x * forward.x + y * forward.y',
      )
      .replace('planes.push({ height: top,', 'if (top < eye.z) planes.push({ height: top,')
      .replace(
        'planes.push({ height: bottom,',
        'if (bottom > eye.z) planes.push({ height: bottom,',
      );
    assert.notEqual(text, states.answer(15));
    const failed = check(15, program(text), expectedOf(scene, 15), scene.world);
    assert.deepEqual(
      failed.filter(({ ok }) => !ok),
      [],
    );
  }
});

test('every state is laid out as the rest of the code', async () => {
  const layout = { ...(await resolveConfig(`${root}/web/x.js`)), parser: 'babel' };
  for (const chapter of chapters) {
    assert.ok(await isLaidOut(states.answer(chapter), layout), `the answer of chapter ${chapter}`);
    assert.ok(await isLaidOut(states.start(chapter), layout), `the start of chapter ${chapter}`);
  }
});

test('the engine draws what the options of a chapter say', () => {
  assert.deepEqual(engineOptions(5), { textures: false, detail: false, light: false, fog: false });
  assert.deepEqual(engineOptions(22), { textures: true, detail: true, light: true, fog: true });
});

// ---- the last state, in many views

const around = [0, 52.5, 97, 143, 188, 233, 301].map((heading, i) =>
  view(2.3 + i * 1.7, [6.6, 4.4, 3.2, 5.8, 4.5, 6.3, 2.4][i] ?? 5, 0.5, heading, 0.04 * (i - 3)),
);
const above = [
  ...[15, 80, 160, 250, 320].map((heading, i) =>
    view(3.1 + 2.3 * i, 2.7 + 0.9 * i, 1.7 + 0.6 * i, heading, -0.1 - 0.12 * i),
  ),
  view(1.4, 7.6, 4.2, 310, -0.5),
  view(14.7, 1.3, 3.3, 150, -0.45),
];
const portals = [
  ...[view(13.4, 3.4, 0.5, 2), view(12.2, 3.9, 0.5, 350), view(14.3, 3.2, 0.6, 340, -0.1)],
  ...[view(7.3, 6.2, 0.5, 92), view(8.1, 7.2, 0.5, 130), view(6.5, 5.4, 0.5, 75, -0.1)],
  ...[view(2.6, 4.9, 0.6, 265), view(3.3, 4.2, 0.5, 245), view(2.2, 3.6, 0.5, 285, -0.15)],
  ...[view(3.5, 4.2, 0.5, 178, 0, 'hall'), view(10.5, 4.6, 0.5, 5, 0, 'hall')],
  ...[view(6.4, 3.1, 0.5, 271, 0, 'hall'), view(8.5, 2.3, 1.4, 200, -0.3, 'hall')],
];
const halls = [20, 75, 140, 215, 262, 333].map((heading, i) =>
  view(1.7 + 1.9 * i, 2.5 + ((i * 2.7) % 5), 0.4 + 0.25 * i, heading, 0.15 - 0.1 * i, 'hall'),
);
const whole = [...around, ...above, ...portals, ...halls, ...heights, ...flying, ...inside];
const wet = [...heights, ...flying, ...inside, ...looking, view(11.3, 4.4, 0.5, 330, -0.3)];

test('the last state agrees with the engine in every view', async (t) => {
  const functions = program(states.answer(22));
  const list = [
    ...whole.map((place) => ['yard.json', place]),
    ...wet.map((place) => ['yard-7.json', place]),
  ];
  let [sum, least, milliseconds] = [0, 1, 0];
  let worst = null;
  for (const [name, place] of list) {
    const scene = await sceneNamed(name);
    const { eye, picture } = lookAt(scene, place, { size: kSize, fov: 66 });
    const begin = performance.now();
    const mine = drawn(functions, scene.world, eye, kSize);
    milliseconds += performance.now() - begin;
    const { share } = difference(mine, picture);
    sum += share;
    if (share < least) [least, worst] = [share, [name, place]];
    assert.ok(share >= kLeast, `${name} ${JSON.stringify(place)}: ${(100 * share).toFixed(3)} %`);
  }
  assert.ok(list.length >= 40);
  t.diagnostic(
    `${list.length} views of 480x300: ${((100 * sum) / list.length).toFixed(4)} % equal, worst ` +
      `${(100 * least).toFixed(4)} % at ${JSON.stringify(worst)}; ` +
      `${(milliseconds / list.length).toFixed(0)} ms a picture`,
  );
});

// raycaster.cpp, which is built with the other native programs.
function drawnNatively(world, views) {
  const folder = mkdtempSync(join(tmpdir(), 'slicecast-raycaster-'));
  try {
    const file = join(folder, 'world');
    writeFileSync(file, Buffer.from(worldNumbers(world, views).buffer));
    const options = { maxBuffer: 1e9 };
    const bytes = execFileSync(join(root, 'build/native/tests/raycaster'), [file], options);
    let start = 0;
    return views.map(({ width, height }) => {
      const data = bytes.subarray(start, start + 4 * width * height);
      start += 4 * width * height;
      return { width, height, data };
    });
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('it also draws what the tutorial does not show', async () => {
  const functions = program(states.answer(22));
  const scene = await openScene('panes.json', join(root, 'tests/learn/scenes'));
  assert.deepEqual(scene.world.leftOut, []);
  const places = [
    ...[5, 61, 118, 171, 236, 292, 349].map((heading) => view(4.4, 3.6, 0.5, heading)),
    ...[view(2.4, 2.3, 0.5, 40), view(6.6, 2.4, 0.5, 190), view(5.3, 4.6, 0.3, 100)],
    ...[view(4.6, 4.4, 1.4, 93, -0.1), view(4.9, 5.2, 1.5, 100), view(3.4, 4.4, 0.5, 182)],
    ...[view(4.4, 6.6, 0.9, 215, -0.35), view(5.5, 6.2, 1.3, 190, -0.3)],
    ...[
      view(5.1, 1.2, 3.2, 80, -0.6),
      view(8.4, 6.5, 2.5, 200, -0.5),
      view(1.2, 7.2, 2.9, 300, -0.4),
    ],
  ];
  const seen = places.map((place) => lookAt(scene, place, { size: kSmall, fov: 75 }));
  const natively = drawnNatively(
    scene.world,
    seen.map(({ eye }) => ({ eye, ...kSmall })),
  );
  for (const [i, place] of places.entries()) {
    const { eye, picture } = seen[i];
    assert.ok(difference(natively[i], picture).share >= kLeast, `C++: ${JSON.stringify(place)}`);
    const { share } = difference(drawn(functions, scene.world, eye, kSmall), picture);
    assert.ok(share >= kLeast, `${JSON.stringify(place)}: ${(100 * share).toFixed(3)} %`);
  }
  // Panes that touch have no faces between them.
  const inner = program(faultyText(states, 'inner-panes', 22));
  const shares = seen.map(({ eye, picture }) =>
    difference(drawn(inner, scene.world, eye, kSmall), picture),
  );
  assert.ok(shares.some(({ share }) => share < kLeast));
});

test('the same program in C++ draws the same, and is short', async (t) => {
  const lines = readFileSync(join(root, 'web/learn/raycaster/raycaster.cpp'), 'utf8').split('\n');
  assert.ok(lines.length <= 401, `${lines.length} lines`);
  let least = 1;
  for (const [name, places] of [
    ['yard.json', whole],
    ['yard-7.json', wet],
  ]) {
    const scene = await sceneNamed(name);
    const seen = places.map((place) => lookAt(scene, place, { size: kSize }));
    const views = seen.map(({ eye }) => ({ eye, ...kSize }));
    drawnNatively(scene.world, views).forEach((mine, i) => {
      const { share } = difference(mine, seen[i].picture);
      least = Math.min(least, share);
      assert.ok(share >= kLeast, `${name} ${JSON.stringify(places[i])}: ${share}`);
    });
  }
  t.diagnostic(`worst view: ${(100 * least).toFixed(4)} % equal; ${lines.length - 1} lines`);
});

test('gates and lifts are where the engine has them', async (t) => {
  const scene = await sceneNamed('yard-6.json');
  const { engine, world } = scene;
  const functions = program(states.answer(17));
  for (const steps of [120, 300, 300, 240]) {
    engine.step(steps);
    world.seconds += steps / 120;
    for (const place of [view(8.2, 4.5, 0.5, 1), view(11.5, 6.4, 0.6, 4), inside[0]]) {
      const { eye, picture } = lookAt(scene, place, { chapter: 17, size: kSmall });
      const { share } = difference(drawn(functions, world, eye, kSmall), picture);
      t.diagnostic(`${world.seconds} s: ${(100 * share).toFixed(3)} %`);
      assert.ok(share >= kLeast, `${world.seconds} s, ${JSON.stringify(place)}: ${share}`);
    }
  }
  engine.reset();
  world.seconds = 0;
});
