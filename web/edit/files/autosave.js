// Keeps the world in the browser after each change, so that closing the page loses nothing.
// Takes names, texts and pictures; gives them back. Two pages that keep the same world tell each
// other.
//
//     const kept = new Autosave('castle');
//     await kept.read()                          // {text, pictures, savedAt} or null
//     kept.keep(text, pictures);                 // soon; the last one counts
//     kept.listen((what) => ...)                 // 'kept', 'failed', 'elsewhere'
//     await kept.forget();

import { del, get, set } from 'idb-keyval';

const kDelay = 400; // milliseconds

export class Autosave {
  #key;
  #timer = 0;
  #world = null; // {text, pictures} to be kept
  #listeners = [];
  #channel = new BroadcastChannel('slicecast edit');
  #id = crypto.randomUUID();

  constructor(name) {
    this.#key = `slicecast edit ${name}`;
    this.#channel.addEventListener('message', ({ data }) => {
      if (data.key !== this.#key || data.id === this.#id) return;
      if (data.what === 'open') this.#channel.postMessage(this.#message('here'));
      this.#tell('elsewhere');
    });
    this.#channel.postMessage(this.#message('open'));
    addEventListener('pagehide', () => this.#write());
  }

  listen(listener) {
    this.#listeners.push(listener);
  }

  async read() {
    try {
      return (await get(this.#key)) ?? null;
    } catch {
      return null; // private windows keep nothing
    }
  }

  keep(text, pictures) {
    this.#world = { text, pictures };
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#write(), kDelay);
  }

  async forget() {
    clearTimeout(this.#timer);
    this.#world = null;
    await del(this.#key).catch(() => {});
  }

  // At once: another page will open it.
  async write(text, pictures) {
    this.#world = { text, pictures };
    await this.#write();
  }

  async #write() {
    clearTimeout(this.#timer);
    const world = this.#world;
    if (world === null) return;
    this.#world = null;
    try {
      await set(this.#key, { ...world, savedAt: Date.now() });
      this.#tell('kept');
    } catch {
      this.#tell('failed');
    }
  }

  #message(what) {
    return { key: this.#key, id: this.#id, what };
  }

  #tell(what) {
    for (const listener of this.#listeners) listener(what);
  }
}
