// Shows in the element what the page's address names.
//
//     const address = new AddressLine(caster, options, problems);
//     await address.open(scenes);       shows the scene of the address; throws a Trouble; `scenes`
//                                       is a promise of the list of scene-list.js
//     address.go('castle.json');        another scene of the list; changes the address
//     address.own(caster => ...);       the visitor's own scene or recording, which has no address
//     address.reference                 the name of the current scene; null for the visitor's own

import { allowed } from '../engine/allowed.js';
import { Trouble } from '../engine/trouble.js';
import { referenceOf, sceneAddress, tourAddress } from './scene-list.js';

const kNamed = ['scene', 'tour', 'view']; // ignored when empty
const kTourName = /^[\w-]+$/;
const kLinked = '#world='; // of edit/files/world-link.js

export class AddressLine {
  #caster;
  #options;
  #problems;
  #files = []; // of the list
  #opens = 0;
  #shown = null; // the query that was shown last

  constructor(caster, options, problems) {
    this.#caster = caster;
    this.#options = options;
    this.#problems = problems;
  }

  get parameters() {
    const parameters = new URLSearchParams(location.search);
    for (const name of kNamed) if (parameters.get(name) === '') parameters.delete(name);
    return parameters;
  }

  // Whether the address names nothing in particular.
  get isPlain() {
    const asked = ['scene', 'tour', 'view', 'options', 'overlay'];
    return !isLinked() && asked.every((name) => !this.parameters.has(name));
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
    this.#problems.begin(new URLSearchParams(location.search));
    this.#options.take(this.parameters);
    const isNamed = !isLinked() && (this.parameters.has('scene') || this.parameters.has('tour'));
    if (isNamed) this.#show();
    const list = await scenes.catch(() => []);
    this.#files = list.map(({ file }) => file);
    if (isNamed || open !== this.#opens) return;
    if (isLinked()) {
      const world = await worldIn(location.hash);
      if (open === this.#opens) this.#show(world);
      return;
    }
    if (this.#named === null)
      throw new Trouble(
        'There is no scene to open',
        'The address names no scene, and the list of scenes could not be loaded.',
      );
    this.#show();
  }

  go(file) {
    ++this.#opens;
    history.pushState(null, '', this.of(file));
    this.#problems.begin(this.parameters);
    this.#options.take(this.parameters);
    this.#show();
  }

  // The query that opens that scene.
  of(file) {
    const wanted = new URLSearchParams({ scene: file.replace(/\.json$/, '') });
    const engine = this.parameters.get('engine');
    if (engine !== null) wanted.set('engine', engine);
    return `?${wanted}`;
  }

  own(show) {
    ++this.#opens;
    this.#problems.begin(new URLSearchParams());
    this.#shown = null;
    show(this.#caster);
    this.#begin();
  }

  // `source` is a world from a link.
  #show(source = null) {
    const { parameters } = this;
    const tour = source === null ? parameters.get('tour') : null;
    const scene = source === null && tour === null ? this.#named : null;
    this.#caster.source = source;
    this.#set('engine', parameters.get('engine'));
    this.#set('scene', scene === null ? null : sceneIn(scene));
    this.#set('tour', tour === null ? null : tourIn(tour));
    this.#set('view', parameters.get('view'));
    // The same address again: start the scene again.
    const shown = source === null ? location.search : null;
    if (shown !== null && shown === this.#shown) this.#caster.reload();
    this.#shown = shown;
    this.#begin();
  }

  #set(name, value) {
    if (value === null) this.#caster.removeAttribute(name);
    else this.#caster.setAttribute(name, value);
  }

  // Starts paused. The element is hidden until the first scene.
  #begin() {
    this.#caster.pause();
    this.#caster.loading = 'eager';
    this.#caster.hidden = false;
  }
}

const isLinked = () => location.hash.startsWith(kLinked);

async function worldIn(link) {
  const { linkedWorld } = await import('../edit/hand-over.js');
  try {
    return linkedWorld(link);
  } catch (error) {
    throw new Trouble('This link cannot be opened', error.message);
  }
}

// A malformed address is passed on: the element reports it.
function sceneIn(reference) {
  try {
    return sceneAddress(reference).href;
  } catch (error) {
    if (error instanceof Trouble) throw error; // not allowed on this page
    return reference;
  }
}

function tourIn(name) {
  if (kTourName.test(name)) return tourAddress(name).href;
  return allowed(new URL(name, document.baseURI)).href;
}
