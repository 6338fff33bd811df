// Makes blocks gates and movers, and plain again.
// Takes a document; gives changes. Changes nothing itself.
//
//     gateAt(scene, map, cell)            // {name, changes}, or {words}; it keeps its looks
//     openedByFind(scene, name, object)   // changes: the gate needs what that object becomes
//     openedByGate(scene, name, other)    // changes: it opens with another gate
//     moverAt(scene, map, cell, point)    // {name, changes} or {words}: moves as far as that point
//     plainAt(scene, map, cell)           // changes: neither gate nor mover
//     plainKind(scene, name)

import { cellChanges } from './cells.js';
import { blueprintAt, groupsOf } from './links.js';
import { freeName, isSame, kindFor } from './kinds.js';
import { extentOf } from './shapes.js';
import { valueAt } from './things.js';

const kGate = { approach: 1.2, hold: 2 };
const kSpeed = 1; // of new movers, units per second

// A motion that looks so already, or a new one.
function motionFor(scene, wanted, motion) {
  const { motions = {} } = scene.value;
  const known = Object.keys(motions).find((name) => isSame(motions[name], motion));
  if (known !== undefined) return { motion: known, changes: [] };
  const name = freeName(wanted, motions);
  return { motion: name, changes: [{ path: ['motions', name], value: motion }] };
}

// The cell gets a kind of its own, which alone is changed.
function ownKind(scene, map, cell, name, blueprint, changes) {
  const kind = kindFor(scene, map, name, blueprint);
  const { level, x, y } = cell;
  return {
    name: kind.name,
    changes: [
      ...changes,
      ...kind.changes,
      ...cellChanges(scene, map, [{ layer: level, x, y, sign: kind.sign }]),
    ],
  };
}

export function gateAt(scene, map, cell) {
  const found = blueprintAt(scene.value, map, cell);
  if (found === null) return { words: 'Found no block there: click a block to make it a gate.' };
  const { name, blueprint } = found;
  if (blueprint.gate !== undefined) return { name, changes: [] };
  if (blueprint.water !== undefined) return { words: 'Found water: it cannot be a gate.' };
  if (blueprint.motion !== undefined)
    return { words: 'Found a block that moves already: right click makes it plain.' };
  const { low, high } = extentOf(blueprint);
  const isSlope = [blueprint.top, blueprint.bottom].some(Array.isArray);
  if (isSlope) return { words: 'Found a slope: choose a block with a level top as a gate.' };
  const made = sunkGate(scene, map, cell, found, high - low);
  // One above another opens as one: its top sinks below them all.
  const stack = stackOf(scene, map, cell, made.name);
  if (stack === 0) return made;
  const { motion, changes } = sinking(scene, high - low + stack);
  const path = ['blueprints', made.name, 'motion'];
  return { name: made.name, changes: [...made.changes, ...changes, { path, value: motion }] };
}

const sinking = (scene, height) =>
  motionFor(scene, 'into the ground', { moves: 'top', to: -Math.round(height * 100) / 100 });

function sunkGate(scene, map, cell, { name, blueprint }, height) {
  const { motion, changes } = sinking(scene, height);
  return ownKind(scene, map, cell, `${name} gate`, { ...blueprint, motion, gate: kGate }, changes);
}

// How many cells of that kind stand directly above and below.
function stackOf(scene, map, { level, x, y }, name) {
  let count = 0;
  for (const step of [1, -1])
    for (let at = level + step; ; at += step, ++count)
      if (blueprintAt(scene.value, map, { level: at, x, y })?.name !== name) break;
  return count;
}

export function openedByFind(scene, name, object) {
  const { sprite, find } = valueAt(scene.value, object);
  const kind = find?.kind ?? find ?? sprite;
  const needs = scene.value.blueprints[name].gate.needs;
  const names = typeof needs === 'number' || needs === undefined ? [] : [needs].flat();
  const isNeeded = names.includes(kind);
  const wanted = isNeeded ? names : [...names, kind];
  return [
    ...(find === undefined ? [{ path: [...object, 'find'], value: kind }] : []),
    ...(isNeeded
      ? []
      : [
          {
            path: ['blueprints', name, 'gate', 'needs'],
            value: wanted.length === 1 ? wanted[0] : wanted,
          },
        ]),
  ];
}

export function openedByGate(scene, name, other) {
  const { follows, approach } = scene.value.blueprints[name].gate;
  const names = [follows ?? []].flat();
  if (names.includes(other) || other === name) return [];
  const all = [...names, other];
  const gate = ['blueprints', name, 'gate'];
  return [
    { path: [...gate, 'follows'], value: all.length === 1 ? all[0] : all },
    // Else it would open by walking up, too.
    ...(approach === undefined ? [] : [{ path: [...gate, 'approach'], value: undefined }]),
  ];
}

export function moverAt(scene, map, cell, point) {
  const found = blueprintAt(scene.value, map, cell);
  if (found === null) return { words: 'Found no block there: click a block that is to move.' };
  const { blueprint } = found;
  if (blueprint.gate !== undefined) return { words: 'Found a gate: its motion is in its form.' };
  const { level, x, y } = cell;
  const far = [point[0] - x - 0.5, point[1] - y - 0.5, point[2] - level];
  const axis = far.reduce(
    (most, by, index) => (Math.abs(by) > Math.abs(far[most]) ? index : most),
    0,
  );
  const to = Math.round(far[axis]);
  if (to === 0) return { words: 'Too near: click at least one tile away.' };
  const motion = {
    ...(axis === 2 ? {} : { along: 'xy'[axis] }),
    moves: 'both',
    to,
    period: Math.max(2, (2 * Math.abs(to)) / kSpeed),
    shape: 'stop-and-go',
  };
  const { name, ...plain } = { ...blueprint, name: found.name };
  const wanted = `${name.replace(/ that moves( \d+)?$/, '')} that moves`;
  const made = motionFor(scene, wanted, motion);
  return ownKind(scene, map, cell, wanted, { ...plain, motion: made.motion }, made.changes);
}

// The whole of the gate or mover that has that cell.
export function plainAt(scene, map, cell) {
  const found = blueprintAt(scene.value, map, cell);
  if (found === null) return [];
  const has = ({ level, x, y }) => level === cell.level && x === cell.x && y === cell.y;
  return plainCells(scene, map, found.name, ({ cells }) => cells.some(has));
}

// All of that kind, in all maps.
export function plainKind(scene, name) {
  return scene.value.maps.flatMap((_, map) => plainCells(scene, map, name, () => true));
}

function plainCells(scene, map, name, isMeant) {
  const { gate, motion, ...plain } = scene.value.blueprints[name];
  if (gate === undefined && motion === undefined) return [];
  const stem = name.replace(/ (gate|that moves)( \d+)?$/, '');
  const kind = kindFor(scene, map, stem, plain);
  const cells = groupsOf(scene.value, map, name)
    .filter(isMeant)
    .flatMap((group) => group.cells)
    .map(({ level, x, y }) => ({ layer: level, x, y, sign: kind.sign }));
  return cells.length === 0 ? [] : [...kind.changes, ...cellChanges(scene, map, cells)];
}
