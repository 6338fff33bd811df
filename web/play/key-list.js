// Finds the engine's keys by the names of actions (src/app/actions.h).

import { ownKeys } from '../element/keyboard.js';

const actionsOf = (caster) => ownKeys(caster.keyList).flatMap(({ actions }) => actions);

// The KeyboardEvent.codes of all keys of these actions.
export function codesOf(caster, names) {
  return actionsOf(caster)
    .filter(({ name }) => names.includes(name))
    .flatMap(({ keys }) => keys.map(({ code }) => code));
}

// The label of the action's first key, "?" if it has none.
export function labelOf(caster, name) {
  const action = actionsOf(caster).find((known) => known.name === name);
  return action?.keys[0]?.label ?? '?';
}
