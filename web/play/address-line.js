// The page's address and the element: what the one names, the other shows.
//
//     const address = new AddressLine(caster, options, slips);
//     address.open(scenes);             shows what the address names; scenes is a promise of scene-list.js's list; throws a Trouble
//     address.go('castle.json');        another scene of the list, in the address too
//     address.own(caster => ...);       a scene or a recording of the visitor's, which has no address
//     address.reference                 what names the scene that is shown, null for one of the visitor's

import { allowed } from '../engine/allowed.js';
import { Trouble } from '../engine/trouble.js';
import { referenceOf, sceneAddress, tourAddress } from './scene-list.js';

const kNamed = ['scene', 'tour', 'view']; // nothing is no name
const kTourName = /^[\w-]+$/;

export class AddressLine {
  #caster;
  #options;
  #slips;
  #files = []; // of the list
  #opens = 0;
  #shown = null; // what the address named, the last time

  constructor(caster, options, slips) {
    this.#caster = caster;
    this.#options = options;
    this.#slips = slips;
  }

  get parameters() {
    const parameters = new URLSearchParams(location.search);
    for (const name of kNamed) if (parameters.get(name) === '') parameters.delete(name);
    return parameters;
  }

  // Nothing in particular is asked for.
  get isPlain() {
    const asked = ['scene', 'tour', 'view', 'options', 'overlay'];
    return asked.every((name) => !this.parameters.has(name));
  }

  get isLive() {
    return this.parameters.get('live') === '1';
  }

  get reference() {
    if (this.#caster.source !== null) return null;
    const { address } = this.#caster;
    const reference = address === '' ? this.#named : referenceOf(address);
    return this.#listed(reference) ?? reference;
  }

  get #named() {
    return this.parameters.get('scene') ?? this.#files[0] ?? null;
  }

  #listed(reference) {
    return this.#files.find((file) => file === reference || file === `${reference}.json`);
  }

  async open(scenes) {
    const open = ++this.#opens;
    this.#slips.begin(new URLSearchParams(location.search));
    this.#options.take(this.parameters);
    const isNamed = this.parameters.has('scene') || this.parameters.has('tour');
    if (isNamed) this.#show();
    const list = await scenes.catch(() => []);
    this.#files = list.map(({ file }) => file);
    if (isNamed || open !== this.#opens) return;
    if (this.#named === null)
      throw new Trouble(
        'There is no scene to open',
        'The address names none, and the list of scenes could not be loaded.',
      );
    this.#show();
  }

  go(file) {
    ++this.#opens;
    history.pushState(null, '', this.of(file));
    this.#slips.begin(this.parameters);
    this.#options.take(this.parameters);
    this.#show();
  }

  // The page's address with that scene.
  of(file) {
    const wanted = new URLSearchParams({ scene: file.replace(/\.json$/, '') });
    const engine = this.parameters.get('engine');
    if (engine !== null) wanted.set('engine', engine);
    return `?${wanted}`;
  }

  own(show) {
    ++this.#opens;
    this.#slips.begin(new URLSearchParams());
    this.#shown = null;
    show(this.#caster);
    this.#begin();
  }

  #show() {
    const { parameters } = this;
    const tour = parameters.get('tour');
    const scene = tour === null ? this.#named : null;
    this.#caster.source = null;
    this.#set('engine', parameters.get('engine'));
    this.#set('scene', scene === null ? null : sceneIn(scene));
    this.#set('tour', tour === null ? null : tourIn(tour));
    this.#set('view', parameters.get('view'));
    // The same once more begins once more.
    if (location.search === this.#shown) this.#caster.reload();
    this.#shown = location.search;
    this.#begin();
  }

  #set(name, value) {
    if (value === null) this.#caster.removeAttribute(name);
    else this.#caster.setAttribute(name, value);
  }

  // At rest. Before the first one there was nothing to be loaded.
  #begin() {
    this.#caster.pause();
    this.#caster.loading = 'eager';
    this.#caster.hidden = false;
  }
}

// What is no address the element says itself.
function sceneIn(reference) {
  try {
    return sceneAddress(reference).href;
  } catch (error) {
    if (error instanceof Trouble) throw error; // not allowed here
    return reference;
  }
}

function tourIn(name) {
  if (kTourName.test(name)) return tourAddress(name).href;
  return allowed(new URL(name, document.baseURI)).href;
}
