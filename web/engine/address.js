// Reads and writes views and options as attributes and addresses spell them.
//
//     view      [walk,|fly,]x,y,z,heading[,look[,map]]
//               units; degrees (0 = east, 90 = south); look in screen heights; a map's name, which
//               may hold commas. Without a name: the map of the start. The word before it says
//               whether the player walks or swims, or flies.
//     options   name=value name=value ...
//               the engine's options; names and values hold neither blanks nor commas
//     overlay   minimap grid ...
//               options to switch on that draw over the picture

import { unknown } from './nearest-name.js';
import { Trouble } from './trouble.js';

export const kOverlays = [
  'minimap',
  'minimapRays',
  'minimapTurns',
  'playerPanel',
  'processPanel',
  'inspector',
  'grid',
  'slow',
];

// Other spellings of on and off; a name alone switches on.
const kSwitches = { '': 'on', true: 'on', false: 'off' };

// The numbers of a view and the largest absolute value of each: coordinates as in
// src/base/coordinate.h, the look as in src/render/options.h.
const kViewLimits = { x: 32767, y: 32767, z: 32767, heading: Infinity, look: 4 };

// Returns {x, y, z, heading, look, map}, and {flying} if the view says so; map is null if none is
// named. Throws a Trouble.
export function parseView(text, standardLook = 0) {
  const [, mode, place] = /^(?:(walk|fly),)?([^]*)/.exec(text);
  const parts = place.split(',');
  const numbers = parts.slice(0, 5).map((part) => (part.trim() === '' ? NaN : Number(part)));
  if (parts.length < 4 || !numbers.every(Number.isFinite)) {
    throw misread(
      `view: found "${text}", expected x,y,z,heading or x,y,z,heading,look or x,y,z,heading,look,map`,
    );
  }
  Object.keys(kViewLimits).forEach(
    (name, index) => index < numbers.length && checkNumber('view', name, numbers[index]),
  );
  const [x, y, z, heading, look = standardLook] = numbers;
  const map = parts.slice(5).join(',').trim() || null;
  return { x, y, z, heading, look, map, ...(mode && { flying: mode === 'fly' }) };
}

// Reads what look() takes: a view as text, or an object with any of its fields. Fields that are
// null or undefined stay as they are. Throws a Trouble.
export function readView(view) {
  if (typeof view === 'string') return parseView(view, null);
  if (typeof view !== 'object' || view === null)
    throw misread(`look: found ${shown(view)}, expected a view`);
  for (const [name, value] of Object.entries(view)) {
    if ((value ?? null) === null) continue;
    if (Object.hasOwn(kViewLimits, name)) checkNumber('look', name, value);
    else if (name === 'flying') {
      if (typeof value !== 'boolean')
        throw misread(`look: found flying ${shown(value)}, expected true or false`);
    } else if (name !== 'map')
      throw misread(
        `look: found ${name} ${shown(value)}, expected a view with some of ${Object.keys(kViewLimits).join(', ')}, map, flying`,
      );
    else if (typeof value !== 'string')
      throw misread(`look: found map ${shown(value)}, expected the name of a map`);
  }
  return view;
}

function checkNumber(what, name, value) {
  const limit = kViewLimits[name];
  if (Number.isFinite(value) && Math.abs(value) <= limit) return;
  throw misread(
    `${what}: found ${name} ${shown(value)}, expected a number${limit === Infinity ? '' : ` from -${limit} to ${limit}`}`,
  );
}

// Some objects have no text.
function shown(value) {
  try {
    return `${value}`;
  } catch {
    return typeof value;
  }
}

function misread(message) {
  return new Trouble('The view cannot be read', message, [], 'address');
}

// Writes an engine's state; reading the text again gives exactly the same eye.
export function formatView({ x, y, z, heading, look, map = null, flying }) {
  const numbers = [
    ...[x, y, z].map(shortest),
    ...[heading, look ?? 0].map((number) => String(Number(number.toFixed(5)))),
  ];
  const mode = flying === undefined ? [] : [flying ? 'fly' : 'walk'];
  return [...mode, ...numbers, ...(map === null ? [] : [map])].join(',');
}

// Coordinates are multiples of 1/65536 unit. Writes the fewest decimals that tell this one from the
// next.
function shortest(coordinate) {
  const raw = (number) => Math.floor(65536 * number + 0.5);
  for (let decimals = 0; ; ++decimals) {
    const text = coordinate.toFixed(decimals);
    if (decimals === 5 || raw(Number(text)) === raw(coordinate)) return String(Number(text));
  }
}

// Returns [[name, value]]. Commas may separate options, and a name alone switches on. The engine
// itself refuses unknown names.
export function parseOptions(text) {
  return wordsOf(text.replace(/\s*[=:]\s*/g, '=')).map((part) => {
    const [, name, value] = /^([^=]+)=?(.*)$/.exec(part) ?? [null, part, ''];
    return [name, Object.hasOwn(kSwitches, value) ? kSwitches[value] : value];
  });
}

export function formatOptions(options) {
  return options.map(([name, value]) => `${name}=${value}`).join(' ');
}

// Returns [name]. Unknown names are left out and reported to `warn`.
export function parseOverlay(text, warn = refuse) {
  return wordsOf(text).filter((name) => {
    const isKnown = kOverlays.includes(name);
    if (!isKnown) warn(unknown('overlay', name, kOverlays));
    return isKnown;
  });
}

// Words are separated by blanks, commas or semicolons.
export function wordsOf(text) {
  return text.split(/[\s,;]+/).filter((word) => word !== '');
}

function refuse(message) {
  throw new Trouble('The address cannot be read', message, [], 'address');
}

// "?scene=castle&view=4.5,2,0.5,90": characters of views and options that a query may hold are not
// escaped. Leaves out values of null.
export function writeQuery(parameters) {
  const write = (text) =>
    encodeURIComponent(text).replace(/%(?:2C|3A|3D|2F|20)/g, (code) =>
      code === '%20' ? '+' : decodeURIComponent(code),
    );
  return `?${Object.entries(parameters)
    .filter(([, value]) => value !== null)
    .map(([name, value]) => `${name}=${write(value)}`)
    .join('&')}`;
}
