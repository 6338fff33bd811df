// The sheet of keys: what fingers do on a touch screen, and tables of the engine's keys.

import { icon } from '../element/icons.js';
import { keyGroups } from '../element/keyboard.js';

// Whether the device seems to have a touch screen and no mouse.
export const isTouch = () => matchMedia('(hover: none) and (pointer: coarse)').matches;

// As in web/element/thumbs.js: [gesture or button, effect, icon of the button].
const kFingers = [
  ['Left thumb', 'walks from wherever you put it; farther out it runs'],
  ['Right thumb', 'drags to look around'],
  ['Two taps on the right', 'also jump'],
  ['Jump', 'jumps; rises when flying', 'jump'],
  ['Crouch', 'crouches; sinks when flying', 'crouch'],
  ['Fly', 'flies, or walks again', 'fly'],
  ['Gate', 'opens or closes the gates nearby; only where there are gates', 'use'],
  ['Cross', 'leaves the picture and shows the menu', 'leave'],
];

// On touch screens the keys are folded away below.
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

// Fills a table for each group of keys.
export function showKeys(box, template, keys) {
  box.replaceChildren(
    ...keyGroups(keys).map(([title, lines]) => {
      const table = template.content.cloneNode(true);
      table.querySelector('caption').textContent = title;
      table.querySelector('tbody').append(...lines.map(keyRow));
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
