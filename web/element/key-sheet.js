// The keys, as a sheet over the picture: H opens it while somebody plays; H, Escape and its button close it.
//
//     const sheet = new KeySheet(section, {closed() {...}});
//     sheet.open(engine.keys);

import { splitKeys } from '../key-help.js';
import { node } from './nodes.js';

export class KeySheet {
  constructor(section, { closed }) {
    this.section = section;
    this.closed = closed;
    section.addEventListener('keydown', (event) => {
      if (event.code !== 'Escape' && event.code !== 'KeyH') return;
      event.preventDefault();
      event.stopPropagation();
      this.close();
    });
  }

  // [{keys, does}], as the engine lists them.
  open(keys) {
    const close = node('button', { class: 'again', part: 'button', type: 'button' }, 'Close');
    close.addEventListener('click', () => this.close());
    this.section.replaceChildren(
      node('h2', { id: 'keys-title' }, 'Keys'),
      close,
      node('dl', {}, ...keys.map(({ keys: names, does }) =>
        node('div', {}, node('dt', {}, ...splitKeys(names).map((name) => node('kbd', {}, name))), node('dd', {}, does)))));
    this.section.hidden = false;
    close.focus({ preventScroll: true });
  }

  close() {
    if (this.section.hidden) return;
    this.hide();
    this.closed();
  }

  hide() {
    this.section.hidden = true;
    this.section.replaceChildren();
  }
}
