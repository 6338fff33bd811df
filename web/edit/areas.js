// New messages of tiles, and the goal of the game.
// Takes a document and tiles; gives changes. Changes nothing itself.
//
//     areaChanges(scene, 'message', 0, { x: 3, y: 4, width: 2 })    // {label, changes, edited}

import { mapNumber, startMap } from './links.js';

export function areaChanges(scene, kind, map, tiles) {
  const { value } = scene;
  if (kind === 'message') {
    const path = ['maps', map, 'messages', (value.maps[map].messages ?? []).length];
    const message = { text: 'Something to read.', ...tiles };
    return { label: 'Message', changes: [{ path, value: message }], edited: path };
  }
  const isStartMap = mapNumber(value, startMap(value)) === map;
  const at = { ...(isStartMap ? {} : { map: value.maps[map].name }), ...tiles };
  const change =
    value.game === undefined
      ? { path: ['game'], value: { aim: 'Find the way out.', at, message: 'You are out!' } }
      : { path: ['game', 'at'], value: at };
  return { label: 'Goal', changes: [change], edited: ['game'] };
}

// From a cell to another, in the format's words.
export function tilesOf({ from, to }) {
  return {
    x: from.x,
    y: from.y,
    ...(to.x === from.x ? {} : { width: to.x - from.x + 1 }),
    ...(to.y === from.y ? {} : { depth: to.y - from.y + 1 }),
    ...(from.level === 0 ? {} : { bottom: from.level }),
  };
}
