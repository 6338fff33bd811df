// Shows an error in the element: its title and text, the scene's faults with their places, and a
// button to try again.
//
//     showMessage(section, detail, retry);      // a detail of faults.js's explain
//     hideMessage(section);

import { node } from './nodes.js';

// Errors that trying again cannot fix: the element's children are shown instead of a picture.
const kHopeless = ['no-webassembly', 'csp'];

export function showMessage(section, { code, title, message, faults }, retry) {
  const again = node('button', { class: 'again', part: 'button', type: 'button' }, 'Try again');
  again.addEventListener('click', retry);
  section.replaceChildren(
    node('h2', {}, title),
    node('p', {}, message),
    ...(faults.length > 0 ? [node('ul', {}, ...faults.map(faultItem))] : []),
    ...(kHopeless.includes(code) ? [node('p', {}, node('slot'))] : [again]),
  );
  const inside = [...section.getRootNode().host.childNodes];
  section
    .querySelector('slot')
    ?.assign?.(...inside.filter((one) => one instanceof Element || one instanceof Text));
  section.classList.toggle('hopeless', kHopeless.includes(code));
  section.setAttribute('role', 'alert');
  // Focusable, so that keys can scroll a long list.
  section.tabIndex = faults.length > 0 ? 0 : -1;
  section.hidden = false;
}

export function hideMessage(section) {
  section.hidden = true;
  section.removeAttribute('role');
  section.replaceChildren();
}

function faultItem({ place, pointer, row, character, found, expected }) {
  const inside = [
    pointer,
    row >= 0 ? `row ${row}` : '',
    character >= 0 ? `character ${character}` : '',
  ].filter((part) => part !== '' && part !== undefined);
  return node(
    'li',
    {},
    node('span', { class: 'place' }, place),
    ...(inside.length > 0 ? [' ', node('span', { class: 'inside' }, inside.join(', '))] : []),
    node('br'),
    node('span', { class: 'found' }, `Found ${found}`),
    `; expected ${expected}`,
  );
}
