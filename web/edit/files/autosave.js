// Keeps the world in the browser after each change, so that closing the page loses nothing.
// Takes a name and worlds as in world-store.js; says how it went.
//
//     const kept = new Autosave('castle');
//     await kept.read()                          // {text, pictures, base, savedAt} or null
//     kept.keep(() => world);                    // soon, as it is then; null: not now
//     await kept.write();                        // at once what is to be kept
//     kept.listen((what) => ...)                 // 'kept', 'failed'
//     await kept.forget();

import { forgetWorld, readWorld, writeWorld } from './world-store.js';

const kDelay = 400; // milliseconds

export class Autosave {
  #name;
  #timer = 0;
  #find = null; // gives what is to be kept
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

  keep(find) {
    this.#find = find;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.write(), kDelay);
  }

  async forget() {
    clearTimeout(this.#timer);
    this.#find = null;
    await forgetWorld(this.#name);
  }

  async write() {
    clearTimeout(this.#timer);
    const world = this.#find?.() ?? null;
    this.#find = null;
    if (world === null) return;
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
