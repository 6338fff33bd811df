// The kinds of blocks of a scene: blueprints and the characters that stand for them in a map.
// Takes a document; gives lists and changes. Changes nothing itself.
//
//     kindsOf(scene, 0)                        // [{sign, name, blueprint}], in the legend's order
//     kindOf(scene, 0, '#')                    // one of them, or null
//     const { sign, changes } = kindFor(scene, 0, 'low wall', { top: 0.5, faces: 'brick' });
//
// kindFor finds a kind that looks so already, or adds one: a character is chosen for it.

import { differences } from './differences.js';

export const kReserved = '. '; // empty, in all legends
const kCharacters =
  '#oxabcdefghijklmnpqrstuvwyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+*=~^%&@$!?/|:;<>()[]{}_-';

export function kindsOf(scene, map) {
  const { legend = {}, blueprints = {}, maps } = scene.value;
  const all = { ...legend, ...maps[map]?.legend };
  const signs = new Set([...scene.keys(['legend']), ...scene.keys(['maps', map, 'legend'])]);
  return [...signs]
    .map((sign) => [sign, all[sign]])
    .filter(([sign, name]) => !kReserved.includes(sign) && Object.hasOwn(blueprints, name))
    .map(([sign, name]) => ({ sign, name, blueprint: blueprints[name] }));
}

export function kindOf(scene, map, sign) {
  return kindsOf(scene, map).find((kind) => kind.sign === sign) ?? null;
}

export function kindFor(scene, map, name, blueprint) {
  const alike = kindsOf(scene, map).filter((kind) => isSame(kind.blueprint, blueprint));
  const known = alike.find((kind) => kind.name === name) ?? alike[0];
  if (known !== undefined) return { sign: known.sign, name: known.name, changes: [] };
  const { blueprints = {} } = scene.value;
  const same = [name, ...Object.keys(blueprints)].find(
    (other) => Object.hasOwn(blueprints, other) && isSame(blueprints[other], blueprint),
  );
  const chosen = same ?? freeName(name, blueprints);
  const sign = signFor(scene, chosen);
  return {
    sign,
    name: chosen,
    changes: [
      ...(same === undefined ? [{ path: ['blueprints', chosen], value: blueprint }] : []),
      { path: ['legend', sign], value: chosen },
    ],
  };
}

// The name itself, or with the first number that makes it new.
export function freeName(name, taken) {
  if (!Object.hasOwn(taken, name)) return name;
  for (let count = 2; ; ++count)
    if (!Object.hasOwn(taken, `${name} ${count}`)) return `${name} ${count}`;
}

// A character that no legend has.
function signFor(scene, name) {
  const legends = [scene.value, ...scene.value.maps].map(({ legend = {} }) => legend);
  return freeSign(
    name,
    legends.flatMap((legend) => Object.keys(legend)),
  );
}

// One that is not taken: a letter of the name if one is free.
export function freeSign(name, others) {
  const taken = new Set([...kReserved, ...others]);
  const letters = [...name].filter((letter) => /[a-z]/i.test(letter));
  for (const sign of [...letters, ...letters.map((letter) => letter.toUpperCase()), ...kCharacters])
    if (!taken.has(sign)) return sign;
  for (let code = 0xc0; ; ++code) {
    const sign = String.fromCodePoint(code);
    if (/\p{L}/u.test(sign) && !taken.has(sign)) return sign;
  }
}

// Notes do not count, nor does the order of keys.
export function isSame(one, other) {
  return one === other || knownCanonical(one) === knownCanonical(other);
}

const texts = new WeakMap(); // values of scenes are never changed in place

function knownCanonical(value) {
  if (typeof value !== 'object' || value === null) return canonical(value);
  if (!texts.has(value)) texts.set(value, canonical(value));
  return texts.get(value);
}

function canonical(value) {
  if (Array.isArray(value)) return `[${value.map(canonical)}]`;
  if (typeof value !== 'object' || value === null) return JSON.stringify(value);
  const keys = Object.keys(value)
    .filter((key) => key !== 'comment')
    .sort();
  return `{${keys.map((key) => `${JSON.stringify(key)}:${canonical(value[key])}`)}}`;
}

// What a scene will have after changes of its names, which are then made together.
export function draftOf(scene) {
  const value = { ...scene.value };
  return {
    value,
    keys: (path) => Object.keys(path.reduce((node, key) => node?.[key], value) ?? {}),
    take(changes) {
      for (const { path, value: entry } of changes)
        value[path[0]] = { ...value[path[0]], [path[1]]: entry };
    },
    changes: () => differences(scene.value, value, []),
  };
}
