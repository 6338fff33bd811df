// The names that a scene gives, and where they are used: of maps, textures, sprites, motions,
// blueprints and finds. A new name goes wherever the old one stood.
// Takes values and documents; gives lists and changes. Changes nothing itself.
//
//     namesOf(value, 'gates')                      // also 'maps', 'textures', ..., 'finds'
//     usesOf(value, 'sprites', 'oak')              // paths
//     tableOf(value, 'textures')                   // its own ones, and the shipped ones it names
//     namedChange(scene, path, value)              // {changes} to set that value, with all that
//                                                  // refers to it; or {words} if that cannot be
//     renameChange(scene, ['sprites', 'oak'], 'elm')     // the same for a key
//     keyed(path)                                  // whether the last key is such a name

import { shippedPicture } from './files/shipped.js';
import { findsOf, matchesOf } from './links.js';
import { valueAt } from './things.js';

const kMostLength = 100; // of a name, as the schema has it

// Where names stand that are given elsewhere. "*" is any name or number.
const kObjects = ['maps/*/objects/*', 'maps/*/objectRows/legend/*'];
const kMoves = [...kObjects, 'maps/*/sow/*'];
export const kReferences = Object.entries({
  maps: [
    'start/map',
    'game/at/map',
    'maps/*/portals/*/to/map',
    ...kMoves.map((place) => `${place}/motion/path/*/map`),
  ],
  textures: [
    'blueprints/*/faces',
    'blueprints/*/faces/*',
    'blueprints/*/faces/*/texture',
    'textures/*/variants/*',
    'maps/*/floor',
    'maps/*/floor/texture',
    'maps/*/floor/water',
    'maps/*/floor/legend/*',
    'maps/*/ceiling/texture',
    'maps/*/ceiling/legend/*',
    'maps/*/sow/*/textures',
    'maps/*/sow/*/textures/*',
  ],
  sprites: kMoves.flatMap((place) => [
    `${place}/sprite`,
    `${place}/motion/sprites/walk`,
    `${place}/motion/sprites/alert`,
  ]),
  motions: ['blueprints/*/motion'],
  blueprints: [
    'legend/*',
    'maps/*/legend/*',
    'blueprints/*/gate/follows',
    'blueprints/*/gate/follows/*',
    'maps/*/sow/*/on',
    'maps/*/sow/*/on/*',
  ],
  finds: [
    'blueprints/*/gate/needs',
    'game/needs',
    ...['maps/*/messages/*', ...kObjects.map((place) => `${place}/message`)].flatMap((message) => [
      `${message}/needs`,
      `${message}/unless`,
    ]),
  ].flatMap((names) => [names, `${names}/*`]),
  // Each map has its own.
  places: [
    'start/place',
    'game/at/place',
    'maps/*/portals/*/to/place',
    'maps/*/messages/*/place',
    ...kMoves.flatMap((place) => [`${place}/motion/path/*`, `${place}/motion/path/*/place`]),
  ],
}).flatMap(([what, patterns]) => patterns.map((pattern) => ({ what, pattern })));

// Where names are given as values; all others are keys.
export const kGiven = [
  { what: 'maps', pattern: 'maps/*/name' },
  ...kMoves.flatMap((place) => [
    { what: 'finds', pattern: `${place}/find` },
    { what: 'finds', pattern: `${place}/find/kind` },
  ]),
];
const kKeyed = { textures: 'texture', sprites: 'sprite', motions: 'motion', blueprints: 'block' };
const kFixed = { blueprints: 'floor' }; // what `on` says for the ground

export function namesOf(value, what) {
  if (what === 'maps') return value.maps.map(({ name }) => name);
  if (what === 'finds') return [...new Set(findsOf(value).map(({ text }) => text))];
  if (what === 'gates')
    return Object.entries(value.blueprints ?? {})
      .filter(([, { gate }]) => gate !== undefined)
      .map(([name]) => name);
  return Object.keys(value[what] ?? {});
}

export function usesOf(value, what, name) {
  return kReferences
    .filter((reference) => reference.what === what)
    .filter(({ pattern }) => !(kFixed[what] === name && /\/on(\/\*)?$/.test(pattern)))
    .flatMap(({ pattern }) => matchesOf(value, pattern))
    .filter(([path, found]) => found === name && path.at(-1) !== 'comment')
    .map(([path]) => path);
}

export function tableOf(value, what) {
  const used = kReferences
    .filter((reference) => reference.what === what)
    .flatMap(({ pattern }) => matchesOf(value, pattern))
    .filter(([path, name]) => typeof name === 'string' && path.at(-1) !== 'comment')
    .map(([, name]) => [name, shippedPicture(what, name)])
    .filter(([name, entry]) => entry !== undefined && !Object.hasOwn(value[what] ?? {}, name));
  return { ...value[what], ...Object.fromEntries(used) };
}

export const keyed = (path) => path.length === 2 && Object.hasOwn(kKeyed, path[0]);

export function namedChange(scene, path, value) {
  const plain = { changes: [{ path, value }] };
  if (value === undefined) return keyed(path) ? removal(scene, path) : plain;
  const given = kGiven.find(({ pattern }) => isMatch(path, pattern));
  const before = valueAt(scene.value, path);
  if (given === undefined || typeof value !== 'string' || typeof before !== 'string') return plain;
  if (before === value) return { changes: [] };
  const { what } = given;
  const isTaken = namesOf(scene.value, what).includes(value);
  if (what === 'maps' && isTaken)
    return { words: `Found another map with the name "${value}": each needs a name of its own.` };
  // Of several finds with one name, the others keep it.
  const isLast = findsOf(scene.value).filter(({ text }) => text === before).length === 1;
  return what === 'maps' || isLast ? carried(scene, what, before, value, { path, value }) : plain;
}

export function renameChange(scene, path, name) {
  const [what, before] = path;
  if (name === before) return { changes: [] };
  if (name === '' || name.length > kMostLength)
    return { words: `A name has 1 to ${kMostLength} characters: found ${name.length}.` };
  if (Object.hasOwn(scene.value[what], name))
    return { words: `Found another ${kKeyed[what]} with the name "${name}": choose another one.` };
  return carried(scene, what, before, name, { path, name });
}

// As one edit, however often the name is used.
function carried(scene, what, before, name, change) {
  const uses = usesOf(scene.value, what, before).map((path) => ({ path, value: name }));
  return { changes: [{ together: [change, ...uses] }] };
}

function removal(scene, path) {
  const [what, name] = path;
  const uses = usesOf(scene.value, what, name);
  if (uses.length === 0) return { changes: [{ path, value: undefined }] };
  const places = uses.length === 1 ? 'one place' : `${uses.length} places`;
  return {
    words: `The ${kKeyed[what]} "${name}" is used in ${places}, first in ${uses[0].join(' / ')}.`,
  };
}

function isMatch(path, pattern) {
  const parts = pattern.split('/');
  return (
    parts.length === path.length &&
    parts.every((part, index) => part === '*' || part === path[index])
  );
}
