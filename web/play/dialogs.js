// The page's dialogs. A button `open-NAME` or a key opens one; its close button, Escape or a press
// beside it closes it. Afterwards the game goes on if it ran before; otherwise what had the focus
// gets it back, which the browser does.
//
//     const dialogs = new Dialogs(caster);
//     dialogs.before('settings', act);       calls act() before opening
//     dialogs.opens('share', act);           calls act() to open it
//     dialogs.open('share');

import { ownKeys } from '../element/keyboard.js';
import { showFingers, showKeys } from './key-help.js';

// Listed after the engine's
const kPageKeys = [
  {
    keys: ['Z'],
    does: 'share this view',
    group: 'program',
    actions: [{ name: 'share', keys: [{ code: 'KeyZ', label: 'Z' }] }],
  },
];

const kNames = ['scenes', 'keys', 'settings', 'share', 'benchmark', 'slice'];

const find = (id) => document.getElementById(id);

export class Dialogs {
  #caster;
  #before = new Map();
  #opens = new Map();
  #playsOn = false;

  constructor(caster) {
    this.#caster = caster;
    for (const name of kNames) {
      this.#opens.set(name, () => find(name).showModal());
      find(`open-${name}`)?.addEventListener('click', () => this.open(name));
    }
    this.before('keys', () => {
      showFingers(find('fingers'), find('key-part'));
      this.showKeys();
    });
    for (const dialog of document.querySelectorAll('dialog')) {
      dialog.addEventListener('pointerdown', (event) => {
        if (event.target === dialog && !contains(dialog.getBoundingClientRect(), event))
          dialog.close();
      });
      dialog.addEventListener('close', () => this.#closed());
    }
    for (const button of document.querySelectorAll('[data-close]'))
      button.addEventListener('click', () => button.closest('dialog').close());
    find('keys').addEventListener('keydown', (event) => {
      if (event.code === 'KeyH') find('keys').close();
    });
  }

  showKeys() {
    const keys = ownKeys([...this.#caster.keyList, ...kPageKeys]);
    showKeys(find('key-tables'), find('key-table'), keys);
  }

  get isOpen() {
    return document.querySelector('dialog[open]') !== null;
  }

  before(name, act) {
    this.#before.set(name, act);
  }

  opens(name, act) {
    this.#opens.set(name, act);
  }

  open(name) {
    if (this.isOpen) return;
    this.#playsOn = this.#caster.entered;
    document.exitPointerLock?.();
    this.#before.get(name)?.();
    this.#opens.get(name)();
  }

  close() {
    document.querySelector('dialog[open]')?.close();
  }

  #closed() {
    if (this.#playsOn) this.#caster.enter();
    this.#playsOn = false;
  }
}

function contains(box, { clientX, clientY }) {
  return clientX >= box.left && clientX <= box.right && clientY >= box.top && clientY <= box.bottom;
}
