// Keeps the world in the browser after each change, so that closing the page loses nothing.
// Takes a name and worlds as in world-store.js; says how it went.
//
//     const kept = new Autosave('castle');
//     await kept.read()                          // {text, pictures, base, savedAt} or null
//     kept.keep(text, pictures, base);           // soon; the last one counts
//     await kept.write();                        // at once what is to be kept
//     kept.listen((what) => ...)                 // 'kept', 'failed'
//     await kept.forget();

import { forgetWorld, readWorld, writeWorld } from './world-store.js';

const kDelay = 400; // milliseconds

export class Autosave {
  #name;
  #timer = 0;
  #world = null; // to be kept
  #listeners = [];

  constructor(name) {
    this.#name = name;
    addEventListener('pagehide', () => this.write());
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  read() {
    return readWorld(this.#name);
  }

  keep(text, pictures, base) {
    this.#world = { text, pictures, base };
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.write(), kDelay);
  }

  async forget() {
    clearTimeout(this.#timer);
    this.#world = null;
    await forgetWorld(this.#name);
  }

  async write() {
    clearTimeout(this.#timer);
    const world = this.#world;
    if (world === null) return;
    this.#world = null;
    try {
      await writeWorld(this.#name, world);
      this.#tell('kept');
    } catch {
      this.#tell('failed');
    }
  }

  #tell(what) {
    for (const listener of this.#listeners) listener(what);
  }
}
