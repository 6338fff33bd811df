// Kinds of blocks that are turned: each gets a blueprint of its own, or finds one that looks so.
// Takes blueprints and motions; gives new ones and their names. Changes nothing in place.
//
//     turnedKinds(scene.value, ['west roof', 'wall'], kTurns.right)
//     // {blueprints, motions, names}: names.get('west roof') is 'north roof'

import { freeName, isSame } from './kinds.js';
import { turnedBlueprint, turnedMotion, turnedName } from './turning.js';

export function turnedKinds({ blueprints, motions = {} }, wanted, turn) {
  const names = new Map();
  const all = { blueprints: { ...blueprints }, motions: { ...motions } };
  const nameOf = (kind, name, value) => {
    const known = all[kind];
    if (isSame(known[name], value)) return name;
    const like = turnedName(name, turn);
    if (Object.hasOwn(known, like) && isSame(known[like], value)) return like;
    const same = Object.keys(known).find((other) => isSame(known[other], value));
    const chosen = same ?? freeName(like, known);
    known[chosen] = value;
    return chosen;
  };
  for (const name of new Set(wanted)) {
    const turned = turnedBlueprint(blueprints[name], turn);
    const motion = motions[turned.motion];
    const moved =
      motion === undefined
        ? turned
        : { ...turned, motion: nameOf('motions', turned.motion, turnedMotion(motion, turn)) };
    names.set(name, nameOf('blueprints', name, moved));
  }
  return { ...all, names };
}
