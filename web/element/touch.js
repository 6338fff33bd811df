// Builds the elements of the touch controls (thumbs.js).
//
//     const layer = touchLayer();
//     const thumbs = new Thumbs(layer, actions);

import { icon } from './icons.js';
import { node } from './nodes.js';

const kButtons = [
  ['use', 'Gate'],
  ['fly', 'Fly'],
  ['crouch', 'Crouch'],
  ['jump', 'Jump'],
];

export function touchLayer() {
  return node(
    'div',
    { class: 'touch', 'aria-hidden': 'true' },
    node(
      'div',
      { class: 'zone', 'data-thumb': 'walk' },
      node('div', { class: 'stick', 'data-thumb': 'stick' }, node('div', { class: 'knob' })),
    ),
    node('div', { class: 'zone', 'data-thumb': 'look' }),
    node(
      'div',
      { class: 'buttons' },
      ...kButtons.map(([name, text]) =>
        node(
          'div',
          { class: 'thumb-button', 'data-thumb': name },
          icon(name),
          node('span', {}, text),
        ),
      ),
    ),
  );
}
