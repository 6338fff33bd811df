// Passes the engine's options to the element: those of the settings or, if the page's address has a
// view, options or overlays, those of the address. Such an address shows what somebody else saw, so
// options that it does not name get their standard values instead of the visitor's settings. The
// settings return with the next address that has none of these.
//
//     const options = new ViewOptions(caster, settings);
//     options.take(parameters);         of the address
//     options.set('fov', 90);           a setting
//     options.takeFromKeys();           updates the settings with changes by keys

import { formatOptions, parseOptions } from '../engine/address.js';

const kOverriding = ['view', 'options', 'overlay'];
const kFall = 1 / 65536; // units; without ground, a step falls by at least this

export class ViewOptions {
  #caster;
  #settings;
  #wanted = new Map();
  #isOverridden = false;
  #unread = ''; // options of the address that cannot be parsed; the element reports them
  #view = null; // of the address, until the scene is ready

  constructor(caster, settings) {
    this.#caster = caster;
    this.#settings = settings;
    caster.addEventListener('ready', () => this.#lookFrom());
  }

  take(parameters) {
    const overrides = kOverriding.some((name) => parameters.has(name));
    this.#view = parameters.get('view');
    this.#unread = '';
    if (overrides || this.#isOverridden) {
      const { optionList } = this.#caster;
      this.#wanted = new Map(optionList.map(({ name, standard }) => [name, standard]));
    }
    if (overrides) this.#override(parameters.get('options') ?? '');
    else {
      if (this.#isOverridden) this.#settings.takeBack();
      this.#wanted.set('wideFov', 'on'); // the window may have any shape
    }
    this.#isOverridden = overrides;
    this.#caster.overlay = parameters.get('overlay');
    this.#write();
  }

  #override(text) {
    this.#settings.lendStandard();
    try {
      for (const [name, value] of parseOptions(text)) {
        this.#settings.lend(name, value);
        this.#wanted.set(name, value);
      }
    } catch {
      this.#unread = text;
    }
  }

  set(name, value) {
    this.#wanted.set(name, typeof value === 'boolean' ? (value ? 'on' : 'off') : String(value));
    this.#write();
  }

  takeFromKeys() {
    for (const { name, value } of this.#caster.optionList) this.#settings.take(name, value);
  }

  #write() {
    this.#caster.options = `${formatOptions([...this.#wanted])} ${this.#unread}`.trim();
  }

  // A view from the air starts flying: one step shows whether there is ground below.
  #lookFrom() {
    const text = this.#view;
    this.#view = null;
    if (text === null) return;
    const caster = this.#caster;
    const before = caster.currentView;
    caster.step(1);
    const falls = caster.currentView.z < before.z - kFall;
    caster.look(before);
    if (falls) caster.flying = true;
  }
}
