// The tables of keys, from the engine's own list of them.

import { splitKeys } from '../element/key-names.js';

// Two tables, side by side where there is room.
export function showKeys(box, template, keys) {
  const half = Math.ceil(keys.length / 2);
  box.replaceChildren(
    ...[keys.slice(0, half), keys.slice(half)].map((part) => {
      const table = template.content.cloneNode(true);
      table.querySelector('tbody').append(...part.map(keyRow));
      return table;
    }),
  );
}

function keyRow({ keys: names, does }) {
  const row = document.createElement('tr');
  const head = document.createElement('th');
  head.scope = 'row';
  head.append(
    ...splitKeys(names).map((name) => {
      const key = document.createElement('kbd');
      key.textContent = name;
      return key;
    }),
  );
  const text = document.createElement('td');
  text.textContent = does;
  row.append(head, text);
  return row;
}
