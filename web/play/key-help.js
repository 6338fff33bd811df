// The sheet of keys: what fingers do where there is a touch screen and no mouse, and the tables of
// keys, from the engine's own list of them.

import { icon } from '../element/icons.js';

// The device is steered by fingers, as far as it tells.
export const isTouch = () => matchMedia('(hover: none) and (pointer: coarse)').matches;

// What web/element/thumbs.js makes of them: [what one does, what it is for, icon of its button].
const kFingers = [
  ['Left thumb', 'walks from wherever you put it; far out it runs'],
  ['Right thumb', 'looks around as it is dragged'],
  ['Two taps on the right', 'jump, too'],
  ['Jump', 'jumps; rises when flying', 'jump'],
  ['Crouch', 'crouches; sinks when flying', 'crouch'],
  ['Fly', 'flies, or walks again', 'fly'],
  ['Gate', 'opens or closes the gates nearby; only where there are gates', 'use'],
  ['Cross', 'leaves the picture and brings the menu back', 'leave'],
];

// Where fingers steer, the keys are folded away below them.
export function showFingers(list, keyPart) {
  list.replaceChildren(
    ...kFingers.map(([finger, does, drawn]) => {
      const row = document.createElement('div');
      const name = document.createElement('dt');
      const text = document.createElement('dd');
      if (drawn !== undefined) name.append(icon(drawn));
      name.append(finger);
      text.textContent = does;
      row.append(name, text);
      return row;
    }),
  );
  keyPart.open = !isTouch();
}

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
