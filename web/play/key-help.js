// The tables of keys, from the engine's own list of them.

// Two tables, side by side where there is room.
export function showKeys(box, template, keys) {
  const shown = keys.filter((line) => line.keys.length > 0);
  const half = Math.ceil(shown.length / 2);
  box.replaceChildren(
    ...[shown.slice(0, half), shown.slice(half)].map((part) => {
      const table = template.content.cloneNode(true);
      table.querySelector('tbody').append(...part.map(keyRow));
      return table;
    }),
  );
}

function keyRow({ keys: labels, does }) {
  const row = document.createElement('tr');
  const head = document.createElement('th');
  head.scope = 'row';
  head.append(
    ...labels.map((name) => {
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
