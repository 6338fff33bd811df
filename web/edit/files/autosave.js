// Keeps the world in the browser after each change, so that closing the page loses nothing.
// Takes names and texts; gives them back. Two pages that keep the same world tell each other.
//
//     const kept = new Autosave('castle');
//     await kept.read()                          // {text, savedAt} or null
//     kept.keep(text);                           // soon; the last one counts
//     kept.listen((what) => ...)                 // 'kept', 'failed', 'elsewhere'
//     await kept.forget();

import { del, get, set } from 'idb-keyval';

const kDelay = 400; // milliseconds

export class Autosave {
  #key;
  #timer = 0;
  #text = null;
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

  keep(text) {
    this.#text = text;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#write(), kDelay);
  }

  async forget() {
    clearTimeout(this.#timer);
    this.#text = null;
    await del(this.#key).catch(() => {});
  }

  async #write() {
    clearTimeout(this.#timer);
    const text = this.#text;
    if (text === null) return;
    this.#text = null;
    try {
      await set(this.#key, { text, savedAt: Date.now() });
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
