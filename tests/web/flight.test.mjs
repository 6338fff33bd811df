// The flight of the opening is smooth and closed, at an even pace, without jumps.

import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';

import { Flight } from '../../web/play/flight.js';
import { root } from '../wasm/load.mjs';

const kRate = 60; // views a second
const scenes = JSON.parse(readFileSync(join(root, 'assets/scenes/index.json'), 'utf8'));
const flown = scenes.filter(({ flight }) => flight !== undefined);

const turn = (from, to) => ((((to - from) % 360) + 540) % 360) - 180;
const between = (a, b) => Math.hypot(b.x - a.x, b.y - a.y, b.z - a.z);

test('the first scene of the list has a flight', () => {
  assert.ok(scenes[0].flight !== undefined);
});

for (const { file, flight } of flown) {
  test(`${file}: the flight is smooth, closed and slow`, () => {
    const way = new Flight(flight);
    assert.deepEqual(way.at(0), way.at(flight.seconds));
    let before = way.at(0);
    for (let i = 1; i <= flight.seconds * kRate; ++i) {
      const now = way.at(i / kRate);
      const moved = between(before, now) * kRate;
      const turned = Math.abs(turn(before.heading, now.heading)) * kRate;
      assert.ok(moved < 4, `${moved} units a second after ${i / kRate} s`);
      assert.ok(turned < 40, `${turned} degrees a second after ${i / kRate} s`);
      assert.ok(now.z > 0.3 && now.heading >= 0 && now.heading < 360);
      before = now;
    }
  });
}

test('a flight passes through its points, and turns the short way', () => {
  const points = [
    [0, 0, 1, 350, 0],
    [10, 0, 1, 10, 0],
    [10, 10, 1, 90, 0.2],
    [0, 10, 1, 270, 0],
  ];
  const way = new Flight({ seconds: 60, points });
  const near = points.map(([x, y]) => {
    let least = Infinity;
    for (let i = 0; i < 6000; ++i) {
      const view = way.at(i / 100);
      least = Math.min(least, Math.hypot(view.x - x, view.y - y));
    }
    return least;
  });
  for (const distance of near) assert.ok(distance < 0.02, `${distance}`);
  const headings = Array.from({ length: 800 }, (_, i) => way.at(i / 100).heading);
  assert.ok(headings.every((heading) => heading > 340 || heading < 20));
});
