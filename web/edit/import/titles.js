// Titles and names for scenes, of the length that the engine takes, and unlike each other.
//
//     titleOf(properties, 'maps/old_town.tmx')        // its property "title", or "Old town"
//     const unlike = uniqueNames();
//     unlike('wall'), unlike('wall')                  // 'wall', 'wall 2'

import { kMostName, kMostTitle } from './import-limits.js';

// What no name needs, and what an editor or a terminal would show as nothing.
const kUnprinted = /[\p{C}\p{Zl}\p{Zp}]+/gu;

export function cleanName(text, most = kMostName) {
  const clean = String(text).replaceAll(kUnprinted, ' ').trim();
  return [...clean].slice(0, most).join('').trim();
}

export function titleOf(properties, file) {
  const own = properties.get('title') ?? properties.get('name');
  const name = file
    .split('/')
    .pop()
    .replace(/\.\w+$/, '')
    .replaceAll(/[-_]+/g, ' ');
  const title = cleanName(typeof own === 'string' && own !== '' ? own : name, kMostTitle);
  return title === '' ? 'A map' : title.replace(/^\p{Ll}/u, (letter) => letter.toUpperCase());
}

export function uniqueNames() {
  const taken = new Map(); // name -> how many had it
  return (wanted, fallback = 'thing') => {
    const base = cleanName(wanted, kMostName - 8) || fallback;
    let name = base;
    for (let count = taken.get(base) ?? 1; taken.has(name); name = `${base} ${count}`) {
      count += 1;
      taken.set(base, count);
    }
    taken.set(name, taken.get(name) ?? 1);
    return name;
  };
}
