// How a view and options are written in attributes and addresses, and read again.
//
//     view      x,y,z,heading[,look[,map]]     units, degrees (0 = east, 90 = south), screen heights; a map by its name, without one that of the start
//     options   name=value name=value ...      those of the engine; names and values hold no blanks

import { Trouble } from './trouble.js';

// {x, y, z, heading, look, map}; map is null where none is named. Throws a Trouble.
export function parseView(text) {
  const parts = text.split(',').map((part) => part.trim());
  const numbers = parts.slice(0, 5).map((part) => (part === '' ? NaN : Number(part)));
  if (parts.length < 4 || parts.length > 6 || !numbers.every(Number.isFinite)) {
    const expected = 'x,y,z,heading or x,y,z,heading,look or x,y,z,heading,look,map';
    throw new Trouble('The view cannot be read', `view: found "${text}", expected ${expected}`, [], 'address');
  }
  const [x, y, z, heading, look = 0] = numbers;
  return { x, y, z, heading, look, map: parts[5] || null };
}

// Of an engine's state; read again it is the same eye.
export function formatView({ x, y, z, heading, look, map = null }) {
  // Coordinates are whole numbers of 1/65536 unit; five decimals tell them apart.
  const numbers = [x, y, z, heading, look ?? 0].map((number) => String(Number(number.toFixed(5))));
  return [...numbers, ...(map === null ? [] : [map])].join(',');
}

// [[name, value]]. Throws a Trouble.
export function parseOptions(text) {
  return text.split(/\s+/).filter((part) => part !== '').map((part) => {
    const at = part.indexOf('=');
    if (at < 1) throw new Trouble('The options cannot be read', `options: found "${part}", expected name=value`, [], 'address');
    return [part.slice(0, at), part.slice(at + 1)];
  });
}

export function formatOptions(options) {
  return options.map(([name, value]) => `${name}=${value}`).join(' ');
}
