// The engine's options, as attributes of the element: those of the settings, or, where the page's
// address gives a view, options or overlays, those of the address. Such an address shows what
// somebody else saw: options that it does not name are at their standard, whatever the visitor's
// own settings are, and those come back with the next address that gives nothing.
//
//     const options = new ViewOptions(caster, settings);
//     options.take(parameters);         of the address
//     options.set('fov', 90);           a setting
//     options.takeFromKeys();           what keys have changed since, the settings show as it is

import { formatOptions, parseOptions } from '../engine/address.js';

const kGiving = ['view', 'options', 'overlay'];
const kFall = 1 / 65536; // units that a step without ground goes down, at least

export class ViewOptions {
  #caster;
  #settings;
  #wanted = new Map();
  #isGiven = false;
  #unread = ''; // of the address; what is wrong with it the element says
  #view = null; // of the address, until it was looked from

  constructor(caster, settings) {
    this.#caster = caster;
    this.#settings = settings;
    caster.addEventListener('ready', () => this.#lookFrom());
  }

  take(parameters) {
    const isGiven = kGiving.some((name) => parameters.has(name));
    this.#view = parameters.get('view');
    this.#unread = '';
    if (isGiven || this.#isGiven) {
      const { optionList } = this.#caster;
      this.#wanted = new Map(optionList.map(({ name, standard }) => [name, standard]));
    }
    if (isGiven) this.#give(parameters.get('options') ?? '');
    else if (this.#isGiven) this.#settings.takeBack();
    this.#isGiven = isGiven;
    this.#caster.overlay = parameters.get('overlay');
    this.#write();
  }

  #give(text) {
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

  // Who looked from the air goes on flying there: whether there is ground is known after a step.
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
