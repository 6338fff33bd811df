// Lets the visitor change keys in the sheet of keys. Changes are kept in the browser's storage and
// hold for every scene.
//
//     const editor = new KeyEditor(dialog, caster, showKeys);      showKeys() shows the plain sheet

import { kGroups, ownKeys } from '../element/keyboard.js';

const kStorageKey = 'slicecast.keys'; // {code: name of an action, or '' for none}

const kReserved = ['Escape', 'Tab', 'F5', 'F11', 'F12']; // used by the browser or to leave

export class KeyEditor {
  #dialog;
  #caster;
  #showKeys;
  #changed = readStorage();
  #waiting = null; // {name, does}: the action that the next key is for

  constructor(dialog, caster, showKeys) {
    this.#dialog = dialog;
    this.#caster = caster;
    this.#showKeys = showKeys;
    this.#find('change').addEventListener('click', () => this.#toggle());
    this.#find('standard').addEventListener('click', () => this.#backToStandard());
    dialog.addEventListener('close', () => this.#end());
    dialog.addEventListener('keydown', (event) => this.#take(event), { capture: true });
    caster.addEventListener('ready', () => this.#apply());
  }

  get #isOn() {
    return this.#dialog.classList.contains('changing');
  }

  #find(name) {
    return this.#dialog.querySelector(`[data-keys="${name}"]`);
  }

  // Each new engine starts with the standard keys.
  #apply() {
    for (const [code, action] of Object.entries(this.#changed)) {
      try {
        this.#caster.bindKey(code, action);
      } catch {
        delete this.#changed[code]; // from another version
      }
    }
  }

  #toggle() {
    if (this.#isOn) {
      this.#end();
      this.#showKeys();
      return;
    }
    this.#dialog.classList.add('changing');
    this.#find('change').textContent = 'Done';
    this.#show();
  }

  #end() {
    this.#waiting = null;
    this.#dialog.classList.remove('changing');
    this.#find('change').textContent = 'Change keys';
    this.#status('');
  }

  #show() {
    const actions = ownKeys(this.#caster.keyList).flatMap(({ group, actions: known }) =>
      known.map((action) => ({ ...action, group })),
    );
    const list = this.#find('list');
    list.replaceChildren(
      ...Object.entries(kGroups).flatMap(([group, title]) => [
        Object.assign(document.createElement('h3'), { textContent: title }),
        ...actions
          .filter((action) => action.group === group && action.name !== 'mouse')
          .map((action) => this.#row(action)),
      ]),
    );
  }

  #row({ name, does, keys }) {
    const row = document.createElement('div');
    row.className = 'key-row';
    const text = Object.assign(document.createElement('span'), { textContent: does });
    const buttons = keys.map(({ code, label }) => {
      const button = Object.assign(document.createElement('button'), {
        type: 'button',
        className: 'key',
        textContent: label,
        title: `Remove ${label}`,
      });
      button.setAttribute('aria-label', `${label}: remove from "${does}"`);
      button.addEventListener('click', () => this.#bind(code, ''));
      return button;
    });
    const add = Object.assign(document.createElement('button'), {
      type: 'button',
      className: 'quiet add',
      textContent: '+',
    });
    add.setAttribute('aria-label', `Add a key: ${does}`);
    add.dataset.action = name;
    add.addEventListener('click', () => {
      this.#waiting = { name, does };
      this.#status(`Press a key: ${does}. Escape cancels.`);
    });
    row.append(text, ...buttons, add);
    return row;
  }

  #take(event) {
    if (this.#waiting === null) return;
    event.preventDefault();
    event.stopPropagation();
    const { name, does } = this.#waiting;
    this.#waiting = null;
    if (event.code === 'Escape') this.#status('');
    else if (kReserved.includes(event.code)) this.#status(`${event.key} is reserved.`);
    else this.#bind(event.code, name, does);
  }

  #bind(code, name, does) {
    try {
      this.#caster.bindKey(code, name);
      this.#changed[code] = name;
      this.#keep();
      this.#show();
      this.#status(name === '' ? '' : `Done: ${does}.`);
      this.#dialog.querySelector(`[data-action="${name}"]`)?.focus();
    } catch (error) {
      this.#status(error.message);
    }
  }

  #backToStandard() {
    this.#changed = {};
    this.#keep();
    this.#caster.standardKeys();
    if (this.#isOn) this.#show();
    else this.#showKeys();
    this.#status('All keys are back to standard.');
  }

  #keep() {
    try {
      localStorage.setItem(kStorageKey, JSON.stringify(this.#changed));
    } catch {
      // Private windows store nothing.
    }
  }

  #status(text) {
    this.#dialog.querySelector('[role="status"]').textContent = text;
  }
}

function readStorage() {
  try {
    const stored = JSON.parse(localStorage.getItem(kStorageKey)) ?? {};
    return Object.fromEntries(
      Object.entries(stored).filter(([, action]) => typeof action === 'string'),
    );
  } catch {
    return {};
  }
}
