// The visitor's settings: shown in the settings dialog and kept in the browser's storage if
// allowed.
//
//     const settings = new Settings(form, (name, value) => ...);    // called for each change
//     settings.ranges(caster.optionList)    sets the sliders' ranges, once there is an engine
//     settings.value('fov')
//     settings.take('fov', '90');     a value as the engine writes it; ignores names of no setting
//     settings.lend('fov', '90')      the same, but not stored: until changed or taken back

import { fitSliders } from './slider.js';

const kStorageKey = 'slicecast.settings';

const kStandard = {
  size: 'auto', // 'auto', a share of the window's pixels as '50%', or 'WIDTHxHEIGHT'
  fov: 60, // degrees
  light: true,
  fog: true,
  lightPreset: 'map', // a time of day; 'map': each map's own
  mirrors: 1, // factor for the strength of all mirrors
  detail: true,
  rate: false, // whether to show the frame rate
  mouse: 1, // factor for the mouse's sensitivity
  invert: false, // whether moving the mouse forward looks down
  sound: true,
};

const kOfPage = ['size', 'rate', 'mouse', 'invert', 'sound']; // the others are options of the engine

const kShown = {
  fov: (value) => `${value}°`,
  mirrors: (value) => `${value.toFixed(1)} ×`,
  mouse: (value) => `${value.toFixed(1)} ×`,
};

export class Settings {
  #values;
  #lent = new Map();

  constructor(form, onChange) {
    this.form = form;
    this.onChange = onChange;
    this.#values = { ...kStandard, ...this.#readStorage() };
    for (const name of Object.keys(kStandard)) this.#show(name);
    form.addEventListener('input', (event) => {
      if (Object.hasOwn(kStandard, event.target.name))
        this.set(event.target.name, this.#read(event.target));
    });
  }

  // Resets stored values outside the ranges, for instance from another version.
  ranges(options) {
    fitSliders(this.form, options);
    for (const { name, kind, least, greatest } of options) {
      const value = this.#values[name];
      if (kind === 'number' && (value < least || value > greatest)) this.set(name, kStandard[name]);
      if (Object.hasOwn(kStandard, name)) this.#show(name);
    }
  }

  value(name) {
    return this.#lent.get(name) ?? this.#values[name];
  }

  get names() {
    return Object.keys(kStandard);
  }

  set(name, value) {
    if (this.value(name) === value) return;
    this.#lent.delete(name);
    this.#values[name] = value;
    this.#show(name);
    this.#writeStorage();
    this.onChange(name, value);
  }

  take(name, text) {
    const value = valueOf(name, text);
    if (value !== null) this.set(name, value);
  }

  lend(name, text) {
    const value = valueOf(name, text);
    if (value === null) return;
    this.#lent.set(name, value);
    this.#show(name);
    this.onChange(name, value);
  }

  // Lends the standard value of every setting.
  lendStandard() {
    for (const name of Object.keys(kStandard)) this.lend(name, written(kStandard[name]));
  }

  takeBack() {
    this.#lent.clear();
    for (const name of Object.keys(kStandard)) {
      this.#show(name);
      this.onChange(name, this.#values[name]);
    }
  }

  backToStandard() {
    this.#values = { ...kStandard };
    this.#writeStorage();
    this.takeBack();
  }

  #read(field) {
    if (field.type === 'checkbox') return field.checked;
    return field.type === 'range' ? Number(field.value) : field.value;
  }

  #show(name) {
    const field = this.form.elements[name];
    const value = this.value(name);
    if (field.type === 'checkbox') field.checked = value;
    else field.value = String(value);
    if (Object.hasOwn(kShown, name))
      this.form.querySelector(`output[for="${field.id}"]`).textContent = kShown[name](value);
  }

  // Accepts only values that the dialog itself could have set.
  #readStorage() {
    let stored;
    try {
      stored = JSON.parse(localStorage.getItem(kStorageKey)) ?? {};
    } catch {
      return {};
    }
    return Object.fromEntries(
      Object.entries(stored).filter(([name, value]) => {
        if (!Object.hasOwn(kStandard, name) || typeof value !== typeof kStandard[name])
          return false;
        const field = this.form.elements[name];
        if (field.type === 'range' && !kOfPage.includes(name)) return Number.isFinite(value);
        if (field.type === 'range') return value >= Number(field.min) && value <= Number(field.max);
        return (
          field.type === 'checkbox' || [...field.options].some((option) => option.value === value)
        );
      }),
    );
  }

  #writeStorage() {
    try {
      localStorage.setItem(kStorageKey, JSON.stringify(this.#values));
    } catch {
      // Private windows and full disks store nothing; the page works without.
    }
  }
}

const written = (value) => (typeof value === 'boolean' ? (value ? 'on' : 'off') : String(value));

// Reads an option's value as the engine writes it; null if it is not a setting or not valid.
function valueOf(name, text) {
  if (!Object.hasOwn(kStandard, name) || kOfPage.includes(name)) return null;
  if (typeof kStandard[name] === 'boolean') return text === 'on';
  if (typeof kStandard[name] === 'string') return text;
  return Number.isFinite(Number(text)) ? Number(text) : null;
}
