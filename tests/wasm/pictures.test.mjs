// An engine can use pixels that another one has decoded.

import assert from 'node:assert/strict';
import { test } from 'node:test';

import { Engine } from '../../build/web/engine/engine.js';
import { readEngine } from '../../build/web/node/engine-files.js';
import { openScene } from '../../build/web/node/scene-files.js';
import { flavours, roomScene, textureBytes } from './load.mjs';
import { png } from '../browser/png.mjs';

const kSize = [160, 100];

// Acts like a page's cache: the same bytes and the same pixels for all.
function openShared() {
  const files = new Map();
  const known = new Map();
  return {
    known,
    pictures: {
      get: (bytes) => known.get(bytes),
      keep: (bytes, pixels) => known.set(bytes, pixels.slice()),
    },
    open(name) {
      const source = openScene(name);
      return {
        ...source,
        pictures: this.pictures,
        async readFile(file) {
          if (!files.has(file)) files.set(file, await source.readFile(file));
          return files.get(file);
        },
      };
    },
  };
}

const openRoom = (bytes, pictures) => ({
  name: 'room.json',
  pictures,
  readText: async () => new TextEncoder().encode(roomScene()),
  readFile: async () => bytes,
});

async function played(flavour, source) {
  const engine = await Engine.create({ files: await readEngine(flavour) });
  return { faults: await engine.loadScene(source), engine };
}

function seen(engine) {
  return [0, 60, 120].map((steps) => {
    engine.step({ forward: 1, turn: 0.3 }, steps);
    return Buffer.from(engine.drawPixels(...kSize)).toString('base64');
  });
}

for (const flavour of flavours) {
  test(`${flavour}: a scene from pixels that others decoded is the same, byte by byte`, async () => {
    const shared = openShared();
    await played(flavour, shared.open('castle'));
    const ofCastle = new Set(shared.known.values());
    assert.ok(ofCastle.size > 30);
    for (const name of ['garden', 'harbour-town', 'wayhouse', 'castle']) {
      const { engine, faults } = await played(flavour, shared.open(name));
      assert.deepEqual(faults, []);
      const alone = await played(flavour, openScene(name));
      assert.deepEqual(seen(engine), seen(alone.engine), name);
    }
    // Nothing was decoded again.
    assert.ok([...ofCastle].every((pixels) => [...shared.known.values()].includes(pixels)));
  });

  test(`${flavour}: the pixels are those of the file, and are taken as they are`, async () => {
    const colour = [10, 20, 30];
    const bytes = png(16, () => colour);
    const kept = [];
    const pictures = { get: () => undefined, keep: (_, pixels) => kept.push([...pixels]) };
    const ofFile = await played(flavour, openRoom(bytes, pictures));
    assert.deepEqual(kept, [Array.from({ length: 256 }, () => [...colour, 255]).flat()]);

    const other = new Uint8Array(kept[0]).fill(200);
    const given = { get: () => other, keep: () => assert.fail('they are known') };
    const ofPixels = await played(flavour, openRoom(bytes, given));
    assert.deepEqual(ofPixels.faults, []);
    assert.notDeepEqual(seen(ofPixels.engine), seen(ofFile.engine));
  });

  test(`${flavour}: faults of pictures are reported as usual, and no pixels are kept`, async () => {
    const damaged = textureBytes.slice();
    damaged.fill(7, 60);
    for (const bytes of [damaged, new Uint8Array([1]), new Uint8Array()]) {
      const expected = (await played(flavour, openRoom(bytes))).faults;
      assert.equal(expected.length, 1);
      const pictures = {
        get: () => undefined,
        keep: () => assert.fail('there is nothing to keep'),
      };
      assert.deepEqual((await played(flavour, openRoom(bytes, pictures))).faults, expected);
    }
    // A picture, but no texture: it may be kept.
    const wrong = png(24, () => [1, 2, 3]);
    const { pictures, known } = openShared();
    const expected = (await played(flavour, openRoom(wrong))).faults;
    assert.match(expected[0].found, /24x24/);
    for (const count of [1, 1]) {
      assert.deepEqual((await played(flavour, openRoom(wrong, pictures))).faults, expected);
      assert.equal(known.size, count);
    }
    // Pixels for an unknown file are ignored.
    const given = { get: () => new Uint8Array(64).fill(9), keep: () => {} };
    const noPicture = (await played(flavour, openRoom(new Uint8Array([1])))).faults;
    assert.deepEqual(
      (await played(flavour, openRoom(new Uint8Array([1]), given))).faults,
      noPicture,
    );
  });
}
