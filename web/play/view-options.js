// Passes the engine's options to the element: those of the settings or, if the page's address has a
// view, options or overlays, those of the address. Such an address shows what somebody else saw, so
// options that it does not name get their standard values instead of the visitor's settings. The
// settings return with the next address that has none of these.
//
//     const options = new ViewOptions(caster, settings);
//     options.take(parameters);         of the address
//     options.set('fov', 90);           a setting
//     options.takeFromKeys();           updates the settings with changes by keys

import { formatOptions, formatView, parseOptions, parseView } from '../engine/address.js';
import { isOfView } from './seen-options.js';

const kOverriding = ['view', 'options', 'overlay'];
const kJustAbove = 1 / 4096; // units: the eye must be above the floor
const kNear = 8; // units around a map

export class ViewOptions {
  #caster;
  #settings;
  #warn;
  #wanted = new Map();
  #isOverridden = false;
  #unread = ''; // options of the address that cannot be parsed; the element reports them
  #view = null; // of the address, until the scene is ready

  // `warn` gets a sentence about the address's view.
  constructor(caster, settings, warn) {
    this.#caster = caster;
    this.#settings = settings;
    this.#warn = warn;
    caster.addEventListener('ready', () => this.#lookFrom());
  }

  take(parameters) {
    const overrides = kOverriding.some((name) => parameters.has(name));
    this.#view = parameters.get('view');
    this.#unread = '';
    if (overrides || this.#isOverridden) {
      const { optionList } = this.#caster;
      const ofViews = optionList.filter(({ name }) => isOfView(name));
      this.#wanted = new Map(ofViews.map(({ name, standard }) => [name, standard]));
    }
    this.#wanted.set('wideFov', 'on'); // the window may have any shape
    if (overrides) this.#override(parameters.get('options') ?? '');
    else if (this.#isOverridden) this.#settings.takeBack();
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

  // Walks or flies as the view says; a view of old links, which does not, flies if the ground is
  // far below. Whoever walks where nobody has room, or flies far from the map, stands on the
  // nearest ground.
  #lookFrom() {
    const text = this.#view;
    const view = readable(text);
    this.#view = null;
    const caster = this.#caster;
    if (view === null) return;
    if (!caster.look(text) && !caster.look(formatView({ ...view, z: kJustAbove }))) return;
    if (view.flying && isNear(caster)) {
      caster.flying = true;
      return;
    }
    const landing = caster.land();
    if (landing === 'stands' || landing === 'falls')
      caster.flying = view.flying === undefined && landing === 'falls';
    else this.#tellMoved(view, landing);
  }

  #tellMoved({ x, y, z }, landing) {
    const { currentView } = this.#caster;
    const at = [currentView.x, currentView.y, currentView.z].map((number) => number.toFixed(1));
    this.#warn(
      `There is no room for the player at ${x}, ${y}, ${z}. ` +
        (landing === 'none'
          ? 'This map has no ground to stand on.'
          : `You stand on the nearest ground, at ${at.join(', ')}.`),
    );
  }
}

// Whether the eye is in its map, or as near that it sees the map from outside.
function isNear({ currentView: { map, x, y, z }, world }) {
  const { width, depth, levels } = world.maps.find(({ name }) => name === map);
  const isIn = (place, size) => place > -kNear && place < size + kNear;
  return isIn(x, width) && isIn(y, depth) && isIn(z, levels);
}

// Null without a view, or for one that the element reports.
function readable(text) {
  try {
    return text === null ? null : parseView(text);
  } catch {
    return null;
  }
}
