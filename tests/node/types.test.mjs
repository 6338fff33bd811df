// The declarations made from the table compile strictly, refuse what is wrong, and describe what
// the engine really hands out.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { test } from 'node:test';
import Ajv from 'ajv';

import { load } from '../../build/web/node/index.js';
import { sceneOfRows } from '../../build/web/ray-caster-rows.js';
import { complaints } from './types.mjs';

const table = JSON.parse(
  await readFile(new URL('../../web/element/api.json', import.meta.url), 'utf8'),
);
const kSize = { width: 96, height: 60 };
const kScenes = ['wayhouse', 'water-palace', 'garden', 'glassworks']; // portals, mirrors, objects, see-through faces

test('a page that uses the element compiles', () => {
  assert.deepEqual(
    complaints(`
    import { apiVersion, errorCodes, RayCaster, type Cast, type FrameTrace, type Pick, type RayCasterAttributes, type SliceTrace, type View } from './ray-caster.js';
    const element = document.createElement('ray-caster');
    const version: 1 = apiVersion;
    const release: string = RayCaster.version;
    element.addEventListener('error', ({ detail }) => console.log(errorCodes[detail.code].remedy, detail.faults[0]?.place));
    element.addEventListener('click', ({ clientX }) => console.log(clientX));
    element.addEventListener('anything', () => {});
    const view: View | null = element.currentView;
    element.keys = 'move';
    element.step(2, { forward: 1, jump: true });
    element.look({ heading: 90 });
    const picture: Promise<Blob> = element.snapshot({ width: 320, height: 200 });
    const column: number | undefined = version > 1 ? 3 : undefined;
    const depths: (number | undefined)[] = element.hits({ first: 0, last: 9 }).map((hits) => hits?.hits[0]?.depth);
    const walks: number[] = element.trace([1, 2]).map((slice) => slice?.walk.length ?? 0);
    const ray: Cast = element.cast({ x: 1, y: 2, heading: 30 });
    const picked: Pick | null = element.pick(3, 4);
    const rows: string[] = element.cells(null, 0);
    const levels: string[][] = element.cells();
    element.setCell('room', 0, 1, 2, element.blueprints()[0]?.character ?? '.');
    console.log(depths, walks, ray.end.why, picked?.point?.[2], rows, levels, element.project(1, 2, 3)?.clientX, element.pixels().data);
    const trace: SliceTrace | FrameTrace | null = element.trace(column);
    const attributes: RayCasterAttributes = { scene: 'castle', controls: true, autoplay: true, loading: 'eager' };
    console.log(version, release, view, picture, element instanceof RayCaster, element.trace(3)?.walk, element.trace().totals, trace, attributes);`),
    [],
  );
});

test('a program under Node compiles', () => {
  assert.deepEqual(
    complaints(`
    import { load, SceneError } from './node/index.js';
    const scene = await load('castle', { engine: 'scalar' }).catch((error: SceneError) => { throw new Error(error.faults.join()); });
    scene.set('fov', 75);
    const bytes = await scene.png({ width: 32, height: 20 });
    const { data, width } = scene.pixels();
    const column: number | undefined = width > 3 ? 3 : undefined;
    console.log(scene.hits([3, 4], { width: 8, height: 8 })[0]?.hits, scene.pick(3, 4)?.what, scene.project(1, 2, 3, null, { width: 8, height: 8 })?.depth);
    console.log(scene.cast({ x: 1, y: 2, heading: 3 }).tiles, scene.cells('town', 1).join(), scene.blueprints('town').length);
    scene.setCell('town', 0, 1, 2, '#');
    console.log(scene.hits(3)?.hits, scene.trace(3)?.runs, scene.trace().columns, scene.trace(column)?.size, new ImageData(data, width), new Blob([bytes]));
    scene.free();
    export {};`),
    [],
  );
});

// Each line must be refused.
const kRefused = `
  <ray-caster scenes="castle" />,
  <ray-caster keys="some" />,
  <ray-caster onreadied={() => {}} />,
  <ray-caster onready={({ detail }) => detail.name} />,`;
const kTaken = `
  <ray-caster scene={castle} tour={tour} controls autoplay keys="move" id="castle" />,
  <ray-caster scene="castle" onready={({ detail }) => console.log(detail.title)}><p>A castle</p></ray-caster>,
  <ray-caster onerror={({ detail }) => console.log(detail.code, detail.faults[0]?.place)} />,
  <ray-caster onviewchange={(event) => console.log(event.detail.view.heading)} />,`;
const kOfSolid = `
  <ray-caster on:ready={({ detail }) => console.log(detail.title)} />,`;

for (const library of ['react', 'preact', 'solid']) {
  test(`JSX of ${library} knows attributes and events, and no others`, () => {
    const found = complaints(
      `import 'slicecast/${library}'; import castle, { tour } from 'slicecast/scenes/castle'; export const all = [${kRefused}${kTaken}${library === 'solid' ? kOfSolid : ''}];`,
      library,
    );
    assert.deepEqual(
      found.map((text) => /^test-lines\.tsx:(\d+)/.exec(text)?.[1] ?? text),
      ['2', '3', '4', '5'],
    );
  });
}

for (const [what, line] of [
  ['a value that an attribute does not take', "element.keys = 'some';"],
  ['a write to what is read-only', "element.state = 'idle';"],
  ['an input that there is not', 'element.step(1, { sideways: 1 });'],
  [
    'an attribute that there is not',
    "const attributes: import('./ray-caster.js').RayCasterAttributes = { scenes: 'castle' }; console.log(attributes, element);",
  ],
  [
    'a detail that an event does not have',
    "element.addEventListener('progress', ({ detail }) => detail.percent);",
  ],
]) {
  test(`the compiler refuses ${what}`, () => {
    assert.equal(
      complaints(
        `import './ray-caster.js'; const element = document.createElement('ray-caster');\n${line}`,
      ).length,
      1,
    );
  });
}

test('hits and traces of real scenes match their declarations', async () => {
  const lines = [
    "import type { Blueprint, Cast, FrameTrace, Hits, Pick, SliceTrace } from './shapes.js';",
  ];
  for (const name of kScenes) {
    const scene = await load(name);
    for (let column = 0; column < kSize.width; column += 16) {
      lines.push(
        `export const ${name.replace('-', '')}${column}: [Hits, SliceTrace] = [${JSON.stringify(scene.hits(column, kSize))}, ${JSON.stringify(scene.trace(column, kSize))}];`,
      );
    }
    const id = name.replace('-', '');
    const { x, y, z, heading } = scene.currentView;
    lines.push(
      `export const casts${id}: Cast[] = ${JSON.stringify([scene.cast({ x, y, heading }), scene.cast({ x, y, z, heading })])};`,
      `export const blueprints${id}: Blueprint[] = ${JSON.stringify(scene.blueprints())};`,
    );
    const rows = Array.from({ length: kSize.height }, (_, row) => scene.pick(48, row, kSize));
    lines.push(`export const picks${id}: (Pick | null)[] = ${JSON.stringify(rows)};`);
    lines.push(
      `export const ${name.replace('-', '')}: FrameTrace = ${JSON.stringify(scene.trace(undefined, kSize))};`,
    );
    scene.free();
  }
  assert.deepEqual(complaints(lines.join('\n')), []);
});

test('the manifest is valid', async () => {
  const schema = JSON.parse(
    await readFile(
      createRequire(import.meta.url).resolve('custom-elements-manifest/schema.json'),
      'utf8',
    ),
  );
  const manifest = JSON.parse(
    await readFile(new URL('../../build/web/custom-elements.json', import.meta.url), 'utf8'),
  );
  const ajv = new Ajv({ strict: false });
  assert.ok(ajv.validate(schema, manifest), ajv.errorsText());
});

test('plain rows may hold the characters of the table, and no others', () => {
  const listed = new Set(
    table.rows.flatMap(({ characters }) =>
      characters.split(' ').map((character) => (character === 'blank' ? ' ' : character)),
    ),
  );
  const starts = ['>', 'v', '<', '^'];
  for (let code = 32; code < 127; ++code) {
    const character = String.fromCharCode(code);
    const rows = starts.includes(character) ? character : `.${character}.>`;
    const isTaken = (() => {
      try {
        return sceneOfRows(rows) !== null;
      } catch {
        return false;
      }
    })();
    assert.equal(isTaken, listed.has(character), JSON.stringify(character));
  }
});
