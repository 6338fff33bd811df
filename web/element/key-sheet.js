// The keys, as a sheet over the picture: H opens it while somebody plays; H, Escape and its button
// close it.
//
//     const sheet = new KeySheet(section, {behind: [stage], closed() {...}});      // what lies behind cannot be reached while it is open
//     sheet.open(engine.keys);

import { splitKeys } from './key-names.js';
import { node } from './nodes.js';

export const kPlayPageKeys = ['T', 'I', 'F9']; // hits as text, frame rate, recording: an element has no place for them, and leaves them to the page

const kLeaving = { keys: 'Escape', does: 'leave the picture' };

export class KeySheet {
  constructor(section, { behind, closed }) {
    this.section = section;
    this.behind = behind;
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
    const here = [
      ...keys.filter((line) => !kPlayPageKeys.includes(line.keys) && line.keys !== kLeaving.keys),
      kLeaving,
    ];
    const close = node('button', { class: 'again', part: 'button', type: 'button' }, 'Close');
    close.addEventListener('click', () => this.close());
    this.section.replaceChildren(
      node('h2', { id: 'keys-title' }, 'Keys'),
      close,
      node(
        'dl',
        {},
        ...here.map(({ keys: names, does }) =>
          node(
            'div',
            {},
            node('dt', {}, ...splitKeys(names).map((name) => node('kbd', {}, name))),
            node('dd', {}, does),
          ),
        ),
      ),
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
