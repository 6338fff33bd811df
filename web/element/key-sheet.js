// A sheet over the picture that lists the keys. H opens it during play; H, Escape and its button
// close it.
//
//     const sheet = new KeySheet(section, {behind: [stage], closed() {...}});
//     sheet.open(engine.keys);
//
// The elements of `behind` are inert while the sheet is open.

import { keyGroups, ownKeys } from './keyboard.js';
import { node } from './nodes.js';

export class KeySheet {
  #codes = ['Escape']; // keys that close it

  constructor(section, { behind, closed }) {
    this.section = section;
    this.behind = behind;
    this.closed = closed;
    section.addEventListener('keydown', (event) => {
      if (!this.#codes.includes(event.code)) return;
      event.preventDefault();
      event.stopPropagation();
      this.close();
    });
  }

  // `keys` is the engine's list. Leaves out keys that only a whole page handles.
  open(keys) {
    const help = keys.flatMap(({ actions }) => actions).find(({ name }) => name === 'help');
    this.#codes = ['Escape', ...help.keys.map(({ code }) => code)];
    const here = ownKeys(keys.filter(({ scope }) => scope !== 'page'));
    const close = node('button', { class: 'again', part: 'button', type: 'button' }, 'Close');
    close.addEventListener('click', () => this.close());
    this.section.replaceChildren(
      node('h2', { id: 'keys-title' }, 'Keys'),
      close,
      ...keyGroups(here).flatMap(([title, lines]) => [
        node('h3', {}, title),
        node('dl', {}, ...lines.map(keyLine)),
      ]),
    );
    this.section.hidden = false;
    this.focus({ preventScroll: true });
    for (const place of this.behind) place.inert = true;
  }

  get isOpen() {
    return !this.section.hidden;
  }

  focus(options) {
    this.section.querySelector('button').focus(options);
  }

  close() {
    if (!this.isOpen) return;
    this.hide();
    this.closed();
  }

  hide() {
    for (const place of this.behind) place.inert = false;
    this.section.hidden = true;
    this.section.replaceChildren();
  }
}

function keyLine({ keys, does }) {
  return node(
    'div',
    {},
    node('dt', {}, ...keys.map((label) => node('kbd', {}, label))),
    node('dd', {}, does),
  );
}
