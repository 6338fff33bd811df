// Custom properties of foreign maps: a list of { name, value } becomes a plain table, and a table
// becomes one line of text, for the comments of a scene. Names may be anything, also `constructor`.
//
//     const own = propertiesOf(layer.properties);     // Map
//     own.get('level')
//     commentOf('Chest', own)                         // 'Chest: gold=5, locked=true'

import { kMostNesting } from './import-limits.js';

const kMostText = 1000; // characters of one value

export function propertiesOf(list) {
  // Before Tiled 1.2 the list was a table.
  const entries = Array.isArray(list)
    ? list.map((one) => [one?.name, one?.value])
    : Object.entries(list ?? {});
  return new Map(entries.filter(([name]) => typeof name === 'string' && name !== ''));
}

export function commentOf(name, properties, except = []) {
  const told = [...properties]
    .filter(([key]) => !except.includes(key))
    .map(([key, value]) => `${key}=${textOf(value)}`)
    .join(', ');
  return [name, told].filter((part) => part !== '').join(': ');
}

export function textOf(value, depth = 0) {
  if (typeof value === 'string') return value.slice(0, kMostText);
  if (typeof value !== 'object' || value === null) return String(value);
  if (depth > kMostNesting) return '...';
  const parts = Array.isArray(value)
    ? value.map((one) => textOf(one, depth + 1))
    : Object.entries(value).map(([key, one]) => `${key}=${textOf(one, depth + 1)}`);
  return `{${parts.join(', ')}}`.slice(0, kMostText);
}

// A number of a property, or null: `top` may be 0.5, "0.5" or nothing.
export function numberOf(properties, name, least = -Infinity, most = Infinity) {
  const value = properties.get(name);
  if (value === undefined || value === '' || typeof value === 'boolean') return null;
  const number = Number(value);
  return Number.isFinite(number) ? Math.min(most, Math.max(least, number)) : null;
}

export function isTrue(properties, name) {
  const value = properties.get(name);
  return value === true || value === 'true' || (typeof value === 'number' && value !== 0);
}
