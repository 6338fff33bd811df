// How a view and options are written in attributes and addresses, and read again.
//
//     view      x,y,z,heading[,look[,map]]     units, degrees (0 = east, 90 = south), screen heights; a map by its name (commas too), without one that of the start
//     options   name=value name=value ...      those of the engine; names and values hold neither blanks nor commas
//     overlay   minimap grid ...               what is drawn over the picture: options that are switched on

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

// A switch as people write it; a name alone switches on.
const kSwitches = { '': 'on', true: 'on', false: 'off' };

// The numbers of a view, and how far each may be from 0: coordinates as in src/base/coordinate.h,
// the look as in src/render/options.h.
const kViewLimits = { x: 32767, y: 32767, z: 32767, heading: Infinity, look: 4 };

// {x, y, z, heading, look, map}; map is null where none is named. Throws a Trouble.
export function parseView(text, standardLook = 0) {
  const parts = text.split(',');
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
  return { x, y, z, heading, look, map: parts.slice(5).join(',').trim() || null };
}

// What look() takes: a view as text, or an object with any of its fields. null and undefined are
// what stays as it is. Throws a Trouble.
export function readView(view) {
  if (typeof view === 'string') return parseView(view, null);
  if (typeof view !== 'object' || view === null)
    throw misread(`look: found ${view}, expected a view`);
  for (const [name, value] of Object.entries(view)) {
    if ((value ?? null) === null) continue;
    if (Object.hasOwn(kViewLimits, name)) checkNumber('look', name, value);
    else if (name !== 'map')
      throw misread(
        `look: found ${name} ${value}, expected a view with some of ${Object.keys(kViewLimits).join(', ')}, map`,
      );
    else if (typeof value !== 'string')
      throw misread(`look: found map ${value}, expected the name of a map`);
  }
  return view;
}

function checkNumber(what, name, value) {
  const limit = kViewLimits[name];
  if (Number.isFinite(value) && Math.abs(value) <= limit) return;
  throw misread(
    `${what}: found ${name} ${value}, expected a number${limit === Infinity ? '' : ` from -${limit} to ${limit}`}`,
  );
}

function misread(message) {
  return new Trouble('The view cannot be read', message, [], 'address');
}

// Of an engine's state; read again it is the same eye.
export function formatView({ x, y, z, heading, look, map = null }) {
  const numbers = [
    ...[x, y, z].map(shortest),
    ...[heading, look ?? 0].map((number) => String(Number(number.toFixed(5)))),
  ];
  return [...numbers, ...(map === null ? [] : [map])].join(',');
}

// Coordinates are whole numbers of 1/65536 unit: the fewest decimals that tell one from the next.
function shortest(coordinate) {
  const raw = (number) => Math.floor(65536 * number + 0.5);
  for (let decimals = 0; ; ++decimals) {
    const text = coordinate.toFixed(decimals);
    if (decimals === 5 || raw(Number(text)) === raw(coordinate)) return String(Number(text));
  }
}

// [[name, value]]: commas may stand between options, and a name alone switches on. What the engine
// does not know, it refuses itself.
export function parseOptions(text) {
  return wordsOf(text.replace(/\s*[=:]\s*/g, '=')).map((part) => {
    const [, name, value] = /^([^=]+)=?(.*)$/.exec(part) ?? [null, part, ''];
    return [name, kSwitches[value] ?? value];
  });
}

export function formatOptions(options) {
  return options.map(([name, value]) => `${name}=${value}`).join(' ');
}

// [name]. What is unknown is told to `warn`, and left out.
export function parseOverlay(text, warn = refuse) {
  return wordsOf(text).filter((name) => {
    const isKnown = kOverlays.includes(name);
    if (!isKnown) warn(unknown('overlay', name, kOverlays));
    return isKnown;
  });
}

// Blanks, commas or semicolons stand between words.
export function wordsOf(text) {
  return text.split(/[\s,;]+/).filter((word) => word !== '');
}

function refuse(message) {
  throw new Trouble('The address cannot be read', message, [], 'address');
}

// "?scene=castle&view=4.5,2,0.5,90": the characters that views and options are made of stay as they
// are, which a query may hold. A value of null is left out.
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
